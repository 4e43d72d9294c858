// What was measured on what, in words for a picture's corner.
#pragma once

#include <string>

#include "report/rows.h"

namespace metamer {

/// `llvmpipe (...) · 1280x720 · 2026-11-22 · metamer chart ...`, without what is not known.
std::string context_note(const ChartContext& context);

/// `45 lamps × 64 materials`, or `all pairs` when the numbers are not known.
std::string pairs_text(const ChartContext& context);

} // namespace metamer
