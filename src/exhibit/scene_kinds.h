// The kinds of scene by name, and the objects that each consists of before [object.NAME] changes them. Where
// the objects stand and what shape they have is the renderer's.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "exhibit/exhibit.h"

namespace metamer {

/// A kind of scene as `list scenes` and INI files write it.
struct SceneKindInfo {
    SceneKind kind;
    std::string_view name;
    std::string_view description;
    std::string_view
        materials; ///< [scene] materials by default: a set, or names with commas between; may be empty
    int fewest = 1, most = kAtlasRows; ///< how many materials it takes
    bool flat = false;      ///< shading is 1 everywhere: a lamp's place, falloff and shadow have no effect
    bool parallel = false;  ///< its lamps have directions, no positions: planes are lit evenly
    bool each_half = false; ///< a comparison shows all of it on either side of the split, not a part
};

std::span<const SceneKindInfo> scene_kinds();
const SceneKindInfo& scene_kind(SceneKind kind);

/// The kind of this name, case aside; nullptr when there is none.
const SceneKindInfo* find_scene_kind(std::string_view name);

/// An object by default. Maps are never a default.
struct ObjectDefault {
    std::string name = {};
    std::string material = {};     ///< as [scene] materials or the library names it; empty: the pair's
    std::string material_end = {}; ///< ramps: at the far end; else empty
    std::string medium = {};       ///< glass or liquid; else empty
    double thickness = 1;          ///< of the medium
    std::optional<MethodChoice> method = {};
    double specular = 0;
    double shininess = 32;
};

/// The objects of a scene: loaf `slice-1` .. `slice-n`, crayons `crayon-1` .. `crayon-n`, patches `patch-1`
/// .. `patch-n`, one for each of `materials` in order; ramp: `ramp-reflectance`, `ramp-xyz`, `ramp-rgb`
/// between materials[0] and materials[1]; still-life: its ten objects, whatever `materials` holds;
/// booth: `interior`, `sample-1` .. `sample-n`, `card-a` and `card-b`, whose materials give_cards() finds.
std::vector<ObjectDefault> scene_objects(SceneKind kind, std::span<const std::string> materials);

} // namespace metamer
