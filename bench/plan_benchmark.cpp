// Planning: what a visitor's change of lamp costs before the next frame. Spectra of materials are there.
#include <benchmark/benchmark.h>

#include "exhibit/load.h"
#include "plan/planner.h"

namespace metamer {
namespace {

void plan(benchmark::State& state, const Exhibit& exhibit) {
    const ExhibitSpectra spectra(exhibit);
    for (auto _ : state)
        benchmark::DoNotOptimize(plan_exhibit(exhibit, spectra));
}

void plan_still_life(benchmark::State& state) {
    plan(state,
         load_exhibit("config/still-life.ini", {"compare.left.method=auto", "compare.right.method=auto"}));
}
BENCHMARK(plan_still_life)->Name("plan/still-life/two halves, three lamps")->Unit(benchmark::kMillisecond);

void plan_media(benchmark::State& state) {
    plan(state, parse_exhibit("[scene]\nkind = media\n", "media", ".",
                              {"lamp.1.spectrum=A2800", "lamp.2.spectrum=F11", "lamp.3.spectrum=D65"}));
}
BENCHMARK(plan_media)->Name("plan/media/three lamps")->Unit(benchmark::kMillisecond);

} // namespace
} // namespace metamer
