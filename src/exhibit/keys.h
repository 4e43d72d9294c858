// The one table of sections and keys that an exhibit's INI file may hold. The loader, its messages and the
// documentation (config/KEYS.md) all come from here.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace metamer {

/// How a value is written.
enum class ValueKind {
    whole,     ///< a whole number
    number,    ///< a decimal number
    numbers,   ///< `count` numbers with blanks or commas between
    choice,    ///< one of choices()
    yes_no,    ///< yes or no (also true, on, 1; false, off, 0)
    split,     ///< a share of the width, or a column as in 640px
    lamp,      ///< name, formula, file or, with [atlas] file, key
    material,  ///< likewise
    materials, ///< a set, or materials with commas between
    lamps,     ///< lamps with commas between
    hours,     ///< from - to, as in 22:00-07:00
    text,      ///< words for people
    file,      ///< a path, relative to the INI file
};

struct KeyInfo {
    /// display, accuracy, atlas, scene, lamp.N, object.NAME, compare, kiosk, tour.N
    std::string_view section;
    std::string_view key; ///< `caption.LANGUAGE` stands for one key per language
    ValueKind kind;
    std::string_view unit;                           ///< empty: none
    double least = 0, most = 0;                      ///< numbers: the range, ends included
    int count = 1;                                   ///< numbers: how many
    std::vector<std::string> (*choices)() = nullptr; ///< choice: the names
    std::string_view fallback;                       ///< what holds without it, as documentation says it
    std::string_view doc;                            ///< one line
};

/// Every key, section by section.
std::span<const KeyInfo> keys();

/// The pattern that a section's name fits (`lamp.2` fits `lamp.N`, N without leading zeros and at most
/// kMostLamps, of tours kMostTourSteps); empty when it fits none.
std::string_view section_pattern(std::string_view section);

/// The key's row in the table; nullptr when the section has no such key. Names are compared with case.
const KeyInfo* find_key(std::string_view section, std::string_view key);

/// `unknown section [lmap.1]; did you mean "lamp.1"?`
std::string unknown_section(std::string_view section);

/// `unknown key "strenght" in [lamp.1]; did you mean "strength"?`
std::string unknown_key(std::string_view section, std::string_view key);

/// A number for people: 1000000 rather than 1e+06.
std::string plain_number(double value);

/// What a value may be, for people: `16 .. 4096 px`, `rgb, tristimulus, spectral`.
std::string range_text(const KeyInfo& info);

/// The whole table in Markdown: config/KEYS.md.
std::string keys_table();

} // namespace metamer
