// Places for labels: near what they name, over nothing that matters, never over one another.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "report/geometry.h"

namespace metamer {

/// A label that seeks a place.
struct LabelWish {
    Px anchor;                    ///< what it names
    double width = 0, height = 0; ///< px
    double farthest = 0;          ///< greatest distance from the anchor, px; 0: wherever there is room
    std::optional<Box> wanted{};  ///< taken if it is free
    double gap = 4;               ///< least distance from the anchor, px
};

/// What labels should keep off: markers, bars, lines. `weight` 1 for what may be covered if it must be, more
/// for what should not.
struct Obstacle {
    Box box;
    double weight = 1;
};

/// A stretch of a column: where its middle should be and how long it is, px.
struct Stretch {
    double middle = 0, length = 0;
};

/// The starts of stretches that follow one another in the order given without overlap between `from` and
/// `to`, with the least sum of squared distances from where they should be (pool adjacent violators, Ayer et
/// al. 1955). What is longer together than the column runs over its end.
std::vector<double> spread_out(std::span<const Stretch> stretches, double from, double to);

/// For each wish a box of its size inside `bounds`, at least 1 px from every other; none for a label for
/// which there is no such place within its reach. Earlier wishes choose first: the cheapest of places on
/// rings around the anchor, where distance, covered obstacles and a leader line that crosses other labels
/// cost; if no ring has a free place and `farthest` is 0, the nearest free place of the whole bounds.
std::vector<std::optional<Box>> place_labels(std::span<const LabelWish> wishes,
                                             std::span<const Obstacle> obstacles, const Box& bounds);

} // namespace metamer
