// The CPU's word on a frame: the plan that an exhibit's first half is drawn by, and any pixel by the twin of
// the method that draws it.
#pragma once

#include <stdexcept>

#include "exhibit/exhibit.h"
#include "methods/shade.h"
#include "plan/planner.h"

namespace metamer {

/// The exhibit must live longer.
class Twin {
public:
    explicit Twin(const Exhibit& exhibit)
        : exhibit_(exhibit), spectra_(exhibit), plan_(plan_exhibit(exhibit, spectra_)) {}

    const HalfView& view() const { return plan_.halves.front().view; }
    const ExhibitSpectra& spectra() const { return spectra_; }

    const ObjectPlan& plan_of(const ObjectSetting& object) const {
        for (const ObjectPlan& plan : plan_.halves.front().objects)
            if (plan.object == object.name)
                return plan;
        throw std::logic_error("no plan for " + object.name);
    }

    /// A pixel of the object under the half's lamps at diffuse 1; the medium at its full thickness.
    Pixel pixel_on(const ObjectSetting& object) const {
        return pixel_of(exhibit_, view(), spectra_, object, object.material);
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

private:
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
