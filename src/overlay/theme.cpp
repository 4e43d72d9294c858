#include "overlay/theme.h"

#include <algorithm>
#include <cmath>

#include "color/observer.h"
#include "color/transfer.h"
#include "color/working_space.h"

namespace metamer {

namespace {

Srgb wavelength_color(const ColorMatching& light, double dimmed, const Matrix3& rgb_from_xyz) {
    const LinearRgb hue = to_linear_rgb(rgb_from_xyz, Xyz{light.x, light.y, light.z});
    const double scale = dimmed / std::max({hue.r, hue.g, hue.b});
    const EncodedRgb8 code =
        encode_rgb8(Transfer::srgb, LinearRgb{scale * hue.r, scale * hue.g, scale * hue.b});
    return {code.r, code.g, code.b};
}

} // namespace

const std::vector<Srgb>& wavelength_colors() {
    static const std::vector<Srgb> colors = [] {
        // Shares of full light at both ends of the grid, and how far from there it is full.
        constexpr double kLeast = 0.35, kFullAfter_nm = 45;
        const Matrix3 rgb_from_xyz = metamer::rgb_from_xyz(working_spaces()[0]);
        std::vector<Srgb> found;
        for (std::size_t i = 0; i < kIntervals; ++i) {
            const double nm = kThesisGrid.wavelength_nm(i);
            const double from_end_nm = std::min(nm - kThesisGrid.first_nm, kThesisGrid.last_nm() - nm);
            const double dimmed = kLeast + (1 - kLeast) * std::min(from_end_nm / kFullAfter_nm, 1.0);
            const auto row = static_cast<std::size_t>(nm - kReferenceGrid.first_nm);
            found.push_back(wavelength_color(cie_1931_2deg()[row], dimmed, rgb_from_xyz));
        }
        return found;
    }();
    return colors;
}

double relative_luminance(const Srgb& color) {
    // WCAG 2.1's threshold 0.03928 and IEC 61966-2-1's 0.04045 part no two of the 256 codes.
    const LinearRgb light = decode_rgb8(Transfer::srgb, {color[0], color[1], color[2]});
    return 0.2126 * light.r + 0.7152 * light.g + 0.0722 * light.b;
}

double contrast(const Srgb& a, const Srgb& b) {
    const std::pair<double, double> ends = std::minmax({relative_luminance(a), relative_luminance(b)});
    return (ends.second + 0.05) / (ends.first + 0.05);
}

Srgb over(const Srgb& ground, double alpha, const Srgb& under) {
    Srgb mixed{};
    for (std::size_t i = 0; i < 3; ++i)
        mixed[i] = static_cast<std::uint8_t>(std::lround(alpha * ground[i] + (1 - alpha) * under[i]));
    return mixed;
}

} // namespace metamer
