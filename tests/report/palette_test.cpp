#include "report/palette.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace metamer {
namespace {

// WCAG 2.1: relative luminance; contrast to white.
double contrast_to_white(Paint p) {
    const auto linear = [](double v) {
        return v <= 0.03928 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 1.05 / (0.2126 * linear(p.r) + 0.7152 * linear(p.g) + 0.0722 * linear(p.b) + 0.05);
}

TEST(TextPaint, CanBeReadOnWhite) {
    for (int i = 0; i < kColors; ++i)
        EXPECT_GE(contrast_to_white(text_paint(series_paint(i))), 4.5) << i;
    EXPECT_EQ(text_paint(series_paint(0)).r, series_paint(0).r) << "what is dark enough stays";
}

TEST(SeriesPaint, ComesAgainAfterTheLast) {
    EXPECT_EQ(series_paint(kColors + 2).r, series_paint(2).r);
    EXPECT_EQ(series_paint(-1).g, series_paint(kColors - 1).g);
}

TEST(MethodColor, IsEachMethodsOwn) {
    std::set<int> colors;
    for (const char* method :
         {"rgb", "tristimulus", "spectral", "prefiltered", "packed", "reduced", "folded", "other"})
        colors.insert(method_color(method));
    EXPECT_EQ(colors.size(), 8u);
}

} // namespace
} // namespace metamer
