#include "render/frame_renderer.h"

#include <GLES2/gl2.h>
#include <algorithm>
#include <glm/vec2.hpp>

#include "gles/check.h"

namespace metamer {

namespace {

enum Unit { kAtlasUnit, kKeyUnit, kLuminanceUnit, kNormalUnit, kMaterialUnit, kShadowUnit };

/// What stands behind the scene: a dark neutral, against which black things still show.
constexpr float kBackground = 0.17f;

/// The line over the split: mid gray stands out from dark and bright colors alike.
constexpr float kLine = 0.55f;

glm::mat3 to_glm(const Matrix3& a) {
    glm::mat3 out;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) // glm counts columns first
            out[column][row] =
                static_cast<float>(a.m[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)]);
    return out;
}

glm::vec3 to_glm(const std::array<double, 3>& v) {
    return {v[0], v[1], v[2]};
}

float row_coordinate(int key) {
    return (static_cast<float>(key) + 0.5f) / kAtlasSize;
}

std::vector<Mesh> upload_meshes(const Scene& scene) {
    std::vector<Mesh> meshes;
    for (const SceneObject& object : scene.objects)
        meshes.emplace_back(object.mesh);
    return meshes;
}

void clear_gray(float gray, GLbitfield what) {
    glClearColor(gray, gray, gray, 1);
    glClear(what);
}

// Materials mixed in code values: what a paint program does with two colors.
std::array<double, 3> codes(const std::array<double, 3>& linear, Transfer transfer) {
    return {encode(transfer, linear[0]), encode(transfer, linear[1]), encode(transfer, linear[2])};
}

} // namespace

Surface surface_of(const ObjectSetting& object, Method method) {
    if (object.material_end)
        return method == Method::rgb ? Surface::ramp_codes : Surface::ramp;
    return has_maps(object) ? Surface::maps : Surface::plain;
}

FrameRenderer::FrameRenderer(const Exhibit& exhibit)
    : exhibit_(exhibit),
      scene_(build_scene(exhibit)),
      meshes_(upload_meshes(scene_)),
      atlas_(kAtlasSize, kAtlasSize, exhibit.atlas.rgba, {Filter::nearest, Wrap::clamp, false}),
      maps_(upload_maps()),
      halves_(load_halves()),
      shadows_(halves_.front().view.lamps, scene_, meshes_) {}

std::vector<std::optional<SurfaceMaps>> FrameRenderer::upload_maps() const {
    std::vector<std::optional<SurfaceMaps>> maps;
    for (const SceneObject& object : scene_.objects) {
        maps.emplace_back();
        if (has_maps(*object.setting))
            maps.back().emplace(*object.setting);
    }
    return maps;
}

std::vector<FrameRenderer::Half> FrameRenderer::load_halves() const {
    std::vector<Half> halves;
    for (HalfView& view : half_views(exhibit_, scene_)) {
        halves.push_back({std::move(view), {}});
        Half& half = halves.back();
        for (const SceneObject& object : scene_.objects) {
            const Method method = method_of(exhibit_, half.view.half, *object.setting);
            if (method == Method::spectral || surface_of(*object.setting, method) != Surface::maps ||
                half.material_maps.contains(method))
                continue;
            const Image map = material_map(method, exhibit_.atlas, half.view.output);
            half.material_maps.emplace(
                method, Texture(map.width, map.height, map.rgba, {Filter::nearest, Wrap::clamp, false}));
        }
    }
    return halves;
}

void FrameRenderer::draw(int width_px, int height_px, int scale) {
    glViewport(0, 0, width_px, height_px);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_DEPTH_TEST);
    clear_gray(kBackground, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const View view = view_of(scene_.camera, static_cast<double>(width_px) / height_px);
    const int split = exhibit_.compare ? split_column(*exhibit_.compare, width_px / scale) * scale : width_px;
    glEnable(GL_SCISSOR_TEST);
    for (std::size_t i = 0; i < halves_.size(); ++i) {
        const int begin = i == 0 ? 0 : split, end = i == 0 ? split : width_px;
        if (begin == end)
            continue;
        glScissor(begin, 0, end - begin, height_px);
        draw_half(halves_[i], view);
    }
    draw_split_line(split, height_px, scale);
    glDisable(GL_SCISSOR_TEST);
    throw_on_gl_error("draw", "the frame");
}

