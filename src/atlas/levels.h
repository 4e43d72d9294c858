// 8-bit levels of a row, chosen together.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "atlas/quadratic_form.h"

namespace metamer {

/// The levels, 0 .. 255, and their error (levels - wanted)' G (levels - wanted).
struct Levels {
    std::array<std::uint8_t, kIntervals> level;
    double error;
};

/// Integer levels near the real ones that `wanted` asks for (closest-vector problem): Babai's nearest plane
/// (Combinatorica 6, 1986) rounds from the last interval to the first, each error handed on to those that
/// follow; then coordinate descent over one level, or two at most three intervals apart, by one step each.
/// The outcome is a local minimum, deterministic.
class LevelSearch {
public:
    /// G must be positive definite. Factors it once; kept by reference: the form outlives the search.
    explicit LevelSearch(const QuadraticForm& form);

    /// `fixed`: the interval whose level is 255, whatever was wanted there.
    Levels nearest(const RowValues& wanted, std::optional<std::size_t> fixed = {}) const;

private:
    RowValues nearest_plane(const RowValues& wanted, std::optional<std::size_t> fixed) const;
    void descend(RowValues& level, const RowValues& wanted, std::optional<std::size_t> fixed) const;

    const QuadraticForm& form_;
    std::array<RowValues, kIntervals> upper_{}; ///< Cholesky factor U, G = U' U
};

} // namespace metamer
