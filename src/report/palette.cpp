#include "report/palette.h"

#include <array>
#include <cmath>

namespace metamer {

namespace {

constexpr Paint from_hex(unsigned rgb) {
    return {(rgb >> 16) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0};
}

constexpr std::array<Paint, kColors> kPaints{from_hex(0x1A1A1A), from_hex(0xE69F00), from_hex(0xD55E00),
                                             from_hex(0xCC79A7), from_hex(0x56B4E9), from_hex(0x0072B2),
                                             from_hex(0x009E73), from_hex(0x808080)};

constexpr std::array<std::string_view, kColors - 1> kMethodOrder{
    "rgb", "tristimulus", "spectral", "prefiltered", "packed", "reduced", "folded"};

// WCAG 2.1, relative luminance.
double luminance(Paint p) {
    const auto linear = [](double v) {
        return v <= 0.03928 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(p.r) + 0.7152 * linear(p.g) + 0.0722 * linear(p.b);
}

} // namespace

Paint series_paint(int index) {
    return kPaints[static_cast<std::size_t>(((index % kColors) + kColors) % kColors)];
}

Paint text_paint(Paint paint) {
    while (1.05 / (luminance(paint) + 0.05) < 4.5)
        paint = {paint.r * 0.95, paint.g * 0.95, paint.b * 0.95};
    return paint;
}

int method_color(std::string_view method) {
    method = method.substr(0, method.find(' ')); // `reduced 8`
    if (method == "planned")
        method = "folded"; // which it is wherever light stays linear
    for (std::size_t i = 0; i < kMethodOrder.size(); ++i)
        if (kMethodOrder[i] == method)
            return static_cast<int>(i);
    return kColors - 1;
}

} // namespace metamer
