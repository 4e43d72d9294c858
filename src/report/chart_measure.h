// `metamer chart`: what each method costs on an exhibit's frame, and how far it is from the reference.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "report/accuracy.h"
#include "report/rows.h"

namespace metamer {

/// The names of two rows that are no method's own: method rgb as everybody writes it (DrawStyle::everybody),
/// which costs 1; and the frame as the planner draws it.
inline constexpr std::string_view kBaseName = "rgb-pow", kPlannedName = "planned";

/// What is charted: one row or path of rows for each.
struct Entry {
    std::string name;
    MethodChoice method; ///< none: planned
    int taps = 0;        ///< of method reduced
    bool everybody = false;

    /// ChartRow::taps: 64 for the loops, N for reduced, 0 where a pixel sums over no wavelengths.
    int sums() const;
};

/// rgb-pow first, then every method, reduced at all kTapCounts, planned last.
std::vector<Entry> chart_entries();

/// Whether every lamp and material of the exhibit is known at full resolution: the planner's levels then.
Levels levels_known(const Exhibit& exhibit);

/// The rows of all entries that can draw the exhibit, with every precision and both Levels; `rounds` of
/// frame_timing.h at the exhibit's size. Precision and Levels of an entry share one time. cost_ratio is the
/// median of the ratios to rgb-pow round by round. Accuracy is over the exhibit's own pairs or, where given,
/// those of `pairs`. `chosen`: the methods that the planner takes for the exhibit's objects, at this GPU's
/// precision and levels_known(). What cannot be drawn or planned is left out, with its cause in
/// ChartContext::left_out. `exhibit`, `date` and `command` of the context are the caller's. Needs a current
/// context.
Chart measure_chart(const Exhibit& exhibit, std::span<const Exhibit> pairs, int rounds);

} // namespace metamer
