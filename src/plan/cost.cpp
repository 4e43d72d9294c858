#include "plan/cost.h"

namespace metamer {

namespace {

constexpr double kExponential = 12, kRoot = 4;
constexpr double kCurve = 3 * (kRoot + 8), kPowCurve = 3 * (2 * kExponential + 4), kMatrix = 9;

double lighting(const PixelWork& work) {
    if (!work.lit)
        return 1;
    const double normal = 10, diffuse = 24, highlight = 2 * kExponential + 20;
    return normal + work.lamps * (diffuse + (work.mirrors ? highlight : 0));
}

double key_fetches(const PixelWork& work) {
    return work.surface == Surface::maps ? 2 * kFetch : 0; // key and luminance
}

double product_color(const PixelWork& work) {
    double cost = work.method == Method::rgb ? 0 : kMatrix;
    if (work.surface == Surface::maps)
        cost += 2 * kFetch + 9;
    if (work.surface == Surface::ramp)
        cost += 6;
    if (work.surface == Surface::ramp_codes)
        cost += kPowCurve;
    if (work.surface == Surface::medium)
        cost += 3 * kExponential;
    return cost + work.lamps * (work.surface == Surface::bounce ? 12 : 9);
}

double folded_color(const PixelWork& work) {
    const double lamps = work.lit ? work.lamps : 1; // without shading all lamps are one
    if (work.surface == Surface::maps)
        return lamps * (2 * kFetch + 15);
    const double terms = 1 + (work.mirrors && work.lit ? 1 : 0) +
                         (work.surface == Surface::bounce || work.surface == Surface::ramp ? 1 : 0);
    return lamps * 3 * terms;
}

double reduced_color(const PixelWork& work) {
    const double lamps = work.lit ? work.lamps : 1;
    const bool table = lamps > 1 || work.taps > 8;
    double tap = lamps * (8 + (table ? 2 * kFetch : 0));
    if (work.surface == Surface::medium)
        tap += kExponential + (table ? 2 * kFetch : 0);
    if (work.surface == Surface::maps || work.surface == Surface::ramp)
        tap += kFetch;
    return work.taps * tap;
}

double loop_color(const PixelWork& work) {
    const double width = work.method == Method::packed ? 4 : 1, rounds = 64 / width;
    const double observers = work.method == Method::packed ? 3 : 1;
    double round = kFetch * (observers + 1 + work.lamps) + width * work.lamps * 8;
    if (work.surface != Surface::plain && work.surface != Surface::maps)
        round += kFetch + width * 2;
    if (work.surface == Surface::medium)
        round += width * 2 * kExponential;
    return rounds * round + kMatrix;
}

double color(const PixelWork& work) {
    if (is_product(work.method))
        return product_color(work);
    if (work.method == Method::folded)
        return folded_color(work);
    return work.method == Method::reduced ? reduced_color(work) : loop_color(work);
}

} // namespace

double operations(const PixelWork& work) {
    return lighting(work) + key_fetches(work) + color(work) + kCurve;
}

double cost_ratio(const PixelWork& work) {
    PixelWork everybody = work;
    everybody.method = Method::rgb;
    everybody.mirrors = true;
    if (work.surface == Surface::ramp)
        everybody.surface = Surface::ramp_codes;
    return operations(work) / (operations(everybody) - kCurve + kPowCurve);
}

} // namespace metamer
