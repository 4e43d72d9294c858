#include "overlay/theme.h"

#include <algorithm>

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

} // namespace metamer
