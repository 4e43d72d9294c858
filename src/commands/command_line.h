// What several commands share of their command lines.
#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "exhibit/load.h"

namespace metamer {

/// An exhibit as commands name it: [EXHIBIT.ini] [--set section.key=value]...
struct ExhibitArguments {
    std::string path; ///< empty: the built-in exhibit
    std::vector<std::string> sets;
};

void add_exhibit_arguments(CLI::App& command, ExhibitArguments& arguments);

/// Loads with `load` what `--size WIDTHxHEIGHT` makes of the arguments: the two keys that it stands for, so
/// that their ranges are one. Errors of these keys name the option.
Exhibit at_size(ExhibitArguments arguments, const std::optional<std::string>& size,
                const std::function<Exhibit(const ExhibitArguments&)>& load);

/// Loads it; `doubts` receives what there is to doubt, a sentence each.
Exhibit load(const ExhibitArguments& arguments, Use use, std::vector<std::string>& doubts);

/// Loads it for a frame; doubts are printed as by warn().
Exhibit load(const ExhibitArguments& arguments);

/// To stderr, as `metamer: warning: ...`.
void warn(const std::vector<std::string>& warnings);

/// One JSON document on stdout.
void print_json(const nlohmann::ordered_json& document);

/// `1 lamp`, `2 lamps`.
std::string counted(std::size_t count, const std::string& what);

/// Refuses an output path that cannot be written, before any work is done: empty, no such folder, or a folder
/// itself.
void check_output(const std::filesystem::path& path);

} // namespace metamer
