// What one half of the split sees: the exhibit with the half's overrides applied. No GL, no geometry.
#pragma once

#include <optional>
#include <vector>

#include "exhibit/exhibit.h"
#include "methods/shade.h"

namespace metamer {

/// A lamp as one half sees it.
struct HalfLamp {
    std::size_t setting;               ///< its place in Exhibit::lamps
    std::string name;                  ///< of its spectrum
    int key;                           ///< its row in the atlas
    Emission emission;                 ///< that row
    std::optional<ReferenceLamp> full; ///< none where only the row is at hand
    double strength;                   ///< I_source
    bool shadow;
};

struct HalfView {
    const Half* half = nullptr;  ///< nullptr where the exhibit compares nothing
    std::vector<HalfLamp> lamps; ///< those that cast shadows first
    int shadows = 0;             ///< how many of them
    std::size_t dominant = 0;    ///< the strongest of the lamps: prefiltered's
    OutputSpace output;          ///< without `dominant`, see output_of()

    OutputSpace output_of() const {
        OutputSpace out = output;
        out.dominant = &lamps[dominant].emission;
        return out;
    }
};

/// One view for the whole frame, or two for a comparison, the left first. Throws bad_input where adaptation
/// to the half's lamps is asked for and impossible.
std::vector<HalfView> half_views(const Exhibit& exhibit);

/// A pixel of the half, lit by all of its lamps at diffuse 1; material and layers are the caller's.
Pixel pixel_of(const HalfView& view);

/// What was asked for an object in a half: the object's own choice, else the half's, else the exhibit's.
MethodChoice choice_of(const Exhibit& exhibit, const Half* half, const ObjectSetting& object);

} // namespace metamer
