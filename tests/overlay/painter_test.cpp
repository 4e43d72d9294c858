#include "overlay/painter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "color/grid.h"
#include "overlay/contrast.h"
#include "overlay/layout.h"
#include "overlay/pixels.h"
#include "overlay/theme.h"

namespace metamer {
namespace {

constexpr double kUnit_px = 5;

Widget widget(Part part, int width_px, int height_px, const std::string& text) {
    Widget made;
    made.part = part;
    made.box = {300, 200, width_px, height_px};
    made.text = text;
    return made;
}

Bars bars_at(std::size_t first, std::size_t last) {
    Bars bars(kIntervals, 0.0F);
    for (std::size_t i = first; i <= last; ++i)
        bars[i] = 1;
    return bars;
}

const std::vector<Part>& parts() {
    static const std::vector<Part> all{Part::left_label,   Part::right_label, Part::split, Part::lamp,
                                       Part::lamp_right,   Part::strength,    Part::mode,  Part::language,
                                       Part::expert,       Part::panel,       Part::next,  Part::close,
                                       Part::expert_panel, Part::caption,     Part::hint,  Part::notice};
    return all;
}

Widget of_part(Part part) {
    Widget made = widget(part, 400, 200, "words");
    if (part == Part::panel)
        made.product =
            ProductPanel{"title",         "lamp",          "material",   "product",    bars_at(10, 40),
                         bars_at(20, 60), bars_at(20, 40), {10, 20, 30}, {40, 50, 60}, "left",
                         "right",         "same",          "0"};
    if (part == Part::expert_panel)
        made.expert = ExpertPanel{{{"Method", "folded"}, {"Tolerance", "0.5"}}};
    return made;
}

TEST(Painter, FillsTheBoxWithPremultipliedPixels) {
    for (const Part part : parts()) {
        const Picture picture = paint(of_part(part), kUnit_px);
        ASSERT_EQ(picture.width_px, 400);
        ASSERT_EQ(picture.height_px, 200);
        ASSERT_EQ(picture.rgba.size(), 400u * 200 * 4);
        int seen = 0;
        for_pixels(picture, [&](int, int, const Pixel& p) {
            seen += p.alpha > 200;
            ASSERT_LE(std::max({p.color[0], p.color[1], p.color[2]}), p.alpha);
        });
        EXPECT_GT(seen, 1000) << static_cast<int>(part);
        EXPECT_FALSE(picture.text_cut) << static_cast<int>(part);
    }
}

TEST(Painter, SameWidgetSamePicture) {
    for (const Part part : parts())
        EXPECT_EQ(paint(of_part(part), kUnit_px).rgba, paint(of_part(part), kUnit_px).rgba);
}

TEST(Painter, WordsAndFocusShowOnEveryWidget) {
    for (const Part part : parts()) {
        Widget focused = of_part(part);
        focused.focused = true;
        EXPECT_NE(paint(focused, kUnit_px).rgba, paint(of_part(part), kUnit_px).rgba)
            << static_cast<int>(part);
        if (part == Part::split || part == Part::panel || part == Part::next) // no words of their own
            continue;
        Widget other = of_part(part);
        other.text = "other";
        EXPECT_NE(paint(other, kUnit_px).rgba, paint(of_part(part), kUnit_px).rgba) << static_cast<int>(part);
    }
}

TEST(Painter, LettersStandOutFromTheirGround) {
    for (const Part part : {Part::left_label, Part::lamp, Part::strength, Part::mode, Part::language,
                            Part::close, Part::caption, Part::hint, Part::notice, Part::expert_panel}) {
        Widget made = of_part(part);
        made.box = {0, 0, 200, 60};
        const Picture picture = paint(made, kUnit_px);
        const Srgb ground = ground_of(picture);
        int letters = 0;
        for_pixels(picture, [&](int, int, const Pixel& p) {
            letters += p.alpha > 200 && !is_loud(p) && contrast(p.color, ground) >= 4.5;
        });
        EXPECT_GT(letters, 50) << static_cast<int>(part);
    }
}

TEST(Painter, ChosenIsToldByMoreThanHue) {
    for (const Part part : {Part::lamp, Part::lamp_right, Part::mode, Part::language, Part::expert}) {
        Widget on = widget(part, 100, 60, "");
        const Picture off_picture = paint(on, kUnit_px);
        on.on = true;
        const Picture picture = paint(on, kUnit_px);
        int brighter = 0;
        for_pixels(picture, [&](int x, int y, const Pixel& p) {
            brighter +=
                relative_luminance(p.color) > relative_luminance(pixel(off_picture, x, y).color) + 0.4;
        });
        // The frame alone has 2 x (100 + 60) x 2.5 px; the mark's disc some 100 more; corners are round.
        EXPECT_GT(brighter, 500) << static_cast<int>(part);
    }
}

TEST(Painter, SpectraHaveShortWavelengthsOnTheLeftInEveryLanguage) {
    for (const bool right_to_left : {false, true}) {
        Widget tile = widget(Part::lamp, 120, 70, "");
        tile.right_to_left = right_to_left;
        tile.bars = bars_at(6, 14);
        EXPECT_LT(mean_x(paint(tile, kUnit_px), is_loud), 0.3);
        tile.bars = bars_at(50, 58);
        EXPECT_GT(mean_x(paint(tile, kUnit_px), is_loud), 0.7);
    }
}

TEST(Painter, SpectrumIsAsHighAsItsValue) {
    const auto loud = [](float value) {
        Widget tile = widget(Part::lamp, 200, 100, "");
        tile.bars = Bars(kIntervals, value);
        int count = 0;
        for_pixels(paint(tile, kUnit_px), [&](int, int, const Pixel& p) { count += is_loud(p); });
        return count;
    };
    EXPECT_EQ(loud(0), 0);
    EXPECT_NEAR(static_cast<double>(loud(0.5F)) / loud(1), 0.5, 0.03);
    EXPECT_EQ(loud(7), loud(1));
    EXPECT_EQ(loud(std::numeric_limits<float>::quiet_NaN()), 0);
}

TEST(Painter, PlotsFollowTheDirectionOfReading) {
    Widget panel = of_part(Part::panel);
    panel.box = {0, 0, 800, 300};
    panel.product->material = panel.product->product = {};
    panel.product->lamp = bars_at(0, 63);
    EXPECT_LT(mean_x(paint(panel, kUnit_px), is_loud), 1.0 / 3);
    panel.right_to_left = true;
    EXPECT_GT(mean_x(paint(panel, kUnit_px), is_loud), 2.0 / 3);
}

TEST(Painter, PanelShowsBothColorsExactlyAndLeftStaysLeft) {
    for (const bool right_to_left : {false, true}) {
        Widget panel = of_part(Part::panel);
        panel.box = {0, 0, 800, 300};
        panel.right_to_left = right_to_left;
        const Srgb left{201, 77, 150}, right{33, 140, 95};
        panel.product->left = left;
        panel.product->right = right;
        const Picture picture = paint(panel, kUnit_px);
        const auto has = [](const Srgb& color) {
            return [color](const Pixel& p) { return p.color == color; };
        };
        const double left_x = mean_x(picture, has(left)), right_x = mean_x(picture, has(right));
        EXPECT_GT(left_x, 0);
        EXPECT_LT(left_x, right_x);
        EXPECT_EQ(right_to_left, right_x > 0.5);
    }
}

TEST(Painter, KnobStandsAtItsValueMirroredWhereReadingIs) {
    // With no words, the knob is the only thing so light.
    const auto knob_x = [](double value, bool right_to_left) {
        Widget slider = widget(Part::strength, 300, 50, "");
        slider.value = value;
        slider.right_to_left = right_to_left;
        const Picture picture = paint(slider, kUnit_px);
        double sum = 0, count = 0;
        const PxBox track = slider_track({0, 0, 300, 50}, kUnit_px);
        for_pixels(picture, [&](int x, int y, const Pixel& p) {
            const bool knob = p.color == kWarmWhite && y < track.top + track.height / 2;
            sum += knob ? x + 0.5 : 0;
            count += knob;
        });
        EXPECT_GT(count, 50);
        return sum / count;
    };
    for (const double value : {0.0, 0.3, 1.0})
        for (const bool right_to_left : {false, true})
            EXPECT_NEAR(slider_value({0, 0, 300, 50}, kUnit_px, right_to_left, knob_x(value, right_to_left)),
                        value, 0.01);
    EXPECT_NEAR(knob_x(-4, false), knob_x(0, false), 1e-9);
    EXPECT_NEAR(knob_x(std::nan(""), false), knob_x(0, false), 1e-9);
}

TEST(Painter, TextThatCannotFitIsCutAndToldSo) {
    const std::string lengthy(400, 'm');
    for (const Part part : {Part::left_label, Part::lamp, Part::strength, Part::mode, Part::language,
                            Part::close, Part::caption, Part::hint, Part::notice}) {
        Widget made = widget(part, 100, 50, lengthy);
        EXPECT_FALSE(text_fits(made, kUnit_px)) << static_cast<int>(part);
        made.text = "m";
        EXPECT_TRUE(text_fits(made, kUnit_px)) << static_cast<int>(part);
    }
    Widget expert = of_part(Part::expert_panel);
    for (int i = 0; i < 40; ++i)
        expert.expert->rows.push_back({"name", "value"});
    EXPECT_FALSE(text_fits(expert, kUnit_px));
}

// An error's cause is its end.
TEST(Painter, ANoticeThatIsCutKeepsItsEnd) {
    const auto picture = [](const std::string& cause) {
        std::string text = "Not taken over: kiosk.ini:12: ";
        for (int i = 0; i < 60; ++i)
            text += "long words ";
        return paint(widget(Part::notice, 500, 63, text + cause), kUnit_px);
    };
    EXPECT_TRUE(picture("no such file").text_cut);
    EXPECT_NE(picture("no such file").rgba, picture("is below 0").rgba);
}

TEST(Painter, ANoticeIsAsHighAsItsWords) {
    const auto height = [](const std::string& text) {
        int lowest = 0;
        for_pixels(paint(widget(Part::notice, 300, 63, text), kUnit_px),
                   [&](int, int y, const Pixel& p) { lowest = p.alpha > 200 ? y : lowest; });
        return lowest;
    };
    std::string four;
    for (int i = 0; i < 14; ++i)
        four += "four lines ";
    EXPECT_FALSE(paint(widget(Part::notice, 300, 63, four), kUnit_px).text_cut);
    EXPECT_GT(height(four), 55);
    EXPECT_LT(height("one line"), 35);
}

TEST(Painter, LettersShrinkBeforeTheyAreCut) {
    EXPECT_TRUE(text_fits(widget(Part::lamp, 100, 60, "Fluorescent tube"), kUnit_px));
    EXPECT_TRUE(text_fits(widget(Part::language, 60, 45, "Nederlands"), kUnit_px));
}

TEST(Painter, NothingWithoutABox) {
    const Picture picture = paint(widget(Part::lamp, 0, 0, "words"), kUnit_px);
    EXPECT_TRUE(picture.rgba.empty());
    EXPECT_FALSE(picture.text_cut);
}

TEST(Painter, BoxesOfAPixelAndTextThatIsNoTextAreSurvived) {
    for (const Part part : parts()) {
        Widget made = of_part(part);
        made.text = "broken \xFF\xFE text";
        made.focused = made.on = true;
        for (const int side : {1, 2, 7, 30}) {
            made.box = {0, 0, side, side};
            EXPECT_EQ(paint(made, kUnit_px).rgba.size(), static_cast<std::size_t>(4 * side * side));
        }
    }
    EXPECT_FALSE(paint(widget(Part::panel, 100, 100, ""), kUnit_px).rgba.empty());
    EXPECT_FALSE(paint(widget(Part::expert_panel, 100, 100, ""), kUnit_px).rgba.empty());
}

} // namespace
} // namespace metamer
