// The methods by name: ways to get from spectra to XYZ. Each has its CPU twin in this room and its GLSL by
// the same name in shaders_es/.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace metamer {

enum class Method { rgb, tristimulus, spectral, prefiltered, packed, reduced, folded };

/// A method as `list methods`, INI files and JSON write it.
struct MethodInfo {
    Method method;
    std::string_view name;
    std::string_view description;
};

inline constexpr std::array<MethodInfo, 7> kMethods{{
    {Method::rgb, "rgb", "product of lamp and material in the working space: what screens usually do"},
    {Method::tristimulus, "tristimulus", "product of lamp and material in XYZ: the thesis's metameric side"},
    {Method::spectral, "spectral",
     "lamp x reflectance x observer, 64 wavelengths from the atlas in the shader: the thesis's loop"},
    {Method::prefiltered, "prefiltered",
     "product in sharpened primaries, materials prefiltered to the dominant lamp"},
    {Method::packed, "packed", "the same 64 wavelengths, four to a texel: 16 rounds"},
    {Method::reduced, "reduced", "4 .. 32 wavelengths chosen and weighted for the scene's own lamps"},
    {Method::folded, "folded", "summed over wavelengths once on the CPU, a constant in the shader"},
}};

constexpr std::string_view method_name(Method method) {
    return kMethods[static_cast<std::size_t>(method)].name;
}

/// What an exhibit asks for: a method, or, when empty, whichever the planner finds best (`auto`).
using MethodChoice = std::optional<Method>;

/// Whether the method multiplies three numbers of the lamp with three of the material.
constexpr bool is_product(Method method) {
    return method == Method::rgb || method == Method::tristimulus || method == Method::prefiltered;
}

/// The method of this name, case aside; none when there is none.
std::optional<Method> find_method(std::string_view name);

} // namespace metamer
