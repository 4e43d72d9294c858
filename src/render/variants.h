// The shader variants: which files with which #defines, from one table. Constants of the color rooms enter
// the shaders here and nowhere else.
#pragma once

#include <compare>
#include <vector>

#include "gles/shader_source.h"
#include "methods/method.h"
#include "plan/object_pixels.h"

namespace metamer {

/// How light becomes a code value in the framebuffer.
enum class OutputCurve {
    none,     ///< code values are light
    srgb,     ///< the polynomial of color/transfer.h
    srgb_pow, ///< the standard's own formula: what everybody writes, and what charts compare with
};

struct OutputStage {
    OutputCurve curve = OutputCurve::srgb;
    bool keep_hue = false; ///< color/gamut.h
    bool dither = false;
    auto operator<=>(const OutputStage&) const = default;
};

/// Everything that makes one program differ from another.
struct Variant {
    Method method = Method::spectral;
    int lamps = 1;       ///< 1 .. kMostLamps
    bool lit = true;     ///< false: I_shading = 1 everywhere (patches, ramps, media)
    bool mirrors = true; ///< false: nothing is mirrored, no highlight is computed; false where not lit
    bool placed =
        true; ///< false: lamps have directions only, no falloff; false where not lit, and for bounces
    bool smooth = true; ///< false: the mesh is of planes, whose normals need no length; true where not lit
    int shadows = 0;    ///< of the first lamps, 0 .. min(lamps, kMostShadows)
    Surface surface = Surface::plain;
    int taps = 0; ///< of method reduced: in uniforms; 0: any number from a texture
    OutputStage output = {};
    auto operator<=>(const Variant&) const = default;
};

/// How many taps the program of a variant takes in uniforms; 0: they come from a texture. ES 2's floor of 16
/// vectors has room for 8 beside one lamp's light, for 12 where nothing else is needed (unlit).
int taps_in_uniforms(int taps, int lamps, bool lit);

/// Lamps that a program knows apart: without shading, `folded` and `reduced` know one, the sum of all.
int lamps_apart(Method method, int lamps, bool lit);

/// Side of one lamp's tile in the shadow map, which holds 2 x 2 of them.
inline constexpr int kShadowTilePx = 1024;

/// A point is tested for shadow this far off its surface, in scene units: some texels of a tile over a scene
/// of radius 2.4; two depths closer than the bias, a share of the lamp's range, are one.
inline constexpr double kShadowLift = 0.012, kShadowBias = 0.0015;

/// The texture of materials that product methods read by key: code 0 .. 65535 is kMaterialMapLeast .. + Span.
inline constexpr double kMaterialMapLeast = -0.5, kMaterialMapSpan = 2.0;

/// Columns of the texture of packed wavelengths and its rows: observer 0 .. 2, lamps 64 + key, materials 128
/// + key.
inline constexpr int kPackedColumns = 16, kPackedRows = 256;

/// Side of the texture of taps.
inline constexpr int kTapTableSize = 32;

/// Its files and defines.
ShaderVariant shader_variant(const Variant& variant);

/// Every variant that a frame may ask for with the common output; and, for one lamp, with every output. What
/// only leaves something out (nothing mirrored, no lamp placed, planes) is there at the ends alone: without
/// shadows, and with as many as can be.
std::vector<Variant> all_variants();

/// The same as files and defines, the shadow pass, laid pictures and the precision probe with them.
std::vector<ShaderVariant> shader_variants();

/// The shadow pass.
ShaderVariant shadow_variant();

/// A picture laid on the screen; `fading`: out of another.
ShaderVariant picture_variant(bool fading);

} // namespace metamer
