#include "window/surfaceless_stage.h"

#include <GLES2/gl2.h>
#include <gmock/gmock.h>
#include <thread>

#include "window/event_text.h"

namespace metamer {
namespace {

using test::texts;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(SurfacelessStage, SaysWhatItIs) {
    SurfacelessStage stage(80, 48, 90, 6);
    EXPECT_EQ(stage.surface_width_px(), 80);
    EXPECT_EQ(stage.surface_height_px(), 48);
    EXPECT_EQ(stage.rotation_deg(), 90);
    EXPECT_EQ(stage.px_per_mm(), 6);
    EXPECT_EQ(stage.driver(), "surfaceless");
    EXPECT_FALSE(stage.context_lost());
}

TEST(SurfacelessStage, TimeIsWhatItWaits) {
    SurfacelessStage stage(8, 8);
    EXPECT_EQ(stage.now_s(), 0);
    EXPECT_THAT(stage.wait(2.5), IsEmpty());
    EXPECT_EQ(stage.now_s(), 2.5);
    EXPECT_THAT(stage.wait(-1), IsEmpty());
    EXPECT_THAT(stage.wait(0), IsEmpty());
    EXPECT_EQ(stage.now_s(), 2.5);
    stage.advance(0.25);
    EXPECT_EQ(stage.now_s(), 2.75);
}

TEST(SurfacelessStage, EventsComeInOrderAndTakeNoTime) {
    SurfacelessStage stage(8, 8);
    stage.post(KeyEvent{Key::left});
    stage.post(QuitEvent{});
    EXPECT_THAT(texts(stage.wait(10)), ElementsAre("key left", "quit"));
    EXPECT_EQ(stage.now_s(), 0);
    EXPECT_THAT(stage.wait(10), IsEmpty());
}

TEST(SurfacelessStage, TheScriptIsAskedWhenNothingIsThere) {
    SurfacelessStage stage(8, 8);
    int asked = 0;
    stage.on_idle([&] {
        if (++asked == 2)
            stage.post(ReloadEvent{});
    });
    stage.post(ExposeEvent{});
    EXPECT_THAT(texts(stage.wait(1)), ElementsAre("expose"));
    EXPECT_EQ(asked, 0);
    EXPECT_THAT(stage.wait(1), IsEmpty());
    EXPECT_EQ(stage.now_s(), 1);
    EXPECT_THAT(texts(stage.wait(1)), ElementsAre("reload"));
    EXPECT_EQ(stage.now_s(), 1);
}

TEST(SurfacelessStage, PostsFromOtherThreads) {
    SurfacelessStage stage(8, 8);
    constexpr int kEach = 1000;
    const auto post = [&] {
        for (int i = 0; i < kEach; ++i)
            stage.post(FilesChangedEvent{});
    };
    std::thread one(post), other(post);
    std::size_t taken = 0;
    for (int i = 0; i < kEach; ++i)
        taken += stage.wait(0).size();
    one.join();
    other.join();
    EXPECT_EQ(taken + stage.wait(0).size(), 2U * kEach);
}

TEST(SurfacelessStage, KeepsWhatWasDrawn) {
    SurfacelessStage stage(4, 2);
    stage.bind();
    glClearColor(1, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 1, 4, 1); // the upper row
    glClearColor(0, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    EXPECT_EQ(stage.frames_shown(), 0);
    stage.show();
    EXPECT_EQ(stage.frames_shown(), 1);
    const std::vector<std::uint8_t> rgba = stage.read_rgba();
    ASSERT_EQ(rgba.size(), 4U * 2 * 4);
    EXPECT_EQ(std::vector<int>(rgba.begin(), rgba.begin() + 4), (std::vector{0, 255, 0, 255}));
    EXPECT_EQ(std::vector<int>(rgba.end() - 4, rgba.end()), (std::vector{255, 0, 0, 255}));
}

TEST(SurfacelessStage, HasDepth) {
    SurfacelessStage stage(4, 2);
    stage.bind();
    GLint bits = 0;
    glGetIntegerv(GL_DEPTH_BITS, &bits);
    EXPECT_GE(bits, 16);
}

TEST(SurfacelessStage, ResizesAndSaysSoAsPeopleSeeIt) {
    SurfacelessStage stage(80, 48, 270);
    stage.resize(64, 32);
    EXPECT_EQ(stage.surface_width_px(), 64);
    EXPECT_THAT(texts(stage.wait(0)), ElementsAre("resize 32x64"));
    stage.bind();
    GLint viewport[4] = {};
    glGetIntegerv(GL_VIEWPORT, viewport);
    EXPECT_THAT(viewport, ElementsAre(0, 0, 64, 32));
    EXPECT_EQ(stage.read_rgba().size(), 64U * 32 * 4);
}

TEST(SurfacelessStage, HangsAsItIsTold) {
    SurfacelessStage stage(300, 400, 0, 7);
    stage.hang(270, 5);
    EXPECT_EQ(stage.rotation_deg(), 270);
    EXPECT_DOUBLE_EQ(stage.px_per_mm(), 500 / (5 * 25.4));
    stage.hang(0, 0);
    EXPECT_EQ(stage.px_per_mm(), 7) << "as it says itself";
}

TEST(SurfacelessStage, ALostContextIsToldOnceUntilItIsRebuilt) {
    SurfacelessStage stage(8, 8);
    for (int i = 0; i < 3; ++i) {
        stage.bind();
        GLuint texture = 0;
        glGenTextures(1, &texture);
        glBindTexture(GL_TEXTURE_2D, texture);
        EXPECT_TRUE(glIsTexture(texture));
        stage.lose_context();
        EXPECT_TRUE(stage.context_lost());
        EXPECT_THAT(texts(stage.wait(0)), ElementsAre("context lost"));
        EXPECT_THAT(stage.wait(0), IsEmpty());
        EXPECT_TRUE(stage.rebuild());
        EXPECT_FALSE(stage.context_lost());
        EXPECT_FALSE(glIsTexture(texture)); // another context
        stage.bind();
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    }
}

TEST(SurfacelessStage, GivesUpWhereTheDisplayIsLost) {
    SurfacelessStage stage(8, 8);
    stage.lose_context();
    stage.lose_display();
    EXPECT_FALSE(stage.rebuild());
    EXPECT_TRUE(stage.context_lost());
}

} // namespace
} // namespace metamer
