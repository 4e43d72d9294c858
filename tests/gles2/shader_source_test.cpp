#include "gles/shader_source.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "gles2/gl_test.h"

namespace metamer {
namespace {

using test::files_of;
using testing::HasSubstr;

/// The origins as `file:line` without the folder, one word per line of text.
std::string origins(const ComposedShader& composed) {
    std::string words;
    for (const ShaderLine& line : composed.lines) {
        EXPECT_TRUE(line.file.starts_with(kShaderFolder)) << line.file;
        words += (words.empty() ? "" : " ") + line.file.substr(kShaderFolder.size()) + ":" +
                 std::to_string(line.line);
    }
    return words;
}

std::string refusal(const test::Texts& texts) {
    try {
        compose_shader("main.frag", {}, files_of(texts));
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Exit::failure);
        return error.what();
    }
    return "not refused";
}

TEST(ComposeShader, LeavesAPlainFileAsItIs) {
    const ComposedShader composed = compose_shader("main.frag", {}, files_of({{"main.frag", "a\n\nb\n"}}));
    EXPECT_EQ(composed.text, "a\n\nb\n");
    EXPECT_EQ(origins(composed), "main.frag:1 main.frag:2 main.frag:3");
    EXPECT_EQ(composed.file, "shaders_es/main.frag");
}

TEST(ComposeShader, ExpandsIncludesInPlaceAndOnce) {
    const ComposedShader composed =
        compose_shader("main.frag", {},
                       files_of({{"main.frag", "a\n#include \"x.glsl\"\nb\n"
                                               "  # include \"y.glsl\" // again\nc"},
                                 {"x.glsl", "x1\n#include \"y.glsl\"\nx2\r\n"},
                                 {"y.glsl", "y"}}));
    EXPECT_EQ(composed.text, "a\nx1\ny\nx2\nb\nc\n");
    EXPECT_EQ(origins(composed), "main.frag:1 x.glsl:1 y.glsl:1 x.glsl:3 main.frag:3 main.frag:5");
}

TEST(ComposeShader, PutsDefinesAfterVersionAndLeadingComments) {
    const std::string text = "// what\n/* and\n   why */\n#version 100\n\n// more\nvoid main() {}\n";
    const ComposedShader composed =
        compose_shader("main.frag", {{"LAMPS", "2"}, {"SRGB", ""}}, files_of({{"main.frag", text}}));
    EXPECT_EQ(composed.text,
              "// what\n/* and\n   why */\n#version 100\n\n// more\n#define LAMPS 2\n#define SRGB \n"
              "void main() {}\n");
    EXPECT_EQ(origins(composed),
              "main.frag:1 main.frag:2 main.frag:3 main.frag:4 main.frag:5 main.frag:6 main.frag:0 "
              "main.frag:0 main.frag:7");
}

TEST(ComposeShader, PutsDefinesBeforeAnIncludeOnTheFirstLine) {
    const ComposedShader composed =
        compose_shader("main.frag", {{"LAMPS", "2"}},
                       files_of({{"main.frag", "#include \"x.glsl\"\n"}, {"x.glsl", "// x\nx\n"}}));
    EXPECT_EQ(composed.text, "#define LAMPS 2\n// x\nx\n");
}

TEST(ComposeShader, DefinesAFileOfCommentsOnly) {
    EXPECT_EQ(compose_shader("main.frag", {{"A", "1"}}, files_of({{"main.frag", "// x\n"}})).text,
              "// x\n#define A 1\n");
}

TEST(ComposeShader, IgnoresIncludesInComments) {
    const std::string text = "// #include \"no.glsl\"\n/*\n#include \"no.glsl\"\n*/\nvoid main() {}\n";
    EXPECT_EQ(compose_shader("main.frag", {}, files_of({{"main.frag", text}})).text, text);
}

TEST(ComposeShader, RefusesMissingFiles) {
    EXPECT_EQ(refusal({}), "cannot read shaders_es/main.frag: no such shader file");
    EXPECT_EQ(refusal({{"main.frag", "\n#include \"x.glsl\"\n"}, {"x.glsl", "x\n#include \"lost.glsl\"\n"}}),
              "cannot compose shaders_es/x.glsl:2: #include \"lost.glsl\": no such shader file");
}

TEST(ComposeShader, RefusesCircles) {
    EXPECT_EQ(refusal({{"main.frag", "#include \"x.glsl\"\n"},
                       {"x.glsl", "#include \"y.glsl\"\n"},
                       {"y.glsl", "\n\n#include \"x.glsl\"\n"}}),
              "cannot compose shaders_es/y.glsl:3: #include \"x.glsl\" goes round in a circle: main.frag > "
              "x.glsl > "
              "y.glsl > x.glsl");
    EXPECT_THAT(refusal({{"main.frag", "#include \"main.frag\"\n"}}), HasSubstr("main.frag > main.frag"));
}

TEST(ComposeShader, RefusesMalformedIncludes) {
    for (const std::string line : {"#include", "#include x.glsl", "#include <x.glsl>", "#include \"\"",
                                   "#include \"x.glsl", "#include \"x.glsl\" junk"})
        EXPECT_EQ(refusal({{"main.frag", line + "\n"}, {"x.glsl", "x"}}),
                  "cannot compose shaders_es/main.frag:1: #include takes a file name in double quotes")
            << line;
}

TEST(ComposeShader, RefusesOtherVersionsAndPlaces) {
    EXPECT_EQ(refusal({{"main.frag", "#version 300 es\n"}}),
              "cannot compose shaders_es/main.frag:1: #version 300 es is not 100");
    EXPECT_EQ(refusal({{"main.frag", "float x;\n#version 100\n"}}),
              "cannot compose shaders_es/main.frag:2: #version must come before everything but comments");
    EXPECT_EQ(refusal({{"main.frag", "#include \"x.glsl\"\n"}, {"x.glsl", "#version 100\n"}}),
              "cannot compose shaders_es/x.glsl:1: #version must come before everything but comments");
}

TEST(ComposeShader, RefusesWhatDoesNotEnd) {
    EXPECT_EQ(refusal({{"main.frag", "a\n/* b\nc\n"}}),
              "cannot compose shaders_es/main.frag:3: a /* comment does not end");
    EXPECT_EQ(refusal({{"main.frag", "#if 1\na\n"}}),
              "cannot compose shaders_es/main.frag:2: an #if does not end in its file");
    EXPECT_EQ(refusal({{"main.frag", "a\n#endif\n"}}),
              "cannot compose shaders_es/main.frag:2: #endif without #if");
}

TEST(ComposeShader, RefusesAnIncludeThatAnotherBranchHides) {
    const std::string twice = "#if A\n#include \"x.glsl\"\n#else\n#include \"x.glsl\"\n#endif\n";
    EXPECT_EQ(refusal({{"main.frag", twice}, {"x.glsl", "x\n"}}),
              "cannot compose shaders_es/main.frag:4: \"x.glsl\" was included before under an #if that does "
              "not reach "
              "here");
    const std::string after = "#if A\n#include \"x.glsl\"\n#endif\n#include \"x.glsl\"\n";
    EXPECT_THAT(refusal({{"main.frag", after}, {"x.glsl", "x\n"}}),
                HasSubstr("main.frag:4: \"x.glsl\" was included"));
}

TEST(ComposeShader, AllowsTheSameIncludeTwiceInOneBranch) {
    const std::string text = "#if A\n#include \"x.glsl\"\n#if B\n#include \"x.glsl\"\n#endif\n#endif\n";
    EXPECT_EQ(compose_shader("main.frag", {}, files_of({{"main.frag", text}, {"x.glsl", "x\n"}})).text,
              "#if A\nx\n#if B\n#endif\n#endif\n");
}

TEST(ComposeShader, FollowsEveryBranchToItsEnd) {
    const std::string text = "#ifdef A\n#elif B\n#ifndef C\n#endif\n#else\n#endif\n#include \"x.glsl\"\n";
    EXPECT_EQ(compose_shader("main.frag", {}, files_of({{"main.frag", text}, {"x.glsl", "x\n"}})).text,
              "#ifdef A\n#elif B\n#ifndef C\n#endif\n#else\n#endif\nx\n");
}

/// Line 1 of the text is line 1 of a.frag, line 2 line 7 of lamps.glsl.
ComposedShader two_lines() {
    return {"a\nb\n", {{"shaders_es/a.frag", 1}, {"shaders_es/lamps.glsl", 7}}, "shaders_es/a.frag"};
}

TEST(RewriteLog, KnowsEveryDriversForm) {
    const std::string wanted = "shaders_es/lamps.glsl:7: error: `x' undeclared";
    EXPECT_EQ(rewrite_log("0:2(3): error: `x' undeclared\n", two_lines()), wanted); // Mesa
    EXPECT_EQ(rewrite_log("ERROR: 0:2: `x' undeclared\n", two_lines()), wanted); // ANGLE, PowerVR, VideoCore
    EXPECT_EQ(rewrite_log("0(2) : error: `x' undeclared", two_lines()), wanted); // NVIDIA
    EXPECT_EQ(rewrite_log("0:2: L0001: no main", two_lines()),
              "shaders_es/lamps.glsl:7: L0001: no main"); // Mali
    EXPECT_EQ(rewrite_log("WARNING: 0:1: slow", two_lines()), "shaders_es/a.frag:1: warning: slow");
    EXPECT_EQ(rewrite_log("0:1(10): preprocessor error: #error no", two_lines()),
              "shaders_es/a.frag:1: preprocessor error: #error no");
}

TEST(RewriteLog, KeepsWhatItDoesNotKnow) {
    for (const std::string line : {"2 errors generated", "0:3(1): error: behind the end",
                                   "0:0(0): error: before it", "0:99999999999(1): error: no number"})
        EXPECT_EQ(rewrite_log(line, two_lines()), line);
}

TEST(RewriteLog, TidiesLines) {
    EXPECT_EQ(rewrite_log(std::string("0:1(1): error: a \r\n\n\n0:2(1): error: b\0\0", 39), two_lines()),
              "shaders_es/a.frag:1: error: a\nshaders_es/lamps.glsl:7: error: b");
    EXPECT_EQ(rewrite_log("", two_lines()), "");
}

} // namespace
} // namespace metamer
