// Half precision: the compiler's where it has it, else our own.
#pragma once

#if !defined(__x86_64__) && !defined(__clang__) && __GNUC__ < 13
#include "base/soft_half.h"
#endif

namespace metamer {

/// IEEE 754 binary16, rounded after every operation (gcc: each operation in float, then rounded; float has
/// more than twice half's digits plus two, so +, -, *, / come out as if rounded once).
#if !defined(__x86_64__) && !defined(__clang__) && __GNUC__ < 13
using Float16 = SoftHalf;
#else
__extension__ typedef _Float16 Float16;
#endif

} // namespace metamer
