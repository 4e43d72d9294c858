// An exhibit's text with everything that is planned of it; keeps alive what plans point into.
#pragma once

#include <algorithm>
#include <string>

#include "exhibit/support.h"
#include "plan/planner.h"

namespace metamer::test {

struct Planned {
    Exhibit exhibit;
    ExhibitSpectra spectra;
    Plan plan;

    explicit Planned(const std::string& text, int fragment_bits = 23)
        : exhibit(parse_exhibit(text, "k.ini", config_folder())),
          spectra(exhibit),
          plan(plan_exhibit(exhibit, spectra, fragment_bits)) {}

    const ObjectPlan& of(const std::string& object, std::size_t half = 0) const {
        return *std::ranges::find(plan.halves.at(half).objects, object, &ObjectPlan::object);
    }
};

} // namespace metamer::test
