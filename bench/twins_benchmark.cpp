// The methods' CPU twins: one pixel of one pair, from atlas rows to code values.
#include <benchmark/benchmark.h>

#include "atlas/atlas.h"
#include "color/working_space.h"
#include "methods/pair.h"

namespace metamer {
namespace {

// Float16 is what gcc makes of it: in hardware where there is AVX512-FP16, else each operation in float.
template <Method kMethod, Scalar T>
void twin(benchmark::State& state) {
    Atlas atlas = empty_atlas();
    const Emission lamp = emission(atlas, add_lamp(atlas, find_lamp("F11")));
    const Reflectance material = reflectance(atlas, add_material(atlas, find_material("cc-orange")));
    const GridObserver seen_by = observer(atlas);
    const Emission white = emission(atlas, add_lamp(atlas, find_lamp("D65")));
    const OutputSpace output{.rgb_from_xyz = rgb_from_xyz(working_spaces()[0]), .white = &white};
    for (auto _ : state)
        benchmark::DoNotOptimize(pair_rgb8<T>(kMethod, lamp, 1, material, seen_by, output));
}
BENCHMARK(twin<Method::rgb, double>);
BENCHMARK(twin<Method::rgb, float>);
BENCHMARK(twin<Method::rgb, Float16>);
BENCHMARK(twin<Method::tristimulus, double>);
BENCHMARK(twin<Method::tristimulus, float>);
BENCHMARK(twin<Method::tristimulus, Float16>);
BENCHMARK(twin<Method::spectral, double>);
BENCHMARK(twin<Method::spectral, float>);
BENCHMARK(twin<Method::spectral, Float16>);

} // namespace
} // namespace metamer
