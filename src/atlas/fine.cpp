#include "atlas/fine.h"

namespace metamer {

namespace {

double dot(const Xyz& a, const Xyz& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

Xyz xyz(const ColorMatching& row) {
    return {row.x, row.y, row.z};
}

// Sums over each interval's hat.
template <class Value>
std::array<Xyz, kIntervals> hat_sums(const Value& value) {
    std::array<Xyz, kIntervals> sums;
    const auto table = cie_1931_2deg();
    for (std::size_t k = 0; k < kReferenceGrid.count; ++k) {
        const HatShare at = hat_share(kReferenceGrid.wavelength_nm(k));
        const Xyz whole = value(k) * xyz(table[k]);
        sums[at.interval] = sums[at.interval] + (1 - at.share_of_next) * whole;
        sums[at.interval + 1] = sums[at.interval + 1] + at.share_of_next * whole;
    }
    return sums;
}

} // namespace

const std::array<Xyz, kIntervals>& interval_weights() {
    static const auto weights = [] {
        const GridObserver o = weighted_observer();
        std::array<Xyz, kIntervals> out;
        for (std::size_t i = 0; i < kIntervals; ++i)
            out[i] = {o.x[i], o.y[i], o.z[i]};
        return out;
    }();
    return weights;
}

RowValues projected(const FineValues& fine) {
    static const auto whole = hat_sums([](std::size_t) { return 1.0; });
    const auto sums = hat_sums([&](std::size_t k) { return fine[k]; });
    RowValues row;
    for (std::size_t i = 0; i < kIntervals; ++i)
        row[i] = dot(sums[i], whole[i]) / dot(whole[i], whole[i]);
    return row;
}

Xyz weighted_sum(const RowValues& row) {
    Xyz sum;
    const auto& weights = interval_weights();
    for (std::size_t i = 0; i < kIntervals; ++i)
        sum = sum + row[i] * weights[i];
    return sum;
}

Xyz ratio(const Xyz& a, const Xyz& b) {
    const auto of = [](double p, double q) { return q != 0 ? p / q : 1; };
    return {of(a.x, b.x), of(a.y, b.y), of(a.z, b.z)};
}

Xyz fine_sum(const FineValues& power, const FineValues& reflectance) {
    Xyz sum;
    const auto table = cie_1931_2deg();
    for (std::size_t k = 0; k < kReferenceGrid.count; ++k)
        sum = sum + (power[k] * reflectance[k]) * xyz(table[k]);
    return sum;
}

} // namespace metamer
