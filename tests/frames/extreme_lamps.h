// The brightest, nearest and most saturated lamps.
#pragma once

#include <vector>

#include "exhibit/exhibit.h"

namespace metamer {

/// The middle of a pixel: a lamp there is at no distance from it.
inline constexpr Vec3 kOnPixel{0.0625, 0.0625, 0};

/// Lamps that no display can show: their light has negative components, in other places each.
inline const char* const kOneLamp = "[lamp.1]\nspectrum = line:510\n";
inline const char* const kTwoLamps = "[lamp.1]\nspectrum = line:510\n[lamp.2]\nspectrum = line:660\n";
/// A lamp whose k' is 0 in the rows of 8 bits.
inline const char* const kVioletLamp = "[lamp.1]\nspectrum = line:390\n";

struct Place {
    const char* name;
    Vec3 position;
    Falloff falloff;
};
inline const Place kPlaces[] = {{"far behind a steep falloff", {100, 100, 100}, {0, 0, 1e6}},
                                {"far without falloff", {-100, 100, 100}, {1, 0, 0}},
                                {"far and not falling off", {0, 0, 100}, {0, 0, 1e-6}},
                                {"at a pixel", kOnPixel, {1, 0, 0}},
                                {"at a pixel without falloff", kOnPixel, {0, 0, 1e-6}},
                                {"at a pixel with a steep falloff", kOnPixel, {0, 1e6, 1e6}},
                                {"before a pixel", {0.0625, 0.0625, 0.02}, {0, 0, 1e-6}}};

/// Of the first lamp, the second, and so on in turns.
using Strengths = std::vector<double>;
inline const Strengths kBright{1e6}, kMixed{1e6, 0, 1e-4, 1e4};
inline const Strengths kStrengths[] = {{0}, {1e-4}, {1e4}, kBright, kMixed};

inline void set_strengths(Exhibit& exhibit, const Strengths& strengths) {
    for (std::size_t l = 0; l < exhibit.lamps.size(); ++l)
        exhibit.lamps[l].strength = strengths[l % strengths.size()];
}

inline void put(Exhibit& exhibit, const Place& place) {
    for (LampSetting& lamp : exhibit.lamps) {
        lamp.position = place.position;
        lamp.falloff = place.falloff;
    }
}

} // namespace metamer
