#include <algorithm>
#include <cmath>

#include "report/axis.h"
#include "report/number_text.h"

namespace metamer {

namespace {

// A hair beyond the ends still counts: 0.1 + 0.2 is an end of 0.3.
bool within(Range range, double value) {
    const double hair = 1e-9 * (range.high - range.low);
    return value >= range.low - hair && value <= range.high + hair;
}

// Multiples of step * power of ten inside the range, computed from whole numbers so that 0 is 0.
std::vector<double> multiples(Range range, int step, int exponent) {
    std::vector<double> out;
    const double unit = step * std::pow(10, std::abs(exponent));
    const auto value = [&](double k) { return exponent < 0 ? k * step / std::pow(10, -exponent) : k * unit; };
    const double size = value(1);
    for (double k = std::floor(range.low / size); k <= std::ceil(range.high / size); ++k)
        if (within(range, value(k)))
            out.push_back(k == 0 ? 0 : value(k));
    return out;
}

// Enough digits for neighbors to differ, however far from zero they are.
int digits_for(Range range, double step) {
    const double greatest = std::max(std::abs(range.low), std::abs(range.high));
    return std::clamp(1 + static_cast<int>(std::floor(std::log10(greatest / step) + 1e-9)), 1, 15) + 1;
}

void leave_out(std::vector<double>& minor, const std::vector<Tick>& major) {
    std::erase_if(minor, [&](double value) {
        return std::any_of(major.begin(), major.end(), [&](const Tick& tick) {
            return std::abs(tick.value - value) <= 1e-9 * std::max(std::abs(value), std::abs(tick.value));
        });
    });
}

Ticks linear_ticks(Range range, int most) {
    const double rough = (range.high - range.low) / most;
    int exponent = static_cast<int>(std::floor(std::log10(rough))), step = 1;
    std::vector<double> values = multiples(range, step, exponent);
    while (values.size() > static_cast<std::size_t>(most)) {
        step = step == 1 ? 2 : step == 2 ? 5 : 1;
        exponent += step == 1;
        values = multiples(range, step, exponent);
    }
    Ticks out;
    for (const double value : values)
        out.major.push_back({value, short_number(value, digits_for(range, step * std::pow(10, exponent)))});
    out.minor = step == 2 ? multiples(range, 5, exponent - 1)
                          : multiples(range, step == 1 ? 2 : 1, exponent - (step == 1));
    leave_out(out.minor, out.major);
    return out;
}

std::vector<double> in_decades(Range range, std::initializer_list<int> digits) {
    std::vector<double> out;
    const int first = static_cast<int>(std::floor(std::log10(range.low)));
    for (int e = first; e <= static_cast<int>(std::ceil(std::log10(range.high))); ++e)
        for (const int digit : digits) {
            const double value = e < 0 ? digit / std::pow(10, -e) : digit * std::pow(10, e);
            if (std::isfinite(value) && value >= range.low * (1 - 1e-9) && value <= range.high * (1 + 1e-9))
                out.push_back(value);
        }
    return out;
}

Ticks log_ticks(Range range, int most) {
    Ticks out;
    std::vector<double> decades = in_decades(range, {1});
    std::vector<double> labeled =
        std::log10(range.high / range.low) < 2 ? in_decades(range, {1, 2, 5}) : decades;
    if (labeled.size() > static_cast<std::size_t>(most))
        labeled = decades;
    if (labeled.size() < 2)
        return linear_ticks(range, most);
    const std::size_t every =
        (labeled.size() + static_cast<std::size_t>(most) - 1) / static_cast<std::size_t>(most);
    for (std::size_t i = 0; i < labeled.size(); i += every)
        out.major.push_back({labeled[i], short_number(labeled[i], 1)});
    out.minor = every == 1 ? in_decades(range, {1, 2, 3, 4, 5, 6, 7, 8, 9}) : decades;
    leave_out(out.minor, out.major);
    return out;
}

} // namespace

Ticks ticks(const Axis& axis, Range range, int most) {
    if (!axis.categories.empty()) {
        Ticks out;
        for (std::size_t i = 0; i < axis.categories.size(); ++i)
            out.major.push_back({static_cast<double>(i), axis.categories[i]});
        return out;
    }
    return axis.scale == Scale::log10 ? log_ticks(range, most) : linear_ticks(range, most);
}

} // namespace metamer
