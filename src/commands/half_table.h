// How far the two halves of a comparison part, lamp by lamp.
#pragma once

#include <string>
#include <vector>

#include "exhibit/exhibit.h"

namespace metamer {

/// The CIEDE2000 between what the two halves make of an exhibit's materials under one lamp.
struct HalfDifference {
    std::string lamp;
    double mean = 0, greatest = 0;
    std::string worst_material; ///< the material of the greatest
};

/// For each of the thesis's fifteen lamps, in its order, the lamp in place of the exhibit's (a half's own
/// lamp stays): the differences over the exhibit's materials at strength 1, seen through their media where
/// these are thickest, of the colors as the display shows them: in its working space or own matrix, clamped,
/// not rounded. Throws bad_input for an exhibit without [compare].
std::vector<HalfDifference> half_differences(const Exhibit& exhibit);

/// The same as a table for people.
std::string half_table(const Exhibit& exhibit);

} // namespace metamer
