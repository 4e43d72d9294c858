// The names, sources, peaks and scales of an atlas as text: what its PNG carries beside the pixels.
//
//     metamer:atlas      1
//     metamer:observer   CIE 1931 2 degree
//     metamer:quantization   weighted; absent when it is the thesis's
//     metamer:lamps      one line per lamp:     row TAB name TAB peak TAB source
//     metamer:materials  one line per material: row TAB name TAB scale TAB source
//
// Lines end with a line feed, rows ascend; numbers are the shortest decimals that read back as the same
// double.
#pragma once

#include <map>
#include <string>

#include "atlas/atlas.h"

namespace metamer {

/// What the observer of row 0 is called, in the PNG and for people.
inline constexpr const char* kObserverName = "CIE 1931 2 degree";

/// The texts by keyword.
std::map<std::string, std::string> atlas_texts(const Atlas& atlas);

/// Fills lamps, materials and quantization of `atlas` from the texts; `place` is the file's name for errors.
/// Throws bad_input for a missing text, another format version, observer or quantization, a line that is not
/// `row TAB name TAB number TAB source`, a row outside 1 .. 63 or repeated, a number that is none. Whether
/// the numbers and names make sense with the pixels is flaw_of's matter. Texts of other keywords are passed
/// over.
void read_atlas_texts(Atlas& atlas, const std::map<std::string, std::string>& texts,
                      const std::string& place);

} // namespace metamer
