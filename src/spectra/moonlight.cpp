#include "spectra/moonlight.h"

#include <cmath>

#include "spectra/tables.h"

namespace metamer {

Curve moonlight() {
    Curve curve = column(cie_illuminants(), "D55");
    for (std::size_t i = 0; i < curve.value.size(); ++i)
        curve.value[i] *= std::pow(curve.wavelength_nm[i] / 560, kLunarReddening);
    return curve;
}

} // namespace metamer
