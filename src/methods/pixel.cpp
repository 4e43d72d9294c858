#include "methods/pixel.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "methods/three_numbers.h"

namespace metamer {

namespace {

using Values = std::span<const double>;

// One lamp's light through the layers, before the division by k'. `observe(i)`: the observer at sample i.
template <class Observe>
Xyz lamp_sum(Values lamp, const Light<double>& light, Values material, Values medium, double thickness,
             Values other, const Observe& observe) {
    Xyz sum;
    for (std::size_t i = 0; i < lamp.size(); ++i) {
        if (lamp[i] == 0)
            continue;
        const double arriving = light.diffuse + (other.empty() ? 0 : light.bounced * other[i]);
        double share = material[i] * arriving;
        if (!medium.empty())
            share *= std::pow(std::max(medium[i], kLeastTransmittance), thickness);
        sum = sum + lamp[i] * (share + light.mirrored) * observe(i);
    }
    return sum;
}

Values values(const Layer& layer, bool full) {
    return full ? Values(*layer.full) : Values(layer.row->value);
}

} // namespace

double Layer::at(double wavelength_nm) const {
    const Grid& grid = full ? kReferenceGrid : kThesisGrid;
    const Values v = values(*this, full != nullptr);
    const double place =
        std::clamp((wavelength_nm - grid.first_nm) / grid.step_nm, 0.0, static_cast<double>(grid.count - 1));
    const auto below = std::min(static_cast<std::size_t>(place), grid.count - 2);
    const double t = place - static_cast<double>(below);
    return v[below] + t * (v[below + 1] - v[below]);
}

std::vector<double> full_values(const Layer& layer) {
    if (layer.full)
        return *layer.full;
    std::vector<double> values;
    for (std::size_t i = 0; i < kReferenceGrid.count; ++i)
        values.push_back(layer.at(kReferenceGrid.wavelength_nm(i)));
    return values;
}

ReferenceLamp reference_lamp(const Emission& row) {
    return reference_lamp(LampSpectrum{curve_of(row.value), {}});
}

Xyz lamp_white(const PixelLamp& lamp, const GridObserver& observer) {
    return lamp.full ? reference_white(*lamp.full) : lamp_xyz(*lamp.row, observer);
}

bool Pixel::at_full_resolution() const {
    return std::all_of(lamps.begin(), lamps.end(), [](const PixelLamp& lamp) { return lamp.full; }) &&
           material.full && (!medium || medium->full) && (!other || other->full);
}

Xyz exact_xyz(const Pixel& pixel, const GridObserver& observer) {
    const bool full = pixel.at_full_resolution();
    const auto table = cie_1931_2deg();
    Xyz total;
    for (const PixelLamp& lamp : pixel.lamps) {
        const Values material = values(pixel.material, full);
        const Values medium = pixel.medium ? values(*pixel.medium, full) : Values();
        const Values other = pixel.other ? values(*pixel.other, full) : Values();
        const auto sum = [&](Values emission, const auto& observe) {
            return lamp_sum(emission, lamp.light, material, medium, pixel.thickness, other, observe);
        };
        if (full)
            total = total + (lamp.strength / lamp.full->k) * sum(lamp.full->power, [&](std::size_t i) {
                                return Xyz{table[i].x, table[i].y, table[i].z};
                            });
        else
            total = total +
                    (lamp.strength / grid_k(*lamp.row, observer)) * sum(lamp.row->value, [&](std::size_t i) {
                        return Xyz{observer.x[i], observer.y[i], observer.z[i]};
                    });
    }
    return total;
}

} // namespace metamer
