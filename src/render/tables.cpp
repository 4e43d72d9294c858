#include "render/tables.h"

#include <algorithm>
#include <cmath>

#include "render/variants.h"

namespace metamer {

namespace {

Image blank(int width, int height) {
    return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(4 * width * height), 255)};
}

std::uint8_t& byte(Image& image, int column, int row, std::size_t channel) {
    return image.rgba[static_cast<std::size_t>(4 * (row * image.width + column)) + channel];
}

// Three numbers over a range as two texels, `high_*` and `low_*`. Returns what rounding left over.
std::array<double, 3> put(Image& image, int high_column, int high_row, int low_column, int low_row,
                          const std::array<double, 3>& numbers, const std::array<double, 2>& range) {
    std::array<double, 3> left{};
    for (std::size_t c = 0; c < 3; ++c) {
        const auto [high, low] = two_bytes(range[1] > 0 ? (numbers[c] - range[0]) / range[1] : 0);
        byte(image, high_column, high_row, c) = high;
        byte(image, low_column, low_row, c) = low;
        left[c] = numbers[c] - (range[0] + range[1] * (256 * high + low) / 65535);
    }
    return left;
}

template <class Numbers>
std::array<double, 2> range_of(const Numbers& all) {
    double least = 0, most = 0;
    for (const auto& three : all)
        for (const double v : three) {
            least = std::min(least, v);
            most = std::max(most, v);
        }
    return {least, most - least};
}

} // namespace

std::array<std::uint8_t, 2> two_bytes(double share) {
    const auto code = static_cast<unsigned>(std::lround(std::clamp(share, 0.0, 1.0) * 65535));
    return {static_cast<std::uint8_t>(code >> 8), static_cast<std::uint8_t>(code & 255)};
}

Image product_table(Method method, const ExhibitSpectra& spectra, const OutputSpace& output) {
    Image out = blank(2, kAtlasSize);
    for (const int key : spectra.keys())
        put(out, 0, key, 1, key, material_numbers(method, *spectra.material(key).row, spectra.seen(), output),
            {kMaterialMapLeast, kMaterialMapSpan});
    return out;
}

Image scale_table(const Atlas& atlas) {
    Image out = blank(2, kAtlasSize);
    for (int key = 1; key <= kAtlasRows; ++key) {
        const double scale = atlas.materials[static_cast<std::size_t>(key)].scale;
        put(out, 0, key, 1, key, {scale, scale, scale}, {0, 1});
    }
    return out;
}

FoldedTable folded_table(const HalfView& view, const ExhibitSpectra& spectra) {
    const Matrix3 rgb_from_xyz = view.output.adapted_rgb_from_xyz();
    std::vector<std::vector<std::array<double, 3>>> colors(view.lamps.size());
    Pixel pixel = pixel_of(view);
    for (const int key : spectra.keys()) {
        pixel.material = spectra.material(key);
        const auto reflected = reflected_colors(pixel, spectra.exact(), rgb_from_xyz);
        for (std::size_t l = 0; l < reflected.size(); ++l)
            colors[l].push_back(reflected[l]);
    }
    FoldedTable out{blank(2 * kMostLamps, kAtlasSize), {}};
    for (std::size_t l = 0; l < colors.size(); ++l) {
        out.ranges.push_back(range_of(colors[l]));
        const int column = 2 * static_cast<int>(l);
        for (std::size_t k = 0; k < colors[l].size(); ++k)
            put(out.image, column, spectra.keys()[k], column + 1, spectra.keys()[k], colors[l][k],
                out.ranges[l]);
    }
    return out;
}

Image tap_reflectances(const ExhibitSpectra& spectra, const Taps& taps) {
    Image out = blank(kTapTableSize, kAtlasSize);
    for (const int key : spectra.keys())
        for (std::size_t i = 0; i < taps.wavelength_nm.size(); ++i) {
            const auto [high, low] = two_bytes(spectra.material(key).at(taps.wavelength_nm[i]));
            byte(out, static_cast<int>(i), key, 0) = high;
            byte(out, static_cast<int>(i), key, 1) = low;
        }
    return out;
}

TapTable tap_table(const std::vector<std::vector<std::array<double, 3>>>& colors,
                   const std::vector<double>& layers) {
    TapTable out{blank(kTapTableSize, kTapTableSize), {}, {}};
    for (std::size_t l = 0; l < colors.size(); ++l) {
        out.ranges.push_back(range_of(colors[l]));
        const int row = 2 * static_cast<int>(l);
        // What rounding leaves of one weight goes to the next, whose light is nearly the same: sums come out.
        std::array<double, 3> left{};
        for (std::size_t i = 0; i < colors[l].size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c)
                left[c] += colors[l][i][c];
            left =
                put(out.image, static_cast<int>(i), row, static_cast<int>(i), row + 1, left, out.ranges[l]);
        }
    }
    const auto [least, most] = std::minmax_element(layers.begin(), layers.end());
    out.layer_range = {std::min(*least, 0.0), std::max(*most, 0.0) - std::min(*least, 0.0)};
    for (std::size_t i = 0; i < layers.size(); ++i)
        put(out.image, static_cast<int>(i), 2 * kMostLamps, static_cast<int>(i), 2 * kMostLamps + 1,
            {layers[i], layers[i], layers[i]}, out.layer_range);
    return out;
}

Image packed_atlas(const Atlas& atlas) {
    Image out = blank(kPackedColumns, kPackedRows);
    const auto put_row = [&](int to, int from, AtlasChannel channel) {
        const AtlasRow values = atlas_row(atlas, from, channel);
        std::copy(values.begin(), values.end(),
                  out.rgba.begin() + static_cast<std::ptrdiff_t>(to * kPackedColumns * 4));
    };
    put_row(0, 0, AtlasChannel::lamp);
    put_row(1, 0, AtlasChannel::material);
    put_row(2, 0, AtlasChannel::excitation);
    for (int key = 1; key <= kAtlasRows; ++key) {
        put_row(kAtlasSize + key, key, AtlasChannel::lamp);
        put_row(2 * kAtlasSize + key, key, AtlasChannel::material);
    }
    return out;
}

Image dither_table() {
    Image out = blank(8, 8);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
            int rank = 0; // Bayer's matrix: bits of x ^ y and y, interleaved, most significant last
            for (int bit = 0; bit < 3; ++bit)
                rank |= ((((x ^ y) >> bit) & 1) << (5 - 2 * bit)) | (((y >> bit) & 1) << (4 - 2 * bit));
            for (std::size_t c = 0; c < 3; ++c)
                byte(out, x, y, c) = static_cast<std::uint8_t>(std::lround((rank + 0.5) / 64 * 255));
        }
    return out;
}

} // namespace metamer
