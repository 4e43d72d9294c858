// Draws of an exhibit by edited programs, on a plane that fills a small frame.
#pragma once

#include <GLES2/gl2.h>
#include <map>
#include <optional>

#include "frames/frames.h"
#include "frames/watched.h"
#include "gles/framebuffer.h"
#include "gles/mesh.h"
#include "gles/texture.h"
#include "render/draws.h"
#include "render/surface_maps.h"
#include "render/tables.h"

namespace metamer {

inline constexpr int kSidePx = 16;
/// The whole frame, facing the eye; texture coordinates from corner to corner.
inline MeshData plane() {
    MeshData mesh;
    for (const auto& [x, y] : {std::pair{-1.0F, -1.0F}, {1.0F, -1.0F}, {1.0F, 1.0F}, {-1.0F, 1.0F}})
        mesh.vertices.insert(mesh.vertices.end(), {x, y, 0, 0, 0, 1, 1, 0, 0, x / 2 + 0.5F, y / 2 + 0.5F});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

/// What draws them: edited programs, each built once.
class Stage {
public:
    std::vector<EncodedRgb8> draw(const Exhibit& exhibit, const HalfDraws& draws,
                                  const FragmentEdits& edits) {
        const Draw& draw = draws.objects.front();
        const Program& program = get(draw.variant, edits);
        program.set("u_clip_from_world", glm::mat4(1));
        program.set("u_eye", glm::vec3(0.0625F, 0.0625F, 3));
        program.set("u_zero", 0.0F);
        program.set("u_nought", 0.0F);
        set_uniforms(program, draws.lamps.at(draw.variant.method));
        set_uniforms(program, draw.uniforms);
        const auto upload = [](const Image& image) {
            return Texture(image.width, image.height, image.rgba, {Filter::nearest, Wrap::clamp, false});
        };
        const auto& rows = exhibit.atlas.rgba;
        const Texture atlas = upload(draw.variant.method == Method::packed
                                         ? packed_atlas(exhibit.atlas)
                                         : Image{kAtlasSize, kAtlasSize, {rows.begin(), rows.end()}});
        std::optional<Texture> materials, taps;
        std::optional<SurfaceMaps> maps;
        if (draw.material_map)
            materials.emplace(upload(*draw.material_map)).bind(kMaterialUnit);
        if (draw.tap_table)
            taps.emplace(upload(*draw.tap_table)).bind(kTapUnit);
        if (draw.variant.surface == Surface::maps)
            maps.emplace(exhibit.objects[0]).bind(kKeyUnit, kLuminanceUnit, kNormalUnit);
        atlas.bind(kAtlasUnit);
        return picture();
    }

private:
    const Program& get(const Variant& variant, const FragmentEdits& edits) {
        const std::string name = shader_variant(variant).name + edits.key();
        auto found = programs_.find(name);
        if (found == programs_.end())
            found = programs_.emplace(name, edited_program(variant, edits)).first;
        return found->second;
    }

    std::vector<EncodedRgb8> picture() const {
        target_.bind();
        glClearColor(0, 0, 0, 0);
        glClear(GL_COLOR_BUFFER_BIT);
        mesh_.draw();
        const Image image{kSidePx, kSidePx, target_.read_rgba()};
        std::vector<EncodedRgb8> pixels;
        for (int i = 0; i < kSidePx * kSidePx; ++i)
            pixels.push_back(pixel(image, i % kSidePx, i / kSidePx));
        return pixels;
    }

    Surfaceless context_;
    Framebuffer target_{kSidePx, kSidePx};
    Mesh mesh_{plane()};
    std::map<std::string, Program> programs_;
};

/// Pixels of a watched picture that met something other than a number.
inline int not_numbers(const std::vector<EncodedRgb8>& watched) {
    return static_cast<int>(std::count_if(watched.begin(), watched.end(), [](const auto& p) {
        return p != EncodedRgb8{255, 255, 255};
    }));
}

} // namespace metamer
