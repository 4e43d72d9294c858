// The reference at full resolution: double precision, 1 nm, 20 lamps x 40 materials of the library.
#include <benchmark/benchmark.h>
#include <vector>

#include "color/colorimetry.h"
#include "color/resample.h"
#include "spectra/library.h"

namespace metamer {
namespace {

constexpr std::size_t kLamps = 20, kMaterials = 40;

// Spread over the whole library: smooth spectra and lines, measured materials and computed ones.
template <class Thing>
std::vector<Thing> spread(std::span<const Thing> all, std::size_t count) {
    std::vector<Thing> out;
    for (std::size_t i = 0; i < count; ++i)
        out.push_back(all[i * all.size() / count]);
    return out;
}

void report(benchmark::State& state) {
    state.counters["pairs"] = kLamps * kMaterials;
    state.counters["pairs_per_s"] =
        benchmark::Counter(kLamps * kMaterials, benchmark::Counter::kIsIterationInvariantRate);
}

// Each pair from its two spectra, as `measure` takes one.
void reference_pair_by_pair(benchmark::State& state) {
    const auto lamps = spread(library_lamps(), kLamps);
    const auto materials = spread(library_materials(), kMaterials);
    for (auto _ : state)
        for (const Lamp& lamp : lamps)
            for (const Material& material : materials)
                benchmark::DoNotOptimize(reference_xyz(lamp.spectrum, material.spectrum));
    report(state);
}
BENCHMARK(reference_pair_by_pair)->Unit(benchmark::kMillisecond);

// Every spectrum resampled once, as a table of pairs is made.
void reference_table(benchmark::State& state) {
    const auto lamps = spread(library_lamps(), kLamps);
    const auto materials = spread(library_materials(), kMaterials);
    for (auto _ : state) {
        std::vector<std::vector<double>> reflectances;
        for (const Material& material : materials)
            reflectances.push_back(resample(material.spectrum, kReferenceGrid));
        for (const Lamp& lamp : lamps) {
            const ReferenceLamp prepared = reference_lamp(lamp.spectrum);
            for (const auto& reflectance : reflectances)
                benchmark::DoNotOptimize(reference_xyz(prepared, reflectance));
        }
    }
    report(state);
}
BENCHMARK(reference_table)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace metamer
