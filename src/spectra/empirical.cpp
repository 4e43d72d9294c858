#include "spectra/gaussian.h"
#include "spectra/sets.h"

namespace metamer {

namespace {

struct Band {
    double center_nm, fwhm_nm, height; // a dip has a height below 0
};

struct Sample {
    double base;
    std::vector<Band> bands;
};

// Made up by hand: bands as narrow as those of rare-earth glasses (10-20 nm), as dyes' (40-80 nm) and as
// pigments' (100 nm and more), at places that line lamps hit and miss.
const std::vector<Sample>& samples() {
    static const std::vector<Sample> table{
        {0.10, {{450, 40, 0.55}, {540, 35, 0.50}, {620, 45, 0.60}}},
        {0.80, {{430, 30, -0.45}, {520, 40, -0.55}, {590, 25, -0.60}, {670, 35, -0.40}}},
        {0.15, {{420, 50, 0.45}, {500, 30, 0.35}, {580, 20, 0.55}, {660, 60, 0.65}}},
        {0.70, {{475, 18, -0.40}, {527, 14, -0.50}, {585, 16, -0.62}, {685, 20, -0.45}}},
        {0.20, {{435, 16, 0.60}, {545, 16, 0.60}, {612, 16, 0.60}}},
        {0.75, {{436, 16, -0.60}, {546, 16, -0.60}, {611, 16, -0.60}}},
        {0.12, {{470, 80, 0.40}, {550, 30, 0.25}, {690, 90, 0.70}}},
        {0.30, {{410, 60, 0.40}, {495, 40, -0.20}, {560, 50, 0.35}, {625, 30, -0.22}, {680, 50, 0.40}}},
        {0.05, {{520, 60, 0.50}, {600, 30, 0.30}, {700, 100, 0.80}}},
        {0.55, {{400, 40, -0.40}, {460, 50, 0.30}, {560, 90, -0.45}, {650, 40, 0.25}}},
        {0.08, {{440, 25, 0.30}, {480, 25, 0.40}, {520, 25, 0.50}, {570, 25, 0.60}, {630, 25, 0.70}}},
        {0.85, {{589, 12, -0.75}, {450, 60, -0.30}, {640, 30, -0.25}}},
        {0.25, {{557, 12, 0.60}, {587, 12, -0.20}, {430, 30, 0.45}, {650, 80, 0.35}}},
        {0.50,
         {{410, 30, 0.35},
          {450, 30, -0.35},
          {490, 30, 0.35},
          {530, 30, -0.35},
          {570, 30, 0.35},
          {610, 30, -0.35},
          {650, 30, 0.35}}},
        {0.06, {{405, 50, 0.35}, {530, 100, 0.22}, {640, 25, 0.45}, {700, 40, 0.60}}},
        {0.45, {{480, 70, 0.40}, {575, 40, -0.35}, {635, 50, 0.40}, {690, 25, -0.25}}},
    };
    return table;
}

MaterialSpectrum spectrum_of(const Sample& sample) {
    constexpr Grid grid{380, 5, 81};
    Curve curve;
    for (std::size_t i = 0; i < grid.count; ++i) {
        double rho = sample.base;
        for (const Band& band : sample.bands)
            rho += band.height * gaussian_at(grid.wavelength_nm(i), band.center_nm, band.fwhm_nm);
        curve.wavelength_nm.push_back(grid.wavelength_nm(i));
        curve.value.push_back(rho);
    }
    return {curve};
}

} // namespace

std::vector<Material> empirical_materials() {
    std::vector<Material> materials;
    for (const Sample& sample : samples())
        materials.push_back(
            {"empirical-" + std::to_string(materials.size() + 1),
             "constructed, not measured: " + std::to_string(sample.bands.size()) + " peaks and dips",
             "a sum of Gaussian bands", spectrum_of(sample)});
    return materials;
}

} // namespace metamer
