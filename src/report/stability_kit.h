// What the experiments share: lamps and materials as methods know them, sweeps, differences, failures.
// Private to this room.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "atlas/quantization.h"
#include "color/difference.h"
#include "methods/shade.h"
#include "report/experiment.h"
#include "report/stability.h"
#include "spectra/library.h"

namespace metamer {

/// A lamp as a row of an atlas and at 1 nm; a material likewise.
struct LampForms {
    Emission row;
    ReferenceLamp full;
};
struct MaterialForms {
    Reflectance row;
    std::vector<double> full;
};

/// `weighted`: as add_lamp() and add_material() make rows; `thesis`: samples rounded one by one, whatever
/// becomes of k'. The lamp must be seen.
LampForms lamp_forms(const LampSpectrum& lamp, Quantization quantization = Quantization::weighted);
/// Of a lamp of the library, weighted.
LampForms lamp_forms(const std::string& name);
MaterialForms material_forms(const MaterialSpectrum& material,
                             Quantization quantization = Quantization::weighted);

/// The taps of one lamp, for light such as `own`, each on kReferenceGrid; empty: for any material.
Taps lamp_taps(const LampForms& lamp, int count, std::span<const std::vector<double>> own = {});

/// Values to the nearest of `levels` steps from 0 to 1, half up.
std::array<double, kIntervals> rounded(std::array<double, kIntervals> values, int levels = 255);

/// The 24 patches of the ColorChecker, and which materials they are.
const std::vector<Material>& patch_materials();
const std::vector<MaterialForms>& patches(Quantization quantization = Quantization::weighted);

LampSpectrum line_lamp(double wavelength_nm);

/// Lamps of the library that have lines, on which coarse grids do worst.
std::span<const std::string> line_lamps();

Pixel pair(const LampForms& lamp, const MaterialForms& material);

/// Both observers of such an atlas; sRGB-D65, no adaptation.
Sight sight(Quantization quantization = Quantization::weighted);
/// Weighted, with taps for method `reduced`, which must outlive it.
Sight sight(const Taps& taps);

/// CIEDE2000 of a method's color in precision T against exact_xyz(). Components as_shown().
template <Scalar T>
double difference(Method method, const Pixel& pixel, const Sight& sight);

/// The greatest over materials.
template <Scalar T>
double worst(Method method, const LampForms& lamp, std::span<const MaterialForms> materials,
             const Sight& sight);

/// A component as a framebuffer takes it: what is no number counts as 0, and nothing is beyond kMostLight.
inline double as_shown(double component) {
    return std::isnan(component) ? 0 : std::clamp(component, -kMostLight, kMostLight);
}

/// A method may be measured several times at one x: the worst counts, and what is no number is the worst.
inline void raise(ExperimentPoint& point, const std::string& method, double delta_e) {
    double& most = point.delta_e.try_emplace(method, 0).first->second;
    most = std::isnan(delta_e) ? HUGE_VAL : std::max(most, delta_e);
}

/// `count` values from low to high, evenly spaced, or evenly on a logarithm.
std::vector<double> evenly(double low, double high, int count);
std::vector<double> logarithmically(double low, double high, int count);

/// In which direction of x an experiment asks more of methods.
enum class Harder { up, down };

/// Where a method's curve first exceeds kFailsAbove on its way to the harder end, between two points on the
/// straight line of the plot, or at the first of them where x is discrete; the easy end itself if it fails
/// there already. None if it never does.
std::optional<double> failure_at(const Experiment& experiment, const std::string& method, Harder harder);

/// Adds that failure, if there is one, with its cause.
void add_failure(Experiment& experiment, const std::string& method, Harder harder, const std::string& why);

/// `WHAT 4.1 nm` for the failure of a method, or `otherwise` where it has none.
std::string finding(const Experiment& experiment, const std::string& method, const std::string& what,
                    const std::string& otherwise);

} // namespace metamer
