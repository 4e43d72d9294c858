#include "gles/framebuffer.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "gles/mesh.h"
#include "gles2/gl_test.h"

namespace metamer {
namespace {

using testing::ElementsAre;
using testing::MatchesRegex;

using FramebufferTest = test::GlTest;

std::string refusal(int width_px, int height_px, ColorBuffer color = ColorBuffer::target) {
    try {
        const Framebuffer target(width_px, height_px, DepthBuffer::none, color);
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Exit::failure);
        return error.what();
    }
    return "not refused";
}

void clear_to(float r, float g, float b, float a) {
    glClearColor(r, g, b, a);
    glClear(GL_COLOR_BUFFER_BIT);
}

TEST_F(FramebufferTest, ReadsTheTopRowFirstAtAnySize) {
    const Framebuffer target(5, 3);
    clear_to(0.2F, 0.4F, 0.6F, 0.8F);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 2, 5, 1); // GL counts rows from the bottom
    clear_to(1, 0, 0, 1);
    glScissor(4, 0, 1, 1);
    clear_to(0, 1, 0, 1);
    const std::vector<std::uint8_t> rgba = target.read_rgba();
    ASSERT_EQ(rgba.size(), 5U * 3 * 4);
    for (int x = 0; x < 5; ++x) {
        EXPECT_THAT(test::pixel(rgba, 5, x, 0), ElementsAre(255, 0, 0, 255));
        EXPECT_THAT(test::pixel(rgba, 5, x, 1), ElementsAre(51, 102, 153, 204));
    }
    EXPECT_THAT(test::pixel(rgba, 5, 3, 2), ElementsAre(51, 102, 153, 204));
    EXPECT_THAT(test::pixel(rgba, 5, 4, 2), ElementsAre(0, 255, 0, 255));
}

/// Eight bits of all four channels, which RGB565 or RGBA4 would not keep.
TEST_F(FramebufferTest, KeepsEveryLevel) {
    const Framebuffer target(256, 1);
    const Program program =
        test::program_of("", "vec4(v_uv.x, 1.0 - v_uv.x, v_uv.x, 1.0 - v_uv.x) * (256.0 / 255.0) "
                             "- 0.5 / 255.0");
    program.use();
    Mesh(test::rectangle(-1, -1, 1, 1)).draw();
    const std::vector<std::uint8_t> rgba = target.read_rgba();
    for (int x = 0; x < 256; ++x)
        EXPECT_THAT(test::pixel(rgba, 256, x, 0), ElementsAre(x, 255 - x, x, 255 - x));
}

TEST_F(FramebufferTest, BindsWithItsOwnViewport) {
    const Framebuffer small(2, 3), large(7, 5);
    small.bind();
    GLint viewport[4] = {};
    glGetIntegerv(GL_VIEWPORT, viewport);
    EXPECT_THAT(viewport, ElementsAre(0, 0, 2, 3));
    clear_to(1, 1, 1, 1);
    large.bind();
    glGetIntegerv(GL_VIEWPORT, viewport);
    EXPECT_THAT(viewport, ElementsAre(0, 0, 7, 5));
    clear_to(0, 0, 0, 0);
    EXPECT_THAT(test::pixel(small.read_rgba(), 2, 1, 2), ElementsAre(255, 255, 255, 255));
}

/// A near rectangle, then a far one, and what is seen in the end.
std::vector<int> near_then_far(DepthBuffer depth) {
    const Framebuffer target(1, 1, depth);
    const Program program = test::program_of("uniform vec4 u_color;", "u_color");
    glEnable(GL_DEPTH_TEST);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    program.set("u_color", glm::vec4(1, 0, 0, 1));
    Mesh(test::rectangle(-1, -1, 1, 1, -0.5F)).draw();
    program.set("u_color", glm::vec4(0, 1, 0, 1));
    Mesh(test::rectangle(-1, -1, 1, 1, 0.5F)).draw();
    return test::pixel(target.read_rgba(), 1, 0, 0);
}

TEST_F(FramebufferTest, HidesWhatLiesBehindOnlyWithDepth) {
    EXPECT_THAT(near_then_far(DepthBuffer::depth16), ElementsAre(255, 0, 0, 255));
    EXPECT_THAT(near_then_far(DepthBuffer::none), ElementsAre(0, 255, 0, 255));
}

TEST_F(FramebufferTest, CanBeSampledAfterwards) {
    const Framebuffer map(2, 2, DepthBuffer::depth16, ColorBuffer::texture);
    clear_to(0.2F, 0.4F, 0.6F, 0.8F);
    const Framebuffer target(1, 1);
    const Program program = test::program_of("uniform sampler2D u_map;", "texture2D(u_map, v_uv).wzyx");
    program.set("u_map", 2);
    map.bind_texture(2);
    Mesh(test::rectangle(-1, -1, 1, 1)).draw();
    EXPECT_THAT(test::pixel(target.read_rgba(), 1, 0, 0), ElementsAre(204, 153, 102, 51));
}

TEST_F(FramebufferTest, IsNotSampledUnlessMadeForIt) {
    const Framebuffer target(3, 2);
    try {
        target.bind_texture(0);
        FAIL() << "not refused";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "cannot sample framebuffer 3x2: it was not made as a texture");
    }
}

TEST_F(FramebufferTest, RefusesSizes) {
    EXPECT_THAT(refusal(0, 4), MatchesRegex("cannot make framebuffer 0x4: sides must be 1 \\.\\. [0-9]+"));
    EXPECT_THAT(refusal(4, -1), MatchesRegex("cannot make framebuffer 4x-1: sides must be 1 \\.\\. [0-9]+"));
    EXPECT_THAT(refusal(1 << 20, 4), MatchesRegex("cannot make framebuffer 1048576x4: sides must be 1 .*"));
    EXPECT_EQ(refusal(6, 4, ColorBuffer::texture),
              "cannot make framebuffer 6x4: sides must be powers of two where it is sampled");
    EXPECT_EQ(refusal(6, 4), "not refused");
}

/// What the tests above saw once, seen on either kind of color buffer.
TEST_F(FramebufferTest, IsTheSameWithAndWithoutRgba8Renderbuffers) {
    for (const char* extensions : {static_cast<const char*>(nullptr), "none"}) {
        const test::Environment environment("METAMER_GL_EXTENSIONS", extensions);
        const Framebuffer target(5, 3, DepthBuffer::depth16);
        GLint kind = 0;
        glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                                              GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &kind);
        EXPECT_EQ(kind, extensions == nullptr ? GL_RENDERBUFFER : GL_TEXTURE);
        clear_to(0.2F, 0.4F, 0.6F, 0.8F);
        EXPECT_THAT(test::pixel(target.read_rgba(), 5, 4, 2), ElementsAre(51, 102, 153, 204));
    }
}

} // namespace
} // namespace metamer
