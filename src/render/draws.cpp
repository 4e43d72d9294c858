#include "render/draws.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "methods/three_numbers.h"
#include "render/meshes.h"
#include "render/tables.h"

namespace metamer {

namespace {

using Rgb = std::array<double, 3>;

float coordinate(int row, int rows) {
    return (static_cast<float>(row) + 0.5f) / static_cast<float>(rows);
}

Rgb scaled(const Rgb& v, double factor) {
    return {v[0] * factor, v[1] * factor, v[2] * factor};
}

glm::vec2 to_glm(const std::array<double, 2>& v) {
    return {finite_in_half(v[0]), finite_in_half(v[1])};
}

// Materials mixed in code values: what a paint program does with two colors.
Rgb codes(const Rgb& linear, Transfer transfer) {
    return {encode(transfer, linear[0]), encode(transfer, linear[1]), encode(transfer, linear[2])};
}

OutputStage output_stage(const Display& display, DrawStyle style) {
    const OutputCurve srgb = style.everybody ? OutputCurve::srgb_pow : OutputCurve::srgb;
    return {display.transfer == Transfer::srgb ? srgb : OutputCurve::none, display.gamut == Gamut::keep_hue,
            display.dither};
}

/// Everything that a half's draws are made of.
class HalfBuilder {
public:
    HalfBuilder(const Exhibit& exhibit, const ExhibitSpectra& spectra, const HalfPlan& plan,
                const Scene& scene, DrawStyle style)
        : exhibit_(exhibit),
          spectra_(spectra),
          plan_(plan),
          scene_(scene),
          style_(style),
          output_(plan.view.output_of()),
          rgb_from_xyz_(output_.adapted_rgb_from_xyz()) {}

    Draw draw(const SceneObject& shape, const ObjectPlan& plan) const;
    Uniforms lamps(Method method, std::span<const ShadowTile> shadows) const;

private:
    void add_product(Draw& draw, const ObjectSetting& object, Method method) const;
    void add_rows(Draw& draw, const ObjectSetting& object, Method method) const;
    void add_folded(Draw& draw, const ObjectSetting& object) const;
    void add_reduced(Draw& draw, const ObjectSetting& object, const Taps& taps) const;
    void add_tap_table(Draw& draw, const std::vector<std::vector<Rgb>>& colors,
                       const std::vector<double>& layers) const;
    std::vector<float> bounced(const ObjectSetting& object) const;
    Rgb lamp_color(const HalfLamp& lamp, Method method) const;

