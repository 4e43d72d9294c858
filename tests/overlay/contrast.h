// What WCAG 2.1 says of the overlay's colors.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "color/transfer.h"
#include "overlay/theme.h"

namespace metamer {

/// Relative luminance of an sRGB color, 0 .. 1.
inline double relative_luminance(const Srgb& color) {
    // WCAG 2.1's threshold 0.03928 and IEC 61966-2-1's 0.04045 part no two of the 256 codes.
    const LinearRgb light = decode_rgb8(Transfer::srgb, {color[0], color[1], color[2]});
    return 0.2126 * light.r + 0.7152 * light.g + 0.0722 * light.b;
}

/// The contrast of two, 1 .. 21.
inline double contrast(const Srgb& a, const Srgb& b) {
    const std::pair<double, double> ends = std::minmax({relative_luminance(a), relative_luminance(b)});
    return (ends.second + 0.05) / (ends.first + 0.05);
}

/// A translucent ground over what lies under it.
inline Srgb over(const Srgb& ground, double alpha, const Srgb& under) {
    Srgb mixed{};
    for (std::size_t i = 0; i < 3; ++i)
        mixed[i] = static_cast<std::uint8_t>(std::lround(alpha * ground[i] + (1 - alpha) * under[i]));
    return mixed;
}

inline constexpr std::array<std::pair<const char*, Tone>, 8> kTones{{{"tile", kTileTone},
                                                                     {"chosen tile", kChosenTone},
                                                                     {"light button", kLightTone},
                                                                     {"mark", kMarkTone},
                                                                     {"panel", kPanelTone},
                                                                     {"plot", kPlotTone},
                                                                     {"label", kLabelTone},
                                                                     {"notice", kNoticeTone}}};

} // namespace metamer
