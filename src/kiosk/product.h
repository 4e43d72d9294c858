// What a tapped object's panel says: lamp x material = eye.
#pragma once

#include "overlay/widget.h"
#include "overlay/words.h"
#include "plan/exhibit_spectra.h"
#include "plan/planner.h"
#include "visit/visit_state.h"

namespace metamer {

/// The panel of an object under the left half's dominant lamp, its lamps' strengths scaled to 1 in sum,
/// evenly lit. The two colors are what the halves' planned methods make of it (methods/shade.h, in double),
/// their difference is of XYZ before any clamping. None where the exhibit has no such object or material.
std::optional<ProductPanel> product_panel(const Exhibit& exhibit, const Plan& plan,
                                          const ExhibitSpectra& spectra, const Seen& seen, const Words& words,
                                          const std::string& language);

/// The emission of a lamp of an exhibit's atlas as bars: greatest 1.
Bars lamp_bars(const Atlas& atlas, int key);

/// What a half is, in words: how it computes where the halves differ in that, else its lamp, else its space.
enum class HalfName { full, brief };
std::string half_name(const Exhibit& exhibit, const Plan& plan, std::size_t half, HalfName kind,
                      const Words& words, const std::string& language);

} // namespace metamer
