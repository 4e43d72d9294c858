// Lamps and materials of known values for the atlas's tests.
#pragma once

#include <string>

#include "atlas/atlas.h"

namespace metamer {

// A curve with a sample on each of the grid's wavelengths: value(i). Resampling passes it unchanged.
template <class Value>
Curve curve_on_grid(const Value& value) {
    Curve curve;
    for (std::size_t i = 0; i < kIntervals; ++i) {
        curve.wavelength_nm.push_back(kThesisGrid.wavelength_nm(i));
        curve.value.push_back(value(i));
    }
    return curve;
}

inline Material flat_material(const std::string& name, double reflectance) {
    return {name, "", "a test", {curve_on_grid([&](std::size_t) { return reflectance; })}};
}

// Rises from 0 in equal steps to `peak` in the last interval.
inline Lamp ramp_lamp(const std::string& name, double peak) {
    return {name,
            "",
            "a test",
            {curve_on_grid([&](std::size_t i) { return peak * static_cast<double>(i) / 63; }), {}}};
}

inline Lamp line_lamp(const std::string& name, double wavelength_nm) {
    return {name, "", "a formula", {{}, {{wavelength_nm, 1}}}};
}

// Three lamps, two materials, names and sources beyond ASCII.
inline Atlas sample_atlas(Quantization quantization = Quantization::thesis) {
    Atlas atlas = empty_atlas(quantization);
    add_lamp(atlas, ramp_lamp("ramp", 12.3));
    add_lamp(atlas, line_lamp("line:589.3", 589.3));
    add_lamp(atlas, {"Gl\xC3\xBChlampe", "", "\xE5\x85\x89, 2015", ramp_lamp("", 0.1).spectrum});
    add_material(atlas, flat_material("gray", 0.5));
    add_material(atlas, flat_material("black", 0));
    return atlas;
}

} // namespace metamer
