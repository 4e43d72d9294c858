#include "gles/mesh.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "gles2/gl_test.h"

namespace metamer {
namespace {

using testing::ElementsAre;

using MeshTest = test::GlTest;

std::string refusal(const MeshData& data) {
    try {
        const Mesh mesh(data);
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Exit::failure);
        return error.what();
    }
    return "not refused";
}

TEST_F(MeshTest, CoversItsPixelsAndNoOthers) {
    const Framebuffer target(8, 4);
    glClear(GL_COLOR_BUFFER_BIT);
    const Program program = test::program_of("", "vec4(1.0)");
    program.use();
    Mesh(test::rectangle(-0.5F, 0.0F, 0.25F, 0.5F)).draw(); // columns 2 .. 4, second row from the top
    const std::vector<std::uint8_t> rgba = target.read_rgba();
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x)
            EXPECT_EQ(test::pixel(rgba, 8, x, y)[0], y == 1 && x >= 2 && x <= 4 ? 255 : 0) << x << ", " << y;
}

TEST_F(MeshTest, HandsEachAttributeToItsLocation) {
    const Framebuffer target(1, 1);
    const char* vertex =
        "attribute vec3 a_position, a_normal, a_tangent;\nattribute vec2 a_uv;\nvarying vec4 v_seen;\n"
        "void main() {\n"
        "    v_seen = vec4(a_normal.xz, a_tangent.xy) + 0.0 * a_uv.x;\n"
        "    gl_Position = vec4(a_position, 1.0);\n}\n";
    const char* fragment =
        "precision mediump float;\nvarying vec4 v_seen;\nvoid main() { gl_FragColor = v_seen; }\n";
    const ShaderFiles files = test::files_of({{"seen.vert", vertex}, {"seen.frag", fragment}});
    const Program program(compose_shader("seen.vert", {}, files), compose_shader("seen.frag", {}, files),
                          kMeshAttributes);
    program.use();
    Mesh(test::rectangle(-1, -1, 1, 1)).draw();
    EXPECT_THAT(test::pixel(target.read_rgba(), 1, 0, 0), ElementsAre(51, 153, 204, 153));
}

TEST_F(MeshTest, HandsOnTextureCoordinates) {
    const Framebuffer target(4, 2);
    const Program program = test::program_of("", "vec4(v_uv, 0.0, 1.0)");
    program.use();
    Mesh(test::rectangle(-1, -1, 1, 1)).draw();
    const std::vector<std::uint8_t> rgba = target.read_rgba();
    EXPECT_THAT(test::pixel(rgba, 4, 0, 1),
                ElementsAre(32, 64, 0, 255)); // (0.125, 0.25) of 255, at the bottom left
    EXPECT_THAT(test::pixel(rgba, 4, 3, 0), ElementsAre(223, 191, 0, 255));
}

TEST_F(MeshTest, DrawsEachOfSeveral) {
    const Framebuffer target(2, 1);
    const Program program = test::program_of("uniform float u_gray;", "vec4(u_gray)");
    const Mesh left(test::rectangle(-1, -1, 0, 1)), right(test::rectangle(0, -1, 1, 1));
    program.set("u_gray", 0.2F);
    left.draw();
    program.set("u_gray", 0.4F);
    right.draw();
    const std::vector<std::uint8_t> rgba = target.read_rgba();
    EXPECT_EQ(test::pixel(rgba, 2, 0, 0)[0], 51);
    EXPECT_EQ(test::pixel(rgba, 2, 1, 0)[0], 102);
}

TEST_F(MeshTest, RefusesWhatIsNoMesh) {
    const std::vector<float> three(3 * kVertexFloats);
    EXPECT_EQ(refusal({{}, {0, 0, 0}}), "cannot make mesh: 0 floats are no vertices of 11");
    EXPECT_EQ(refusal({std::vector<float>(12), {0, 0, 0}}),
              "cannot make mesh: 12 floats are no vertices of 11");
    EXPECT_EQ(refusal({three, {}}), "cannot make mesh: 0 indices are no triangles");
    EXPECT_EQ(refusal({three, {0, 1, 2, 0}}), "cannot make mesh: 4 indices are no triangles");
    EXPECT_EQ(refusal({three, {0, 1, 3}}), "cannot make mesh: index 3 of 3 vertices");
    EXPECT_EQ(refusal({three, {0, 1, 2}}), "not refused");
}

} // namespace
} // namespace metamer
