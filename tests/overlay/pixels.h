// Looking at pictures.
#pragma once

#include <functional>
#include <map>

#include "overlay/painter.h"
#include "overlay/theme.h"

namespace metamer {

/// Whether every text of the widget stands there whole.
inline bool text_fits(const Widget& widget, double unit_px) {
    return !paint(widget, unit_px).text_cut;
}

struct Pixel {
    Srgb color;
    std::uint8_t alpha;
};

inline Pixel pixel(const Picture& picture, int x, int y) {
    const auto* at = &picture.rgba[static_cast<std::size_t>(4 * (y * picture.width_px + x))];
    return {{at[0], at[1], at[2]}, at[3]};
}

inline void for_pixels(const Picture& picture, const std::function<void(int, int, const Pixel&)>& look) {
    for (int y = 0; y < picture.height_px; ++y)
        for (int x = 0; x < picture.width_px; ++x)
            look(x, y, pixel(picture, x, y));
}

/// The color that most pixels have.
inline Srgb ground_of(const Picture& picture) {
    std::map<Srgb, int> counts;
    for_pixels(picture, [&](int, int, const Pixel& p) { counts[p.color] += p.alpha > 200; });
    Srgb most{};
    int count = -1;
    for (const auto& [color, times] : counts)
        if (times > count) {
            most = color;
            count = times;
        }
    return most;
}

/// Loud: no gray, no ink of the theme; the colors of spectra.
inline bool is_loud(const Pixel& p) {
    const auto [least, most] = std::minmax({p.color[0], p.color[1], p.color[2]});
    return most > 140 && least < 30;
}

/// The mean column of the pixels chosen, as a share of the width; -1 for none.
inline double mean_x(const Picture& picture, const std::function<bool(const Pixel&)>& chosen) {
    double sum = 0;
    int count = 0;
    for_pixels(picture, [&](int x, int, const Pixel& p) {
        if (chosen(p)) {
            sum += x + 0.5;
            ++count;
        }
    });
    return count == 0 ? -1 : sum / count / picture.width_px;
}

} // namespace metamer
