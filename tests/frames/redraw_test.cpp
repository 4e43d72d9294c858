// A renderer that stays: it draws what changed, all of it, and nothing else.
#include <GLES2/gl2.h>
#include <gtest/gtest.h>

#include "frames/frames.h"
#include "gles/framebuffer.h"
#include "render/frame_renderer.h"

namespace metamer {
namespace {

constexpr int kWidth = 96, kHeight = 54;

Exhibit small(const std::string& kind, const std::string& rest = "") {
    return exhibit_of("[display]\nwidth = 96\nheight = 54\n[scene]\nkind = " + kind +
                      "\n[lamp.1]\nspectrum = D65\n" + rest);
}

Image picture(FrameRenderer& renderer, const Framebuffer& target) {
    target.bind();
    renderer.draw(kWidth, kHeight);
    return {kWidth, kHeight, target.read_rgba()};
}

void change_lamp(Exhibit& exhibit, const char* name, double strength) {
    exhibit.lamps[0].lamp = find_lamp(name);
    exhibit.lamps[0].key = add_lamp(exhibit.atlas, exhibit.lamps[0].lamp);
    exhibit.lamps[0].strength = strength;
}

TEST(DrawIfChanged, DrawsOnceForEachChange) {
    const Surfaceless context;
    const Framebuffer target(kWidth, kHeight, DepthBuffer::depth16);
    Exhibit exhibit = small("loaf");
    FrameRenderer renderer(exhibit);
    target.bind();
    EXPECT_TRUE(renderer.draw_if_changed(kWidth, kHeight));
    glClearColor(1, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_FALSE(renderer.draw_if_changed(kWidth, kHeight));
    EXPECT_EQ(pixel({kWidth, kHeight, target.read_rgba()}, 48, 27), (EncodedRgb8{255, 0, 255}))
        << "untouched";
    EXPECT_TRUE(renderer.draw_if_changed(kWidth, kHeight - 2)) << "another size";
    EXPECT_TRUE(renderer.draw_if_changed(kWidth, kHeight - 2, 2)) << "another scale";
    EXPECT_FALSE(renderer.draw_if_changed(kWidth, kHeight - 2, 2));
    renderer.update();
    EXPECT_TRUE(renderer.draw_if_changed(kWidth, kHeight - 2, 2));
    EXPECT_FALSE(renderer.draw_if_changed(kWidth, kHeight - 2, 2));
}

// By every method and by the planner's own, in scenes that make it choose a constant, a table, taps.
TEST(Update, EqualsARendererMadeAfresh) {
    const Surfaceless context;
    const Framebuffer target(kWidth, kHeight, DepthBuffer::depth16);
    std::vector<MethodChoice> choices{MethodChoice()};
    for (const MethodInfo& info : kMethods)
        choices.emplace_back(info.method);
    for (const char* kind : {"loaf", "still-life", "corner", "media", "ramp"})
        for (const MethodChoice& choice : choices) {
            if (choice && std::string_view(kind) != "still-life")
                continue; // one scene for each method, each scene for the planner
            Exhibit exhibit = small(kind, std::string_view(kind) == "still-life"
                                              ? "shadow = yes\n[object.ball]\nkey_map = maps/beach-ball.png\n"
                                              : "");
            exhibit.accuracy.method = choice;
            SCOPED_TRACE(std::string(kind) + ' ' + (choice ? std::string(method_name(*choice)) : "auto"));
            FrameRenderer renderer(exhibit);
            const Image before = picture(renderer, target);
            change_lamp(exhibit, "F11", 0.6);
            renderer.update();
            const Image updated = picture(renderer, target);
            EXPECT_NE(updated.rgba, before.rgba);
            FrameRenderer fresh(exhibit);
            EXPECT_EQ(updated.rgba, picture(fresh, target).rgba);
        }
}

TEST(Update, TakesOverMethods) {
    const Surfaceless context;
    const Framebuffer target(kWidth, kHeight, DepthBuffer::depth16);
    Exhibit exhibit = small("crayons");
    change_lamp(exhibit, "F11", 1);
    exhibit.accuracy.method = Method::rgb;
    FrameRenderer renderer(exhibit);
    const Image before = picture(renderer, target);
    for (const Method method : {Method::packed, Method::spectral, Method::reduced, Method::folded}) {
        exhibit.accuracy.method = method;
        renderer.update();
        const Image updated = picture(renderer, target);
        EXPECT_NE(updated.rgba, before.rgba);
        FrameRenderer fresh(exhibit);
        EXPECT_EQ(updated.rgba, picture(fresh, target).rgba) << method_name(method);
    }
}

} // namespace
} // namespace metamer
