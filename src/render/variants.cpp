#include "render/variants.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "atlas/atlas.h"
#include "base/numbers.h"
#include "exhibit/exhibit.h"
#include "methods/light.h"
#include "methods/pair.h"

namespace metamer_shaders {
std::string_view embedded(std::string_view name);
}

namespace metamer {

namespace {

// GLSL ES 1.00 does not turn whole numbers into floats.
std::string literal(double value) {
    std::string text = to_text(value);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

Defines constants() {
    return {
        {"INTERVALS", std::to_string(kIntervals)},
        {"ATLAS_SIZE", literal(kAtlasSize)},
        {"SRGB_LINEAR_UP_TO", literal(SrgbCurve::kLinearUpTo)},
        {"SRGB_SLOPE", literal(SrgbCurve::kSlope)},
        {"SRGB_SCALE", literal(SrgbCurve::kScale)},
        {"SRGB_OFFSET", literal(SrgbCurve::kOffset)},
        {"SRGB_GAMMA", literal(SrgbCurve::kGamma)},
        {"LEAST_FALLOFF", literal(kLeastFalloff)},
        {"LEAST_LENGTH_SQUARED", literal(kLeastLengthSquared)},
        {"MOST_LIGHT", literal(kMostLight)},
        {"MATERIAL_MAP_LEAST", literal(kMaterialMapLeast)},
        {"MATERIAL_MAP_SPAN", literal(kMaterialMapSpan)},
        {"SHADOW_TILE_PX", literal(kShadowTilePx)},
        {"SHADOW_LIFT", literal(kShadowLift)},
        {"SHADOW_BIAS", literal(kShadowBias)},
        {"SURFACE_PLAIN", "0"},
        {"SURFACE_MAPS", "1"},
        {"SURFACE_RAMP", "2"},
        {"SURFACE_RAMP_CODES", "3"},
    };
}

constexpr std::string_view kSurfaceNames[] = {"plain", "maps", "ramp", "ramp-codes"};

void add_surfaces(std::vector<Variant>& variants, Variant v) {
    v.lit = false;
    for (Surface surface : {Surface::plain, Surface::ramp, Surface::ramp_codes}) {
        v.surface = surface;
        if (surface != Surface::ramp_codes || v.method == Method::rgb)
            variants.push_back(v);
    }
    v.lit = true;
    for (v.shadows = 0; v.shadows <= std::min(v.lamps, kMostShadows); ++v.shadows)
        for (Surface surface : {Surface::plain, Surface::maps}) {
            v.surface = surface;
            variants.push_back(v);
        }
}

} // namespace

ShaderVariant shader_variant(const Variant& v) {
    const std::string method(method_name(v.method));
    const auto surface = static_cast<std::size_t>(v.surface);
    ShaderVariant out;
    out.name = method + "-" + std::to_string(v.lamps) + (v.lamps == 1 ? "lamp-" : "lamps-") +
               (v.lit ? "lit-" : "flat-") + (v.shadows > 0 ? std::to_string(v.shadows) + "shadows-" : "") +
               std::string(kSurfaceNames[surface]) + (v.transfer == Transfer::srgb ? "" : "-linear");
    out.vertex = "surface.vert";
    out.fragment = method + ".frag";
    out.defines = constants();
    out.defines.insert(out.defines.end(), {{"LAMPS", std::to_string(v.lamps)},
                                           {"LIT", v.lit ? "1" : "0"},
                                           {"SHADOWS", std::to_string(v.shadows)},
                                           {"SURFACE", std::to_string(surface)},
                                           {"TRANSFER_SRGB", v.transfer == Transfer::srgb ? "1" : "0"}});
    return out;
}

std::vector<Variant> all_variants() {
    std::vector<Variant> variants;
    for (const MethodInfo& info : kMethods)
        for (int lamps = 1; lamps <= kMostLamps; ++lamps)
            for (Transfer transfer : {Transfer::srgb, Transfer::none})
                add_surfaces(variants, {.method = info.method, .lamps = lamps, .transfer = transfer});
    return variants;
}

ShaderVariant shadow_variant() {
    return {"shadow", "shadow.vert", "shadow.frag", {}};
}

std::vector<ShaderVariant> shader_variants() {
    std::vector<ShaderVariant> out{shadow_variant()};
    for (const Variant& variant : all_variants())
        out.push_back(shader_variant(variant));
    return out;
}

ShaderFiles shader_files() {
    return metamer_shaders::embedded;
}

} // namespace metamer
