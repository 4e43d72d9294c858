// Colors of plots.
#pragma once

#include <string_view>

namespace metamer {

/// An sRGB color, 0..1.
struct Paint {
    double r = 0, g = 0, b = 0;
};

inline constexpr Paint kInk{0.13, 0.13, 0.15};      ///< titles
inline constexpr Paint kFaded{0.38, 0.38, 0.41};    ///< ticks, captions, notes
inline constexpr Paint kHairline{0.88, 0.88, 0.90}; ///< grids
inline constexpr int kColors = 8;

/// The i-th color, over again after kColors: six of Okabe and Ito's (2008, "Color Universal Design"; told
/// apart with any color vision; their yellow is left out, which is not seen on white), black, gray.
Paint series_paint(int index);

/// A little darker, for text: contrast to white of at least 4.5 (WCAG 2.1, 1.4.3).
Paint text_paint(Paint paint);

/// The index that a method has in every chart, by its first word; `planned` has folded's; kColors - 1, the
/// gray, for a name that is none.
int method_color(std::string_view method);

} // namespace metamer
