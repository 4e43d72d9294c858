// An axis: from values to places on the picture, and the ticks that people read it by.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace metamer {

enum class Scale { linear, log10 };

struct Axis {
    std::string title{}; ///< with its unit
    Scale scale = Scale::linear;
    std::optional<double> low{}, high{};   ///< the ends; where unset they are fitted to the values
    double floor = 0;                      ///< log10 only: a fitted low end is not below this; 0: no floor
    std::vector<std::string> categories{}; ///< value i is the i-th name; no numbers then
};

/// The values at both ends; low < high, and above 0 on a log10 axis.
struct Range {
    double low = 0, high = 1;
};

/// The given ends, and for those not given, ends a little beyond the values that the scale can show. Without
/// any such value 1..10 on a log10 axis, else 0..1; n categories: -0.5..n-0.5. Throws bad_input `cannot draw
/// the axis TITLE: ...` for ends that are not finite, out of order, or not above 0 on a log10 axis.
Range fitted_range(const Axis& axis, std::span<const double> values);

struct Tick {
    double value = 0;
    std::string label{};
};

struct Ticks {
    std::vector<Tick> major{};   ///< ascending, inside the range
    std::vector<double> minor{}; ///< ascending, inside the range, none of the major ones
};

/// At most `most` >= 2 labeled ticks. Linear: a step of 1, 2 or 5 times a power of ten, minor ones at a
/// fifth or a fourth. Log10: the decades, every k-th where there are too many; 1, 2, 5 below two decades;
/// minor ones at 1..9; linear steps where even those give fewer than two. Categories: each one, labeled.
Ticks ticks(const Axis& axis, Range range, int most);

/// Where a value lies: px, and whether it is off the range (-1 below or not above 0 on a log10 axis, 1
/// above), in which case `at` is that end.
struct Place {
    double at = 0;
    int beyond = 0;
};

/// From values to px: `from_px` is the low end's place, `to_px` the high end's (above it, so less, on a y
/// axis).
class AxisMap {
public:
    AxisMap(Scale scale, Range range, double from_px, double to_px)
        : scale_(scale), range_(range), from_px_(from_px), to_px_(to_px) {}
    Place operator()(double value) const; ///< infinities lie beyond; not for NaN

private:
    Scale scale_;
    Range range_;
    double from_px_, to_px_;
};

} // namespace metamer
