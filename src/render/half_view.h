// What one half of the split shows: the exhibit with the half's overrides applied, in the numbers that
// uniforms take. No GL here.
#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "exhibit/exhibit.h"
#include "methods/pair.h"
#include "render/scene.h"

namespace metamer {

/// A lamp as one half sees it.
struct HalfLamp {
    int key;           ///< its row in the atlas
    Emission emission; ///< that row
    double strength;   ///< I_source
    glm::vec4 place;   ///< position, w = 1; or unit direction towards the lamp, w = 0
    Falloff falloff;
    bool shadow;
};

struct HalfView {
    const Half* half = nullptr;  ///< nullptr where the exhibit compares nothing
    std::vector<HalfLamp> lamps; ///< those that cast shadows first
    int shadows = 0;             ///< how many of them
    OutputSpace output;
};

/// One view for the whole frame, or two for a comparison, the left first. Throws bad_input where adaptation
/// to the half's lamps is asked for and impossible.
std::vector<HalfView> half_views(const Exhibit& exhibit, const Scene& scene);

/// The column where the right half begins, 0 .. width_px.
int split_column(const Compare& compare, int width_px);

/// The method for an object in a half: the object's own, else the half's, else the exhibit's.
Method method_of(const Exhibit& exhibit, const Half* half, const ObjectSetting& object);

} // namespace metamer
