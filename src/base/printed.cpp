#include "base/printed.h"

#include <cstdarg>
#include <cstdio>

#include "base/error.h"

namespace metamer {

std::string printed(const char* format, ...) {
    std::va_list values, again;
    va_start(values, format);
    va_copy(again, values);
    const int length = std::vsnprintf(nullptr, 0, format, values);
    va_end(values);
    std::string text(length > 0 ? static_cast<std::size_t>(length) : 0, '\0');
    // The terminating NUL lands where the string has its own.
    const int written = std::vsnprintf(text.data(), text.size() + 1, format, again);
    va_end(again);
    if (length < 0 || written != length)
        throw failure("print", std::string("\"") + format + "\"", "the C library refuses it");
    return text;
}

} // namespace metamer
