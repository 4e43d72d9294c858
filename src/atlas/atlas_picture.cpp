#include "atlas/atlas_picture.h"

#include <algorithm>

#include "color/observer.h"
#include "color/transfer.h"
#include "color/working_space.h"

namespace metamer {

namespace {

constexpr int kBar = 7;     // px, one interval
constexpr int kStrip = 12;  // px, full height
constexpr int kPitch = 14;  // px, strip to strip
constexpr int kMargin = 8;  // px
constexpr int kMiddle = 16; // px, lamps to materials
constexpr int kHalf = kBar * static_cast<int>(kIntervals);
constexpr EncodedRgb8 kBackground{20, 20, 20};
constexpr EncodedRgb8 kStripBackground{44, 44, 44};

using Colors = std::array<EncodedRgb8, kIntervals>;

// The wavelengths' colors lie outside sRGB: clipped to it, then scaled so that the greatest of the three
// is 1.
Colors wavelength_colors() {
    const GridObserver exact = sampled_observer();
    const Matrix3 rgb_from = rgb_from_xyz(working_spaces().front());
    Colors colors;
    for (std::size_t i = 0; i < kIntervals; ++i) {
        LinearRgb c = to_linear_rgb(rgb_from, Xyz{exact.x[i], exact.y[i], exact.z[i]});
        const double most = std::max({c.r, c.g, c.b});
        c = {std::max(c.r, 0.0) / most, std::max(c.g, 0.0) / most, std::max(c.b, 0.0) / most};
        colors[i] = encode_rgb8(Transfer::srgb, c);
    }
    return colors;
}

void set(Image& image, int x, int y, const EncodedRgb8& c) {
    const auto at = static_cast<std::size_t>((y * image.width + x) * 4);
    image.rgba[at] = c.r;
    image.rgba[at + 1] = c.g;
    image.rgba[at + 2] = c.b;
    image.rgba[at + 3] = 255;
}

void fill(Image& image, int left, int top, int width, int height, const EncodedRgb8& c) {
    for (int y = top; y < top + height; ++y)
        for (int x = left; x < left + width; ++x)
            set(image, x, y, c);
}

int bar_height(std::uint8_t value) {
    return (value * kStrip + 127) / 255;
}

void draw_strip(Image& image, int left, int row, const Atlas& atlas, AtlasChannel channel,
                const Colors& colors) {
    const int top = kMargin + row * kPitch;
    fill(image, left, top, kHalf, kStrip, kStripBackground);
    for (std::size_t i = 0; i < kIntervals; ++i) {
        const int height = bar_height(atlas.rgba[atlas_byte(row, i, channel)]);
        fill(image, left + kBar * static_cast<int>(i), top + kStrip - height, kBar, height, colors[i]);
    }
}

void draw_observer(Image& image, const Atlas& atlas, const Colors& colors) {
    for (std::size_t i = 0; i < kIntervals; ++i) {
        const int x = kMargin + kBar * static_cast<int>(i);
        const auto lit = [&](AtlasChannel channel, int y) -> std::uint8_t {
            return kStrip - y <= bar_height(atlas.rgba[atlas_byte(0, i, channel)]) ? 255 : 44;
        };
        for (int y = 0; y < kStrip; ++y)
            fill(image, x, kMargin + y, kBar, 1,
                 {lit(AtlasChannel::lamp, y), lit(AtlasChannel::material, y),
                  lit(AtlasChannel::excitation, y)});
        fill(image, x + kHalf + kMiddle, kMargin, kBar, kStrip, colors[i]);
    }
}

int last_row(const Atlas& atlas) {
    int last = 0;
    for (int row = 1; row <= kAtlasRows; ++row) {
        const auto at = static_cast<std::size_t>(row);
        if (!atlas.lamps[at].name.empty() || !atlas.materials[at].name.empty())
            last = row;
    }
    return last;
}

} // namespace

Image picture(const Atlas& atlas) {
    const int last = last_row(atlas);
    Image image;
    image.width = 2 * (kMargin + kHalf) + kMiddle;
    image.height = 2 * kMargin + kPitch * last + kStrip;
    image.rgba.resize(static_cast<std::size_t>(image.width * image.height * 4));
    fill(image, 0, 0, image.width, image.height, kBackground);
    const Colors colors = wavelength_colors();
    draw_observer(image, atlas, colors);
    for (int row = 1; row <= last; ++row) {
        const auto at = static_cast<std::size_t>(row);
        if (!atlas.lamps[at].name.empty())
            draw_strip(image, kMargin, row, atlas, AtlasChannel::lamp, colors);
        if (!atlas.materials[at].name.empty())
            draw_strip(image, kMargin + kHalf + kMiddle, row, atlas, AtlasChannel::material, colors);
    }
    return image;
}

} // namespace metamer
