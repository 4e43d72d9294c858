// The three numbers that product methods know of lamps and materials, and what becomes of light on its way to
// the framebuffer.
#pragma once

#include <algorithm>
#include <array>

#include "color/matrix3.h"
#include "color/observer.h"
#include "color/spectrum.h"
#include "color/transfer.h"
#include "methods/method.h"
#include "methods/scalar.h"

namespace metamer {

/// What becomes of XYZ on the way to the framebuffer.
struct OutputSpace {
    Matrix3 rgb_from_xyz = Matrix3::identity(); ///< working space or own matrix
    Matrix3 adaptation = Matrix3::identity();   ///< XYZ to XYZ, before rgb_from_xyz
    const Emission* white = nullptr;    ///< the illuminant that materials of method rgb are known under
    const Emission* dominant = nullptr; ///< and those of method prefiltered: the strongest lamp
    Transfer transfer = Transfer::srgb;

    Matrix3 adapted_rgb_from_xyz() const { return rgb_from_xyz * adaptation; }
};

/// XYZ to sharpened cone primaries (Suesstrunk, Holm, Finlayson 2001, "Sharp" transform), in which products
/// err least: the basis of method `prefiltered` (Ward and Eydelberg-Vileshin 2002).
inline constexpr Matrix3 kSharpFromXyz{
    {{{1.2694, -0.0988, -0.1706}, {-0.8364, 1.8006, 0.0357}, {0.0297, -0.0315, 1.0018}}}};

/// The three numbers that a product method knows of a lamp, strength not in them: XYZ, linear RGB for `rgb`,
/// sharpened primaries for `prefiltered`.
std::array<double, 3> lamp_numbers(Method method, const Emission& lamp, const GridObserver& observer,
                                   const OutputSpace& output);

/// And of a material or a medium: XYZ under equal energy; for `rgb` linear RGB under the white of the working
/// space; for `prefiltered` what turns the dominant lamp's numbers into those of its light on the material
/// (where that lamp has next to nothing of a primary: under equal energy).
std::array<double, 3> material_numbers(Method method, const Reflectance& material,
                                       const GridObserver& observer, const OutputSpace& output);

/// Light in a product method's space to linear RGB of the display: the identity for `rgb`.
Matrix3 rgb_from_numbers(Method method, const OutputSpace& output);

/// Light in XYZ to linear RGB, as shaders_es/output.glsl and the matrix before it do.
template <Scalar T>
BasicLinearRgb<T> to_output(const Matrix3& rgb_from_xyz, BasicXyz<T> xyz) {
    return to_linear_rgb(rgb_from_xyz, BasicXyz<T>{bounded(xyz.x), bounded(xyz.y), bounded(xyz.z)});
}

} // namespace metamer
