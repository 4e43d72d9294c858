#include "report/axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/numbers.h"
#include "report/number_text.h"

namespace metamer {

namespace {

constexpr double kRoom = 0.05; // of the range, between the outermost value and the end

// Computed in logarithms, the range of values up to the greatest double does not overflow.
Range with_room(double low, double high, Scale scale) {
    if (scale == Scale::log10) {
        const double from = std::log10(low), to = std::log10(high);
        const double room = to > from ? kRoom * (to - from) : 0.3;
        return {std::max(std::pow(10, from - room), std::numeric_limits<double>::min()),
                std::min(std::pow(10, to + room), std::numeric_limits<double>::max())};
    }
    if (high > low) {
        const double room = kRoom * (high - low);
        // Zero is an end that people expect.
        return {low >= 0 && low < high / 4 ? 0 : low - room, high + room};
    }
    const double room = low == 0 ? 1 : std::abs(low) / 2;
    return {low - room, high + room};
}

Range around_values(const Axis& axis, std::span<const double> values) {
    const bool log = axis.scale == Scale::log10;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const double value : values) {
        if (!std::isfinite(value) || (log && value <= 0))
            continue;
        const double raised = log ? std::max(value, axis.floor) : value;
        low = std::min(low, raised);
        high = std::max(high, raised);
    }
    if (low > high)
        return log ? Range{1, 10} : Range{0, 1};
    return with_room(low, high, axis.scale);
}

void refuse(const Axis& axis, const std::string& cause) {
    throw bad_input("draw", "the axis " + axis.title, cause);
}

} // namespace

Range fitted_range(const Axis& axis, std::span<const double> values) {
    if (!axis.categories.empty())
        return {-0.5, static_cast<double>(axis.categories.size()) - 0.5};
    for (const auto& end : {axis.low, axis.high}) {
        if (end && !std::isfinite(*end))
            refuse(axis, "an end is not finite");
        if (end && axis.scale == Scale::log10 && *end <= 0)
            refuse(axis, "an end is " + to_text(*end) + "; a logarithmic axis starts above 0");
    }
    Range range = around_values(axis, values);
    const bool log = axis.scale == Scale::log10;
    if (axis.low) {
        range.low = *axis.low;
        if (!axis.high && range.high <= range.low) // all values lie below the given end
            range.high = log ? range.low * 10 : range.low + 1;
    }
    if (axis.high) {
        range.high = *axis.high;
        if (!axis.low && range.low >= range.high)
            range.low = log ? range.high / 10 : range.high - 1;
    }
    if (!(range.low < range.high) || !std::isfinite(range.high - range.low))
        refuse(axis, "its ends are " + to_text(range.low) + " and " + to_text(range.high));
    return range;
}

Place AxisMap::operator()(double value) const {
    const bool log = scale_ == Scale::log10;
    if (value < range_.low)
        return {from_px_, -1};
    if (value > range_.high)
        return {to_px_, 1};
    const auto at = [&](double v) { return log ? std::log10(v) : v; };
    const double part = (at(value) - at(range_.low)) / (at(range_.high) - at(range_.low));
    return {from_px_ + part * (to_px_ - from_px_), 0};
}

} // namespace metamer
