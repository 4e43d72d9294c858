// Frames timed side by side.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "exhibit/exhibit.h"
#include "gles/framebuffer.h"
#include "render/frame_renderer.h"

namespace metamer {

/// What a timer says of a call, ms.
using StopWatch = std::function<double(const std::function<void()>&)>;

/// Draws until glFinish by the steady clock; or, with GL_EXT_disjoint_timer_query, what the GPU says it took,
/// and the clock's time where the GPU was disturbed. Software renderers are timed by the clock: their GPU is
/// the CPU, and a query there leaves out what happens before rasterization. `name` tells which. Needs a
/// current context.
struct FrameClock {
    StopWatch watch;
    std::string name; ///< `glFinish` or `GL_EXT_disjoint_timer_query`
};
FrameClock frame_clock();

/// Milliseconds of each frame in each round: [frame][round]. In every round every frame is drawn once, in an
/// order that is shuffled anew, the same on every run: what disturbs the machine for longer than a frame
/// disturbs all alike, and none profits from its neighbors. One round before them is not counted: what is
/// compiled at first use is compiled there.
std::vector<std::vector<double>> time_rounds(std::span<const std::function<void()>> frames, int rounds,
                                             const StopWatch& watch);

/// Round by round a / b.
std::vector<double> ratios(std::span<const double> a, std::span<const double> b);

/// An exhibit's frame, ready to be drawn again and again into a framebuffer of its own size. Needs a current
/// context, made before and destroyed after it.
class TimedFrame {
public:
    /// Throws what FrameRenderer throws.
    explicit TimedFrame(Exhibit exhibit, DrawStyle style = {});

    void draw();
    const Plan& plan() const { return renderer_.plan(); }

private:
    Exhibit exhibit_;
    FrameRenderer renderer_;
    Framebuffer target_;
};

} // namespace metamer
