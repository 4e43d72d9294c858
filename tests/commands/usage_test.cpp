// Command lines that nothing takes, and the help that people are sent to.
#include "commands/command_test.h"

namespace metamer::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class Usage : public CommandTest {};

TEST_F(Usage, EveryCommandHasHelp) {
    const std::vector<std::vector<std::string>> commands = {
        {},
        {"render"},
        {"measure"},
        {"plan"},
        {"atlas"},
        {"atlas", "build"},
        {"atlas", "show"},
        {"check"},
        {"info"},
        {"list"},
        {"list", "lamps"},
        {"list", "materials"},
        {"list", "spaces"},
        {"list", "methods"},
        {"list", "scenes"},
    };
    for (auto command : commands) {
        std::string name = "metamer";
        for (const std::string& word : command)
            name += " " + word;
        command.push_back("--help");
        EXPECT_THAT(output_of(command), HasSubstr("Usage: " + name + " [OPTIONS]")) << name;
    }
}

TEST_F(Usage, TheProgramsHelpNamesEveryCommand) {
    const std::string help = output_of({"--help"});
    for (const char* command : {"render", "measure", "plan", "atlas", "check", "info", "list"})
        EXPECT_THAT(help, HasSubstr("\n  " + std::string(command) + " "));
    for (const char* option : {"--output", "--size", "--set", "--table", "EXHIBIT.ini"})
        EXPECT_THAT(output_of({"render", "--help"}), HasSubstr(option));
}

TEST_F(Usage, TheVersionIsTheProjects) {
    EXPECT_EQ(output_of({"--version"}), "metamer " METAMER_PROJECT_VERSION "\n");
}

TEST_F(Usage, ACommandIsNeeded) {
    expect_failure(2, {},
                   "cannot use the command line: a command is missing, one of run, render, measure, plan, "
                   "chart, stability, "
                   "atlas, check, "
                   "info, list; see metamer --help");
    expect_failure(2, {"atlas"},
                   "cannot use the command line: a command is missing, one of build, show; see metamer atlas "
                   "--help");
    expect_failure(2, {"list"},
                   "cannot use the command line: a command is missing, one of lamps, materials, spaces, "
                   "methods, scenes; see metamer list --help");
}

TEST_F(Usage, UnknownWordsAreNamedWithTheNearestKnown) {
    expect_failure(2, {"rendr", "a.ini", "--output", "x.png"},
                   "cannot use the command line: metamer has no command \"rendr\"; did you mean \"render\"?");
    expect_failure(2, {"atlas", "shw", "a.png"},
                   "cannot use the command line: metamer atlas has no command \"shw\"; did you mean "
                   "\"show\"?");
    expect_failure(2, {"list", "lmaps"},
                   "cannot use the command line: metamer list has no command \"lmaps\"; did you mean "
                   "\"lamps\"?");
    expect_failure(2, {"frobnicate"},
                   "cannot use the command line: metamer has no command \"frobnicate\"; see metamer --help");
    expect_failure(
        2, {"render", "--ouptut", "x.png"},
        "cannot use the command line: metamer render has no option --ouptut; did you mean \"--output\"?");
    expect_failure(
        2, {"measure", "--lamp", "E", "--material", "crayon-red", "--jsno=1"},
        "cannot use the command line: metamer measure has no option --jsno; did you mean \"--json\"?");
    expect_failure(2, {"--verbose", "info"},
                   "cannot use the command line: metamer has no option --verbose; did you mean "
                   "\"--version\"?");
}

TEST_F(Usage, ArgumentsTooManyOrTooFew) {
    expect_failure(2, {"render", "a.ini", "b.ini", "--output", "x.png"},
                   "cannot use the command line: \"b.ini\" is one argument too many; see metamer render "
                   "--help");
    expect_failure(2, {"list", "lamps", "all"},
                   "cannot use the command line: \"all\" is one argument too many; see metamer list lamps "
                   "--help");
    expect_failure(2, {"render"},
                   "cannot use the command line: --output is required; see metamer render --help");
    expect_failure(2, {"render", "--output"},
                   "cannot use the command line: --output needs a value; see metamer render --help");
    expect_failure(2, {"measure", "--lamp", "E"},
                   "cannot use the command line: --material is required; see metamer measure --help");
    expect_failure(2, {"atlas", "show"},
                   "cannot use the command line: atlas is required; see metamer atlas show --help");
    expect_failure(2, {"check"}, "cannot use the command line: files is required; see metamer check --help");
}

TEST_F(Usage, AFlagTakesNoValue) {
    expect_failure_like(2, {"info", "--json=maybe"}, StartsWith("metamer: cannot use the command line: "));
}

} // namespace
} // namespace metamer::test
