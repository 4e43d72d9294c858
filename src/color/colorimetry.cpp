#include "color/colorimetry.h"

#include "base/error.h"
#include "color/observer.h"
#include "color/resample.h"

namespace metamer {

ReferenceLamp reference_lamp(const LampSpectrum& lamp) {
    ReferenceLamp out{resample(lamp, kReferenceGrid), 0};
    const auto observer = cie_1931_2deg();
    for (std::size_t i = 0; i < observer.size(); ++i)
        out.k += out.power[i] * observer[i].y;
    if (!(out.k > 0))
        throw bad_input("weigh", "a lamp", "it has no light that the eye sees (360..830 nm)");
    return out;
}

Xyz reference_xyz(const ReferenceLamp& lamp, std::span<const double> reflectance) {
    const auto observer = cie_1931_2deg();
    Xyz sum;
    for (std::size_t i = 0; i < observer.size(); ++i) {
        const double light = lamp.power[i] * reflectance[i];
        sum = sum + light * Xyz{observer[i].x, observer[i].y, observer[i].z};
    }
    return (1 / lamp.k) * sum;
}

Xyz reference_xyz(const LampSpectrum& lamp, const MaterialSpectrum& material) {
    return reference_xyz(reference_lamp(lamp), resample(material, kReferenceGrid));
}

Xyz reference_white(const ReferenceLamp& lamp) {
    return reference_xyz(lamp, std::vector<double>(kReferenceGrid.count, 1.0));
}

Xyz reference_white(const LampSpectrum& lamp) {
    return reference_white(reference_lamp(lamp));
}

Chromaticity chromaticity(const Xyz& c) {
    const double sum = c.x + c.y + c.z;
    return sum != 0 ? Chromaticity{c.x / sum, c.y / sum} : Chromaticity{};
}

Xyz xyz_of(const Chromaticity& c) {
    return {c.x / c.y, 1, (1 - c.x - c.y) / c.y};
}

} // namespace metamer
