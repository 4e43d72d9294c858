// An exhibit on the GPU: what is uploaded once, and drawing it into any framebuffer.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "exhibit/exhibit.h"
#include "gles/mesh.h"
#include "gles/texture.h"
#include "render/draws.h"
#include "render/programs.h"
#include "render/scene.h"
#include "render/shadow_maps.h"
#include "render/surface_maps.h"

namespace metamer {

/// Needs a current ES 2 context, made before and destroyed after it. The exhibit must live as long.
class FrameRenderer {
public:
    /// Measures what the fragment shaders compute with, plans, uploads, and draws the shadow maps. Throws
    /// failure where GL refuses, bad_input where the exhibit cannot be planned.
    explicit FrameRenderer(const Exhibit& exhibit, DrawStyle style = {});

    /// Draws the frame, both halves, into the bound framebuffer of this size; `scale` multiplies everything
    /// that is given in pixels (supersampling).
    void draw(int width_px, int height_px, int scale = 1);

    /// Draws one half alone over the whole frame, without a line: 0 the left, 1 the right; the only one where
    /// nothing is compared.
    void draw_side(std::size_t half, int width_px, int height_px);

    /// Takes over what a visitor changed in the exhibit's lamps (spectrum, strength; not their number, places
    /// or shadows), materials (not what the scene is made of), methods or tolerance: plans again and uploads
    /// what follows. draw_if_changed() draws then.
    void update();

    /// Draws only where update() or another size made the last frame stale. Returns whether it drew.
    bool draw_if_changed(int width_px, int height_px, int scale = 1);

    const Plan& plan() const { return plan_; }
    const Scene& scene() const { return scene_; }
    const ExhibitSpectra& spectra() const { return spectra_; }

private:
    /// An object's program and textures.
    struct Prepared {
        const Program* program;
        std::optional<Texture> material_map, tap_table;
    };
    struct Half {
        HalfDraws draws;
        std::vector<Prepared> objects;
    };

    void prepare();
    void upload_atlases();
    View begin(int width_px, int height_px) const;
    void end() const;
    void draw_half(const Half& half, const View& view);
    void draw_split_line(int split_px, int height_px, int scale) const;
    std::vector<glm::vec4> lamp_places() const;
    std::vector<std::optional<SurfaceMaps>> upload_maps() const;

    const Exhibit& exhibit_;
    DrawStyle style_;
    ExhibitSpectra spectra_;
    Plan plan_;
    Scene scene_;
    std::vector<Mesh> meshes_;
    std::vector<std::size_t> front_to_back_;
    std::vector<std::optional<SurfaceMaps>> maps_;
    ShadowMaps shadows_; ///< of both halves: they differ in light, not in lamps' places
    Programs programs_;
    std::optional<Texture> atlas_, packed_, dither_;
    std::vector<Half> halves_;
    std::array<int, 3> drawn_{}; ///< width, height, scale of the last frame; 0: stale
};

/// What the fragment shaders of the current context compute with, in mantissa bits: measured, as drivers
/// report wishes.
int measured_bits();

} // namespace metamer
