#include "commands/command_line.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "commands/commands.h"
#include "exhibit/load.h"

namespace metamer {

void add_commands(CLI::App& app) {
    add_run_command(app);
    add_render_command(app);
    add_measure_command(app);
    add_plan_command(app);
    add_chart_command(app);
    add_stability_command(app);
    add_atlas_command(app);
    add_check_command(app);
    add_info_command(app);
    add_list_command(app);
}

void add_exhibit_arguments(CLI::App& command, ExhibitArguments& arguments) {
    command.add_option("exhibit", arguments.path, "exhibit as INI file (default: the built-in crayons)")
        ->type_name("EXHIBIT.ini");
    command.add_option("--set", arguments.sets, "override a key of the exhibit, e.g. lamp.1.spectrum=F11")
        ->type_name("section.key=value")
        ->take_all()
        ->allow_extra_args(false);
}

void warn(const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings)
        std::cerr << "metamer: warning: " << warning << '\n';
}

Exhibit at_size(ExhibitArguments arguments, const std::optional<std::string>& size,
                const std::function<Exhibit(const ExhibitArguments&)>& load) {
    if (!size)
        return load(arguments);
    const auto x = size->find_first_of("xX");
    if (x == std::string::npos || x == 0 || x + 1 == size->size())
        throw bad_input("read", "--size " + *size, "it must be WIDTHxHEIGHT in pixels, as in 1280x720");
    const std::string width = "display.width=" + size->substr(0, x);
    const std::string height = "display.height=" + size->substr(x + 1);
    arguments.sets.insert(arguments.sets.end(), {width, height});
    try {
        return load(arguments);
    } catch (const Error& error) {
        if (error.place() == "--set " + width || error.place() == "--set " + height)
            throw bad_input("read", "--size " + *size, error.cause());
        throw;
    }
}

Exhibit load(const ExhibitArguments& arguments, Use use, std::vector<std::string>& doubts) {
    return arguments.path.empty() ? default_exhibit(arguments.sets, &doubts, use)
                                  : load_exhibit(arguments.path, arguments.sets, &doubts, use);
}

Exhibit load(const ExhibitArguments& arguments) {
    std::vector<std::string> doubts;
    Exhibit exhibit = load(arguments, Use::frame, doubts);
    warn(doubts);
    return exhibit;
}

void print_json(const nlohmann::ordered_json& document) {
    std::cout << document.dump(2) << '\n';
}

std::string counted(std::size_t count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

void check_output(const std::filesystem::path& path) {
    if (path.empty())
        throw bad_input("write", "\"\"", "it names no file");
    std::error_code ec; // what cannot be asked for cannot be written either, and write_file says why
    const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    if (!std::filesystem::is_directory(folder, ec))
        throw bad_input("write", path.string(), "there is no folder " + folder.string());
    if (std::filesystem::is_directory(path, ec))
        throw bad_input("write", path.string(), "it is a folder");
}

} // namespace metamer
