#include "atlas/levels.h"

#include <algorithm>
#include <cmath>

namespace metamer {

namespace {

constexpr double kMostLevel = 255;
constexpr std::size_t kReach = 3; // intervals between two levels that move together
constexpr int kMostRounds = 32;

double rounded(double v) {
    constexpr double round_off = 1e-7; // a half is rounded up on every machine
    return std::clamp(std::floor(v + 0.5 + round_off), 0.0, kMostLevel);
}

bool is_level(double v) {
    return v >= 0 && v <= kMostLevel;
}

// The levels on their way down, and the slope G (level - wanted).
struct Descent {
    const QuadraticForm& form;
    RowValues& level;
    RowValues slope;
    double least_gain;

    void move(std::size_t i, double step) {
        level[i] += step;
        for (std::size_t k = 0; k < kIntervals; ++k)
            slope[k] += step * form.g[i][k];
    }

    bool try_one(std::size_t i) {
        const double step = slope[i] > 0 ? -1 : 1;
        if (!is_level(level[i] + step) || 2 * step * slope[i] + form.g[i][i] > -least_gain)
            return false;
        move(i, step);
        return true;
    }

    bool try_two(std::size_t i, std::size_t j) {
        for (const double a : {-1.0, 1.0})
            for (const double b : {-1.0, 1.0}) {
                const double gain = 2 * (a * slope[i] + b * slope[j]) + form.g[i][i] + form.g[j][j] +
                                    2 * a * b * form.g[i][j];
                if (!is_level(level[i] + a) || !is_level(level[j] + b) || gain > -least_gain)
                    continue;
                move(i, a);
                move(j, b);
                return true;
            }
        return false;
    }
};

RowValues difference(const RowValues& a, const RowValues& b) {
    RowValues d;
    for (std::size_t i = 0; i < kIntervals; ++i)
        d[i] = a[i] - b[i];
    return d;
}

double product(const RowValues& a, const RowValues& b) {
    double sum = 0;
    for (std::size_t i = 0; i < kIntervals; ++i)
        sum += a[i] * b[i];
    return sum;
}

} // namespace

LevelSearch::LevelSearch(const QuadraticForm& form) : form_(form) {
    // Row by row: what the rows above explain is taken off first.
    for (std::size_t i = 0; i < kIntervals; ++i) {
        RowValues rest = form.g[i];
        for (std::size_t k = 0; k < i; ++k)
            for (std::size_t j = i; j < kIntervals; ++j)
                rest[j] -= upper_[k][i] * upper_[k][j];
        const double root = std::sqrt(std::max(rest[i], 1e-12 * form.g[i][i]));
        for (std::size_t j = i; j < kIntervals; ++j)
            upper_[i][j] = rest[j] / root;
        upper_[i][i] = root;
    }
}

RowValues LevelSearch::nearest_plane(const RowValues& wanted, std::optional<std::size_t> fixed) const {
    RowValues level{};
    for (std::size_t i = kIntervals; i-- > 0;) {
        double handed_on = 0;
        for (std::size_t j = i + 1; j < kIntervals; ++j)
            handed_on += upper_[i][j] * (level[j] - wanted[j]);
        level[i] = fixed == i ? kMostLevel : rounded(wanted[i] - handed_on / upper_[i][i]);
    }
    return level;
}

void LevelSearch::descend(RowValues& level, const RowValues& wanted, std::optional<std::size_t> fixed) const {
    double scale = 0;
    for (std::size_t i = 0; i < kIntervals; ++i)
        scale = std::max(scale, form_.g[i][i]);
    // A gain must be more than round-off, or two roundings could take turns.
    Descent descent{form_, level, form_.times(difference(level, wanted)), 1e-8 * scale};
    bool moved = true;
    for (int round = 0; moved && round < kMostRounds; ++round) {
        moved = false;
        for (std::size_t i = 0; i < kIntervals; ++i) {
            if (fixed == i)
                continue;
            moved |= descent.try_one(i);
            for (std::size_t j = i + 1; j < std::min(kIntervals, i + kReach + 1); ++j)
                if (fixed != j)
                    moved |= descent.try_two(i, j);
        }
    }
}

Levels LevelSearch::nearest(const RowValues& wanted, std::optional<std::size_t> fixed) const {
    RowValues level = nearest_plane(wanted, fixed);
    descend(level, wanted, fixed);
    const RowValues off = difference(level, wanted);
    Levels out{{}, product(off, form_.times(off))};
    std::transform(level.begin(), level.end(), out.level.begin(),
                   [](double v) { return static_cast<std::uint8_t>(v); });
    return out;
}

} // namespace metamer
