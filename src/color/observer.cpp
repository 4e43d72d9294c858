#include "color/observer.h"

#include <algorithm>
#include <cmath>

namespace metamer {

namespace {

void divide_by_greatest(GridObserver& o) {
    double greatest = 0;
    for (const auto* function : {&o.x, &o.y, &o.z})
        greatest = std::max(greatest, *std::max_element(function->begin(), function->end()));
    for (auto* function : {&o.x, &o.y, &o.z})
        for (double& value : *function)
            value /= greatest;
}

} // namespace

GridObserver sampled_observer() {
    const auto table = cie_1931_2deg();
    GridObserver o;
    for (std::size_t i = 0; i < kIntervals; ++i) {
        const auto row = static_cast<std::size_t>(kThesisGrid.wavelength_nm(i) - kReferenceGrid.first_nm);
        o.x[i] = table[row].x;
        o.y[i] = table[row].y;
        o.z[i] = table[row].z;
    }
    divide_by_greatest(o);
    return o;
}

GridObserver weighted_observer() {
    const auto table = cie_1931_2deg();
    GridObserver o;
    for (std::size_t k = 0; k < table.size(); ++k) {
        const HatShare at = hat_share(kReferenceGrid.wavelength_nm(k));
        const auto add = [&](std::size_t i, double share) {
            o.x[i] += share * table[k].x;
            o.y[i] += share * table[k].y;
            o.z[i] += share * table[k].z;
        };
        add(at.interval, 1 - at.share_of_next);
        add(at.interval + 1, at.share_of_next);
    }
    divide_by_greatest(o);
    return o;
}

HatShare hat_share(double wavelength_nm) {
    const double last = static_cast<double>(kIntervals - 1);
    const double at = std::clamp((wavelength_nm - kThesisGrid.first_nm) / kThesisGrid.step_nm, 0.0, last);
    const double interval = std::min(std::floor(at), last - 1);
    return {static_cast<std::size_t>(interval), at - interval};
}

} // namespace metamer
