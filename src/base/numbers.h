// Numbers from text and back, the same in every locale.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace metamer {

/// A finite decimal number that fills the whole text (surrounding blanks aside); none for anything else:
/// empty text, `nan`, `inf`, hexadecimal, a decimal comma, trailing letters, or a value beyond double.
std::optional<double> parse_number(std::string_view text);

/// A whole number under the same rules.
std::optional<int> parse_whole(std::string_view text);

/// The shortest text that reads back as the same double: 0.1, 589.3, 1e-07.
std::string to_text(double value);

} // namespace metamer
