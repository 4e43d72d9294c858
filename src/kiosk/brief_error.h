// An error for a corner of the screen.
#pragma once

#include <string>
#include <string_view>

namespace metamer {

/// Words with an error's sentence in them, `cannot VERB PLACE: CAUSE`, as brief as they can be without losing
/// the cause: the file without its folder; where it has a line, nothing before it (`kiosk.ini:12: ...`); of
/// `key = value: ...` no more than the value's beginning. Words without such a sentence stay as they are.
std::string brief_error(std::string_view words);

} // namespace metamer
