#include "render/variants.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "atlas/atlas.h"
#include "base/numbers.h"
#include "exhibit/exhibit.h"
#include "gles/precision_probe.h"
#include "methods/light.h"
#include "methods/shade.h"

namespace metamer {

namespace {

// GLSL ES 1.00 does not turn whole numbers into floats.
std::string literal(double value) {
    std::string text = to_text(value);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

// Where a minus sign may meet an operator.
std::string in_brackets(double value) {
    return "(" + literal(value) + ")";
}

Defines constants() {
    return {
        {"INTERVALS", std::to_string(kIntervals)},
        {"ATLAS_SIZE", literal(kAtlasSize)},
        {"PACKED_COLUMNS", literal(kPackedColumns)},
        {"PACKED_ROWS", literal(kPackedRows)},
        {"TAP_TABLE_SIZE", literal(kTapTableSize)},
        {"MOST_LAMPS", literal(kMostLamps)},
        {"LEAST_K", literal(kLeastK)},
        {"LEAST_TRANSMITTANCE", literal(kLeastTransmittance)},
        {"SRGB_LINEAR_UP_TO", literal(SrgbCurve::kLinearUpTo)},
        {"SRGB_SLOPE", literal(SrgbCurve::kSlope)},
        {"SRGB_SCALE", literal(SrgbCurve::kScale)},
        {"SRGB_OFFSET", literal(SrgbCurve::kOffset)},
        {"SRGB_GAMMA", literal(SrgbCurve::kGamma)},
        {"SRGB_LINE_UP_TO", literal(SrgbPolynomial::kLineUpTo)},
        {"SRGB_ROOT_0", in_brackets(SrgbPolynomial::kOfRoot[0])},
        {"SRGB_ROOT_1", in_brackets(SrgbPolynomial::kOfRoot[1])},
        {"SRGB_ROOT_2", in_brackets(SrgbPolynomial::kOfRoot[2])},
        {"SRGB_ROOT_3", in_brackets(SrgbPolynomial::kOfRoot[3])},
        {"SRGB_ROOT_4", in_brackets(SrgbPolynomial::kOfRoot[4])},
        {"TRANSFER_NONE", "0"},
        {"TRANSFER_SRGB", "1"},
        {"TRANSFER_SRGB_POW", "2"},
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
        {"SURFACE_MEDIUM", "4"},
        {"SURFACE_BOUNCE", "5"},
    };
}

constexpr std::string_view kSurfaceNames[] = {"plain", "maps", "ramp", "ramp-codes", "medium", "bounce"};
constexpr std::string_view kCurveNames[] = {"-linear", "", "-pow"};

// With 0 for the texture, what a program of this many lamps may be built for.
std::vector<int> tap_counts(Method method, int lamps, bool lit) {
    std::vector<int> counts{0};
    if (method == Method::reduced)
        for (const int count : kTapCounts)
            if (taps_in_uniforms(count, lamps, lit) > 0)
                counts.push_back(count);
    return counts;
}

// All that a method draws in shaded scenes under so many lamps.
void add_lit(std::vector<Variant>& variants, Variant v) {
    const int most = std::min(v.lamps, kMostShadows);
    for (v.shadows = 0; v.shadows <= most; ++v.shadows)
        for (const Surface surface : {Surface::plain, Surface::maps, Surface::bounce})
            for (const bool mirrors : {true, false})
                for (const bool placed : {true, false}) {
                    const bool whole = mirrors && (placed || surface == Surface::bounce);
                    const bool at_an_end = v.shadows == 0 || v.shadows == most;
                    v.surface = surface;
                    v.mirrors = mirrors;
                    v.placed = placed;
                    if (placed && surface == Surface::bounce)
                        continue;
                    v.smooth = true;
                    if (whole || at_an_end)
                        variants.push_back(v);
                    v.smooth = false;
                    if (whole && at_an_end)
                        variants.push_back(v);
                }
}

// All that a method draws under so many lamps.
void add_surfaces(std::vector<Variant>& variants, Variant v) {
    for (v.lit = false; const int taps : tap_counts(v.method, v.lamps, v.lit)) {
        v.taps = taps;
        v.mirrors = v.placed = false;
        if (lamps_apart(v.method, v.lamps, v.lit) != v.lamps)
            break;
        for (v.surface = Surface::plain;
             const Surface surface : {Surface::plain, Surface::ramp, Surface::ramp_codes, Surface::medium}) {
            v.surface = surface;
            if ((surface != Surface::ramp_codes || v.method == Method::rgb) &&
                can_draw(v.method, surface == Surface::medium))
                variants.push_back(v);
        }
    }
    for (v.lit = true; const int taps : tap_counts(v.method, v.lamps, v.lit)) {
        v.taps = taps;
        add_lit(variants, v);
    }
}

void add_outputs(std::vector<Variant>& variants, Variant v) {
    for (const OutputCurve curve : {OutputCurve::none, OutputCurve::srgb, OutputCurve::srgb_pow})
        for (const bool keep_hue : {false, true})
            for (const bool dither : {false, true}) {
                v.output = {curve, keep_hue, dither};
                if (v.output != OutputStage())
                    variants.push_back(v);
            }
}

} // namespace

int taps_in_uniforms(int taps, int lamps, bool lit) {
    return lamps == 1 && taps <= (lit ? 8 : 12) ? taps : 0;
}

int lamps_apart(Method method, int lamps, bool lit) {
    return !lit && (method == Method::folded || method == Method::reduced) ? 1 : lamps;
}

ShaderVariant shader_variant(const Variant& v) {
    const std::string method(method_name(v.method));
    const auto surface = static_cast<std::size_t>(v.surface),
               curve = static_cast<std::size_t>(v.output.curve);
    ShaderVariant out;
    out.name = method + (v.taps > 0 ? std::to_string(v.taps) : "") + "-" + std::to_string(v.lamps) +
               (v.lamps == 1 ? "lamp-" : "lamps-") + (v.lit ? "lit-" : "flat-") +
               (v.shadows > 0 ? std::to_string(v.shadows) + "shadows-" : "") +
               std::string(kSurfaceNames[surface]) + (v.lit && !v.mirrors ? "-dull" : "") +
               (v.lit && !v.placed ? "-parallel" : "") + (v.smooth ? "" : "-planes") +
               std::string(kCurveNames[curve]) + (v.output.keep_hue ? "-hue" : "") +
               (v.output.dither ? "-dither" : "");
    out.vertex = "surface.vert";
    out.fragment = method + ".frag";
    out.defines = constants();
    const auto flag = [](bool on) { return on ? "1" : "0"; };
    out.defines.insert(out.defines.end(), {{"LAMPS", std::to_string(v.lamps)},
                                           {"LIT", flag(v.lit)},
                                           {"MIRRORS", flag(v.lit && v.mirrors)},
                                           {"PLACED", flag(v.lit && v.placed)},
                                           {"SMOOTH", flag(v.smooth)},
                                           {"SHADOWS", std::to_string(v.shadows)},
                                           {"SURFACE", std::to_string(surface)},
                                           {"TAPS", std::to_string(v.taps)},
                                           {"TRANSFER", std::to_string(curve)},
                                           {"KEEP_HUE", flag(v.output.keep_hue)},
                                           {"DITHER", flag(v.output.dither)}});
    return out;
}

std::vector<Variant> all_variants() {
    std::vector<Variant> variants;
    for (const MethodInfo& info : kMethods) {
        for (int lamps = 1; lamps <= kMostLamps; ++lamps)
            add_surfaces(variants, {.method = info.method, .lamps = lamps});
        for (const bool lit : {false, true})
            add_outputs(variants, {.method = info.method, .lit = lit, .mirrors = lit, .placed = lit});
    }
    return variants;
}

ShaderVariant shadow_variant() {
    return {"shadow", "shadow.vert", "shadow.frag", {}};
}

ShaderVariant picture_variant(bool fading) {
    return {fading ? "picture-fading" : "picture",
            "picture.vert",
            "picture.frag",
            {{"FADING", fading ? "1" : "0"}}};
}

std::vector<ShaderVariant> shader_variants() {
    std::vector<ShaderVariant> out{shadow_variant(), picture_variant(false), picture_variant(true),
                                   precision_probe_variant(Precision::mediump),
                                   precision_probe_variant(Precision::highp)};
    for (const Variant& variant : all_variants())
        out.push_back(shader_variant(variant));
    return out;
}

} // namespace metamer
