// An atlas as a picture for people.
#pragma once

#include "atlas/atlas.h"
#include "image/png.h"

namespace metamer {

/// One strip per row up to the last that holds something: lamps at the left, materials at the right, each
/// interval a bar as high as its value and in its wavelength's own color (sRGB, clipped, at its brightest).
/// Strip 0 is the observer: at the left the three functions as overlapping red, green and blue bars, at the
/// right every color at full height. 928 px wide, 14 px a strip, at most 910 px high; sRGB.
Image picture(const Atlas& atlas);

} // namespace metamer
