#include "plan/reason.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/printed.h"

namespace metamer {

namespace {

std::string main_clause(const Reason& reason) {
    const std::string errs = "errs by at most " + error_text(reason.error);
    const std::string taps = std::to_string(reason.taps) +
                             " wavelengths chosen for these lamps err by at most " + error_text(reason.error);
    switch (reason.ground) {
    case Ground::asked:
        return "the exhibit asks for it; it errs by up to " + error_text(reason.error) + " (" +
               in_english(reason.worst) + ")";
    case Ground::constant:
        return "light stays linear: its color under each lamp is a constant, summed before the frame; " +
               errs;
    case Ground::table:
        return "light stays linear: a table gives the color of each key under each lamp, summed before the "
               "frame; " +
               errs;
    case Ground::product:
        return "under these lamps three numbers are as good as spectra: the product " + errs;
    case Ground::taps:
        return taps;
    case Ground::thickness:
        return "its thickness varies from pixel to pixel: " + taps;
    case Ground::all:
        break;
    }
    return "nothing cheaper than all 64 wavelengths holds; it " + errs;
}

} // namespace

std::string PixelName::surface() const {
    if (medium.empty())
        return material;
    return material + " through " + medium + ", thickness " + to_text(std::round(thickness * 100) / 100);
}

std::string in_english(const PixelName& name) {
    return (name.lamp.empty() ? "all lamps" : name.lamp) + " on " + name.surface();
}

std::string in_english(const Reason& reason) {
    if (!reason.rejected)
        return main_clause(reason);
    const Reason::Rejected& rejected = *reason.rejected;
    return main_clause(reason) + "; " + std::string(method_name(rejected.method)) +
           (rejected.taps > 0 ? " with " + std::to_string(rejected.taps) : "") +
           ", which is cheaper, would err by " + error_text(rejected.error) + " or more";
}

ToldError told_error(double error) {
    constexpr double kLeast = 0.001, kTwoDecimals = 0.0095;
    return {std::max(error, kLeast), error < kTwoDecimals ? 3 : 2};
}

std::string error_text(double error) {
    const ToldError told = told_error(error);
    return printed("%.*f", told.decimals, told.value);
}

} // namespace metamer
