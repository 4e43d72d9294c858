// Half precision: the compiler's where it has it, else our own.
#pragma once

// In C++, gcc has it on x86, and everywhere from 13 on; clang everywhere but on x86, and there from 15 on.
#if defined(__x86_64__) ? defined(__clang__) && __clang_major__ < 15 : !defined(__clang__) && __GNUC__ < 13
#define METAMER_SOFT_HALF
#include "base/soft_half.h"
#endif

namespace metamer {

/// IEEE 754 binary16, rounded after every operation (gcc: each operation in float, then rounded; float has
/// more than twice half's digits plus two, so +, -, *, / come out as if rounded once).
#ifdef METAMER_SOFT_HALF
using Float16 = SoftHalf;
#else
__extension__ typedef _Float16 Float16;
#endif

} // namespace metamer
