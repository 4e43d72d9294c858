// Runs a program and keeps what it says.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace metamer::test {

/// The world that a program runs in.
struct World {
    std::filesystem::path folder = ".";               ///< its working folder
    std::map<std::string, std::string> environment{}; ///< added to this process's own
    std::optional<std::size_t> most_file_bytes{};     ///< no file may grow beyond: a disk that fills up
    std::filesystem::path standard_output{};          ///< where stdout goes instead of into Outcome::out
};

/// What came of it.
struct Outcome {
    int status = -1; ///< exit status; 128 + signal when one ended it
    std::string out, err;
};

/// Runs `program` with these arguments to its end, with an empty stdin. Throws std::runtime_error when the
/// system has no process or file to give.
Outcome run_program(const std::string& program, const std::vector<std::string>& arguments,
                    const World& world = {});

} // namespace metamer::test
