#include <algorithm>
#include <functional>

#include "base/numbers.h"
#include "color/colorimetry.h"
#include "color/resample.h"
#include "spectra/sets.h"

namespace metamer {

namespace {

// Left out of the set: see the header.
constexpr std::size_t kLeftOut = 1;

MaterialSpectrum hat(double center_nm, double height) {
    return {{{center_nm - kThesisGrid.step_nm, center_nm, center_nm + kThesisGrid.step_nm}, {0, height, 0}}};
}

// Luminance of each hat of height 1 under equal energy, Y = 1 for the perfect reflector.
std::vector<double> luminances() {
    const ReferenceLamp e =
        reference_lamp({{{kReferenceGrid.first_nm, kReferenceGrid.last_nm()}, {1, 1}}, {}});
    std::vector<double> out;
    for (std::size_t i = kLeftOut; i < kThesisGrid.count; ++i)
        out.push_back(reference_xyz(e, resample(hat(kThesisGrid.wavelength_nm(i), 1), kReferenceGrid)).y);
    return out;
}

} // namespace

std::vector<Material> single_wavelength_materials() {
    std::vector<Material> materials;
    for (std::size_t i = kLeftOut; i < kThesisGrid.count; ++i) {
        const std::string w = to_text(kThesisGrid.wavelength_nm(i));
        materials.push_back({"single-" + w, "constructed: reflects one interval, " + w + " nm",
                             "a hat function of half-width 5 nm", hat(kThesisGrid.wavelength_nm(i), 1)});
    }
    return materials;
}

std::vector<Material> weighted_wavelength_materials() {
    const std::vector<double> luminance = luminances();
    std::vector<double> descending = luminance;
    std::sort(descending.begin(), descending.end(), std::greater<>());
    const double level = descending[descending.size() / 2];
    std::vector<Material> materials;
    for (std::size_t i = 0; i < luminance.size(); ++i) {
        const double center_nm = kThesisGrid.wavelength_nm(i + kLeftOut);
        const std::string w = to_text(center_nm);
        materials.push_back(
            {"weighted-" + w,
             "constructed: reflects one interval, " + w + " nm, at equal luminance under E where it can",
             "a hat function of half-width 5 nm, scaled",
             hat(center_nm, std::min(1.0, level / luminance[i]))});
    }
    return materials;
}

} // namespace metamer
