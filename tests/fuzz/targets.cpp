#include "fuzz/targets.h"

namespace metamer::fuzz {

std::span<const Target> targets() {
    static constexpr Target kTargets[] = {
        {"ini", try_exhibit}, {"strings", try_strings}, {"atlas", try_atlas}, {"spectrum", try_spectrum}};
    return kTargets;
}

} // namespace metamer::fuzz
