// The experiments of `metamer stability`, and what is said of them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "report/experiment.h"

namespace metamer {

/// A method fails where its color is further than this from the reference: what most people just see between
/// two patches that touch.
inline constexpr double kFailsAbove = 1; // CIEDE2000

/// Runs every experiment, about two seconds in all. Nothing in them is measured by the clock or drawn by
/// chance: the same program gives the same numbers.
std::vector<Experiment> stability_experiments();

/// A picture and the name of its file, without the ending.
struct StabilityPage {
    std::string file;
    Picture picture;
};

/// One page per group of experiments, two plots side by side.
std::vector<StabilityPage> stability_pages(std::span<const Experiment> experiments);

/// For a terminal (UTF-8, lines of at most 100 columns): per experiment its finding, what was swept, where
/// each method fails and why, and the guard.
std::string stability_text(std::span<const Experiment> experiments);

/// CSV (RFC 4180, LF), a line per experiment, point and method: experiment, swept, unit, x, point (its name,
/// if it has one), method, delta_e_2000. Numbers read back as the same doubles.
std::string stability_csv(std::span<const Experiment> experiments);

} // namespace metamer
