#include "commands/half_table.h"

#include <algorithm>

#include "base/error.h"
#include "base/printed.h"
#include "color/difference.h"
#include "methods/shade.h"
#include "plan/planner.h"
#include "render/frame.h"
#include "spectra/library.h"

namespace metamer {

namespace {

// The color that the display gives to one half's code values, clamped as it clamps them.
Xyz shown(const Exhibit& exhibit, const ExhibitSpectra& spectra, const HalfPlan& half, std::size_t object) {
    const ObjectSetting& setting = exhibit.objects[object];
    Pixel pixel = pixel_of(exhibit, half.view, spectra, setting, setting.material);
    pixel.lamps.front().strength = 1;
    const ObjectPlan& plan = half.objects[object];
    const auto rgb = shade<double>(plan.method, pixel, sight_of(half.view, spectra, &plan.taps));
    const auto clamped = [](double v) { return std::clamp(v, 0.0, 1.0); };
    return to_xyz(xyz_from_display_rgb(exhibit.display), {clamped(rgb.r), clamped(rgb.g), clamped(rgb.b)});
}

Exhibit under_lamp(Exhibit exhibit, const std::string& name) {
    LampSetting setting;
    setting.lamp = find_lamp(name);
    setting.key = add_lamp(exhibit.atlas, setting.lamp);
    exhibit.lamps = {setting};
    return exhibit;
}

HalfDifference difference_under(const Exhibit& exhibit, const std::string& lamp) {
    const Exhibit lit = under_lamp(exhibit, lamp);
    const ExhibitSpectra spectra(lit);
    const Plan plan = plan_exhibit(lit, spectra);
    HalfDifference out{.lamp = lamp, .mean = 0, .greatest = -1, .worst_material = {}};
    for (std::size_t i = 0; i < lit.objects.size(); ++i) {
        const ObjectSetting& object = lit.objects[i];
        const double difference =
            delta_e_2000(shown(lit, spectra, plan.halves[0], i), shown(lit, spectra, plan.halves[1], i));
        out.mean += difference / static_cast<double>(lit.objects.size());
        if (difference > out.greatest) {
            out.greatest = difference;
            out.worst_material = object.material.material.name;
        }
    }
    return out;
}

} // namespace

std::vector<HalfDifference> half_differences(const Exhibit& exhibit) {
    if (!exhibit.compare)
        throw bad_input("compare the halves of", exhibit.place, "it has no section [compare]");
    std::vector<HalfDifference> out;
    for (const std::string& lamp : thesis_lamps())
        out.push_back(difference_under(exhibit, lamp));
    return out;
}

std::string half_table(const Exhibit& exhibit) {
    std::string out = "CIEDE2000 between the two halves as shown, all materials of " + exhibit.place +
                      ", strength 1\n" + "lamp          mean   greatest  material\n";
    for (const HalfDifference& row : half_differences(exhibit))
        out += printed("%-12s %5.2f   %8.2f  %s\n", row.lamp.c_str(), row.mean, row.greatest,
                       row.worst_material.c_str());
    return out;
}

} // namespace metamer
