// What a tapped object's panel says: lamp x material = eye.
#pragma once

#include "overlay/widget.h"
#include "overlay/words.h"
#include "plan/exhibit_spectra.h"
#include "plan/planner.h"
#include "visit/visit_state.h"

namespace metamer {

/// The panel of an object under the left half's lamps, their strengths scaled to 1 in sum, evenly lit; behind
/// a medium where that is thickest. The plots are of what the colors are computed from, 5 nm a bar, the lamps
/// weighted as in equation 7.10: the third is the first times the second. The two colors are what the halves'
/// planned methods make of it (methods/shade.h, in double), their difference is of XYZ before any clamping.
/// None where the exhibit has no such object or material.
std::optional<ProductPanel> product_panel(const Exhibit& exhibit, const Plan& plan,
                                          const ExhibitSpectra& spectra, const Seen& seen, const Words& words,
                                          const std::string& language);

/// The emission of a lamp as bars, 5 nm each: greatest 1. `atlas`: of its exhibit, for a lamp that is known
/// by its row only.
Bars lamp_bars(const LampSetting& lamp, const Atlas& atlas);

/// Whether nobody can tell the booth's two cards apart in a half, evenly lit: CIEDE2000 below 1.
bool cards_match(const Exhibit& booth, const Plan& plan, const ExhibitSpectra& spectra, std::size_t half);

/// What a half is, in words: how it computes where the halves differ in that, else its lamp, else its space.
enum class HalfName { full, brief };
std::string half_name(const Exhibit& exhibit, const Plan& plan, std::size_t half, HalfName kind,
                      const Words& words, const std::string& language);

} // namespace metamer
