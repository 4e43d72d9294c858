// The scalars that the CPU twins are templates over: double, float, and Float16, which is what a Mali-400
// computes in.
#pragma once

#include <algorithm>
#include <concepts>

#include "base/float16.h"

namespace metamer {

template <class T>
concept Scalar = std::same_as<T, double> || std::same_as<T, float> || std::same_as<T, Float16>;

/// Light above this is white whatever the matrix: what follows stays finite in half precision.
inline constexpr double kMostLight = 4096;

/// What half precision can hold: uniforms and rows of more than this are this.
inline constexpr double kMostInHalf = 65504;

/// Light no further than kMostLight from 0: sums of it stay numbers. As shaders_es/output.glsl has it.
template <Scalar T>
T bounded(T light) {
    const T most = static_cast<T>(kMostLight);
    return std::min(std::max(light, static_cast<T>(-most)), most);
}

/// A number of the CPU's as a shader receives it.
template <Scalar T>
T uploaded(double value) {
    return static_cast<T>(std::clamp(value, -kMostInHalf, kMostInHalf));
}

} // namespace metamer
