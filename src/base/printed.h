// Text from a format of printf's.
#pragma once

#include <string>

namespace metamer {

/// What std::printf would print, of any length; the compiler checks the values against the format. Numbers
/// are those of the C locale, which the program stays in. Throws failure for a format that the C library
/// refuses.
[[gnu::format(printf, 1, 2)]] std::string printed(const char* format, ...);

} // namespace metamer
