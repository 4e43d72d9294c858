// The methods' CPU twins: one pixel of one pair, from atlas rows to code values.
#include <benchmark/benchmark.h>

#include "atlas/atlas.h"
#include "color/working_space.h"
#include "methods/shade.h"
#include "methods/three_numbers.h"

namespace metamer {
namespace {

// Float16 is what gcc makes of it: in hardware where there is AVX512-FP16, else each operation in float.
template <Method kMethod, Scalar T>
void twin(benchmark::State& state) {
    Atlas atlas = empty_atlas();
    const Emission lamp = emission(atlas, add_lamp(atlas, find_lamp("F11")));
    const Reflectance material = reflectance(atlas, add_material(atlas, find_material("cc-orange")));
    const GridObserver seen_by = observer(atlas);
    const GridObserver exact = exact_observer(atlas);
    Sight sight{&seen_by, &exact, {}};
    sight.output.rgb_from_xyz = rgb_from_xyz(working_spaces()[0]);
    sight.output.white = &white_emission(working_spaces()[0]);
    Pixel pixel;
    pixel.lamps.emplace_back().row = &lamp;
    pixel.material.row = &material;
    const Taps taps = kMethod == Method::reduced ? taps_for(pixel, sight.tap_count) : Taps{};
    sight.taps = &taps;
    for (auto _ : state)
        benchmark::DoNotOptimize(shade_rgb8<T>(kMethod, pixel, sight));
}
BENCHMARK(twin<Method::rgb, double>);
BENCHMARK(twin<Method::rgb, float>);
BENCHMARK(twin<Method::rgb, Float16>);
BENCHMARK(twin<Method::tristimulus, double>);
BENCHMARK(twin<Method::tristimulus, float>);
BENCHMARK(twin<Method::tristimulus, Float16>);
BENCHMARK(twin<Method::prefiltered, double>);
BENCHMARK(twin<Method::prefiltered, float>);
BENCHMARK(twin<Method::prefiltered, Float16>);
BENCHMARK(twin<Method::folded, double>);
BENCHMARK(twin<Method::folded, float>);
BENCHMARK(twin<Method::folded, Float16>);
BENCHMARK(twin<Method::reduced, double>);
BENCHMARK(twin<Method::reduced, float>);
BENCHMARK(twin<Method::reduced, Float16>);
BENCHMARK(twin<Method::packed, double>);
BENCHMARK(twin<Method::packed, float>);
BENCHMARK(twin<Method::packed, Float16>);
BENCHMARK(twin<Method::spectral, double>);
BENCHMARK(twin<Method::spectral, float>);
BENCHMARK(twin<Method::spectral, Float16>);

} // namespace
} // namespace metamer
