// A planned half as a list of draws: which program, with which uniforms and textures. No GL here: computed
// when a plan changes, not when a frame is drawn.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "plan/planner.h"
#include "render/scene.h"
#include "render/shadow_maps.h"
#include "render/uniforms.h"
#include "render/variants.h"

namespace metamer {

/// Texture units.
enum Unit {
    kAtlasUnit, ///< or the packed atlas
    kKeyUnit,
    kLuminanceUnit,
    kNormalUnit,
    kMaterialUnit,
    kShadowUnit,
    kTapUnit,
    kDitherUnit,
};

/// One object of the scene.
struct Draw {
    Variant variant;
    Uniforms uniforms;                 ///< of this object alone
    std::optional<Image> material_map; ///< for kMaterialUnit
    std::optional<Image> tap_table;    ///< for kTapUnit
};

struct HalfDraws {
    std::vector<Draw> objects; ///< in the scene's order
    /// What all objects of the half share that are drawn by one method: the lamps' light.
    std::map<Method, Uniforms> lamps;
};

/// `everybody`: method rgb as everybody writes it, with the standard's pow() and highlights on everything:
/// what charts call cost 1.
struct DrawStyle {
    bool everybody = false;
};

/// The half's draws. `shadows`: tiles of the lamps that cast shadows.
HalfDraws half_draws(const Exhibit& exhibit, const ExhibitSpectra& spectra, const HalfPlan& plan,
                     const Scene& scene, std::span<const ShadowTile> shadows, DrawStyle style = {});

/// Where a lamp stands: its position, w = 1; or unit direction towards it, w = 0.
glm::vec4 lamp_place(const Exhibit& exhibit, const HalfLamp& lamp, const Scene& scene);

} // namespace metamer
