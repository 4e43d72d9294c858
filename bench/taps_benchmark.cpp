// Choosing and weighting wavelengths: what a visitor's change of lamp costs.
#include <benchmark/benchmark.h>

#include <cmath>

#include "color/resample.h"
#include "methods/taps.h"
#include "spectra/library.h"

namespace metamer {
namespace {

// 64 thicknesses of cobalt glass under `lamps` lamps.
void choose(benchmark::State& state) {
    constexpr std::array kLamps{"A", "F11", "krypton", "D65", "F2", "white-LED", "NIST-LPS", "moonlight"};
    const auto count = static_cast<std::size_t>(state.range(0));
    std::vector<ReferenceLamp> lamps;
    for (std::size_t i = 0; i < count; ++i)
        lamps.push_back(reference_lamp(find_lamp(kLamps[i]).spectrum));
    std::vector<const ReferenceLamp*> views;
    for (const ReferenceLamp& lamp : lamps)
        views.push_back(&lamp);
    const std::vector<double> medium = resample(find_material("glass-cobalt").spectrum, kReferenceGrid);
    std::vector<std::vector<double>> own;
    for (int k = 0; k < 64; ++k) {
        own.emplace_back();
        for (const double t : medium)
            own.back().push_back(std::pow(t, 3.0 * k / 63));
    }
    for (auto _ : state)
        benchmark::DoNotOptimize(choose_taps(views, own, static_cast<int>(state.range(1))));
}
BENCHMARK(choose)
    ->Name("taps/lamps/count")
    ->ArgsProduct({{1, 3, 8}, {4, 8, 16, 32}})
    ->Unit(benchmark::kMillisecond);

} // namespace
} // namespace metamer
