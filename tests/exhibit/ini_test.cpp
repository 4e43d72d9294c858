#include "exhibit/ini.h"

#include <gmock/gmock.h>

#include "base/error.h"

namespace metamer {
namespace {

using testing::ElementsAre;

std::string error_of(const std::string& text) {
    try {
        parse_ini(text, "a.ini");
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Exit::bad_input);
        return error.what();
    }
    return "no error";
}

std::string listed(const IniEntry& e) {
    return std::to_string(e.line) + " " + e.section + "|" + e.key + "|" + e.value;
}

std::vector<std::string> listed(const std::string& text) {
    std::vector<std::string> out;
    for (const IniEntry& entry : parse_ini(text, "a.ini").entries)
        out.push_back(listed(entry));
    return out;
}

TEST(Ini, EveryValueKnowsItsLine) {
    EXPECT_THAT(listed("; c\n\n[a]\nx = 1\n\n# c\n y: 2 ; c\n[b.c]\nx=a;b # c\n"),
                ElementsAre("4 a|x|1", "7 a|y|2", "9 b.c|x|a;b # c"));
}

TEST(Ini, TakesCarriageReturnsAByteOrderMarkAndNoLastNewline) {
    EXPECT_THAT(listed("\xEF\xBB\xBF[a]\r\nx = 1\r\ny = 2"), ElementsAre("2 a|x|1", "3 a|y|2"));
}

TEST(Ini, AnIndentedLineContinuesNothing) {
    EXPECT_THAT(listed("[a]\nx = 1\n    y = 2\n"), ElementsAre("2 a|x|1", "3 a|y|2"));
    EXPECT_EQ(error_of("[a]\nx = 1\n   and more\n"),
              "cannot read a.ini:3: \"and more\" is neither [section] nor key = value");
}

TEST(Ini, KeepsUtf8AndRefusesOtherText) {
    EXPECT_THAT(listed("; gr\xFCn\n[a]\nx = gr\xC3\xBCn ; gr\xFCn\n"), ElementsAre("3 a|x|gr\xC3\xBCn"));
    for (const char* text : {"[a]\nx = gr\xFCn\n", "[a]\ngr\xFCn = 1\n", "[gr\xFCn]\nx = 1\n"})
        EXPECT_EQ(error_of(text), "cannot read a.ini:2: text that is not UTF-8");
}

TEST(Ini, SectionsWithoutValuesAreThere) {
    const IniFile file = parse_ini("\xEF\xBB\xBF[a]\n  [ b ] ; c\nx = 1\n", "a.ini");
    ASSERT_EQ(file.sections.size(), 2u);
    EXPECT_EQ(file.sections[0].name, "a");
    EXPECT_EQ(file.sections[1].name, "b");
    EXPECT_EQ(file.sections[1].line, 2);
    EXPECT_EQ(file.entries.at(0).section, "b");
}

TEST(Ini, RefusesWithTheLine) {
    const std::pair<std::string, std::string> cases[] = {
        {"[a]\nnothing\n", "2: \"nothing\" is neither [section] nor key = value"},
        {"[a\nx = 1\n", "1: \"[a\" is neither [section] nor key = value"},
        {"\n\n" + std::string(80, 'x') + "\n",
         "3: \"" + std::string(60, 'x') + "...\" is neither [section] nor key = value"},
        {"x = 1\n", "1: key \"x\" stands outside any section"},
        {"[a]\n = 1\n", "2: a value needs a key before the \"=\""},
        {"[]\nx = 1\n", "1: a section needs a name"},
        {"[a] x = 1\n", "1: text after the \"]\" of [a]; each value has a line of its own"},
        {"[a]\nx = 1\n[b]\nx = 1\n[a]\nx = 2\n", "6: key \"x\" is given twice in [a], first at line 2"},
        {"[" + std::string(50, 's') + "]\n", "1: the section's name is over 49 bytes"},
        {std::string("[a]\nx = \0 1\n", 12), "2: a NUL byte; this is no text file"},
        {"[a]\n\nx = " + std::string(4093, 'y') + "\n", "3: the line is over 4096 bytes"},
    };
    for (const auto& [text, cause] : cases)
        EXPECT_EQ(error_of(text), "cannot read a.ini:" + cause) << text;
}

TEST(Ini, TheFirstFaultIsTold) {
    EXPECT_EQ(error_of("[a]\nnothing\nx = 1\nx = 2\n"),
              "cannot read a.ini:2: \"nothing\" is neither [section] nor key = value");
    EXPECT_EQ(error_of("[a]\nx = 1\nx = 2\nnothing\n"),
              "cannot read a.ini:3: key \"x\" is given twice in [a], first at line 2");
}

TEST(Ini, LinesAndSectionsUpToTheirLimitsAreWhole) {
    const std::string section(49, 's'), value(4092, 'y');
    const IniFile file = parse_ini("[" + section + "]\nx = " + value + "\n", "a.ini");
    EXPECT_EQ(file.entries.at(0).section, section);
    EXPECT_EQ(file.entries.at(0).value, value);
}

TEST(Ini, AnEmptyFileHoldsNothing) {
    EXPECT_TRUE(parse_ini("", "a.ini").entries.empty());
    EXPECT_TRUE(parse_ini("\n", "a.ini").sections.empty());
}

} // namespace
} // namespace metamer
