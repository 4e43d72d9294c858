// Whether a program draws at all.
#pragma once

#include "gles/program.h"

namespace metamer {

/// Draws one pixel and looks. Some drivers of small GPUs (Vivante GC400, VideoCore IV) accept a shader that
/// is too long for the GPU, report success for compiling, linking and drawing, and draw nothing
/// (docs/low-end.md). The program must put `a_position` where it is in clip space with its uniforms as they
/// are now, and write an alpha of 1; its samplers read white from unit 0, whatever is bound there. Leaves
/// framebuffer, texture, viewport, blending, dithering, scissor and depth test as they were.
bool draws(const Program& program);

} // namespace metamer
