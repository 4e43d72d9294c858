// Every GL object goes with its owner, however often, and moves without being copied or lost.
#include <gtest/gtest.h>
#include <optional>

#include "gles/info.h"
#include "gles/mesh.h"
#include "gles/texture.h"
#include "gles2/gl_test.h"

namespace metamer {
namespace {

/// GL objects that are alive, by asking for every name that a small test can have been given.
int live_objects() {
    int count = 0;
    for (GLuint name = 1; name < 500; ++name)
        for (const auto is :
             {glIsBuffer, glIsFramebuffer, glIsProgram, glIsRenderbuffer, glIsShader, glIsTexture})
            count += is(name) == GL_TRUE ? 1 : 0;
    return count;
}

struct Everything {
    Program program = test::program_of("", "vec4(1.0)");
    Texture texture{2, 2, std::vector<std::uint8_t>(16), {.mipmaps = true}};
    Framebuffer target{3, 5, DepthBuffer::depth16};
    Framebuffer map{4, 4, DepthBuffer::depth16, ColorBuffer::texture};
    Mesh mesh{test::rectangle(-1, -1, 1, 1)};

    void draw() const {
        map.bind();
        program.use();
        texture.bind(0);
        mesh.draw();
        EXPECT_EQ(test::pixel(map.read_rgba(), 4, 3, 3), std::vector<int>(4, 255));
    }
};

using Lifetime = test::GlTest;

TEST_F(Lifetime, LeavesNothingAfterFiftyTimes) {
    const int before = live_objects();
    for (int i = 0; i < 50; ++i) {
        const Everything everything;
        everything.draw();
        ASSERT_GT(live_objects(), before);
    }
    glUseProgram(0); // a program in use outlives its deletion
    EXPECT_EQ(live_objects(), before);
}

TEST_F(Lifetime, MovesWithoutCopyOrLoss) {
    std::optional<Everything> first(std::in_place);
    const int one_set = live_objects();
    Everything second(std::move(*first));
    first.reset(); // what was moved away owns nothing
    EXPECT_EQ(live_objects(), one_set);
    second.draw();
    std::optional<Everything> third(std::in_place);
    EXPECT_GT(live_objects(), one_set);
    *third = std::move(second);
    EXPECT_EQ(live_objects(), one_set);
    third->draw();
    third.reset();
    glUseProgram(0); // a program in use outlives its deletion
    EXPECT_LT(live_objects(), one_set);
}

TEST_F(Lifetime, LeavesNothingWhereAConstructorThrows) {
    const int before = live_objects();
    EXPECT_ANY_THROW(test::program_of("", "lost"));
    EXPECT_ANY_THROW(test::program_of("varying vec2 v_lost;", "v_lost.xyxy"));
    EXPECT_ANY_THROW(Texture(3, 3, std::vector<std::uint8_t>(36)));
    EXPECT_ANY_THROW(Framebuffer(3, 3, DepthBuffer::depth16, ColorBuffer::texture));
    EXPECT_ANY_THROW(Mesh({std::vector<float>(kVertexFloats), {0, 0, 1}}));
    EXPECT_EQ(live_objects(), before);
}

TEST_F(Lifetime, LeavesNothingAfterMeasuring) {
    const int before = live_objects();
    gl_info();
    glUseProgram(0);
    EXPECT_EQ(live_objects(), before);
}

} // namespace
} // namespace metamer
