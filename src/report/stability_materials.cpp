// What reflects: bands in reflectances, and next to no reflectance.
#include <numbers>

#include "report/stability_groups.h"
#include "report/stability_kit.h"
#include "spectra/gaussian.h"
#include "spectra/library.h"

namespace metamer {

namespace {

constexpr double kFirst_nm = 400, kLast_nm = 700;

MaterialSpectrum by_formula(const auto& value) {
    Curve curve;
    for (double nm = 360; nm <= 830; nm += 0.5) {
        curve.wavelength_nm.push_back(nm);
        curve.value.push_back(std::clamp(value(nm), 0.0, 1.0));
    }
    return {curve};
}

struct LampWithTaps {
    LampForms forms;
    Taps taps;
};

// Daylight, and two lamps whose lines sit on whatever the bands do.
std::vector<LampWithTaps> day_and_lines() {
    std::vector<LampWithTaps> out;
    for (const char* name : {"D65", "F11", "krypton"}) {
        LampForms forms = lamp_forms(name);
        Taps taps = lamp_taps(forms, 8);
        out.push_back({std::move(forms), std::move(taps)});
    }
    return out;
}

void measure_bands(ExperimentPoint& point, const std::vector<LampWithTaps>& lamps,
                   const MaterialSpectrum& spectrum) {
    const std::vector<MaterialForms> weighted{material_forms(spectrum)},
        thesis{material_forms(spectrum, Quantization::thesis)};
    for (const LampWithTaps& lamp : lamps) {
        const auto with = [&](Method method) { return worst<float>(method, lamp.forms, weighted, sight()); };
        raise(point, "tristimulus", with(Method::tristimulus));
        raise(point, "spectral", with(Method::spectral));
        raise(point, "spectral, thesis's rows", worst<float>(Method::spectral, lamp.forms, thesis, sight()));
        raise(point, "reduced", worst<float>(Method::reduced, lamp.forms, weighted, sight(lamp.taps)));
        raise(point, "folded", with(Method::folded));
    }
}

void explain_bands(Experiment& e, Harder harder) {
    add_failure(e, "tristimulus", harder, "three numbers know no bands");
    add_failure(e, "spectral, thesis's rows", harder,
                "reflectances are averaged over 10 nm, a line sees one wavelength");
    add_failure(e, "spectral", harder, "a row of 5 nm intervals cannot follow such bands");
    add_failure(e, "reduced", harder, "8 wavelengths, chosen for any material, miss bands between them");
}

} // namespace

Experiment band_count() {
    Experiment e{.name = "Bands of a reflectance",
                 .swept = "bands between 400 and 700 nm, D65, F11, krypton",
                 .unit = ""};
    const auto lamps = day_and_lines();
    for (const double bands : logarithmically(0.5, 64, 22)) {
        ExperimentPoint& point = e.points.emplace_back(ExperimentPoint{bands});
        for (const double phase : {0.0, 0.25, 0.5})
            measure_bands(point, lamps, by_formula([&](double nm) {
                              const double turn = bands * (nm - kFirst_nm) / (kLast_nm - kFirst_nm) + phase;
                              return 0.5 + 0.45 * std::cos(2 * std::numbers::pi * turn);
                          }));
    }
    explain_bands(e, Harder::up);
    e.finding =
        finding(e, "reduced", "8 wavelengths for any material hold up to", "8 wavelengths hold all bands") +
        finding(e, "spectral", " bands, 64 up to", " bands, 64 hold");
    e.guard = "folded sums at 1 nm; where a loop must be, the planner fits reduced to the scene's own "
              "materials";
    return e;
}

Experiment band_spacing() {
    Experiment e{.name = "Spacing of two bands",
                 .swept = "from band to band, each half as wide, around 545 nm, D65, F11, krypton",
                 .unit = "nm"};
    const auto lamps = day_and_lines();
    for (const double spacing_nm : logarithmically(1, 200, 22)) {
        ExperimentPoint& point = e.points.emplace_back(ExperimentPoint{spacing_nm});
        measure_bands(point, lamps, by_formula([&](double nm) {
                          return gaussian_at(nm, 545 - spacing_nm / 2, spacing_nm / 2) +
                                 gaussian_at(nm, 545 + spacing_nm / 2, spacing_nm / 2);
                      }));
    }
    explain_bands(e, Harder::down);
    e.finding = finding(e, "spectral", "64 wavelengths fail for bands closer than", "64 wavelengths hold") +
                finding(e, "reduced", ", 8 of them than", ", 8 of them too");
    e.guard = "folded sums at 1 nm, and so does whatever the planner holds a method against: what fails is "
              "not chosen";
    return e;
}

Experiment dark_materials() {
    Experiment e{.name = "Dark materials",
                 .swept = "share of the patches' reflectance, D65, F11, krypton",
                 .unit = ""};
    const auto lamps = day_and_lines();
    for (const double share : logarithmically(0.001, 1, 10)) {
        ExperimentPoint& point = e.points.emplace_back(ExperimentPoint{share});
        for (const Material& patch : patch_materials()) {
            MaterialSpectrum dark = patch.spectrum;
            for (double& v : dark.curve.value)
                v *= share;
            const std::vector<MaterialForms> weighted{material_forms(dark)};
            const std::vector<MaterialForms> unscaled{
                {{rounded(weighted.front().row.value)}, weighted.front().full}};
            for (const LampWithTaps& lamp : lamps) {
                raise(point, "tristimulus", worst<float>(Method::tristimulus, lamp.forms, weighted, sight()));
                raise(point, "spectral", worst<float>(Method::spectral, lamp.forms, weighted, sight()));
                raise(point, "spectral in fp16",
                      worst<Float16>(Method::spectral, lamp.forms, weighted, sight()));
                raise(point, "spectral, rows not scaled",
                      worst<float>(Method::spectral, lamp.forms, unscaled, sight()));
            }
        }
    }
    add_failure(e, "spectral, rows not scaled", Harder::down,
                "a dark material has only a few of the 255 levels");
    add_failure(e, "spectral", Harder::down, "its levels are too coarse");
    add_failure(e, "spectral in fp16", Harder::down, "small terms are lost beside the sum");
    add_failure(e, "tristimulus", Harder::up,
                "three numbers; in the dark their error shrinks as all color does");
    e.finding = finding(e, "spectral, rows not scaled", "8-bit rows without scales fail from a share of",
                        "8-bit rows hold without scales") +
                finding(e, "spectral", " down; with scales from", " down; with scales they hold");
    e.guard = "rows are stored at full scale, their scale apart";
    return e;
}

} // namespace metamer
