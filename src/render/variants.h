// The shader variants: which files with which #defines, from one table. Constants of the color rooms enter
// the shaders here and nowhere else.
#pragma once

#include <compare>
#include <vector>

#include "color/transfer.h"
#include "gles/shader_source.h"
#include "methods/method.h"

namespace metamer {

/// How a surface tells its material: one key; maps of keys, luminance and normals; a ramp between two
/// materials, mixed linearly; a ramp mixed in code values (method rgb only).
enum class Surface { plain, maps, ramp, ramp_codes };

/// Everything that makes one program differ from another.
struct Variant {
    Method method = Method::spectral;
    int lamps = 1;   ///< 1 .. kMostLamps
    bool lit = true; ///< false: I_shading = 1 everywhere (patches, ramps)
    int shadows = 0; ///< of the first lamps, 0 .. min(lamps, kMostShadows)
    Surface surface = Surface::plain;
    Transfer transfer = Transfer::srgb;
    auto operator<=>(const Variant&) const = default;
};

/// Side of one lamp's tile in the shadow map, which holds 2 x 2 of them.
inline constexpr int kShadowTilePx = 1024;

/// A point is tested for shadow this far off its surface, in scene units: some texels of a tile over a scene
/// of radius 2.4; two depths closer than the bias, a share of the lamp's range, are one.
inline constexpr double kShadowLift = 0.012, kShadowBias = 0.0015;

/// The texture of materials that product methods read by key: code 0 .. 65535 is kMaterialMapLeast .. + Span.
inline constexpr double kMaterialMapLeast = -0.5, kMaterialMapSpan = 2.0;

/// Its files and defines.
ShaderVariant shader_variant(const Variant& variant);

/// Every variant that a frame may ask for.
std::vector<Variant> all_variants();

/// The same as files and defines, the shadow pass with them.
std::vector<ShaderVariant> shader_variants();

/// The files of shaders_es/, built into the program.
ShaderFiles shader_files();

/// The shadow pass.
ShaderVariant shadow_variant();

} // namespace metamer
