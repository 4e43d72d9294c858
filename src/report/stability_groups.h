// Which experiment is in which file. Private to this room.
#pragma once

#include "report/experiment.h"

namespace metamer {

// stability_lamps.cpp: narrow light
Experiment line_width();
Experiment line_position(const std::string& name, double from_nm, double to_nm);
Experiment tap_counts();

// stability_materials.cpp: what reflects
Experiment band_count();
Experiment band_spacing();
Experiment dark_materials();

// stability_rows.cpp: the atlas's 8 bits
Experiment dim_rows();
Experiment level_bits();
Experiment row_filtering();

// stability_half.cpp: half precision
Experiment summation_order();
Experiment key_precision();
Experiment texel_precision();

// stability_light.cpp: too much light, too little
Experiment strength();
Experiment violet_lamps();
Experiment red_lamps();

// stability_paths.cpp: light that meets several things
Experiment two_bounces();
Experiment thickness();

// stability_output.cpp: on the way to the screen
Experiment matrix_condition();
Experiment lightness_white();
Experiment outside_gamut();

} // namespace metamer