    const Exhibit& exhibit_;
    const ExhibitSpectra& spectra_;
    const HalfPlan& plan_;
    const Scene& scene_;
    DrawStyle style_;
    OutputSpace output_;
    Matrix3 rgb_from_xyz_;
};

// What a highlight mirrors of a lamp, in the space that the method's shader adds it up in.
Rgb HalfBuilder::lamp_color(const HalfLamp& lamp, Method method) const {
    if (is_product(method))
        return scaled(lamp_numbers(method, lamp.emission, spectra_.seen(), output_), lamp.strength);
    const Xyz white =
        lamp_white({&lamp.emission, lamp.full ? &*lamp.full : nullptr, 1, {}}, spectra_.exact());
    return scaled(rgb_from_xyz_ * Rgb{white.x, white.y, white.z}, lamp.strength);
}

// What the other wall gets of each lamp: planes are lit evenly by parallel light.
std::vector<float> HalfBuilder::bounced(const ObjectSetting& object) const {
    const ObjectSetting* other = other_wall(exhibit_, object);
    if (!other)
        return {};
    glm::vec3 normal(0);
    for (const SceneObject& shape : scene_.objects)
        if (shape.setting == other)
            normal = glm::vec3(shape.mesh.vertices[3], shape.mesh.vertices[4], shape.mesh.vertices[5]);
    std::vector<float> shares;
    for (const HalfLamp& lamp : plan_.view.lamps)
        shares.push_back(std::max(glm::dot(normal, glm::vec3(lamp_place(exhibit_, lamp, scene_))), 0.0f));
    return shares;
}

Uniforms HalfBuilder::lamps(Method method, std::span<const ShadowTile> shadows) const {
    std::vector<glm::vec4> places, depths;
    std::vector<glm::vec3> falloffs, colors;
    std::vector<glm::vec2> rows, corners;
    std::vector<glm::mat4> views;
    for (const HalfLamp& lamp : plan_.view.lamps) {
        const Falloff& falloff = exhibit_.lamps[lamp.setting].falloff;
        places.push_back(lamp_place(exhibit_, lamp, scene_));
        falloffs.emplace_back(falloff.constant, falloff.linear, falloff.quadratic);
        colors.push_back(metamer::to_glm(lamp_color(lamp, method)));
        if (method == Method::packed)
            rows.emplace_back(coordinate(kAtlasSize + lamp.key, kPackedRows),
                              finite_in_half(packed_scale(lamp.emission, lamp.strength, spectra_.seen())));
        else
            rows.emplace_back(coordinate(lamp.key, kAtlasSize), finite_in_half(lamp.strength));
    }
    for (const ShadowTile& tile : shadows) {
        views.push_back(tile.shadow_from_world);
        depths.push_back(tile.depth_from_world);
        corners.push_back(tile.corner);
    }
    return {{"u_lamp_place", places},
            {"u_lamp_falloff", falloffs},
            {"u_lamp_color", colors},
            {"u_lamp_row", rows},
            {"u_rounds", static_cast<float>(kPackedRounds)},
            {"u_rgb_from_xyz", metamer::to_glm(rgb_from_xyz_)},
            {"u_rgb_from_numbers", metamer::to_glm(rgb_from_numbers(method, output_))},
            {"u_shadow_from_world", views},
            {"u_depth_from_world", depths},
            {"u_shadow_tile", corners},
            {"u_dither_step", exhibit_.display.color_depth_bits == 16
                                  ? glm::vec3(1 / 31.0f, 1 / 63.0f, 1 / 31.0f)
                                  : glm::vec3(1 / 255.0f)},
            {"u_atlas", kAtlasUnit},
            {"u_packed", kAtlasUnit},
            {"u_key_map", kKeyUnit},
            {"u_luminance_map", kLuminanceUnit},
            {"u_normal_map", kNormalUnit},
            {"u_material_map", kMaterialUnit},
            {"u_shadow_map", kShadowUnit},
            {"u_tap_table", kTapUnit},
            {"u_dither_map", kDitherUnit}};
}

void HalfBuilder::add_product(Draw& draw, const ObjectSetting& object, Method method) const {
    if (draw.variant.surface == Surface::maps) {
        draw.material_map = product_table(method, spectra_, output_);
        return;
    }
    const auto numbers = [&](const MaterialSetting& material) {
        return material_numbers(method, *spectra_.material(material.key).row, spectra_.seen(), output_);
    };
    const auto mixed = [&](const MaterialSetting& material) {
        return metamer::to_glm(draw.variant.surface == Surface::ramp_codes
                                   ? codes(numbers(material), output_.transfer)
                                   : numbers(material));
    };
    draw.uniforms.push_back({"u_material", mixed(object.material)});
    if (object.material_end)
        draw.uniforms.push_back({"u_material_end", mixed(*object.material_end)});
    if (object.medium)
        draw.uniforms.push_back({"u_medium_log2", metamer::to_glm(scaled(medium_log2(numbers(*object.medium)),
                                                                         object.thickness))});
    if (const ObjectSetting* other = other_wall(exhibit_, object))
        draw.uniforms.push_back({"u_other", metamer::to_glm(numbers(other->material))});
}

void HalfBuilder::add_rows(Draw& draw, const ObjectSetting& object, Method method) const {
    if (draw.variant.surface == Surface::maps) {
        draw.material_map = scale_table(exhibit_.atlas);
        return;
    }
    const ObjectSetting* other = other_wall(exhibit_, object);
    const MaterialSetting& second = object.material_end ? *object.material_end
                                    : object.medium     ? *object.medium
                                    : other             ? other->material
                                                        : object.material;
    const auto row = [&](const MaterialSetting& material) {
        return method == Method::packed ? coordinate(2 * kAtlasSize + material.key, kPackedRows)
                                        : coordinate(material.key, kAtlasSize);
    };
    const auto scale = [&](const MaterialSetting& material) {
        return static_cast<float>(exhibit_.atlas.materials[static_cast<std::size_t>(material.key)].scale);
    };
    draw.uniforms.push_back({"u_material_row", glm::vec2(row(object.material), row(second))});
    draw.uniforms.push_back({"u_material_scale", glm::vec2(scale(object.material), scale(second))});
    draw.uniforms.push_back({"u_thickness", static_cast<float>(object.thickness)});
}

void HalfBuilder::add_folded(Draw& draw, const ObjectSetting& object) const {
    if (draw.variant.surface == Surface::maps) {
        const FoldedTable table = folded_table(plan_.view, spectra_);
        draw.material_map = table.image;
        std::vector<glm::vec2> ranges;
        for (const auto& range : table.ranges)
            ranges.push_back(to_glm(range));
        draw.uniforms.push_back({"u_folded_range", ranges});
        return;
    }
    // Where nothing tells the lamps apart they are one.
    const auto per_lamp = [&](const std::vector<FoldedLamp<double>>& lamps, auto member) {
        std::vector<glm::vec3> colors;
        Rgb sum{};
        for (const FoldedLamp<double>& lamp : lamps) {
            colors.push_back(metamer::to_glm(lamp.*member));
            for (std::size_t c = 0; c < 3; ++c)
                sum[c] += (lamp.*member)[c];
        }
        return scene_.lit ? colors : std::vector{metamer::to_glm(sum)};
    };
    using Folded = FoldedLamp<double>;
    const auto fold = [&](const MaterialSetting& material) {
        return folded_lamps(pixel_of(exhibit_, plan_.view, spectra_, object, material), spectra_.exact(),
                            rgb_from_xyz_);
    };
    const auto lamps = fold(object.material);
    draw.uniforms.push_back({"u_folded", per_lamp(lamps, &Folded::reflected)});
    if (object.material_end)
        draw.uniforms.push_back({"u_folded_end", per_lamp(fold(*object.material_end), &Folded::reflected)});
    if (draw.variant.surface == Surface::bounce)
        draw.uniforms.push_back({"u_folded_bounce", per_lamp(lamps, &Folded::bounced)});
}

void HalfBuilder::add_tap_table(Draw& draw, const std::vector<std::vector<Rgb>>& colors,
                                const std::vector<double>& layers) const {
    const TapTable table = tap_table(colors, layers);
    std::vector<glm::vec4> ranges;
    for (const auto& range : table.ranges)
        ranges.emplace_back(to_glm(range), to_glm(table.layer_range));
    draw.tap_table = table.image;
    draw.uniforms.push_back({"u_tap_range", ranges});
    draw.uniforms.push_back({"u_taps", static_cast<float>(layers.size())});
}

void HalfBuilder::add_reduced(Draw& draw, const ObjectSetting& object, const Taps& taps) const {
    Pixel seen = pixel_of(exhibit_, plan_.view, spectra_, object, object.material);
    const bool by_texture = draw.variant.surface == Surface::maps || draw.variant.surface == Surface::ramp;
    const Reflectance white = [] {
        Reflectance r;
        r.value.fill(1);
        return r;
    }();
    if (by_texture) {
        seen.material = {&white, nullptr};
        draw.material_map = tap_reflectances(spectra_, taps);
        const int end = object.material_end ? object.material_end->key : object.material.key;
        draw.uniforms.push_back({"u_material_row", glm::vec2(coordinate(object.material.key, kAtlasSize),
                                                             coordinate(end, kAtlasSize))});
    }
    auto colors = tap_colors(seen, taps, rgb_from_xyz_);
    if (!scene_.lit)
        for (std::size_t i = 0; i < taps.wavelength_nm.size(); ++i)
            for (std::size_t l = 1; l < colors.size(); ++l)
                for (std::size_t c = 0; c < 3; ++c)
                    colors[0][i][c] += colors[l][i][c];
    if (!scene_.lit)
        colors.resize(1);
    std::vector<double> layers;
    for (const TapLayers<double>& layer : tap_layers(seen, taps))
        layers.push_back(seen.medium ? layer.medium_log2 * seen.thickness : layer.other);
    if (draw.variant.taps == 0) {
        add_tap_table(draw, colors, layers);
        return;
    }
    std::vector<glm::vec4> uniform;
    for (std::size_t i = 0; i < layers.size(); ++i)
        uniform.emplace_back(metamer::to_glm(colors[0][i]), finite_in_half(layers[i]));
    draw.uniforms.push_back({"u_tap", uniform});
}

Draw HalfBuilder::draw(const SceneObject& shape, const ObjectPlan& plan) const {
    const ObjectSetting& object = *shape.setting;
    const int lamps = static_cast<int>(plan_.view.lamps.size());
    Draw draw;
    draw.variant.method = plan.method;
    draw.variant.lamps = lamps_apart(plan.method, lamps, scene_.lit);
    draw.variant.lit = scene_.lit;
    draw.variant.mirrors = scene_.lit && (object.specular > 0 || style_.everybody);
    draw.variant.shadows = plan_.view.shadows;
    draw.variant.surface = surface_of(exhibit_, object, plan.method);
    draw.variant.smooth = !scene_.lit || style_.everybody || !is_of_planes(shape.mesh);
    // Scenes with a second wall take parallel light only.
    draw.variant.placed =
        scene_.lit && draw.variant.surface != Surface::bounce &&
        (style_.everybody || std::any_of(exhibit_.lamps.begin(), exhibit_.lamps.end(),
                                         [](const LampSetting& lamp) { return lamp.position.has_value(); }));
    draw.variant.taps = plan.method == Method::reduced
                            ? taps_in_uniforms(static_cast<int>(plan.taps.wavelength_nm.size()),
                                               draw.variant.lamps, scene_.lit)
                            : 0;
    draw.variant.output = output_stage(exhibit_.display, style_);
    draw.uniforms.push_back({"u_mirror", glm::vec2(object.specular, object.shininess / 2)});
    if (const auto shares = bounced(object); !shares.empty())
        draw.uniforms.push_back({"u_bounced", shares});
    if (is_product(plan.method))
        add_product(draw, object, plan.method);
    else if (plan.method == Method::folded)
        add_folded(draw, object);
    else if (plan.method == Method::reduced)
        add_reduced(draw, object, plan.taps);
    else
        add_rows(draw, object, plan.method);
    return draw;
}

} // namespace

glm::vec4 lamp_place(const Exhibit& exhibit, const HalfLamp& lamp, const Scene& scene) {
    const LampSetting& setting = exhibit.lamps[lamp.setting];
    if (setting.position)
        return {(*setting.position)[0], (*setting.position)[1], (*setting.position)[2], 1};
    if (setting.direction) // light travels along it, shaders look back towards the lamp
        return {-(*setting.direction)[0], -(*setting.direction)[1], -(*setting.direction)[2], 0};
    return {scene.lamp_directions.at(lamp.setting), 0};
}

HalfDraws half_draws(const Exhibit& exhibit, const ExhibitSpectra& spectra, const HalfPlan& plan,
                     const Scene& scene, std::span<const ShadowTile> shadows, DrawStyle style) {
    const HalfBuilder builder(exhibit, spectra, plan, scene, style);
    HalfDraws out;
    for (const SceneObject& shape : scene.objects) {
        const auto object = static_cast<std::size_t>(shape.setting - exhibit.objects.data());
        out.objects.push_back(builder.draw(shape, plan.objects[object]));
        const Method method = plan.objects[object].method;
        if (!out.lamps.contains(method))
            out.lamps.emplace(method, builder.lamps(method, shadows));
    }
    return out;
}

} // namespace metamer
