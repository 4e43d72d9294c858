// Libpng reports errors by longjmp; this keeps the jump inside one small frame. Private to this room.
//
// Exceptions thrown through libpng would be shorter, but its C frames carry no unwind tables on every
// platform (32-bit ARM).
#pragma once

#include <array>
#include <csetjmp>

#include <png.h>

namespace metamer {

/// Libpng's last error, kept where its error callback can write without allocating.
struct PngFailure {
    std::array<char, 128> message{};
};

/// The error callback: the error pointer is a PngFailure, which receives the message; then jumps to
/// `guarded`.
[[noreturn]] void png_give_up(png_structp png, png_const_charp message);

/// The warning callback: what is merely odd is passed over.
void png_pass_over(png_structp png, png_const_charp message);

/// Runs `step`; false if libpng gave up in it. A jump skips destructors, so `step` holds nothing that has
/// one.
template <class Step>
bool guarded(png_structp png, const Step& step) {
    if (setjmp(png_jmpbuf(png)))
        return false;
    step();
    return true;
}

} // namespace metamer
