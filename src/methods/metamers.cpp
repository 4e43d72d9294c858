#include "methods/metamers.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "base/numbers.h"
#include "color/difference.h"
#include "color/observer.h"
#include "methods/color_program.h"

namespace metamer {

namespace {

constexpr int kDirections = 64;
constexpr int kMostClimbs = 16;

Triple triple(const Xyz& c) {
    return {c.x, c.y, c.z};
}

// The reference integration is linear in the reflectance: its columns.
std::vector<Triple> colors_under(const ReferenceLamp& lamp) {
    std::vector<Triple> out;
    const auto observer = cie_1931_2deg();
    for (std::size_t i = 0; i < observer.size(); ++i) {
        const double light = lamp.power[i] / lamp.k;
        out.push_back({light * observer[i].x, light * observer[i].y, light * observer[i].z});
    }
    return out;
}

/// One end of a pair: the reflectance that goes furthest in some direction of XYZ under the parting lamp.
struct End {
    std::vector<double> reflectance;
    Xyz parting;
};

struct Pair {
    End a, b;
    double delta_e_2000 = -1;
};

class Search {
public:
    Search(const ReferenceLamp& matching, const ReferenceLamp& parting, const Xyz& xyz)
        : lamp_(parting),
          program_{colors_under(matching), triple(xyz)},
          parting_(colors_under(parting)),
          extremes_(program_) {}

    End end(const Triple& direction) {
        std::vector<double> weight(parting_.size());
        std::ranges::transform(parting_, weight.begin(), [&](const Triple& c) { return dot(direction, c); });
        std::optional<Extreme> found = extremes_.greatest(weight);
        if (!found)
            refuse();
        hold_where_dark(found->reflectance);
        const Xyz color = reference_xyz(lamp_, found->reflectance);
        return {std::move(found->reflectance), color};
    }

private:
    // Where neither lamp shines any reflectance will do: as its neighbor.
    void hold_where_dark(std::vector<double>& reflectance) const {
        const auto is_lit = [&](std::size_t i) {
            return dot(parting_[i], parting_[i]) + dot(program_.color[i], program_.color[i]) > 0;
        };
        std::size_t first = 0;
        while (first + 1 < reflectance.size() && !is_lit(first))
            ++first;
        for (std::size_t i = 0; i < first; ++i)
            reflectance[i] = reflectance[first];
        for (std::size_t i = first + 1; i < reflectance.size(); ++i)
            if (!is_lit(i))
                reflectance[i] = reflectance[i - 1];
    }

    [[noreturn]] void refuse() const {
        const Triple& t = program_.target;
        throw bad_input("find", "a metameric pair",
                        "no reflectance of 0 .. 1 has X Y Z = " + to_text(t[0]) + " " + to_text(t[1]) + " " +
                            to_text(t[2]) + " under the lamp where they are to match");
    }

    const ReferenceLamp& lamp_;
    ColorProgram program_;
    std::vector<Triple> parting_;
    ColorExtremes extremes_;
};

Pair pair_of(End a, End b) {
    const double difference = delta_e_2000(a.parting, b.parting);
    return {std::move(a), std::move(b), difference};
}

// Point i of n, evenly over the upper half of the unit sphere (Fibonacci's lattice): opposite points are one
// pair.
Triple lattice_point(int i, int n) {
    const double z = (i + 0.5) / n, r = std::sqrt(1 - z * z);
    const double turn = 2 * std::numbers::pi * i * (std::numbers::phi - 1);
    return {r * std::cos(turn), r * std::sin(turn), z};
}

// Evenly as the eye sees it: the lattice in the space where CIEDE2000 is a length near `color`.
Triple direction_of(const Triple& point, const Matrix3& slopes) {
    Triple out{};
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t l = 0; l < 3; ++l)
            out[k] += slopes.m[l][k] * point[l];
    const double length = std::sqrt(dot(out, out));
    return {out[0] / length, out[1] / length, out[2] / length};
}

// Where CIEDE2000 from `other` grows the fastest.
Triple uphill(const Xyz& from, const Xyz& other) {
    constexpr double kStep = 1e-6;
    Triple slope{};
    for (std::size_t k = 0; k < 3; ++k) {
        const Xyz step{k == 0 ? kStep : 0, k == 1 ? kStep : 0, k == 2 ? kStep : 0};
        slope[k] = delta_e_2000(from + step, other) - delta_e_2000(from + -1 * step, other);
    }
    const double length = std::sqrt(dot(slope, slope));
    return length > 0 ? Triple{slope[0] / length, slope[1] / length, slope[2] / length} : Triple{0, 1, 0};
}

// Each end in turn goes where the difference grows, until neither can.
Pair climbed(Search& search, Pair best) {
    for (int climb = 0; climb < kMostClimbs; ++climb) {
        const double before = best.delta_e_2000;
        Pair next = pair_of(search.end(uphill(best.a.parting, best.b.parting)), best.b);
        if (next.delta_e_2000 > best.delta_e_2000)
            best = std::move(next);
        next = pair_of(best.a, search.end(uphill(best.b.parting, best.a.parting)));
        if (next.delta_e_2000 > best.delta_e_2000)
            best = std::move(next);
        if (best.delta_e_2000 <= before + 1e-9)
            break;
    }
    return best;
}

// As a gray of this Y.
Xyz expected(const Xyz& xyz, const ReferenceLamp& parting) {
    return xyz.y * reference_white(parting);
}

MaterialSpectrum material(std::vector<double> reflectance) {
    MaterialSpectrum out;
    for (std::size_t i = 0; i < kReferenceGrid.count; ++i)
        out.curve.wavelength_nm.push_back(kReferenceGrid.wavelength_nm(i));
    out.curve.value = std::move(reflectance);
    return out;
}

} // namespace

MetamericPair metameric_pair(const ReferenceLamp& matching, const ReferenceLamp& parting, const Xyz& xyz) {
    Search search(matching, parting, xyz);
    const Matrix3 slopes = delta_e_2000_slopes(expected(xyz, parting));
    Pair best;
    for (int i = 0; i < kDirections; ++i) {
        const Triple d = direction_of(lattice_point(i, kDirections), slopes);
        Pair pair = pair_of(search.end(d), search.end({-d[0], -d[1], -d[2]}));
        if (pair.delta_e_2000 > best.delta_e_2000)
            best = std::move(pair);
    }
    best = climbed(search, std::move(best));
    const Xyz match = reference_xyz(matching, best.a.reflectance);
    return {material(std::move(best.a.reflectance)),
            material(std::move(best.b.reflectance)),
            match,
            best.a.parting,
            best.b.parting,
            best.delta_e_2000};
}

} // namespace metamer
