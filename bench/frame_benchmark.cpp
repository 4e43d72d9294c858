// A 1280 x 720 frame of the loaf by each method, on whatever GL there is. Context, shaders and textures stand
// before the clock starts. To compare methods under one temperature of the machine, interleave them:
// --benchmark_filter=loaf_frame --benchmark_repetitions=9 --benchmark_enable_random_interleaving=true
#include <GLES2/gl2.h>
#include <benchmark/benchmark.h>
#include <string>

#include "exhibit/load.h"
#include "gles/framebuffer.h"
#include "gles/info.h"
#include "gles/surfaceless.h"
#include "render/frame_renderer.h"

namespace metamer {
namespace {

// Made with the first frame: benchmarks without GL need none.
void need_context() {
    static const Surfaceless context;
}

template <Method kMethod>
void loaf_frame(benchmark::State& state) {
    need_context();
    const std::string text =
        "[scene]\nkind = loaf\n[accuracy]\nmethod = " + std::string(method_name(kMethod)) + "\n";
    const Exhibit exhibit = parse_exhibit(text, "the benchmark's loaf", ".");
    const int width_px = exhibit.display.width_px, height_px = exhibit.display.height_px;
    FrameRenderer renderer(exhibit);
    const Framebuffer target(width_px, height_px, DepthBuffer::depth16);
    const auto draw = [&] {
        target.bind();
        renderer.draw(width_px, height_px);
        glFinish();
    };
    draw(); // compiles what is compiled at first use
    for (auto _ : state)
        draw();
    state.SetLabel(std::to_string(width_px) + "x" + std::to_string(height_px) + " on " + gl_renderer());
}
// Wall time: llvmpipe draws on threads of its own, a GPU on none of ours.
BENCHMARK(loaf_frame<Method::rgb>)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(loaf_frame<Method::tristimulus>)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(loaf_frame<Method::spectral>)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
} // namespace metamer
