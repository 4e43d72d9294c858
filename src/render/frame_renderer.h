// An exhibit on the GPU: what is uploaded once, and drawing it into any framebuffer.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "exhibit/exhibit.h"
#include "gles/mesh.h"
#include "gles/texture.h"
#include "render/half_view.h"
#include "render/programs.h"
#include "render/scene.h"
#include "render/shadow_maps.h"
#include "render/surface_maps.h"

namespace metamer {

/// Needs a current ES 2 context, made before and destroyed after it. The exhibit must live as long.
class FrameRenderer {
public:
    /// Uploads meshes, maps and atlas, and draws the shadow maps. Throws failure where GL refuses.
    explicit FrameRenderer(const Exhibit& exhibit);

    /// Draws the frame, both halves, into the bound framebuffer of this size; `scale` multiplies everything
    /// that is given in pixels (supersampling).
    void draw(int width_px, int height_px, int scale = 1);

private:
    /// One half with the textures that are its own.
    struct Half {
        HalfView view;
        std::map<Method, Texture> material_maps; ///< for product methods on objects with maps
    };

    void draw_half(const Half& half, const View& view);
    void draw_object(const Half& half, const View& view, std::size_t object);
    void set_lamps(const Program& program, const Half& half, Method method) const;
    void set_material(const Program& program, const Half& half, Method method,
                      const ObjectSetting& object) const;
    void draw_split_line(int split_px, int height_px, int scale) const;
    std::vector<Half> load_halves() const;
    std::vector<std::optional<SurfaceMaps>> upload_maps() const;

    const Exhibit& exhibit_;
    Scene scene_;
    std::vector<Mesh> meshes_;
    Texture atlas_;
    std::vector<std::optional<SurfaceMaps>> maps_;
    std::vector<Half> halves_;
    ShadowMaps shadows_; ///< of both halves: they differ in light, not in lamps' places
    Programs programs_;
};

/// How an object tells its material to a shader of this method.
Surface surface_of(const ObjectSetting& object, Method method);

} // namespace metamer
