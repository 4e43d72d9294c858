// Why a method: the planner's reason in people's words.
#pragma once

#include <string>

#include "overlay/words.h"
#include "plan/reason.h"

namespace metamer {

/// What in_english() says, in a language of the exhibit: keys `reason.*`, with its names for methods, lamps
/// and materials and its decimal sign.
std::string reason_words(const Reason& reason, const Words& words, const std::string& language);

} // namespace metamer
