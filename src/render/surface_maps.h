// The textures of objects with maps: keys, luminance and normals, neutral where an object has none.
#pragma once

#include <array>

#include "exhibit/exhibit.h"
#include "gles/texture.h"

namespace metamer {

/// Heights to a tangent-space normal map of the same size, RGBA8 with 128 as zero (Blinn 1978): slopes by
/// central differences, wrapping at the edges; `height` is that of white over black in units of the map's
/// width.
Image normal_map(const Image& heights, double height);

/// Needs a context. Move-only.
class SurfaceMaps {
public:
    explicit SurfaceMaps(const ObjectSetting& object);
    void bind(int key_unit, int luminance_unit, int normal_unit) const;

private:
    Texture keys_, luminance_, normals_;
};

} // namespace metamer
