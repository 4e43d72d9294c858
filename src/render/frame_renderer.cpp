#include "render/frame_renderer.h"

#include <GLES2/gl2.h>
#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>

#include "exhibit/scene_kinds.h"
#include "gles/check.h"
#include "gles/precision_probe.h"
#include "render/tables.h"

namespace metamer {

namespace {

/// What stands behind the scene: a dark neutral, against which black things still show.
constexpr float kBackground = 0.17f;

/// The line over the split: mid gray stands out from dark and bright colors alike.
constexpr float kLine = 0.55f;

std::vector<Mesh> upload_meshes(const Scene& scene) {
    std::vector<Mesh> meshes;
    for (const SceneObject& object : scene.objects)
        meshes.emplace_back(object.mesh);
    return meshes;
}

/// What ends nearest is drawn first, so that what it hides is not shaded: things before what they stand on.
std::vector<std::size_t> front_to_back(const Scene& scene) {
    std::vector<float> distance;
    for (const SceneObject& object : scene.objects) {
        float farthest = 0;
        for (std::size_t v = 0; v + 2 < object.mesh.vertices.size(); v += kVertexFloats)
            farthest =
                std::max(farthest, glm::distance(scene.camera.eye, glm::vec3(object.mesh.vertices[v],
                                                                             object.mesh.vertices[v + 1],
                                                                             object.mesh.vertices[v + 2])));
        distance.push_back(farthest);
    }
    std::vector<std::size_t> order(scene.objects.size());
    std::iota(order.begin(), order.end(), 0u);
    if (!scene.camera.flat)
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return distance[a] < distance[b]; });
    return order;
}

void clear_gray(float gray, GLbitfield what) {
    glClearColor(gray, gray, gray, 1);
    glClear(what);
}

Texture upload(const Image& image) {
    return {image.width, image.height, image.rgba, {Filter::nearest, Wrap::clamp, false}};
}

} // namespace

int measured_bits() {
    // Once: a process draws on one GPU, and the probe's program takes as long as a scene's.
    static const int measured = [] {
        GLint range[2] = {}, bits = 0;
        glGetShaderPrecisionFormat(GL_FRAGMENT_SHADER, GL_HIGH_FLOAT, range, &bits);
        return measured_fragment_bits(bits > 0 ? Precision::highp : Precision::mediump);
    }();
    return measured;
}

FrameRenderer::FrameRenderer(const Exhibit& exhibit, DrawStyle style)
    : exhibit_(exhibit),
      style_(style),
      spectra_(exhibit),
      plan_(plan_exhibit(exhibit, spectra_, measured_bits())),
      scene_(build_scene(exhibit)),
      meshes_(upload_meshes(scene_)),
      front_to_back_(front_to_back(scene_)),
      maps_(upload_maps()),
      shadows_(lamp_places(), scene_, meshes_) {
    prepare();
}

std::vector<std::optional<SurfaceMaps>> FrameRenderer::upload_maps() const {
    std::vector<std::optional<SurfaceMaps>> maps;
    for (const SceneObject& object : scene_.objects) {
        maps.emplace_back();
        if (surface_of(exhibit_, *object.setting, Method::folded) == Surface::maps)
            maps.back().emplace(*object.setting);
    }
    return maps;
}

// Of the lamps that cast shadows.
std::vector<glm::vec4> FrameRenderer::lamp_places() const {
    std::vector<glm::vec4> places;
    for (const HalfLamp& lamp : plan_.halves.front().view.lamps)
        if (lamp.shadow)
            places.push_back(lamp_place(exhibit_, lamp, scene_));
    return places;
}

void FrameRenderer::update() {
    spectra_ = ExhibitSpectra(exhibit_);
    plan_ = plan_exhibit(exhibit_, spectra_, plan_.fragment_bits);
    prepare();
}

void FrameRenderer::prepare() {
    halves_.clear();
    for (const HalfPlan& plan : plan_.halves) {
        Half& half = halves_.emplace_back();
        half.draws = half_draws(exhibit_, spectra_, plan, scene_, shadows_.tiles(), style_);
        for (const Draw& draw : half.draws.objects) {
            Prepared& object = half.objects.emplace_back();
            object.program = &programs_.get(draw.variant);
            if (draw.material_map)
                object.material_map = upload(*draw.material_map);
            if (draw.tap_table)
                object.tap_table = upload(*draw.tap_table);
        }
    }
    upload_atlases();
    drawn_ = {};
}

