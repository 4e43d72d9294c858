#include "methods/numbers.h"

#include "methods/three_numbers.h"

namespace metamer {

namespace {

/// A primary of which the dominant lamp has less than this share of its greatest cannot be divided by.
constexpr double kLeastPrimary = 1e-3;

std::array<double, 3> numbers(const Xyz& c) {
    return {c.x, c.y, c.z};
}

std::array<double, 3> prefiltered(const Reflectance& material, const Emission& dominant,
                                  const GridObserver& observer) {
    const auto lamp = kSharpFromXyz * numbers(lamp_xyz(dominant, observer));
    const auto reflected = kSharpFromXyz * numbers(grid_xyz(dominant, material, observer));
    const auto equal = kSharpFromXyz * numbers(material_xyz(material, observer));
    const double greatest = std::max({lamp[0], lamp[1], lamp[2]});
    std::array<double, 3> out{};
    for (std::size_t c = 0; c < 3; ++c)
        out[c] = lamp[c] > kLeastPrimary * greatest ? reflected[c] / lamp[c] : equal[c];
    return out;
}

} // namespace

std::array<double, 3> lamp_numbers(Method method, const Emission& lamp, const GridObserver& observer,
                                   const OutputSpace& output) {
    const auto xyz = numbers(lamp_xyz(lamp, observer));
    if (method == Method::prefiltered)
        return kSharpFromXyz * xyz;
    return method == Method::rgb ? output.adapted_rgb_from_xyz() * xyz : xyz;
}

std::array<double, 3> material_numbers(Method method, const Reflectance& material,
                                       const GridObserver& observer, const OutputSpace& output) {
    if (method == Method::prefiltered)
        return prefiltered(material, *output.dominant, observer);
    if (method == Method::rgb)
        return output.rgb_from_xyz * numbers(grid_xyz(*output.white, material, observer));
    return numbers(material_xyz(material, observer));
}

Matrix3 rgb_from_numbers(Method method, const OutputSpace& output) {
    if (method == Method::rgb)
        return Matrix3::identity();
    const Matrix3 rgb_from_xyz = output.adapted_rgb_from_xyz();
    return method == Method::prefiltered ? rgb_from_xyz * inverse(kSharpFromXyz).value() : rgb_from_xyz;
}

} // namespace metamer
