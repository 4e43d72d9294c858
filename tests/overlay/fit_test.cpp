// Every word of every language, on every screen.
#include <gtest/gtest.h>

#include <optional>

#include "overlay/painter.h"
#include "overlay/sample_screen.h"
#include "pixels.h"

namespace metamer {
namespace {

const std::vector<ScreenSize>& screens() {
    static const std::vector<ScreenSize> all{
        {640, 480, 0}, {480, 640, 0}, {800, 480, 5.2}, {480, 800, 5.2}, {1280, 720, 0}, {720, 1280, 0},
    };
    return all;
}

std::string said(const Sample& sample) {
    return sample.language + " at " + std::to_string(sample.screen.width_px) + "x" +
           std::to_string(sample.screen.height_px);
}

class Fit : public testing::TestWithParam<std::string> {
protected:
    void expect_fits(const Sample& sample, std::optional<Part> only = {}) const {
        const SampleScreen screen = sample_screen(words_, sample);
        for (const Widget& widget : screen.widgets)
            if (!only || widget.part == *only) {
                EXPECT_TRUE(text_fits(widget, screen.layout.unit_px))
                    << said(sample) << ", part " << static_cast<int>(widget.part) << ": " << widget.text;
            }
    }

    Words words_;
};

TEST_P(Fit, EveryWidgetOnEveryScreen) {
    for (const ScreenSize& screen : screens())
        for (const bool booth : {false, true}) {
            Sample sample;
            sample.screen = screen;
            sample.language = GetParam();
            sample.contents.lamps = booth ? 8 : 12;
            sample.contents.booth = booth;
            sample.contents.expert = sample.contents.panel = sample.contents.notice = true;
            expect_fits(sample);
            sample.contents.panel = sample.contents.expert = false;
            sample.contents.hint = sample.contents.caption = true;
            expect_fits(sample);
        }
}

TEST_P(Fit, EveryLampOnItsTile) {
    for (const ScreenSize& screen : screens()) {
        Contents contents;
        contents.lamps = 12;
        contents.languages = 6;
        const Layout layout = lay_out(screen, contents);
        for (const auto& [key, name] : words_.language(GetParam()).words) {
            if (!key.starts_with("lamp."))
                continue;
            Widget tile;
            tile.part = Part::lamp;
            tile.box = layout.lamps[0];
            tile.text = name;
            tile.on = true;
            tile.right_to_left = words_.language(GetParam()).right_to_left;
            EXPECT_TRUE(text_fits(tile, layout.unit_px)) << key << " " << name << " " << screen.width_px;
        }
    }
}

TEST_P(Fit, EveryDifferenceMethodAndHintInItsPlace) {
    for (const ScreenSize& screen : screens()) {
        Sample sample;
        sample.screen = screen;
        sample.language = GetParam();
        sample.contents.lamps = 12;
        sample.contents.panel = sample.contents.expert = true;
        for (const double delta_e : {0.5, 1.5, 3.0, 7.0, 20.0}) {
            sample.difference = std::string(difference_key(delta_e));
            expect_fits(sample, Part::panel);
        }
        for (const char* method : {"rgb", "tristimulus", "spectral", "prefiltered", "packed", "reduced"}) {
            sample.method = method;
            expect_fits(sample, Part::expert_panel);
        }
        sample.contents = {12, 6, false, false, false, true, true, false, false};
        for (const char* key : {"hint.start", "hint.methods", "hint.booth", "booth.match", "booth.part"}) {
            SampleScreen whole = sample_screen(words_, sample);
            for (Widget& widget : whole.widgets)
                if (widget.part == Part::hint || widget.part == Part::caption) {
                    widget.text = words_.text(GetParam(), key);
                    EXPECT_TRUE(text_fits(widget, whole.layout.unit_px)) << said(sample) << " " << key;
                }
        }
    }
}

TEST_P(Fit, PanelLeavesItsCornerToTheCloseButton) {
    for (const ScreenSize& screen : screens()) {
        Sample sample;
        sample.screen = screen;
        sample.language = GetParam();
        sample.contents.lamps = 9;
        sample.contents.panel = true;
        const SampleScreen whole = sample_screen(words_, sample);
        for (const Widget& widget : whole.widgets) {
            if (widget.part != Part::panel)
                continue;
            Widget lengthy = widget; // reaches as far as the panel lets it
            for (int i = 0; i < 4; ++i)
                lengthy.product->difference += " " + widget.product->difference;
            const Picture picture = paint(lengthy, whole.layout.unit_px);
            PxBox close = whole.layout.close;
            close.left -= widget.box.left;
            close.top -= widget.box.top;
            const Pixel ground = pixel(picture, close.left, close.top);
            int written = 0;
            for (int y = close.top; y < close.bottom(); ++y)
                for (int x = close.left; x < close.right(); ++x)
                    written += contrast(pixel(picture, x, y).color, ground.color) > 2;
            EXPECT_EQ(written, 0) << said(sample);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Languages, Fit, testing::Values("en", "ar", "de", "es", "fr", "ja"),
                         [](const auto& language) { return language.param; });

} // namespace
} // namespace metamer
