// What the tests of the commands share: the built program, a folder of their own, and what every failure
// keeps to.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

#include "commands/process.h"

namespace metamer::test {

namespace fs = std::filesystem;

class CommandTest : public testing::Test {
protected:
    CommandTest()
        : folder_(fs::canonical(fs::temp_directory_path()) /
                  ("metamer-commands-" + std::to_string(::getpid()))) {
        fs::create_directories(folder_);
    }
    ~CommandTest() override { fs::remove_all(folder_); }

    /// Runs metamer in the test's folder.
    Outcome metamer(const std::vector<std::string>& arguments) const {
        return metamer(arguments, {.folder = folder_});
    }
    Outcome metamer(const std::vector<std::string>& arguments, World world) const {
        if (world.folder == ".")
            world.folder = folder_;
        return run_program(METAMER_PROGRAM, arguments, world);
    }

    /// What it says on stdout; it must succeed and say nothing on stderr.
    std::string output_of(const std::vector<std::string>& arguments) const {
        const Outcome outcome = metamer(arguments);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        return outcome.out;
    }

    /// stdout as the one JSON document that it must be, every number finite (others are written as null).
    nlohmann::json json_of(const std::vector<std::string>& arguments) const {
        const std::string text = output_of(arguments);
        const nlohmann::json document = nlohmann::json::parse(text, nullptr, false);
        EXPECT_FALSE(document.is_discarded()) << text;
        return document;
    }

    /// Expects this exit status, `metamer: MESSAGE` as the one line on stderr, nothing on stdout, and no
    /// file more or less in the folder than before.
    void expect_failure(int status, const std::vector<std::string>& arguments, const std::string& message,
                        World world = {}) const {
        expect_failure_like(status, arguments, testing::Eq("metamer: " + message + "\n"), std::move(world));
    }

    /// The same for stderr as a whole.
    void expect_failure_like(int status, const std::vector<std::string>& arguments,
                             const testing::Matcher<std::string>& on_stderr, World world = {}) const {
        const auto before = files();
        const Outcome outcome = metamer(arguments, std::move(world));
        EXPECT_EQ(outcome.status, status) << testing::PrintToString(arguments);
        EXPECT_EQ(outcome.out, "") << testing::PrintToString(arguments);
        EXPECT_THAT(outcome.err, on_stderr) << testing::PrintToString(arguments);
        EXPECT_EQ(files(), before) << testing::PrintToString(arguments);
    }

    /// Every path in the folder, sorted, the parts of unfinished files among them.
    std::vector<std::string> files() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::recursive_directory_iterator(folder_))
            names.push_back(entry.path().lexically_relative(folder_).string());
        std::sort(names.begin(), names.end());
        return names;
    }

    void write(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
    }

    std::string read(const std::string& name) const {
        std::ifstream in(folder_ / name, std::ios::binary);
        std::ostringstream text;
        text << in.rdbuf();
        return text.str();
    }

    fs::path folder_;
};

/// A lamp's CSV: flat from 400 to 700 nm.
inline constexpr const char* kFlatLamp = "wavelength_nm,flat\n400,1\n700,1\n";

/// Two reflectances: a gray of 50 % and a step at 550 nm.
inline constexpr const char* kTwoMaterials =
    "# Two samples\nwavelength_nm,half,step\n380,0.5,0\n545,0.5,0\n555,0.5,1\n780,0.5,1\n";

} // namespace metamer::test
