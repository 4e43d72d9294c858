#include "render/surface_maps.h"

#include <algorithm>
#include <cmath>

namespace metamer {

namespace {

Image single_pixel(std::uint8_t r, std::uint8_t g, std::uint8_t b) {
    return {1, 1, {r, g, b, 255}};
}

// Pictures begin at the top, texture coordinates at the bottom.
Texture upload(const Image& image, Filter filter) {
    std::vector<std::uint8_t> flipped;
    flipped.reserve(image.rgba.size());
    const auto row_bytes = static_cast<std::ptrdiff_t>(image.width) * 4;
    for (auto row = image.rgba.end(); row != image.rgba.begin(); row -= row_bytes)
        flipped.insert(flipped.end(), row - row_bytes, row);
    return {image.width,
            image.height,
            flipped,
            {filter, Wrap::repeat, filter == Filter::linear && image.width > 1}};
}

// Keys are names, not amounts: they must not be filtered. Heights and luminances may.
Image key_image(const ObjectSetting& object) {
    return object.key_map ? *object.key_map
                          : single_pixel(static_cast<std::uint8_t>(object.material.key), 0, 0);
}

Image luminance_image(const ObjectSetting& object) {
    return object.luminance_map ? *object.luminance_map : single_pixel(255, 255, 255);
}

Image normal_image(const ObjectSetting& object) {
    return object.bump_map ? normal_map(*object.bump_map, object.bump) : single_pixel(128, 128, 255);
}

} // namespace

Image normal_map(const Image& heights, double height) {
    Image out{heights.width, heights.height, std::vector<std::uint8_t>(heights.rgba.size(), 255)};
    const auto at = [&](int x, int y) {
        const int wx = (x + heights.width) % heights.width, wy = (y + heights.height) % heights.height;
        return heights.rgba[static_cast<std::size_t>(4 * (wy * heights.width + wx))] / 255.0;
    };
    const double scale = height * heights.width / 2; // a central difference spans two texels
    for (int y = 0; y < heights.height; ++y)
        for (int x = 0; x < heights.width; ++x) {
            const double dx = scale * (at(x + 1, y) - at(x - 1, y)),
                         dy = scale * (at(x, y - 1) - at(x, y + 1)); // t grows upwards
            const double length = std::sqrt(dx * dx + dy * dy + 1);
            const auto code = [&](double v) {
                return static_cast<std::uint8_t>(std::lround(128 + 127 * v / length));
            };
            auto* pixel = &out.rgba[static_cast<std::size_t>(4 * (y * heights.width + x))];
            pixel[0] = code(-dx);
            pixel[1] = code(-dy);
            pixel[2] = code(1);
        }
    return out;
}

SurfaceMaps::SurfaceMaps(const ObjectSetting& object)
    : keys_(upload(key_image(object), Filter::nearest)),
      luminance_(upload(luminance_image(object), Filter::linear)),
      normals_(upload(normal_image(object), Filter::linear)) {}

void SurfaceMaps::bind(int key_unit, int luminance_unit, int normal_unit) const {
    keys_.bind(key_unit);
    luminance_.bind(luminance_unit);
    normals_.bind(normal_unit);
}

} // namespace metamer
