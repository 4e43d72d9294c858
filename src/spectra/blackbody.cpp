#include "spectra/blackbody.h"

#include <cmath>

namespace metamer {

Curve blackbody(double temperature_k) {
    const auto exitance = [&](double w_nm) {
        return std::pow(w_nm, -5) / std::expm1(kSecondRadiation_nm_k / (w_nm * temperature_k));
    };
    Curve curve;
    for (std::size_t i = 0; i < kReferenceGrid.count; ++i) {
        const double w = kReferenceGrid.wavelength_nm(i);
        curve.wavelength_nm.push_back(w);
        curve.value.push_back(100 * exitance(w) / exitance(560));
    }
    return curve;
}

} // namespace metamer
