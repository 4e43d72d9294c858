#include <algorithm>

#include "atlas/fine_shapes.h"
#include "atlas/material_fit.h"
#include "spectra/blackbody.h"

namespace metamer {

namespace {

// White is the row's white: what is left of an error is the material's.
void take_off_own_error(PriorLamp& lamp) {
    Xyz fine, row;
    for (const Xyz& part : lamp.fine)
        fine = fine + part;
    for (const Xyz& part : lamp.interval)
        row = row + part;
    const Xyz factor = ratio(row, fine);
    for (Xyz& part : lamp.fine)
        part = {part.x * factor.x, part.y * factor.y, part.z * factor.z};
}

// `row`: the emission that the lamp's atlas row stands for.
PriorLamp as_they_are(double weight, const FineValues& power, const RowValues& row) {
    const auto lit = [](double v) { return v > 0; };
    PriorLamp lamp{weight, 0, {}, 0, 0, {}};
    lamp.fine_begin = static_cast<std::size_t>(std::find_if(power.begin(), power.end(), lit) - power.begin());
    const auto fine_end =
        static_cast<std::size_t>(power.rend() - std::find_if(power.rbegin(), power.rend(), lit));
    double k = 0;
    for (std::size_t i = lamp.fine_begin; i < fine_end; ++i)
        k += power[i] * cie_1931_2deg()[i].y;
    for (std::size_t i = lamp.fine_begin; i < fine_end; ++i) {
        const ColorMatching& at = cie_1931_2deg()[i];
        lamp.fine.push_back((power[i] / k) * Xyz{at.x, at.y, at.z});
    }
    lamp.begin = static_cast<std::size_t>(std::find_if(row.begin(), row.end(), lit) - row.begin());
    lamp.end = static_cast<std::size_t>(row.rend() - std::find_if(row.rbegin(), row.rend(), lit));
    const double row_k = weighted_sum(row).y;
    for (std::size_t i = lamp.begin; i < lamp.end; ++i)
        lamp.interval[i] = (row[i] / row_k) * interval_weights()[i];
    return lamp;
}

PriorLamp made(double weight, const FineValues& power, const RowValues& row) {
    PriorLamp lamp = as_they_are(weight, power, row);
    take_off_own_error(lamp);
    return lamp;
}

PriorLamp broad(double weight, const FineValues& power) {
    LampSpectrum spectrum;
    for (std::size_t k = 0; k < power.size(); ++k)
        spectrum.continuum.wavelength_nm.push_back(kReferenceGrid.wavelength_nm(k));
    spectrum.continuum.value.assign(power.begin(), power.end());
    return made(weight, power, fit_lamp(lamp_power(spectrum)).best);
}

PriorLamp line(double weight, double wavelength_nm) {
    const LampPower power = lamp_power({{}, {{wavelength_nm, 1}}});
    return made(weight, power.fine, projected(power.fine));
}

std::vector<PriorLamp> make_lamps() {
    std::vector<PriorLamp> all{broad(1, fine_values([](double) { return 1.0; }))};
    for (const double kelvin : {2000.0, 2856.0, 4000.0, 6500.0, 20000.0}) {
        FineValues power;
        const Curve curve = blackbody(kelvin);
        std::copy(curve.value.begin(), curve.value.end(), power.begin());
        all.push_back(broad(1, power));
    }
    for (const double deviation_nm : {10.0, 30.0})
        for (double c = 430; c <= 670; c += 15)
            all.push_back(broad(0.2, fine_values([&](double w) { return bell(w, c, deviation_nm); })));
    for (double w = 400; w <= 695; w += 2.5)
        all.push_back(line(0.05, w));
    return all;
}

} // namespace

PriorLamp own_lamp(const LampPower& power, const RowValues& row, double share) {
    return as_they_are(kOwnWeight * share, power.fine, row);
}

const std::vector<PriorLamp>& prior_lamps() {
    static const auto all = make_lamps();
    return all;
}

} // namespace metamer
