// Making an atlas, and solving for the smoothest reflectances of the crayons.
#include <benchmark/benchmark.h>

#include <memory>

#include "atlas/atlas_file.h"
#include "spectra/library.h"
#include "spectra/sets.h"

namespace metamer {
namespace {

// Every lamp of the library and one set, quantized and encoded as PNG. The library itself stands by then.
void atlas_build(benchmark::State& state) {
    const std::vector<Material> materials = colorchecker_materials();
    benchmark::DoNotOptimize(library_lamps().size());
    for (auto _ : state) {
        Atlas atlas = empty_atlas();
        for (const Lamp& lamp : library_lamps())
            add_lamp(atlas, lamp);
        for (const Material& material : materials)
            add_material(atlas, material);
        benchmark::DoNotOptimize(encode_atlas(atlas));
    }
}
BENCHMARK(atlas_build)->Unit(benchmark::kMillisecond);

// One row each, the levels chosen together: what a visitor's change of lamp costs.
void atlas_lamp_row(benchmark::State& state) {
    const Lamp lamp = find_lamp("F11");
    const Atlas empty = empty_atlas();
    for (auto _ : state) {
        Atlas atlas = empty;
        benchmark::DoNotOptimize(add_lamp(atlas, lamp));
    }
}
BENCHMARK(atlas_lamp_row)->Unit(benchmark::kMicrosecond);

void atlas_material_row(benchmark::State& state) {
    const Material material = find_material("cc-orange");
    const Atlas empty = empty_atlas();
    add_material(*std::make_unique<Atlas>(empty), material); // the prior stands by then
    for (auto _ : state) {
        Atlas atlas = empty;
        benchmark::DoNotOptimize(add_material(atlas, material));
    }
}
BENCHMARK(atlas_material_row)->Unit(benchmark::kMicrosecond);

void lhtss_of_fifteen_crayons(benchmark::State& state) {
    for (auto _ : state)
        benchmark::DoNotOptimize(crayon_materials());
}
BENCHMARK(lhtss_of_fifteen_crayons)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace metamer
