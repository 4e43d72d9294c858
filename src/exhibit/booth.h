// The light booth: one set of materials under two lamps, and a pair of cards that tells them apart.
#pragma once

#include "exhibit/exhibit.h"

namespace metamer {

inline constexpr int kMostSamples = 12; ///< sample cards that stand in the booth

/// The pair's materials: grays of one color under `matching`, as different as physics allows under `parting`,
/// of the grays of Y = 0.2, 0.3 and 0.4 those that part the most.
struct CardMaterials {
    Material a, b;
};
CardMaterials card_materials(const Lamp& matching, const Lamp& parting);

/// Gives the booth's cards that nobody gave a material their part of the pair: `card-a` and `card-b` match
/// under the left half's lamp and part under the right half's; without [compare] they match under lamp 1 and
/// part under the first of D65 and F11 that is another. Adds them to the exhibit's atlas; throws bad_input
/// where it is full. Other scenes stay as they are.
void give_cards(Exhibit& exhibit);

/// The booth for two lamps (only lamp and key of each count), each half all of it under its own: the base's
/// display and accuracy, its first 12 materials as samples, the cards made for these lamps, method auto. Two
/// lamps of that spectrum, as in config/booth.ini: one from above casts shadows, one in front fills them. It
/// has an atlas of its own, with keys of its own, and no kiosk.
Exhibit booth_exhibit(const Exhibit& base, const LampSetting& left, const LampSetting& right);

} // namespace metamer
