// Exhibits that charts are measured on: one exhibit by each method, and pairs of lamp and material without a
// scene.
#pragma once

#include <span>
#include <vector>

#include "exhibit/exhibit.h"

namespace metamer {

/// The whole frame by one method (none: the planner's choice), whatever objects and halves ask for; no
/// halves. `taps`: of method reduced.
Exhibit drawn_by(const Exhibit& exhibit, MethodChoice method, int taps);

/// The same as if only the atlas's rows were known of its lamps and materials.
Exhibit from_atlas_alone(const Exhibit& exhibit);

/// Every lamp with every material, as exhibits of one lamp and up to 63 materials on one object each: a chart
/// over more lamps and materials than an atlas holds. At least one of each. The same material twice under one
/// name counts once; throws bad_input for two of one name that differ, and what add_lamp and add_material
/// throw.
std::vector<Exhibit> pair_exhibits(std::span<const Lamp> lamps, std::span<const Material> materials,
                                   const Display& display);

} // namespace metamer
