// What tests of frames share: exhibits from text, pixels, and how far two pixels are apart.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <string>

#include "color/xyz.h"
#include "exhibit/load.h"
#include "gles/surfaceless.h"
#include "render/frame.h"

namespace metamer {

/// An exhibit from INI text; relative paths start in config/.
inline Exhibit exhibit_of(const std::string& ini) {
    return parse_exhibit(ini, "test.ini", METAMER_SOURCE_DIR "/config");
}

/// A frame in a context of its own.
inline Image frame_of(const Exhibit& exhibit) {
    const Surfaceless context;
    return render_frame(exhibit);
}

inline EncodedRgb8 pixel(const Image& image, int x, int y) {
    const auto at = static_cast<std::size_t>(4 * (y * image.width + x));
    return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2]};
}

/// The greatest difference of the three, in steps of 8 bits.
inline int steps(const EncodedRgb8& a, const EncodedRgb8& b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

/// A pixel for people.
inline std::string text_of(const EncodedRgb8& c) {
    return std::to_string(c.r) + ' ' + std::to_string(c.g) + ' ' + std::to_string(c.b);
}

/// The first `count` of [lamp.1] .. [lamp.8]: lines and daylight, each of its own strength, together as
/// bright as white.
inline std::string lamps_of(int count) {
    const char* const kNames[] = {"F11", "A2800", "D65", "krypton", "F2", "white-LED", "line:589", "E"};
    std::string text;
    for (int i = 0; i < count; ++i)
        text += "[lamp." + std::to_string(i + 1) + "]\nspectrum = " + kNames[i] +
                "\nstrength = " + std::to_string((1.2 + 0.1 * i) / count) + "\n";
    return text;
}

/// As an atlas file alone would have it: every spectrum is known by its row only.
inline void forget_full_spectra(Exhibit& exhibit) {
    exhibit.materials.clear();
    for (LampSetting& lamp : exhibit.lamps)
        lamp.full_resolution = false;
}

} // namespace metamer
