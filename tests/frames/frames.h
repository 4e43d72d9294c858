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

} // namespace metamer
