// Exhibits for the tests of the kiosk, and words, loaded once.
#pragma once

#include <memory>
#include <string>

#include "exhibit/load.h"
#include "overlay/words.h"

namespace metamer {

/// Three flat patches of known color, halves that compute differently, a shelf of three lamps; nothing that
/// moves by itself. `more` begins in [kiosk] and may set idle_s, watch_s and pixel_shift itself.
inline std::string patches(const std::string& more = "") {
    const auto unless_set = [&](const std::string& key, const std::string& value) {
        return more.find(key) == std::string::npos ? key + " = " + value + "\n" : "";
    };
    return "[atlas]\nquantization = thesis\n[scene]\nkind = patches\n"
           "materials = crayon-red, crayon-blue, cc-yellow\n[lamp.1]\nspectrum = F11\nstrength = 0.8\n"
           "[compare]\nsplit = 0.5\nleft.method = tristimulus\nright.method = folded\n"
           "[kiosk]\nlamps = E, D65, F11\nbooth.left = D65\nbooth.right = F11\n" +
           unless_set("idle_s", "60") + unless_set("watch_s", "0") + unless_set("pixel_shift", "0") + more;
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

inline Exhibit kiosk_exhibit(const std::string& text) {
    return parse_exhibit(text, "kiosk.ini", ".", {}, nullptr, Use::kiosk);
}

inline const Words& all_words() {
    static const Words words;
    return words;
}

} // namespace metamer
