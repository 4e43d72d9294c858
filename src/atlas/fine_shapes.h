// Spectra by formula, at 1 nm.
#pragma once

#include <cmath>

#include "atlas/fine.h"

namespace metamer {

/// value(wavelength_nm) on kReferenceGrid.
template <class Function>
FineValues fine_values(const Function& value) {
    FineValues fine;
    for (std::size_t k = 0; k < fine.size(); ++k)
        fine[k] = value(kReferenceGrid.wavelength_nm(k));
    return fine;
}

/// Gaussian of height 1.
inline double bell(double wavelength_nm, double center_nm, double deviation_nm) {
    const double t = (wavelength_nm - center_nm) / deviation_nm;
    return std::exp(-0.5 * t * t);
}

/// Logistic edge from 0 to 1, 1/2 at its center.
inline double rise(double wavelength_nm, double center_nm, double width_nm) {
    return 1 / (1 + std::exp((center_nm - wavelength_nm) / width_nm));
}

} // namespace metamer
