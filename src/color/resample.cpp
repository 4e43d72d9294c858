#include "color/resample.h"

#include <algorithm>
#include <cmath>

namespace metamer {

namespace {

// The curve with the grid's wavelengths (continued beyond its ends) inserted wherever two samples are further
// apart than a step.
Curve cut_at_grid(const Curve& curve, const Grid& grid) {
    Curve cut;
    const auto push = [&](double w, double v) {
        cut.wavelength_nm.push_back(w);
        cut.value.push_back(v);
    };
    for (std::size_t k = 0; k < curve.wavelength_nm.size(); ++k) {
        const double w0 = curve.wavelength_nm[k], v0 = curve.value[k];
        push(w0, v0);
        if (k + 1 == curve.wavelength_nm.size())
            break;
        const double w1 = curve.wavelength_nm[k + 1], v1 = curve.value[k + 1];
        if (w1 - w0 <= grid.step_nm)
            continue;
        const double first = std::floor((w0 - grid.first_nm) / grid.step_nm) + 1;
        for (double n = first; grid.first_nm + n * grid.step_nm < w1; ++n) {
            const double w = grid.first_nm + n * grid.step_nm;
            push(w, v0 + (v1 - v0) * (w - w0) / (w1 - w0));
        }
    }
    return cut;
}

double interval_nm(const Curve& curve, std::size_t k) {
    const auto& w = curve.wavelength_nm;
    if (w.size() < 2)
        return 0;
    const double left = k > 0 ? w[k] - w[k - 1] : w[1] - w[0];
    const double right = k + 1 < w.size() ? w[k + 1] - w[k] : w[k] - w[k - 1];
    return 0.5 * (left + right);
}

// Adds an energy to the two grid wavelengths beside it.
void share(std::vector<double>& energy, const Grid& grid, double wavelength_nm, double amount) {
    const double at = (wavelength_nm - grid.first_nm) / grid.step_nm;
    const double below = std::floor(at), t = at - below;
    const auto add = [&](double index, double part) {
        if (index >= 0 && index < static_cast<double>(grid.count))
            energy[static_cast<std::size_t>(index)] += part;
    };
    add(below, (1 - t) * amount);
    if (t > 0)
        add(below + 1, t * amount);
}

} // namespace

std::vector<double> resample(const LampSpectrum& lamp, const Grid& grid) {
    std::vector<double> energy(grid.count, 0.0);
    const Curve cut = cut_at_grid(lamp.continuum, grid);
    for (std::size_t k = 0; k < cut.wavelength_nm.size(); ++k)
        share(energy, grid, cut.wavelength_nm[k], cut.value[k] * interval_nm(cut, k));
    for (const EmissionLine& line : lamp.lines)
        share(energy, grid, line.wavelength_nm, line.power);
    for (double& e : energy)
        e /= grid.step_nm;
    return energy;
}

std::vector<double> resample(const MaterialSpectrum& material, const Grid& grid) {
    const Curve cut = cut_at_grid(material.curve, grid);
    std::vector<double> sum(grid.count, 0.0), weight(grid.count, 0.0), mean(grid.count);
    for (std::size_t k = 0; k < cut.wavelength_nm.size(); ++k) {
        const double dw = interval_nm(cut, k);
        share(sum, grid, cut.wavelength_nm[k], cut.value[k] * dw);
        share(weight, grid, cut.wavelength_nm[k], dw);
    }
    for (std::size_t i = 0; i < grid.count; ++i) {
        const double w = grid.wavelength_nm(i);
        const bool inside =
            w >= material.curve.wavelength_nm.front() && w <= material.curve.wavelength_nm.back();
        mean[i] = inside && weight[i] > 0 ? sum[i] / weight[i] : value_at_held(material.curve, w);
    }
    return mean;
}

double lost_share(const LampSpectrum& lamp, const Grid& grid) {
    double all = 0, kept = 0;
    const Curve cut = cut_at_grid(lamp.continuum, grid);
    for (std::size_t k = 0; k < cut.wavelength_nm.size(); ++k)
        all += cut.value[k] * interval_nm(cut, k);
    for (const EmissionLine& line : lamp.lines)
        all += line.power;
    for (double power_per_nm : resample(lamp, grid))
        kept += power_per_nm * grid.step_nm;
    return all > 0 ? std::max(0.0, 1 - kept / all) : 0;
}

SampledLamp sample_lamp(const LampSpectrum& lamp) {
    const std::vector<double> power = resample(lamp, kThesisGrid);
    SampledLamp sampled{{}, *std::max_element(power.begin(), power.end())};
    if (sampled.peak > 0)
        std::transform(power.begin(), power.end(), sampled.emission.value.begin(),
                       [&](double p) { return p / sampled.peak; });
    return sampled;
}

Reflectance sample_material(const MaterialSpectrum& material) {
    const std::vector<double> mean = resample(material, kThesisGrid);
    Reflectance sampled;
    std::transform(mean.begin(), mean.end(), sampled.value.begin(),
                   [](double r) { return std::clamp(r, 0.0, 1.0); });
    return sampled;
}

} // namespace metamer
