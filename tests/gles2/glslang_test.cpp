// glslang really refuses what it is asked to refuse: without this, its silence would prove nothing.
#include "gles2/glslang.h"

#include <gmock/gmock.h>

namespace metamer::test {
namespace {

using testing::HasSubstr;

std::string complaint(Stage stage, const std::string& text) {
    return glslang_complaints({{"sample", stage, text}});
}

std::string fragment_complaint(const std::string& text) {
    return complaint(Stage::fragment, "precision mediump float;\nuniform int u_n;\n" + text);
}

TEST(Glslang, AcceptsGoodShaders) {
    EXPECT_EQ(fragment_complaint(
                  "uniform vec4 u_a[4];\nvoid main() {\n    vec4 s = vec4(0.0);\n"
                  "    for (int i = 0; i < 4; i++)\n        s += u_a[i];\n    gl_FragColor = s;\n}\n"),
              "");
    EXPECT_EQ(complaint(Stage::vertex, "attribute vec4 a;\nvoid main() { gl_Position = a; }\n"), "");
}

TEST(Glslang, NamesTheShaderAndTheLine) {
    const std::string said =
        glslang_complaints({{"good", Stage::vertex, "void main() { gl_Position = vec4(0.0); }\n"},
                            {"bad", Stage::fragment, "void main() {\n    lost();\n}\n"}});
    EXPECT_THAT(said, HasSubstr("bad.frag"));
    EXPECT_THAT(said, HasSubstr("0:2:"));
}

/// GLSL ES 1.00.17 appendix A section 4: control flow.
TEST(Glslang, RefusesLoopsThatAreNotConstant) {
    EXPECT_THAT(fragment_complaint("void main() { float s = 0.0; for (int i = 0; i < u_n; i++) s += 1.0;\n"
                                   "gl_FragColor = vec4(s); }"),
                HasSubstr("inductive-loop condition"));
    EXPECT_THAT(fragment_complaint("void main() { float s = 0.0; int i = 0; for (; i < 4; i++) s += 1.0;\n"
                                   "gl_FragColor = vec4(s); }"),
                HasSubstr("inductive-loop init-declaration"));
    EXPECT_THAT(
        fragment_complaint("void main() { for (int i = 0; i < 4; i++) i = 3; gl_FragColor = vec4(0.0); }"),
        HasSubstr("inductive loop index modified"));
    EXPECT_THAT(fragment_complaint(
                    "void main() { float s = 0.0; while (s < 3.0) s += 1.0; gl_FragColor = vec4(s); }"),
                HasSubstr("while loops not available"));
    EXPECT_THAT(fragment_complaint("void main() { float s = 0.0; do s += 1.0; while (s < 3.0);\n"
                                   "gl_FragColor = vec4(s); }"),
                HasSubstr("do-while loops not available"));
}

/// The same, section 5: indexing.
TEST(Glslang, RefusesIndicesThatAreNotConstant) {
    for (const std::string text :
         {"uniform vec4 a[4]; void main() { gl_FragColor = a[u_n]; }",
          "uniform sampler2D a[4]; void main() { gl_FragColor = texture2D(a[u_n], vec2(0.0)); }",
          "varying vec4 a[4]; void main() { gl_FragColor = a[u_n]; }",
          "uniform mat3 a; void main() { gl_FragColor = vec4(a[u_n], 1.0); }",
          "void main() { const mat2 a = mat2(1.0); gl_FragColor = vec4(a[u_n], 1.0, 1.0); }",
          "void main() { float a[2]; a[0] = a[1] = 1.0; gl_FragColor = vec4(a[u_n]); }"})
        EXPECT_THAT(fragment_complaint(text), HasSubstr("Non-constant-index-expression")) << text;
}

TEST(Glslang, RefusesWhatEs2DoesNotHave) {
    EXPECT_THAT(complaint(Stage::fragment, "void main() { float a = 0.0; gl_FragColor = vec4(a); }"),
                HasSubstr("default precision"));
    EXPECT_THAT(fragment_complaint("void main() { gl_FragColor = vec4(float(5 % 2)); }"),
                HasSubstr("not supported"));
    EXPECT_THAT(fragment_complaint("void main() { float a = 1; gl_FragColor = vec4(a); }"),
                HasSubstr("cannot convert"));
    EXPECT_THAT(fragment_complaint("varying vec2 v; void main() { gl_FragColor = vec4(dFdx(v.x)); }"),
                HasSubstr("GL_OES_standard_derivatives"));
    EXPECT_THAT(fragment_complaint("uniform sampler2D a; void main() {\n"
                                   "gl_FragColor = texture2DLodEXT(a, vec2(0.0), 0.0); }"),
                HasSubstr("GL_EXT_shader_texture_lod"));
}

/// The limits are really those of es2_limits.conf: OpenGL ES 2.0.25 tables 6.18 to 6.20.
TEST(Glslang, TakesTheFloorsOfEs2ForLimits) {
    for (const auto& [limit, floor] :
         {std::pair("FragmentUniformVectors", "16"), std::pair("VertexUniformVectors", "128"),
          std::pair("VaryingVectors", "8"), std::pair("VertexAttribs", "8"),
          std::pair("TextureImageUnits", "8"), std::pair("VertexTextureImageUnits", "0"),
          std::pair("CombinedTextureImageUnits", "8"), std::pair("DrawBuffers", "1")}) {
        // An array of size 1 where it is the floor, of the forbidden size 0 where it is not.
        const std::string is_floor = std::string("gl_Max") + limit + " == " + floor;
        EXPECT_EQ(fragment_complaint("const int size = int(" + is_floor +
                                     ");\nvoid main() {\n"
                                     "float a[size]; a[0] = 0.0; gl_FragColor = vec4(a[0]); }"),
                  "")
            << limit;
        EXPECT_NE(fragment_complaint("const int size = int(!(" + is_floor +
                                     "));\nvoid main() {\n"
                                     "float a[size]; a[0] = 0.0; gl_FragColor = vec4(a[0]); }"),
                  "")
            << limit;
    }
}

TEST(Glslang, Preprocesses) {
    const std::vector<std::string> texts = glslang_preprocessed(
        {{"a", Stage::fragment, "#define N 2 // two\n#if N == 2\nyes N\n#else\nno\n#endif\n"},
         {"b", Stage::vertex, "/* b */ b\n"}});
    ASSERT_EQ(texts.size(), 2U);
    EXPECT_EQ(tokens(texts[0]), (std::vector<std::string>{"yes", "2"}));
    EXPECT_EQ(tokens(texts[1]), (std::vector<std::string>{"b"}));
}

} // namespace
} // namespace metamer::test
