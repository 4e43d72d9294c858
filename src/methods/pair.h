// A lamp and a material by any method: from atlas rows to a pixel. The CPU twin of a whole fragment shader at
// I_shading = 1; frames under other light use spectral() and product() with a Light of their own.
#pragma once

#include <algorithm>
#include <array>

#include "color/matrix3.h"
#include "color/observer.h"
#include "color/spectrum.h"
#include "color/transfer.h"
#include "methods/method.h"
#include "methods/product.h"
#include "methods/spectral.h"

namespace metamer {

/// What becomes of XYZ on the way to the framebuffer.
struct OutputSpace {
    Matrix3 rgb_from_xyz = Matrix3::identity(); ///< working space or own matrix
    Matrix3 adaptation = Matrix3::identity();   ///< XYZ to XYZ, before rgb_from_xyz
    const Emission* white = nullptr; ///< the illuminant that materials of method rgb are known under
    Transfer transfer = Transfer::srgb;

    Matrix3 adapted_rgb_from_xyz() const { return rgb_from_xyz * adaptation; }
};

/// Light above this is white whatever the matrix: what follows stays finite in half precision.
inline constexpr double kMostLight = 4096;

/// The three numbers that a product method knows of a lamp, strength not in them: XYZ, or linear RGB for
/// `rgb`.
std::array<double, 3> lamp_numbers(Method method, const Emission& lamp, const GridObserver& observer,
                                   const OutputSpace& output);

/// And of a material: XYZ under equal energy, or for `rgb` linear RGB under the white of the working space.
std::array<double, 3> material_numbers(Method method, const Reflectance& material,
                                       const GridObserver& observer, const OutputSpace& output);

/// XYZ of the pair, Y = 1 for the perfect reflector, before any adaptation: what `measure` compares with the
/// reference. For `rgb`, the XYZ that its linear RGB stands for. Double precision on the atlas's rows.
Xyz pair_xyz(Method method, const Emission& lamp, const Reflectance& material, const GridObserver& observer,
             const OutputSpace& output);

/// Light in XYZ to linear RGB, as shaders_es/output.glsl and the matrix before it do.
template <Scalar T>
BasicLinearRgb<T> to_output(const Matrix3& rgb_from_xyz, BasicXyz<T> xyz) {
    const T most = static_cast<T>(kMostLight);
    xyz = {std::min(xyz.x, most), std::min(xyz.y, most), std::min(xyz.z, most)};
    return to_linear_rgb(rgb_from_xyz, xyz);
}

/// The light of a lamp of this strength on a material, linear, before clamping, in the scalar T.
template <Scalar T>
BasicLinearRgb<T> pair_linear(Method method, const Emission& lamp, double strength,
                              const Reflectance& material, const GridObserver& observer,
                              const OutputSpace& output) {
    const Matrix3 matrix = output.adapted_rgb_from_xyz();
    if (method == Method::spectral) {
        const LitEmission<T> lit[]{{&lamp, static_cast<T>(strength), {}}};
        return to_output(matrix, spectral<T>(lit, material, observer));
    }
    const auto of_lamp = lamp_numbers(method, lamp, observer, output);
    const auto of_material = material_numbers(method, material, observer, output);
    LitColor<T> lit[1];
    std::array<T, 3> color{};
    for (std::size_t c = 0; c < 3; ++c) {
        lit[0].color[c] = static_cast<T>(strength * of_lamp[c]);
        color[c] = static_cast<T>(of_material[c]);
    }
    const auto [a, b, c] = product<T>(lit, color);
    if (method == Method::rgb)
        return {a, b, c};
    return to_output(matrix, BasicXyz<T>{a, b, c});
}

/// Its pixel: what the GPU's framebuffer should hold.
template <Scalar T>
EncodedRgb8 pair_rgb8(Method method, const Emission& lamp, double strength, const Reflectance& material,
                      const GridObserver& observer, const OutputSpace& output) {
    return encode_rgb8(output.transfer, pair_linear<T>(method, lamp, strength, material, observer, output));
}

} // namespace metamer
