// Chromatic adaptation.
#pragma once

#include "color/matrix3.h"

namespace metamer {

/// Whether the eye is taken to be adapted to the display (none) or to the lamp (bradford).
enum class Adaptation { none, bradford };

/// The linear Bradford transform from one white to another (Lam 1985; ICC.1:2022 annex E.3): XYZ seen under
/// `from_white` to the XYZ that looks alike under `to_white`. Identity for equal whites. Throws bad_input
/// when `from_white` excites a cone response of the Bradford basis by less than 1e-3 of its Y (low-pressure
/// sodium has no blue to adapt with: the gain would be without bound).
Matrix3 bradford(const Xyz& from_white, const Xyz& to_white);

} // namespace metamer
