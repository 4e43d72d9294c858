// Names that people type: compared without case, and the nearest one offered when none fits.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace metamer {

/// ASCII lower case; other bytes (UTF-8) stay as they are.
std::string lower_case(std::string_view text);

/// Equal but for ASCII case.
bool same_name(std::string_view a, std::string_view b);

/// White space off both ends.
std::string_view trimmed(std::string_view text);

/// The pieces between separators, each trimmed; an empty text gives no piece.
std::vector<std::string> split(std::string_view text, char separator);

/// The candidate with the least optimal-string-alignment distance (insertions, deletions, replacements,
/// neighbors swapped; case ignored), the first of equals; empty when even the nearest differs in more than
/// half its letters.
std::string nearest_name(std::string_view typed, std::span<const std::string> candidates);

/// `E, D65, F11`; of many the first twelve and how many more.
std::string listed(std::span<const std::string> names);

/// `; did you mean "crayons"?`, or an empty text when nothing is near.
std::string did_you_mean(std::string_view typed, std::span<const std::string> candidates);

} // namespace metamer
