#include "report/stability.h"

#include "report/stability_groups.h"

namespace metamer {

namespace {

void add(std::vector<Experiment>& all, const std::string& group, std::vector<Experiment> experiments) {
    for (Experiment& experiment : experiments) {
        experiment.group = group;
        all.push_back(std::move(experiment));
    }
}

} // namespace

std::vector<Experiment> stability_experiments() {
    std::vector<Experiment> all;
    add(all, "narrow light",
        {line_width(), line_position("Position of a line, green", 540, 550),
         line_position("Position of a line, yellow", 580, 595), tap_counts()});
    add(all, "materials", {band_count(), band_spacing(), dark_materials()});
    add(all, "rows of the atlas", {dim_rows(), level_bits(), row_filtering()});
    add(all, "half precision", {summation_order(), key_precision(), texel_precision()});
    add(all, "too much light and too little", {strength(), violet_lamps(), red_lamps()});
    add(all, "light on its way", {two_bounces(), thickness()});
    add(all, "on the way to the screen", {matrix_condition(), lightness_white(), outside_gamut()});
    return all;
}

} // namespace metamer
