#include "methods/pair.h"

#include "methods/three_numbers.h"

namespace metamer {

namespace {

std::array<double, 3> numbers(const Xyz& c) {
    return {c.x, c.y, c.z};
}

} // namespace

std::array<double, 3> lamp_numbers(Method method, const Emission& lamp, const GridObserver& observer,
                                   const OutputSpace& output) {
    const auto xyz = numbers(lamp_xyz(lamp, observer));
    return method == Method::rgb ? output.adapted_rgb_from_xyz() * xyz : xyz;
}

std::array<double, 3> material_numbers(Method method, const Reflectance& material,
                                       const GridObserver& observer, const OutputSpace& output) {
    if (method == Method::rgb)
        return output.rgb_from_xyz * numbers(grid_xyz(*output.white, material, observer));
    return numbers(material_xyz(material, observer));
}

Xyz pair_xyz(Method method, const Emission& lamp, const Reflectance& material, const GridObserver& observer,
             const OutputSpace& output) {
    if (method == Method::spectral)
        return grid_xyz(lamp, material, observer);
    OutputSpace unadapted = output;
    unadapted.adaptation = Matrix3::identity();
    const auto l = lamp_numbers(method, lamp, observer, unadapted);
    const auto m = material_numbers(method, material, observer, unadapted);
    const std::array<double, 3> p{l[0] * m[0], l[1] * m[1], l[2] * m[2]};
    if (method == Method::rgb)
        return to_xyz(inverse(output.rgb_from_xyz).value(), {p[0], p[1], p[2]});
    return {p[0], p[1], p[2]};
}

} // namespace metamer
