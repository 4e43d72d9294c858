#include "gles2/source_facts.h"

#include <gmock/gmock.h>

namespace metamer::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Tokens, AreWordsNumbersAndSigns) {
    EXPECT_THAT(tokens("vec3 a_b[2];\n x+=1.5e3;"),
                ElementsAre("vec3", "a_b", "[", "2", "]", ";", "x", "+", "=", "1.5e3", ";"));
}

TEST(Declarations, AreFoundWithTypeNameAndSize) {
    const auto found = declarations(
        tokens("uniform vec4 u_a[3], u_b; varying highp vec2 v_c; attribute float a_d; float not_me;"));
    ASSERT_EQ(found.size(), 4U);
    EXPECT_EQ(found[0].name + found[1].name + found[2].name + found[3].name, "u_au_bv_ca_d");
    EXPECT_EQ(found[0].size, 3);
    EXPECT_EQ(found[1].size, 1);
    EXPECT_EQ(found[1].type, "vec4");
    EXPECT_EQ(found[2].type, "vec2");
    EXPECT_EQ(found[3].qualifier, "attribute");
}

TEST(Vectors, AreCountedWithoutPacking) {
    const auto found =
        declarations(tokens("uniform float u_a, u_b[3]; uniform vec3 u_c; uniform mat3 u_d[2];"
                            "uniform mat4 u_e; uniform sampler2D u_f[2]; varying vec2 v_g[2];"));
    EXPECT_EQ(vectors(found, "uniform"), 1 + 3 + 1 + 2 * 3 + 4);
    EXPECT_EQ(vectors(found, "varying"), 2);
    EXPECT_EQ(samplers(found), 2);
}

TEST(Rules, AllowConstantLoopsAndTextures) {
    const std::string text = "for ( int i = 0; i < 64; i ++) { for(int j=1;j<8;j++) texture2D(u, v); }";
    EXPECT_THAT(broken_rules(Stage::fragment, tokens(text)), IsEmpty());
}

TEST(Rules, RefuseOtherLoops) {
    const std::string what = "a loop is not for (int i = NUMBER; i < NUMBER; i++)";
    for (const std::string text :
         {"for (int i = 0; i < n; i++)", "for (int i = n; i < 4; i++)", "for (int i = 0; j < 4; i++)",
          "for (int i = 0; i < 4; j++)", "for (float i = 0; i < 4; i++)", "for (int i = 0; i < 4; i += 2)",
          "for (;;)"})
        EXPECT_THAT(broken_rules(Stage::fragment, tokens(text)), ElementsAre(what)) << text;
    EXPECT_THAT(broken_rules(Stage::fragment, tokens("while (x) {}")),
                ElementsAre("while is not for the oldest GPUs"));
    EXPECT_THAT(broken_rules(Stage::fragment, tokens("do {} ")),
                ElementsAre("do is not for the oldest GPUs"));
}

TEST(Rules, RefuseWhatNeedsExtensions) {
    EXPECT_THAT(
        broken_rules(Stage::fragment, tokens("#extension GL_OES_standard_derivatives : enable\ndFdx(v)")),
        ElementsAre("extension is not for the oldest GPUs", "dFdx is not for the oldest GPUs"));
    EXPECT_THAT(broken_rules(Stage::fragment, tokens("texture2DLodEXT(u, v, 0.0)")),
                ElementsAre("texture2DLodEXT asks for a level of detail"));
    EXPECT_THAT(broken_rules(Stage::fragment, tokens("texture2DProjGradEXT(u, v, x, y)")),
                ElementsAre("texture2DProjGradEXT asks for a level of detail"));
}

TEST(Rules, RefuseTexturesInVertexShaders) {
    EXPECT_THAT(broken_rules(Stage::vertex, tokens("texture2D(u, v)")),
                ElementsAre("texture2D in a vertex shader"));
}

} // namespace
} // namespace metamer::test
