#include <numbers>

#include "atlas/fine_shapes.h"
#include "atlas/lamp_fit.h"

namespace metamer {

namespace {

// On the grid's wavelengths as it is there; the ends stand for all that lies beyond them.
RowValues row_of(const FineValues& fine) {
    RowValues row = projected(fine);
    for (std::size_t i = 1; i + 1 < kIntervals; ++i)
        row[i] = fine[static_cast<std::size_t>(kThesisGrid.wavelength_nm(i) - kReferenceGrid.first_nm)];
    return row;
}

Xyz xyz_error(const RowValues& row, const FineValues& fine) {
    FineValues equal_energy;
    equal_energy.fill(1);
    RowValues white;
    white.fill(1);
    const double row_k = weighted_sum(white).y, fine_k = fine_sum(equal_energy, equal_energy).y;
    return ratio((1 / row_k) * weighted_sum(row), (1 / fine_k) * fine_sum(equal_energy, fine));
}

std::vector<PriorMaterial> make_materials() {
    std::vector<PriorMaterial> all;
    const auto add = [&](double weight, const auto& value) {
        const FineValues fine = fine_values(value);
        const RowValues row = row_of(fine);
        all.push_back({fine, row, xyz_error(row, fine), weight});
    };
    add(2, [](double) { return 1.0; });
    for (double c = 410; c < 690; c += 20) {
        add(0.3, [&](double w) { return 0.03 + 0.9 * bell(w, c, 25); });
        add(0.3, [&](double w) { return 0.9 - 0.85 * bell(w, c, 25); });
        add(0.3, [&](double w) { return 0.03 + 0.9 * rise(w, c, 12); });
        add(0.3, [&](double w) { return 0.9 - 0.85 * rise(w, c, 12); });
        add(0.1, [&](double w) { return 0.03 + 0.9 * bell(w, c, 8); });
        add(0.1, [&](double w) { return 0.05 + 0.3 * rise(w, c, 5); });
    }
    for (const double period_nm : {40.0, 70.0, 110.0, 170.0})
        for (const double quarter : {0.0, 0.5, 1.0, 1.5})
            add(0.2, [&](double w) {
                return 0.4 + 0.35 * std::sin((2 * w / period_nm + quarter) * std::numbers::pi);
            });
    return all;
}

} // namespace

const std::vector<PriorMaterial>& prior_materials() {
    static const auto all = make_materials();
    return all;
}

} // namespace metamer
