// The picture watchdog: a known patch, drawn, read back, and held against the CPU twin; never the same twice
// in a row.
#pragma once

#include <optional>
#include <string>

#include "exhibit/exhibit.h"
#include "gles/framebuffer.h"
#include "render/frame_renderer.h"

namespace metamer {

/// Needs a current context; goes before it.
class PictureWatch {
public:
    PictureWatch();

    /// What is wrong, as one sentence: `spectral shows 12 34 56 where 80 90 20 belongs`, `cannot draw
    /// the frame: GL_OUT_OF_MEMORY`; empty where all is well. A color may be 2 steps off. Leaves another
    /// framebuffer bound.
    std::string look();

private:
    Exhibit exhibit_; ///< two patches under one lamp, by the loop and by sums on the CPU
    FrameRenderer renderer_;
    Framebuffer target_;
    std::size_t looks_ = 0;
};

} // namespace metamer
