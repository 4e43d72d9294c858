// INI text as a list of sections and values that know their lines. What the values mean is not known here.
//
// The language is inih's (version 55): `[section]`, `key = value` or `key: value`, blanks around each
// dropped; a line that starts with `;` or `#` is a comment, and so is everything after a `;` that follows a
// blank. One line each: an indented line continues nothing.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace metamer {

inline constexpr int kLongestIniLine = 4096;  ///< bytes, without the line's end: 63 names with room to spare
inline constexpr int kLongestIniSection = 49; ///< bytes; inih cuts longer names off

struct IniSection {
    std::string name;
    int line; ///< from 1
};

struct IniEntry {
    std::string section, key, value;
    int line; ///< from 1
};

/// In the file's order. A section without values is in `sections` only; one that is opened again is there
/// again.
struct IniFile {
    std::vector<IniSection> sections;
    std::vector<IniEntry> entries;
};

/// Reads INI text; `place` is the file's name for errors, which add the line. Throws bad_input for a line
/// that is neither, text after `]`, a key outside any section, a key twice in a section, empty names, a line
/// or section name over its limit, a NUL byte, and a value that is not UTF-8 or stands under such a name; in
/// comments any bytes will do. A byte order mark at the start is skipped.
IniFile parse_ini(std::string_view text, const std::string& place);

} // namespace metamer
