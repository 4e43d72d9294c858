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

/// A factor of brightness as people read it, to two digits: `0.25`, `1.5`, `12`.
std::string factor_words(double factor, const Words& words, const std::string& language);

/// What a half is, in words: by numbers or by wavelengths where the halves differ in that; else what they do
/// differ in: the lamp, the space, the lamps' strength, the method.
enum class HalfName { full, brief };
std::string half_name(const Exhibit& exhibit, const Plan& plan, std::size_t half, HalfName kind,
                      const Words& words, const std::string& language);

} // namespace metamer