void FrameRenderer::draw_half(const Half& half, const View& view) {
    atlas_.bind(kAtlasUnit);
    shadows_.bind(kShadowUnit);
    for (std::size_t i = 0; i < meshes_.size(); ++i)
        draw_object(half, view, i);
}

void FrameRenderer::draw_object(const Half& half, const View& view, std::size_t object) {
    const ObjectSetting& setting = *scene_.objects[object].setting;
    const Method method = method_of(exhibit_, half.view.half, setting);
    const Surface surface = surface_of(setting, method);
    const Program& program = programs_.get({.method = method,
                                            .lamps = static_cast<int>(half.view.lamps.size()),
                                            .lit = scene_.lit,
                                            .shadows = half.view.shadows,
                                            .surface = surface,
                                            .transfer = half.view.output.transfer});
    program.use();
    program.set("u_clip_from_world", view.clip_from_world);
    program.set("u_eye", view.eye);
    program.set("u_mirror", glm::vec2(setting.specular, setting.shininess));
    program.set("u_rgb_from_xyz", to_glm(half.view.output.adapted_rgb_from_xyz()));
    program.set("u_atlas", kAtlasUnit);
    set_lamps(program, half, method);
    set_material(program, half, method, setting);
    if (surface == Surface::maps) {
        maps_[object]->bind(kKeyUnit, kLuminanceUnit, kNormalUnit);
        if (method != Method::spectral)
            half.material_maps.at(method).bind(kMaterialUnit);
    }
    meshes_[object].draw();
}

void FrameRenderer::set_lamps(const Program& program, const Half& half, Method method) const {
    std::vector<glm::vec4> places;
    std::vector<glm::vec3> falloffs, colors;
    std::vector<glm::vec2> rows;
    const GridObserver seen_by = observer(exhibit_.atlas);
    for (const HalfLamp& lamp : half.view.lamps) {
        places.push_back(lamp.place);
        falloffs.emplace_back(lamp.falloff.constant, lamp.falloff.linear, lamp.falloff.quadratic);
        rows.emplace_back(row_coordinate(lamp.key), lamp.strength);
        colors.push_back(static_cast<float>(lamp.strength) *
                         to_glm(lamp_numbers(method, lamp.emission, seen_by, half.view.output)));
    }
    program.set("u_lamp_place", places);
    program.set("u_lamp_falloff", falloffs);
    program.set("u_lamp_row", rows);
    program.set("u_lamp_color", colors);
    std::vector<glm::mat4> views;
    std::vector<glm::vec4> depths;
    std::vector<glm::vec2> corners;
    for (const ShadowTile& tile : shadows_.tiles()) {
        views.push_back(tile.shadow_from_world);
        depths.push_back(tile.depth_from_world);
        corners.push_back(tile.corner);
    }
    program.set("u_shadow_from_world", views);
    program.set("u_depth_from_world", depths);
    program.set("u_shadow_tile", corners);
    program.set("u_shadow_map", kShadowUnit);
}

void FrameRenderer::set_material(const Program& program, const Half& half, Method method,
                                 const ObjectSetting& object) const {
    const MaterialSetting& begin = object.material;
    const MaterialSetting& end = object.material_end ? *object.material_end : begin;
    program.set("u_material_row", glm::vec2(row_coordinate(begin.key), row_coordinate(end.key)));
    program.set("u_key_map", kKeyUnit);
    program.set("u_luminance_map", kLuminanceUnit);
    program.set("u_normal_map", kNormalUnit);
    program.set("u_material_map", kMaterialUnit);
    if (method == Method::spectral)
        return;
    const bool as_codes = surface_of(object, method) == Surface::ramp_codes;
    const auto numbers = [&](const MaterialSetting& material) {
        const auto linear = material_numbers(method, reflectance(exhibit_.atlas, material.key),
                                             observer(exhibit_.atlas), half.view.output);
        return to_glm(as_codes ? codes(linear, half.view.output.transfer) : linear);
    };
    program.set("u_material", numbers(begin));
    program.set("u_material_end", numbers(end));
}

void FrameRenderer::draw_split_line(int split_px, int height_px, int scale) const {
    const int line = exhibit_.compare ? exhibit_.compare->line_px * scale : 0;
    if (line == 0)
        return;
    glScissor(split_px - line / 2, 0, line, height_px);
    clear_gray(kLine, GL_COLOR_BUFFER_BIT);
}

} // namespace metamer
