// The scalars that the CPU twins are templates over: double, float, and Float16, which is what a Mali-400
// computes in.
#pragma once

#include <concepts>

namespace metamer {

/// IEEE 754 binary16, rounded after every operation (gcc: each operation in float, then rounded; float has
/// more than twice half's digits plus two, so +, -, *, / come out as if rounded once).
__extension__ typedef _Float16 Float16;

template <class T>
concept Scalar = std::same_as<T, double> || std::same_as<T, float> || std::same_as<T, Float16>;

} // namespace metamer
