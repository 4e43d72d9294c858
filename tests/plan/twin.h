// The CPU's word on a frame: the plan that an exhibit is drawn by, and any pixel by the twin of the method
// that draws it.
#pragma once

#include <algorithm>
#include <stdexcept>

#include "exhibit/exhibit.h"
#include "methods/shade.h"
#include "plan/object_pixels.h"
#include "plan/planner.h"

namespace metamer {

/// Of an exhibit as it is drawn, which must live longer. Without a half named: of the first.
class Twin {
public:
    explicit Twin(const Exhibit& exhibit)
        : exhibit_(exhibit), spectra_(exhibit), plan_(plan_exhibit(exhibit, spectra_)) {}

    const HalfView& view(std::size_t half = 0) const { return plan_of_half(half).view; }
    const ExhibitSpectra& spectra() const { return spectra_; }

    const ObjectPlan& plan_of(const ObjectSetting& object, std::size_t half = 0) const {
        for (const ObjectPlan& plan : plan_of_half(half).objects)
            if (plan.object == object.name)
                return plan;
        throw std::logic_error("no plan for " + object.name);
    }

    /// A pixel of the object under the half's lamps at diffuse 1; the medium at its full thickness.
    Pixel pixel_on(const ObjectSetting& object, std::size_t half = 0) const {
        return pixel_of(exhibit_, view(half), spectra_, object, object.material);
    }

    /// Linear RGB of a pixel by the object's method.
    LinearRgb light(const ObjectSetting& object, const Pixel& pixel) const {
        const ObjectPlan& plan = plan_of(object);
        const auto rgb = shade<float>(plan.method, pixel, sight_of(view(), spectra_, &plan.taps));
        return {static_cast<double>(rgb.r), static_cast<double>(rgb.g), static_cast<double>(rgb.b)};
    }

    EncodedRgb8 rgb8(const ObjectSetting& object, const Pixel& pixel) const {
        return encode_rgb8(view().output.transfer, light(object, pixel));
    }
    EncodedRgb8 rgb8(const ObjectSetting& object) const { return rgb8(object, pixel_on(object)); }

    /// The color of the exhibit's object in a half of an unlit scene; where there is one half only, in that.
    EncodedRgb8 color(std::size_t object, std::size_t half) const {
        const ObjectSetting& setting = exhibit_.objects[object];
        const ObjectPlan& plan = plan_of(setting, half);
        return shade_rgb8<float>(plan.method, pixel_on(setting, half),
                                 sight_of(view(half), spectra_, &plan.taps));
    }

private:
    const HalfPlan& plan_of_half(std::size_t half) const {
        return plan_.halves[std::min(half, plan_.halves.size() - 1)];
    }

    const Exhibit& exhibit_;
    ExhibitSpectra spectra_;
    Plan plan_;
};

/// The object of this name.
inline ObjectSetting& object_of(Exhibit& exhibit, std::string_view name) {
    for (ObjectSetting& object : exhibit.objects)
        if (object.name == name)
            return object;
    throw std::logic_error("no object of that name");
}

} // namespace metamer
