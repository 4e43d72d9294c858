// The colors of the overlay: dark and calm, so that the scene's colors are the only loud ones.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace metamer {

using Srgb = std::array<std::uint8_t, 3>;

/// A ground and the inks that stand on it. Every letter is painted from one of these.
struct Tone {
    Srgb ground;
    double alpha; ///< of the ground: what lies under it shines through
    Srgb ink;     ///< letters
    Srgb faded;   ///< letters that matter less
};

/// The screen behind the controls: what the kiosk clears to.
inline constexpr Srgb kBackdrop{0x14, 0x14, 0x13};

inline constexpr Srgb kWarmWhite{0xF6, 0xF1, 0xE7}, kSand{0xBE, 0xB6, 0xA8}, kAmber{0xFF, 0xC4, 0x5C};
inline constexpr Srgb kDark{0x16, 0x15, 0x13}, kHairline{0x4C, 0x48, 0x41};

inline constexpr Tone kTileTone{{0x26, 0x25, 0x22}, 1, kWarmWhite, kSand};
inline constexpr Tone kChosenTone{{0x3A, 0x35, 0x2B}, 1, kWarmWhite, kSand};
inline constexpr Tone kLightTone{{0xEF, 0xE8, 0xDA}, 1, kDark, {0x57, 0x52, 0x49}};
inline constexpr Tone kMarkTone{kAmber, 1, kDark, kDark};
inline constexpr Tone kPanelTone{{0x1A, 0x19, 0x17}, 0.97, kWarmWhite, kSand};
inline constexpr Tone kPlotTone{{0x0D, 0x0D, 0x0C}, 1, kWarmWhite, kSand};
inline constexpr Tone kLabelTone{{0x12, 0x11, 0x10}, 0.86, kWarmWhite, {0xE4, 0xDD, 0xD0}};
inline constexpr Tone kNoticeTone{{0x4A, 0x12, 0x0E}, 0.96, {0xFF, 0xE9, 0xE2}, {0xFF, 0xE9, 0xE2}};

/// The display's color of each interval of the grid (385 + 5 i nm), sRGB codes: monochromatic light, what
/// sRGB cannot hold of it cut off, as bright as it allows, dimmer towards the ends of sight. (Mixed with gray
/// instead, which keeps hues in the sense of gamut.h, reds look pink.)
const std::vector<Srgb>& wavelength_colors();

} // namespace metamer
