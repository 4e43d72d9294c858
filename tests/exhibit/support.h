// Shared by the exhibit's tests: a text's exhibit, its error, a folder that goes away.
#pragma once

#include <filesystem>
#include <string>
#include <unistd.h>
#include <vector>

#include "base/error.h"
#include "exhibit/load.h"

namespace metamer {

/// The message of what `run` throws, which must be bad input; "no error" without one.
template <class F>
std::string error_of(F run) {
    try {
        run();
    } catch (const Error& error) {
        return error.status() == Exit::bad_input ? error.what()
                                                 : std::string("other status: ") + error.what();
    }
    return "no error";
}

/// config/ as the place of a text: its maps can be named.
inline std::filesystem::path config_folder() {
    return std::filesystem::path(METAMER_SOURCE_DIR) / "config";
}

/// `sets` behind rows as the thesis has them: those take no time, and next to no test is about levels.
inline std::vector<std::string> with_quick_rows(std::vector<std::string> sets = {}) {
    sets.insert(sets.begin(), "atlas.quantization=thesis");
    return sets;
}

/// An exhibit from text; with_quick_rows() where the text says nothing of an atlas.
inline Exhibit exhibit_of(const std::string& text, const std::vector<std::string>& sets = {},
                          std::vector<std::string>* warnings = nullptr) {
    const bool quick = text.find("[atlas]") == std::string::npos;
    return parse_exhibit(text, "k.ini", config_folder(), quick ? with_quick_rows(sets) : sets, warnings);
}

/// A folder of the test's own, removed at its end.
class TestFolder {
public:
    TestFolder() {
        path_ = std::filesystem::temp_directory_path() / ("metamer-exhibit-" + std::to_string(::getpid()));
        std::filesystem::create_directories(path_);
    }
    ~TestFolder() { std::filesystem::remove_all(path_); }
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

} // namespace metamer