// Only what some object reads.
void FrameRenderer::upload_atlases() {
    const auto drawn_by = [&](Method method) {
        return std::any_of(halves_.begin(), halves_.end(),
                           [&](const Half& half) { return half.draws.lamps.contains(method); });
    };
    if (drawn_by(Method::spectral))
        atlas_.emplace(kAtlasSize, kAtlasSize, exhibit_.atlas.rgba,
                       Sampling{Filter::nearest, Wrap::clamp, false});
    if (drawn_by(Method::packed))
        packed_ = upload(packed_atlas(exhibit_.atlas));
    if (exhibit_.display.dither && !dither_)
        dither_ = upload(dither_table());
}

View FrameRenderer::begin(int width_px, int height_px) const {
    glViewport(0, 0, width_px, height_px);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glDisable(GL_DITHER); // on by default, and each driver does as it likes
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE); // closed bodies hide their backs
    clear_gray(kBackground, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    return view_of(scene_.camera, static_cast<double>(width_px) / height_px);
}

void FrameRenderer::end() const {
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
    throw_on_gl_error("draw", "the frame");
}

void FrameRenderer::draw(int width_px, int height_px, int scale) {
    const View view = begin(width_px, height_px);
    const int split = exhibit_.compare ? split_column(*exhibit_.compare, width_px / scale) * scale : width_px;
    const bool each_half = scene_kind(exhibit_.scene).each_half;
    glEnable(GL_SCISSOR_TEST);
    for (std::size_t i = 0; i < halves_.size(); ++i) {
        const int left = i == 0 ? 0 : split, right = i == 0 ? split : width_px;
        if (left == right)
            continue;
        glScissor(left, 0, right - left, height_px);
        if (each_half)
            glViewport(left, 0, right - left, height_px);
        draw_half(halves_[i],
                  each_half ? view_of(scene_.camera, static_cast<double>(right - left) / height_px) : view);
    }
    draw_split_line(split, height_px, scale);
    end();
    drawn_ = {width_px, height_px, scale};
}

void FrameRenderer::draw_side(std::size_t half, int width_px, int height_px) {
    const View view = begin(width_px, height_px);
    draw_half(halves_[std::min(half, halves_.size() - 1)], view);
    end();
    drawn_ = {};
}

bool FrameRenderer::draw_if_changed(int width_px, int height_px, int scale) {
    if (drawn_ == std::array{width_px, height_px, scale})
        return false;
    draw(width_px, height_px, scale);
    return true;
}

void FrameRenderer::draw_half(const Half& half, const View& view) {
    shadows_.bind(kShadowUnit);
    if (dither_)
        dither_->bind(kDitherUnit);
    const Program* current = nullptr;
    for (const std::size_t i : front_to_back_) {
        const Prepared& object = half.objects[i];
        const Draw& draw = half.draws.objects[i];
        const Method method = draw.variant.method;
        if (object.program != current) {
            current = object.program;
            current->use();
            current->set("u_clip_from_world", view.clip_from_world);
            current->set("u_eye", view.eye);
            set_uniforms(*current, half.draws.lamps.at(method));
            if (method == Method::spectral)
                atlas_->bind(kAtlasUnit);
            if (method == Method::packed)
                packed_->bind(kAtlasUnit);
        }
        set_uniforms(*current, draw.uniforms);
        if (maps_[i])
            maps_[i]->bind(kKeyUnit, kLuminanceUnit, kNormalUnit);
        if (object.material_map)
            object.material_map->bind(kMaterialUnit);
        if (object.tap_table)
            object.tap_table->bind(kTapUnit);
        meshes_[i].draw();
    }
}

void FrameRenderer::draw_split_line(int split_px, int height_px, int scale) const {
    const int line = exhibit_.compare ? exhibit_.compare->line_px * scale : 0;
    if (line == 0)
        return;
    glScissor(split_px - line / 2, 0, line, height_px);
    clear_gray(kLine, GL_COLOR_BUFFER_BIT);
}

} // namespace metamer
