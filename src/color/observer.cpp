#include "color/observer.h"

#include <algorithm>

namespace metamer {

GridObserver sampled_observer() {
    const auto table = cie_1931_2deg();
    GridObserver o;
    double greatest = 0;
    for (std::size_t i = 0; i < kIntervals; ++i) {
        const auto row = static_cast<std::size_t>(kThesisGrid.wavelength_nm(i) - kReferenceGrid.first_nm);
        o.x[i] = table[row].x;
        o.y[i] = table[row].y;
        o.z[i] = table[row].z;
        greatest = std::max({greatest, o.x[i], o.y[i], o.z[i]});
    }
    for (auto* function : {&o.x, &o.y, &o.z})
        for (double& value : *function)
            value /= greatest;
    return o;
}

} // namespace metamer
