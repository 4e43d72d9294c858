#include "exhibit/scene_kinds.h"

#include <algorithm>

#include "base/names.h"
#include "exhibit/booth.h"

namespace metamer {

namespace {

constexpr SceneKindInfo kKinds[] = {
    {SceneKind::loaf, "loaf", "a cube cut in slices, one material each (figures 35-44)", "crayons"},
    {SceneKind::crayons, "crayons", "crayons side by side, one material each (figures 48-51)", "crayons"},
    {SceneKind::still_life, "still-life", "table, wall and eight things on the table (figures 52-53)", "", 0},
    {SceneKind::ramp, "ramp", "two materials mixed by reflectance, by XYZ and by RGB (chapter 8.3)",
     "crayon-blue, crayon-yellow", 2, 2, true},
    {SceneKind::patches, "patches", "flat patches, one material each, evenly lit", "crayons", 1, kAtlasRows,
     true},
    {SceneKind::media, "media", "a wedge of colored glass and a liquid in a vessel before a light box",
     "rgb:FFFFFF", 1, 1, true},
    {SceneKind::corner, "corner", "a colored wall and a floor that light each other",
     "crayon-red, crayon-white", 2, 2, false, true},
    {SceneKind::booth, "booth", "a light booth: samples, and two cards that match under one lamp only",
     "cc-orange, cc-yellow, cc-green, cc-cyan, cc-purplish-blue, cc-magenta", 1, kMostSamples, false, false,
     true},
};

std::vector<ObjectDefault> pieces(const std::string& word, std::span<const std::string> materials,
                                  double specular) {
    std::vector<ObjectDefault> objects;
    for (const std::string& material : materials)
        objects.push_back({.name = word + "-" + std::to_string(objects.size() + 1),
                           .material = material,
                           .specular = specular});
    return objects;
}

std::vector<ObjectDefault> ramps(const std::string& near_end, const std::string& far_end) {
    const auto ramp = [&](const char* name, MethodChoice method) {
        return ObjectDefault{.name = name, .material = near_end, .material_end = far_end, .method = method};
    };
    return {ramp("ramp-reflectance", std::nullopt), ramp("ramp-xyz", Method::tristimulus),
            ramp("ramp-rgb", Method::rgb)};
}

/// Seen against a light box: a wedge of colored glass above, a liquid in a round vessel below.
std::vector<ObjectDefault> media(const std::string& ground) {
    return {{.name = "board", .material = ground},
            {.name = "wedge", .material = ground, .medium = "glass-cobalt", .thickness = 4},
            {.name = "vessel", .material = ground, .medium = "liquid-allura-red", .thickness = 2}};
}

/// A wall and a floor, each lit by the lamps and by the other.
std::vector<ObjectDefault> corner(const std::string& wall, const std::string& floor) {
    return {{.name = "wall", .material = wall}, {.name = "floor", .material = floor}};
}

std::vector<ObjectDefault> booth(std::span<const std::string> materials) {
    std::vector<ObjectDefault> objects = pieces("sample", materials, 0);
    objects.insert(objects.begin(), {.name = "interior", .material = "cc-neutral-8"});
    objects.push_back({.name = "card-a"});
    objects.push_back({.name = "card-b"});
    return objects;
}

/// Warm and cool things side by side: no lamp flatters both.
std::vector<ObjectDefault> still_life() {
    const auto thing = [](const char* name, const char* material, double specular, double shininess) {
        return ObjectDefault{
            .name = name, .material = material, .specular = specular, .shininess = shininess};
    };
    return {thing("table", "cc-dark-skin", 0.05, 16),     thing("wall", "cc-neutral-6.5", 0, 32),
            thing("ball", "crayon-white", 0.2, 60),       thing("orange", "crayon-orange", 0.1, 24),
            thing("apple", "crayon-red", 0.25, 60),       thing("box", "crayon-cerulean", 0.05, 16),
            thing("vase", "crayon-blue-green", 0.4, 120), thing("cone", "crayon-yellow", 0.1, 32),
            thing("ring", "crayon-violet", 0.3, 80),      thing("cloth", "crayon-carnation-pink", 0, 32)};
}

} // namespace

std::span<const SceneKindInfo> scene_kinds() {
    return kKinds;
}

const SceneKindInfo& scene_kind(SceneKind kind) {
    return *std::find_if(std::begin(kKinds), std::end(kKinds),
                         [&](const auto& info) { return info.kind == kind; });
}

const SceneKindInfo* find_scene_kind(std::string_view name) {
    const auto found = std::find_if(std::begin(kKinds), std::end(kKinds),
                                    [&](const auto& info) { return same_name(info.name, name); });
    return found == std::end(kKinds) ? nullptr : found;
}

std::vector<ObjectDefault> scene_objects(SceneKind kind, std::span<const std::string> materials) {
    switch (kind) {
    case SceneKind::loaf:
        return pieces("slice", materials, 0);
    case SceneKind::crayons:
        return pieces("crayon", materials, 0.05);
    case SceneKind::patches:
        return pieces("patch", materials, 0);
    case SceneKind::ramp:
        return ramps(materials[0], materials[1]);
    case SceneKind::still_life:
        return still_life();
    case SceneKind::media:
        return media(materials[0]);
    case SceneKind::corner:
        return corner(materials[0], materials[1]);
    case SceneKind::booth:
        return booth(materials);
    }
    return {};
}

} // namespace metamer
