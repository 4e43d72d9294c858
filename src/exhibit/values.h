// Values from their text, within the range that the table of keys gives. Every function throws bad_input as
// `cannot read PLACE: KEY = VALUE is ...` with what the value may be and, for names, the nearest one.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "exhibit/settings.h"

namespace metamer {

/// The error for a value, e.g. refused(s, "is below 0") gives `cannot read kiosk.ini:12: strength = -1 is
/// below 0`.
Error refused(const Setting& setting, const std::string& why);

/// The error for a value whose own lookup failed: `KEY = VALUE: CAUSE`. `item` is the part of the value that
/// was looked up; where that is not all of it, `KEY: ITEM: CAUSE`. An inner place that says more than the
/// item (a file's line) stands instead of it, else before the cause.
Error refused_by(const Setting& setting, const std::string& item, const Error& inner);

int whole(const Setting& setting);
double number(const Setting& setting);

/// As many numbers as the table says, with blanks or commas between.
std::vector<double> numbers(const Setting& setting);

/// Which of the table's choices, from 0. Case, blanks, `-` and `_` aside.
std::size_t choice(const Setting& setting);

bool yes_no(const Setting& setting);

} // namespace metamer
