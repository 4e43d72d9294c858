// The CPU's word on an unlit scene: each object is one color in each half, by the twin of the method that the
// plan draws it with.
#pragma once

#include <algorithm>

#include "methods/shade.h"
#include "plan/object_pixels.h"
#include "plan/planner.h"

namespace metamer {

/// Of an exhibit as it is drawn; it must live as long.
class ColorTwin {
public:
    explicit ColorTwin(const Exhibit& drawn)
        : exhibit_(drawn), spectra_(drawn), plan_(plan_exhibit(drawn, spectra_)) {}

    EncodedRgb8 color(std::size_t object, std::size_t half) const {
        const HalfPlan& plan = plan_.halves[std::min(half, plan_.halves.size() - 1)];
        const ObjectSetting& setting = exhibit_.objects[object];
        const Pixel pixel = pixel_of(exhibit_, plan.view, spectra_, setting, setting.material);
        const ObjectPlan& planned = plan.objects[object];
        return shade_rgb8<float>(planned.method, pixel, sight_of(plan.view, spectra_, &planned.taps));
    }

private:
    const Exhibit& exhibit_;
    ExhibitSpectra spectra_;
    Plan plan_;
};

} // namespace metamer
