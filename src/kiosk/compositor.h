// Pictures laid on the screen, turned as it hangs.
#pragma once

#include <array>
#include <optional>

#include "gles/mesh.h"
#include "gles/program.h"
#include "overlay/box.h"
#include "visit/motion.h"
#include "window/rotation.h"

namespace metamer {

/// The part of a texture that is shown: its lower left corner, width and height, 0 .. 1, in GL's direction;
/// a negative height turns rows that are stored from the top.
struct Patch {
    float left = 0, bottom = 0, width = 1, height = 1;
};

/// Where the texture of a laid picture, and of the one that it fades out of, must be bound.
inline constexpr int kPictureUnit = 0, kBeforeUnit = 1;

/// Needs a current context.
class Compositor {
public:
    Compositor();

    /// Begins a frame of the bound framebuffer: blending for premultiplied alpha, everything black.
    /// `picture`: the size as people see it. Nothing is shifted.
    void begin(PxSize picture, int rotation_deg);

    /// What follows stands this far right and down.
    void shift(Shift shift) { shift_ = shift; }

    /// Lays the texture at kPictureUnit on the box, one texel a pixel where sizes agree; `share` of it.
    void lay(const PxBox& box, const Patch& patch, float share = 1);

    /// The same, opaque, `share` of the way from the texture at kBeforeUnit.
    void fade(const PxBox& box, const Patch& patch, const Patch& before, float share);

private:
    void place(const Program& program, const PxBox& box, const Patch& patch) const;

    Program laid_;
    std::optional<Program> fading_; ///< from the first fade on: the first frame does not wait for it
    Mesh square_;
    PxSize picture_;
    Shift shift_;
    std::array<float, 4> turn_{};
};

} // namespace metamer
