// An exhibit for the tests of visits.
#pragma once

#include <string>

#include "exhibit/load.h"

namespace metamer {

inline Exhibit visited(const std::string& more = {}) {
    return parse_exhibit(
        "[atlas]\nquantization = thesis\n[scene]\nkind = loaf\nmaterials = crayon-red, crayon-blue\n"
        "[lamp.1]\nspectrum = F11\nstrength = 2\n[lamp.2]\nspectrum = E\nstrength = 0.5\n"
        "[compare]\nsplit = 0.25\n[kiosk]\nidle_s = 10\nlamps = E, D65, A2800, F11\n" +
            more,
        "visit.ini", ".");
}

} // namespace metamer
