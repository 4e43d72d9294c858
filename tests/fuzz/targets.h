// What the fuzzers are let loose on: everything that the outside hands to Metamer, one function each.
//
// Each takes any bytes. An Error of exit status 2 is the right answer to a bad input; whatever else happens
// (a crash, another exception, a promise of must.h that is not kept) ends the process.
#pragma once

#include <span>
#include <string_view>

namespace metamer::fuzz {

enum class Outcome { taken, refused };

/// An exhibit's INI: parsed, and loaded as `metamer run` loads it. Names with a `/` are refused here, so that
/// no input leads out of tests/fuzz/folder, where its relative paths start.
Outcome try_exhibit(std::string_view bytes);

/// A language's INI, held against all of the English keys, and against a few of its own that small inputs
/// reach.
Outcome try_strings(std::string_view bytes);

/// A PNG: any picture, and an atlas with all of its rows and texts.
Outcome try_atlas(std::string_view bytes);

/// A spectrum CSV: read as every kind, then its columns used as lamps and as materials.
Outcome try_spectrum(std::string_view bytes);

struct Target {
    std::string_view name; ///< of its folder in tests/fuzz/corpus
    Outcome (*run)(std::string_view bytes);
};

/// All four.
std::span<const Target> targets();

} // namespace metamer::fuzz
