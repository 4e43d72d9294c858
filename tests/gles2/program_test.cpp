#include "gles/program.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>

#include "base/error.h"
#include "gles/mesh.h"
#include "gles2/gl_test.h"

namespace metamer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::StartsWith;
using testing::UnorderedElementsAre;

class ProgramTest : public test::GlTest {
protected:
    /// The one pixel that the program draws.
    std::vector<int> drawn(const Program& program) {
        program.use();
        Mesh(test::rectangle(-1, -1, 1, 1)).draw();
        return test::pixel(target_.read_rgba(), 1, 0, 0);
    }

    Framebuffer target_{1, 1};
};

std::string refusal(const test::Texts& texts) {
    const ShaderFiles files = test::files_of(texts);
    try {
        const Program program(compose_shader("main.vert", {{"A", "1"}}, files),
                              compose_shader("main.frag", {{"A", "1"}}, files), kMeshAttributes);
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Exit::failure);
        return error.what();
    }
    return "not refused";
}

TEST_F(ProgramTest, NamesTheFileAndLineOfAnIncludeThatDoesNotCompile) {
    const std::string what = refusal({{"main.vert", test::kPassVertex},
                                      {"main.frag", "precision mediump float;\n#include \"lamps.glsl\"\n"
                                                    "void main() { gl_FragColor = lamp(); }\n"},
                                      {"lamps.glsl", "// lamps\nvec4 lamp() {\n    return lost;\n}\n"}});
    EXPECT_THAT(what, StartsWith("cannot compile shaders_es/main.frag: shaders_es/lamps.glsl:3: error: "));
    EXPECT_THAT(what, HasSubstr("lost"));
    EXPECT_THAT(what, testing::Not(HasSubstr("\n")));
}

TEST_F(ProgramTest, NamesTheLineAfterAnInclude) {
    EXPECT_THAT(refusal({{"main.vert", "#include \"x.glsl\"\n\nvoid main() { gl_Position = lost; }\n"},
                         {"main.frag", "void main() {}\n"},
                         {"x.glsl", "uniform float u_a;\nuniform float u_b;\n"}}),
                StartsWith("cannot compile shaders_es/main.vert: shaders_es/main.vert:3: error: "));
}

TEST_F(ProgramTest, RefusesStagesThatDoNotMeet) {
    EXPECT_THAT(refusal({{"main.vert", "void main() { gl_Position = vec4(0.0); }\n"},
                         {"main.frag", "precision mediump float;\nvarying vec2 v_lost;\n"
                                       "void main() { gl_FragColor = v_lost.xyxy; }\n"}}),
                MatchesRegex("cannot link shaders_es/main.vert with shaders_es/main.frag: .*v_lost.*"));
}

TEST_F(ProgramTest, SetsScalarsAndVectors) {
    const Program program =
        test::program_of("uniform float u_f; uniform vec2 u_2; uniform vec3 u_3; uniform vec4 u_4;",
                         "vec4(u_f, u_2.y, u_3.z, u_4.w)");
    program.set("u_f", 0.2F);
    program.set("u_2", glm::vec2(0, 0.4F));
    program.set("u_3", glm::vec3(0, 0, 0.6F));
    program.set("u_4", glm::vec4(0, 0, 0, 0.8F));
    EXPECT_THAT(drawn(program), ElementsAre(51, 102, 153, 204));
}

TEST_F(ProgramTest, SetsMatricesByColumns) {
    const Program program =
        test::program_of("uniform mat3 u_3; uniform mat4 u_4;", "vec4(u_3[0].yz, u_4[1].zw)");
    glm::mat3 three(0);
    three[0] = {0, 0.2F, 0.4F};
    glm::mat4 four(0);
    four[1] = {0, 0, 0.6F, 0.8F};
    program.set("u_3", three);
    program.set("u_4", four);
    EXPECT_THAT(drawn(program), ElementsAre(51, 102, 153, 204));
}

TEST_F(ProgramTest, SetsArrays) {
    const Program program = test::program_of("uniform float u_f[2]; uniform vec2 u_2[2]; uniform vec3 "
                                             "u_3[2]; uniform vec4 u_4[2]; uniform mat4 u_m[2];",
                                             "vec4(u_f[1], u_2[1].y, u_3[1].z, u_4[1].w) * u_m[1][3][3] + "
                                             "u_f[0] + u_2[0].x + u_3[0].x + u_4[0].x");
    program.set("u_f", std::array{0.0F, 0.2F});
    program.set("u_2", std::array{glm::vec2(0), glm::vec2(0, 0.4F)});
    program.set("u_3", std::array{glm::vec3(0), glm::vec3(0, 0, 0.6F)});
    program.set("u_4", std::array{glm::vec4(0), glm::vec4(0, 0, 0, 0.8F)});
    program.set("u_m", std::array{glm::mat4(0), glm::mat4(1)});
    program.set("u_f", std::span<const float>());
    EXPECT_THAT(drawn(program), ElementsAre(51, 102, 153, 204));
}

TEST_F(ProgramTest, SetsItsOwnUniformsWhateverIsInUse) {
    const Program first = test::program_of("uniform float u_f;", "vec4(u_f)");
    const Program second = test::program_of("uniform float u_f;", "vec4(u_f)");
    first.set("u_f", 0.2F);
    second.set("u_f", 0.4F);
    EXPECT_THAT(drawn(first), ElementsAre(51, 51, 51, 51));
    EXPECT_THAT(drawn(second), ElementsAre(102, 102, 102, 102));
}

TEST_F(ProgramTest, TakesADroppedUniformSilently) {
    const Program program = test::program_of("uniform float u_kept, u_dropped;", "vec4(u_kept)");
    program.set("u_dropped", 1.0F);
    EXPECT_EQ(program.uniform("u_dropped"), -1);
    EXPECT_NE(program.uniform("u_kept"), -1);
    EXPECT_EQ(program.uniform("u_kept"), program.uniform("u_kept"));
}

TEST_F(ProgramTest, ListsActiveUniforms) {
    const Program program =
        test::program_of("uniform float u_kept, u_dropped; uniform vec3 u_many[3];\n"
                         "uniform sampler2D u_picture;",
                         "vec4(u_many[0] + u_many[2], u_kept) * texture2D(u_picture, v_uv)");
    std::vector<std::string> names;
    for (const ActiveUniform& uniform : program.active_uniforms()) {
        names.push_back(uniform.name);
        if (uniform.name == "u_many") {
            EXPECT_EQ(uniform.type, static_cast<GLenum>(GL_FLOAT_VEC3));
            EXPECT_EQ(uniform.size, 3);
        }
        if (uniform.name == "u_picture") {
            EXPECT_EQ(uniform.type, static_cast<GLenum>(GL_SAMPLER_2D));
            EXPECT_EQ(uniform.size, 1);
        }
    }
    EXPECT_THAT(names, UnorderedElementsAre("u_kept", "u_many", "u_picture"));
}

} // namespace
} // namespace metamer
