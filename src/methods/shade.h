// Any method on any pixel: the CPU twins of whole fragment shaders, one function.
#pragma once

#include <vector>

#include "methods/folded.h"
#include "methods/numbers.h"
#include "methods/packed.h"
#include "methods/pixel.h"
#include "methods/reduced.h"
#include "methods/spectral.h"
#include "methods/taps.h"

namespace metamer {

/// What all pixels of one half share.
struct Sight {
    const GridObserver* seen;  ///< the atlas's row 0, as the loops in the shaders read it
    const GridObserver* exact; ///< unquantized, as sums on the CPU take it
    OutputSpace output;        ///< `dominant` unset: the pixel's first lamp
    const Taps* taps =
        nullptr;       ///< of method reduced, lamps in the pixel's order; unset: chosen for the pixel
    int tap_count = 8; ///< how many are chosen then
};

/// Three numbers of a medium, as its shader takes them: log2 of each, the least transmittance below and 1
/// above, which linear RGB of vivid glass passes: thick enough, it would be brighter than any lamp.
std::array<double, 3> medium_log2(const std::array<double, 3>& numbers);

/// Spectra that a pixel of this kind may hold, for choose_taps: its material; through a medium, at
/// thicknesses up to the pixel's; by way of another wall, in several mixtures.
std::vector<std::vector<double>> own_spectra(const Pixel& pixel);

/// The taps that serve pixels of these lamps: of this pixel's kind alone, or of spectra given.
Taps taps_for(const Pixel& pixel, int count);
Taps taps_for(const Pixel& pixel, const std::vector<std::vector<double>>& own, int count);

/// Uniforms of method reduced for a pixel's material: per lamp and tap linear RGB, strength in it.
std::vector<std::vector<std::array<double, 3>>> tap_colors(const Pixel& pixel, const Taps& taps,
                                                           const Matrix3& rgb_from_xyz);

/// What all lamps share at each tap: log2 of the medium's transmittance at thickness 1, of
/// kLeastTransmittance at least, and the other wall's reflectance; 0 where there is none.
std::vector<TapLayers<double>> tap_layers(const Pixel& pixel, const Taps& taps);

/// What each lamp of a pixel at diffuse 1 makes of its material: linear RGB, strength in it.
std::vector<std::array<double, 3>> reflected_colors(const Pixel& pixel, const GridObserver& exact,
                                                    const Matrix3& rgb_from_xyz);

/// The same with what each lamp's highlights and the other wall add: linear RGB, strength in it.
std::vector<FoldedLamp<double>> folded_lamps(const Pixel& pixel, const GridObserver& exact,
                                             const Matrix3& rgb_from_xyz);

/// Whether a method can draw this at all: `folded` cannot where a medium's thickness varies.
constexpr bool can_draw(Method method, bool medium) {
    return method != Method::folded || !medium;
}

/// Linear RGB of the pixel before clamping, in the scalar T. `folded` takes a medium as of constant
/// thickness.
template <Scalar T>
BasicLinearRgb<T> shade(Method method, const Pixel& pixel, const Sight& sight);

/// Its code values: what the GPU's framebuffer should hold, to a step.
template <Scalar T>
EncodedRgb8 shade_rgb8(Method method, const Pixel& pixel, const Sight& sight) {
    return encode_rgb8(sight.output.transfer, shade<T>(method, pixel, sight));
}

/// XYZ of the pixel, before any adaptation: what is compared with exact_xyz(). For `rgb`, the XYZ that its
/// linear RGB stands for.
template <Scalar T>
Xyz shade_xyz(Method method, const Pixel& pixel, const Sight& sight);

} // namespace metamer
