// What is on the screen, in words: for tests, and for whoever reads screens aloud.
#pragma once

#include <string>

#include "kiosk/desk.h"
#include "visit/motion.h"
#include "window/rotation.h"

namespace metamer {

/// One JSON document:
/// {"width_px","height_px","phase","mode","language","split","strength","scene":[left,top,width,
/// height],"widgets":[{"part","index","box":[..],"text","on","focused","value","colors","rows"}]}, of which
/// "colors" are a panel's two and "rows" the expert view's. Boxes are px of the picture as people see it, the
/// shift against burn-in included.
std::string description(const Desk& desk, const Visit& visit, PxSize picture, Shift shift);

/// The part's name there: `left-label`, `lamp`, `expert-panel`.
const char* part_name(Part part);

} // namespace metamer
