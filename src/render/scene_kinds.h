// The builders of the single kinds; scene.cpp picks one.
#pragma once

#include "render/scene.h"

namespace metamer {

Scene build_loaf(const Exhibit& exhibit);       ///< figures 35, 37-43: a cube cut in slices
Scene build_crayons(const Exhibit& exhibit);    ///< figures 48-51: crayons side by side
Scene build_still_life(const Exhibit& exhibit); ///< figures 52-53: objects on a table
Scene build_ramp(const Exhibit& exhibit);       ///< chapter 8.3: bars between two materials
Scene build_media(const Exhibit& exhibit);      ///< a wedge of glass and a vessel before a light box
Scene build_corner(const Exhibit& exhibit);     ///< a wall and a floor that light each other
Scene build_booth(const Exhibit& exhibit);      ///< a gray room with samples and two cards
Scene build_patches(const Exhibit& exhibit);    ///< a grid of flat patches

} // namespace metamer
