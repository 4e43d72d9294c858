// A chart's rows for people.
#pragma once

#include <string>

#include "report/rows.h"

namespace metamer {

/// What was measured, then one line per row: method, taps, precision, atlas, ms, ratio with its quartiles,
/// mean, 95th percentile, worst pair by name; `*` on the frontier, `<` chosen; then what was left out, and
/// why.
std::string chart_table(const Chart& chart);

} // namespace metamer
