// Text from files: well-formed UTF-8 or not at all.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace metamer {

/// Whether the bytes are well-formed UTF-8: shortest forms only, no surrogates, at most U+10FFFF (RFC 3629
/// section 4).
bool is_utf8(std::string_view text);

/// Whether well-formed UTF-8 holds a control character: U+0000 .. U+001F, U+007F .. U+009F (the Unicode
/// category Cc). A name without one fits in a line, and cannot steer a terminal.
bool has_control(std::string_view utf8);

/// Any bytes with each control character as one `?`; all else stays, well-formed or not.
std::string without_control(std::string_view text);

/// ISO 8859-1, the encoding of tEXt and zTXt chunks (PNG 1.2 section 4.2.3), as UTF-8.
std::string utf8_from_latin1(std::string_view latin1);

/// The number of code points in well-formed UTF-8.
std::size_t code_points(std::string_view utf8);

/// Untrusted bytes as an error message may quote them: control characters and what is not UTF-8 become `?`,
/// and what goes on beyond 40 bytes is cut at a code point and ends in `...`.
std::string quotable(std::string_view text);

} // namespace metamer
