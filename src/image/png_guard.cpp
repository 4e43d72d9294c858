#include "image/png_guard.h"

#include <cstring>

namespace metamer {

void png_give_up(png_structp png, png_const_charp message) {
    auto* failure = static_cast<PngFailure*>(png_get_error_ptr(png));
    std::strncpy(failure->message.data(), message, failure->message.size() - 1);
    png_longjmp(png, 1);
}

void png_pass_over(png_structp, png_const_charp) {}

} // namespace metamer
