// The scalars that the CPU twins are templates over: double, float, and half, which is what Mali-400 computes
// in.
#pragma once

#include <concepts>

namespace metamer {

/// IEEE 754 binary16, rounded after every operation (gcc: each operation in float, then rounded; float has
/// more than twice half's digits plus two, so +, -, *, / come out as if rounded once).
__extension__ typedef _Float16 half;

template <class T>
concept Scalar = std::same_as<T, double> || std::same_as<T, float> || std::same_as<T, half>;

} // namespace metamer
