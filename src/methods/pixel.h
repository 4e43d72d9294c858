// What a pixel knows of its light: lamps, the material, what the light passes on its way. Every method is a
// function of this; so is the exact answer that they are held against.
#pragma once

#include <optional>
#include <vector>

#include "color/colorimetry.h"
#include "color/observer.h"
#include "color/spectrum.h"
#include "methods/light.h"

namespace metamer {

/// A lamp as a pixel sees it. Pointers are not owned.
struct PixelLamp {
    const Emission* row = nullptr;       ///< of the atlas
    const ReferenceLamp* full = nullptr; ///< at 1 nm; nullptr where only the row is at hand
    double strength = 1;                 ///< I_source
    Light<double> light;                 ///< I_shading
};

/// Something that filters light: a material's reflectance, or the internal transmittance of a medium at
/// thickness 1.
struct Layer {
    const Reflectance* row = nullptr;          ///< of the atlas
    const std::vector<double>* full = nullptr; ///< on kReferenceGrid; nullptr where only the row is at hand

    /// Its value at a wavelength, linear between samples, its end values held: from `full`, else from `row`.
    double at(double wavelength_nm) const;
};

struct Pixel {
    std::vector<PixelLamp> lamps;
    Layer material;
    std::optional<Layer> medium; ///< absorbs before the material's light leaves: transmittance^thickness
    double thickness = 0;        ///< 0 and up
    std::optional<Layer> other;  ///< the wall whose light falls here too, Light::bounced of it

    /// Whether every spectrum is at hand at 1 nm.
    bool at_full_resolution() const;
};

/// Transmittances below this count as this: logarithms stay finite, in half precision too.
inline constexpr double kLeastTransmittance = 1.0 / 65536;

/// A layer's values on kReferenceGrid, from whichever samples are at hand.
std::vector<double> full_values(const Layer& layer);

/// A lamp of which only the row is at hand, at 1 nm: linear between the row's samples, its ends' light within
/// half an interval.
ReferenceLamp reference_lamp(const Emission& row);

/// XYZ of the lamp on the perfect reflector at strength 1.
Xyz lamp_white(const PixelLamp& lamp, const GridObserver& observer);

/// XYZ of the pixel's light in double: per lamp the sum of S (R (diffuse + bounced R_other) T^thickness +
/// mirrored) over k' (equations 7.1, 7.6-7.10; Beer-Lambert law for T), Y = 1 for the perfect reflector at
/// strength 1 and diffuse 1. At 1 nm where every spectrum is at hand so, else on the thesis's grid with
/// `observer`. This is both the reference and what method `folded` knows.
Xyz exact_xyz(const Pixel& pixel, const GridObserver& observer);

} // namespace metamer
