// What the kiosk is made of.
#pragma once

#include "exhibit/exhibit.h"
#include "overlay/words.h"

namespace metamer {

/// Loaded together, so that it is taken over together or not at all.
struct Loaded {
    Exhibit exhibit; ///< for Use::kiosk
    Words words;
};

/// The words that the exhibit asks for: those of its folder of strings, else the built-in ones. Throws
/// bad_input as Words() does, and where the language that it starts with is not among them.
Words words_of(const Exhibit& exhibit);

} // namespace metamer
