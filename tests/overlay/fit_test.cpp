// Every word of every language, on every screen.
#include <gtest/gtest.h>

#include <optional>

#include "overlay/contrast.h"
#include "overlay/painter.h"
#include "overlay/pixels.h"
#include "overlay/sample_screen.h"

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

    /// The first place on the shelf, once with every lamp's name, none chosen.
    std::vector<Widget> lamp_tiles(const Layout& layout) const {
        std::vector<Widget> tiles;
        for (const auto& [key, name] : words_.language(GetParam()).words)
            if (key.starts_with("lamp.")) {
                Widget& tile = tiles.emplace_back();
                tile.part = Part::lamp;
                tile.box = layout.lamps[0];
                tile.text = name;
                tile.right_to_left = words_.language(GetParam()).right_to_left;
            }
        return tiles;
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
        for (Widget& tile : lamp_tiles(layout)) {
            tile.on = true;
            EXPECT_TRUE(text_fits(tile, layout.unit_px)) << tile.text << " " << screen.width_px;
        }
    }
}

TEST_P(Fit, EveryLampOverItsSideOfTheBooth) {
    for (const ScreenSize& screen : screens()) {
        Contents contents;
        contents.lamps = 8;
        contents.languages = 6;
        contents.booth = true;
        const Layout layout = lay_out(screen, contents);
        for (const auto& [key, name] : words_.language(GetParam()).words)
            for (const char* said : {"booth.match", "booth.part", "half.lamp"}) {
                if (!key.starts_with("lamp."))
                    continue;
                Widget label;
                label.part = Part::right_label;
                label.box = layout.right_label;
                label.text = words_.text(GetParam(), said, {{"lamp", name}});
                label.right_to_left = words_.language(GetParam()).right_to_left;
                EXPECT_TRUE(text_fits(label, layout.unit_px)) << label.text << " " << screen.width_px;
            }
    }
}

// Halves that differ in their methods or strengths only.
TEST_P(Fit, EveryMethodAndStrengthOverItsHalf) {
    std::vector<std::string> names{words_.text(GetParam(), "slider.strength", {{"factor", "0.05"}})};
    for (const char* method :
         {"rgb", "tristimulus", "spectral", "prefiltered", "packed", "reduced", "folded"})
        names.push_back(words_.text(GetParam(), std::string("method.") + method));
    for (const ScreenSize& screen : screens()) {
        Sample sample;
        sample.screen = screen;
        sample.language = GetParam();
        sample.contents.lamps = 12;
        SampleScreen whole = sample_screen(words_, sample);
        for (Widget& widget : whole.widgets)
            for (const std::string& name : names) {
                if (widget.part != Part::left_label && widget.part != Part::right_label)
                    continue;
                widget.text = name;
                EXPECT_TRUE(text_fits(widget, whole.layout.unit_px)) << said(sample) << " " << name;
            }
    }
}

/// The rows of a tile that its name's letters stand in.
std::pair<int, int> rows_of_name(const Widget& tile, double unit_px) {
    const Picture picture = paint(tile, unit_px);
    const Srgb ground = pixel(picture, picture.width_px / 2, static_cast<int>(0.8 * unit_px)).color;
    std::pair<int, int> rows{-1, -1};
    const int edge = static_cast<int>(unit_px);
    for (int y = edge; y < 0.46 * picture.height_px; ++y)
        for (int x = edge; x < picture.width_px - edge; ++x)
            if (contrast(pixel(picture, x, y).color, ground) > 4.5)
                rows = {rows.first < 0 ? y : rows.first, y};
    return rows;
}

TEST_P(Fit, ALampsNameStaysWhereItIsWhenItIsChosen) {
    for (const ScreenSize& screen :
         {ScreenSize{640, 480, 0}, {800, 480, 5.2}, {1280, 720, 0}, {1920, 1080, 0}}) {
        Contents contents;
        contents.lamps = 8;
        contents.languages = 6;
        const Layout layout = lay_out(screen, contents);
        for (Widget& tile : lamp_tiles(layout)) {
            const auto plain = rows_of_name(tile, layout.unit_px);
            tile.on = true;
            const auto chosen = rows_of_name(tile, layout.unit_px);
            const double slack = 0.5 * layout.unit_px; // bold letters are a little higher
            EXPECT_NEAR(plain.first, chosen.first, slack) << tile.text << " " << screen.width_px;
            EXPECT_NEAR(plain.second, chosen.second, slack) << tile.text << " " << screen.width_px;
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
            sample.glass = !sample.glass;
            expect_fits(sample, Part::panel);
        }
        for (const char* method : {"rgb", "tristimulus", "spectral", "prefiltered", "packed", "reduced"})
            for (const char* ground : {"asked", "constant", "table", "product", "taps", "medium", "all"}) {
                sample.method = method;
                sample.ground = ground;
                expect_fits(sample, Part::expert_panel);
            }
        sample.contents = {12, 6, false, false, false, true, true, false, false};
        for (const char* key :
             {"hint.start", "hint.methods", "hint.objects", "hint.booth", "booth.match", "booth.part"}) {
            SampleScreen whole = sample_screen(words_, sample);
            for (Widget& widget : whole.widgets)
                if (widget.part == Part::hint || widget.part == Part::caption) {
                    widget.text = words_.text(
                        GetParam(), key, {{"lamp", words_.name_of(GetParam(), "lamp", "NIST-MH-MHC100-4K")}});
                    EXPECT_TRUE(text_fits(widget, whole.layout.unit_px)) << said(sample) << " " << key;
                }
        }
    }
}

TEST_P(Fit, PanelLeavesItsCornerToItsButtons) {
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
            for (PxBox button : {whole.layout.close, whole.layout.next}) {
                button.left -= widget.box.left;
                button.top -= widget.box.top;
                const Pixel ground = pixel(picture, button.left, button.top);
                int written = 0;
                for (int y = button.top; y < button.bottom(); ++y)
                    for (int x = button.left; x < button.right(); ++x)
                        written += contrast(pixel(picture, x, y).color, ground.color) > 2;
                EXPECT_EQ(written, 0) << said(sample);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Languages, Fit, testing::Values("en", "ar", "de", "es", "fr", "ja"),
                         [](const auto& language) { return language.param; });

} // namespace
} // namespace metamer
