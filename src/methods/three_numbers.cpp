#include "methods/three_numbers.h"

#include <map>
#include <string>

#include "color/resample.h"
#include "spectra/library.h"

namespace metamer {

namespace {

template <class Value>
Value constant(double v) {
    Value out;
    out.value.fill(v);
    return out;
}

std::map<std::string, Emission, std::less<>> white_emissions() {
    std::map<std::string, Emission, std::less<>> whites;
    for (const WorkingSpace& space : working_spaces()) {
        const std::string name(space.white_illuminant);
        whites.try_emplace(name, sample_lamp(find_lamp(name).spectrum).emission);
    }
    return whites;
}

} // namespace

double grid_k(const Emission& lamp, const GridObserver& observer) {
    double k = 0;
    for (std::size_t i = 0; i < kIntervals; ++i)
        k += lamp.value[i] * observer.y[i];
    return k;
}

namespace {

// Of a lamp whose light the rows do not hold nothing is left: no division by zero.
double per_k(const Emission& lamp, const GridObserver& observer) {
    const double k = grid_k(lamp, observer);
    return k > 0 ? 1 / k : 0;
}

} // namespace

double packed_scale(const Emission& lamp, double strength, const GridObserver& observer) {
    return strength * per_k(lamp, observer);
}

Xyz grid_xyz(const Emission& lamp, const Reflectance& material, const GridObserver& observer) {
    Xyz sum;
    for (std::size_t i = 0; i < kIntervals; ++i)
        sum = sum + lamp.value[i] * material.value[i] * Xyz{observer.x[i], observer.y[i], observer.z[i]};
    return per_k(lamp, observer) * sum;
}

Xyz lamp_xyz(const Emission& lamp, const GridObserver& observer) {
    return grid_xyz(lamp, constant<Reflectance>(1), observer);
}

Xyz material_xyz(const Reflectance& material, const GridObserver& observer) {
    return grid_xyz(constant<Emission>(1), material, observer);
}

const Emission& white_emission(const WorkingSpace& space) {
    static const auto whites = white_emissions();
    return whites.find(space.white_illuminant)->second;
}

} // namespace metamer
