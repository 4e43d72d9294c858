#include "gles/draw_check.h"

#include <GLES2/gl2.h>
#include <cstdint>

#include "gl_test.h"
#include "gles/texture.h"

namespace metamer::test {
namespace {

class DrawCheck : public GlTest {
protected:
    static Program program(const std::string& body, const std::string& uniforms = {}) {
        const ShaderFiles files = files_of(
            {{"a.vert", "attribute vec3 a_position;\nvoid main() { gl_Position = vec4(a_position, 1.0); }\n"},
             {"a.frag", "precision mediump float;\n" + uniforms + "\nvoid main() { " + body + " }\n"}});
        return {compose_shader("a.vert", {}, files), compose_shader("a.frag", {}, files), kMeshAttributes};
    }
};

TEST_F(DrawCheck, SeesAProgramThatDraws) {
    EXPECT_TRUE(draws(program("gl_FragColor = vec4(0.0, 0.0, 0.0, 1.0);")));
}

// What a dropped draw leaves: nothing.
TEST_F(DrawCheck, SeesAProgramThatDrawsNothing) {
    EXPECT_FALSE(draws(program("discard;")));
}

// As in a kiosk that loads an exhibit anew in the midst of drawing: nothing of that tells of the program.
TEST_F(DrawCheck, SeesItWhateverIsBoundAndBlended) {
    const std::uint8_t clear[4] = {0, 0, 0, 0};
    const Texture nothing(1, 1, clear);
    nothing.bind(0);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ZERO, GL_ONE);
    EXPECT_TRUE(
        draws(program("gl_FragColor = texture2D(u_picture, vec2(0.5));", "uniform sampler2D u_picture;")));
    EXPECT_TRUE(glIsEnabled(GL_BLEND));
    nothing.bind(3);
    EXPECT_TRUE(draws(program("gl_FragColor = vec4(1.0);")));
    GLint unit = 0;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &unit);
    EXPECT_EQ(unit, GL_TEXTURE3);
    glActiveTexture(GL_TEXTURE0);
    glDisable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ZERO);
}

TEST_F(DrawCheck, LeavesTheStateAsItWas) {
    const Framebuffer target(8, 4);
    target.bind();
    glViewport(1, 2, 3, 1);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 1, 1);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_DITHER);
    glClearColor(0.25f, 0.5f, 0.75f, 1);
    const std::uint8_t white[4] = {255, 255, 255, 255};
    const Texture texture(1, 1, white);
    texture.bind(0);
    GLint bound_before = 0, bound_after = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound_before);
    GLint before = 0, after = 0, viewport[4];
    GLfloat clear[4];
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &before);
    EXPECT_TRUE(draws(program("gl_FragColor = vec4(1.0);"))) << "whatever the scissor";
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &after);
    glGetIntegerv(GL_VIEWPORT, viewport);
    glGetFloatv(GL_COLOR_CLEAR_VALUE, clear);
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound_after);
    EXPECT_EQ(bound_before, bound_after);
    EXPECT_EQ(before, after);
    EXPECT_EQ(viewport[0] * 1000 + viewport[1] * 100 + viewport[2] * 10 + viewport[3], 1231);
    EXPECT_EQ(clear[1], 0.5f);
    EXPECT_TRUE(glIsEnabled(GL_SCISSOR_TEST));
    EXPECT_FALSE(glIsEnabled(GL_DEPTH_TEST));
    EXPECT_TRUE(glIsEnabled(GL_DITHER));
    glDisable(GL_SCISSOR_TEST);
}

} // namespace
} // namespace metamer::test
