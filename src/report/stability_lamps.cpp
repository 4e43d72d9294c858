// Narrow light: where grids and few wavelengths fail.
#include "color/resample.h"
#include "report/stability_groups.h"
#include "report/stability_kit.h"
#include "spectra/gaussian.h"

namespace metamer {

namespace {

// The lamp read at the grid's wavelengths as the thesis reads it, without regard to what lies between.
Emission point_samples(const LampSpectrum& lamp) {
    Emission out;
    for (std::size_t i = 0; i < kIntervals; ++i)
        out.value[i] = value_at_held(lamp.continuum, kThesisGrid.wavelength_nm(i));
    const double peak = *std::max_element(out.value.begin(), out.value.end());
    for (double& v : out.value)
        v /= peak > 0 ? peak : 1;
    return {rounded(out.value)};
}

// All of a line's light in the one interval that is nearest.
Emission nearest_sample(double wavelength_nm) {
    Emission out;
    const double at = std::round((wavelength_nm - kThesisGrid.first_nm) / kThesisGrid.step_nm);
    out.value[static_cast<std::size_t>(at)] = 1;
    return out;
}

void measure_width(ExperimentPoint& point, const LampSpectrum& lamp) {
    const LampForms forms = lamp_forms(lamp);
    const LampForms points{point_samples(lamp), forms.full};
    const Taps taps = lamp_taps(forms, 8);
    const auto with = [&](Method method) { return worst<float>(method, forms, patches(), sight()); };
    raise(point, "rgb", with(Method::rgb));
    raise(point, "tristimulus", with(Method::tristimulus));
    raise(point, "spectral", with(Method::spectral));
    raise(point, "spectral, point samples",
          worst<float>(Method::spectral, points, patches(Quantization::thesis), sight(Quantization::thesis)));
    raise(point, "reduced", worst<float>(Method::reduced, forms, patches(), sight(taps)));
    raise(point, "folded", with(Method::folded));
}

// Weights of wavelengths that are evenly spaced over the visible, whatever the lamp does in between.
Taps even_taps(const ReferenceLamp& lamp, int count) {
    Taps out{{}, {{}}};
    const auto table = cie_1931_2deg();
    double k = 0;
    for (int j = 0; j < count; ++j) {
        const double nm = std::round(400 + 300 * (j + 0.5) / count);
        const auto i = static_cast<std::size_t>(nm - kReferenceGrid.first_nm);
        out.wavelength_nm.push_back(nm);
        out.weight[0].push_back(lamp.power[i] * Xyz{table[i].x, table[i].y, table[i].z});
        k += lamp.power[i] * table[i].y;
    }
    for (Xyz& weight : out.weight[0])
        weight = (k > 0 ? 1 / k : 0) * weight;
    return out;
}

} // namespace

Experiment line_width() {
    Experiment e{.name = "Width of a lamp's band",
                 .swept = "full width at half maximum of the lamp, at 451.5, 543.5 and 588.5 nm",
                 .unit = "nm"};
    for (const double fwhm_nm : logarithmically(kNarrowest_nm, 100, 25)) {
        ExperimentPoint& point = e.points.emplace_back(ExperimentPoint{fwhm_nm});
        for (const double center_nm : {451.5, 543.5, 588.5})
            measure_width(point, {gaussian(center_nm, std::clamp(fwhm_nm, kNarrowest_nm, 100.0)), {}});
    }
    const std::string product = "three numbers do not know where in the spectrum the light is";
    add_failure(e, "rgb", Harder::down, product);
    add_failure(e, "tristimulus", Harder::down, product);
    add_failure(e, "spectral, point samples", Harder::down,
                "a band narrower than the 5 nm grid slips through between two samples");
    add_failure(e, "spectral", Harder::down, "a line between two intervals is shared by both");
    add_failure(e, "reduced", Harder::down, "8 wavelengths are too few");
    e.finding = finding(e, "spectral, point samples", "Samples at points misjudge lamps narrower than",
                        "Samples at points catch every lamp");
    e.guard = "the atlas shares a lamp's energy between the intervals beside it; the planner takes folded, "
              "summed at 1 nm";
    return e;
}

Experiment line_position(const std::string& name, double from_nm, double to_nm) {
    constexpr double step_nm = 0.1;
    Experiment e{.name = name, .swept = "wavelength of a lamp of one line", .unit = "nm", .log_x = false};
    const int count = static_cast<int>(std::lround((to_nm - from_nm) / step_nm)) + 1;
    for (const double nm : evenly(from_nm, to_nm, count)) {
        const LampForms forms = lamp_forms(line_lamp(nm));
        const LampForms nearest{nearest_sample(nm), forms.full};
        const auto with = [&](Method method) { return worst<float>(method, forms, patches(), sight()); };
        ExperimentPoint& point = e.points.emplace_back(ExperimentPoint{nm});
        raise(point, "tristimulus", with(Method::tristimulus));
        raise(point, "spectral", with(Method::spectral));
        raise(point, "spectral, nearest interval",
              worst<float>(Method::spectral, nearest, patches(Quantization::thesis),
                           sight(Quantization::thesis)));
        raise(point, "folded", with(Method::folded));
    }
    add_failure(e, "tristimulus", Harder::up, "three numbers do not know where the line is");
    add_failure(e, "spectral, nearest interval", Harder::up,
                "the whole line jumps from interval to interval, 2.5 nm off at worst");
    add_failure(e, "spectral", Harder::up,
                "between two intervals the observer is not the straight line that sharing assumes");
    e.finding = finding(e, "spectral, nearest interval", "Put into the nearest interval, a line fails from",
                        "A line may be put into the nearest interval") +
                finding(e, "spectral", "; shared by two, from", "; shared by two, it holds");
    e.guard = "a line is shared by the two intervals beside it, so that its energy and its place stay";
    return e;
}

Experiment tap_counts() {
    Experiment e{.name = "Wavelengths under line lamps",
                 .swept = "wavelengths N; krypton, F11, low-pressure sodium",
                 .discrete = true};
    std::vector<LampForms> lamps;
    for (const std::string& name : line_lamps())
        lamps.push_back(lamp_forms(name));
    std::vector<std::vector<double>> own;
    for (const MaterialForms& patch : patches())
        own.push_back(patch.full);
    for (const int count : kTapCounts) {
        ExperimentPoint& point = e.points.emplace_back(ExperimentPoint{static_cast<double>(count)});
        for (const LampForms& lamp : lamps) {
            const auto measure = [&](const std::string& name, const Taps& taps) {
                raise(point, name, worst<float>(Method::reduced, lamp, patches(), sight(taps)));
            };
            measure("spectral, N evenly spaced samples", even_taps(lamp.full, count));
            measure("reduced, for any material", lamp_taps(lamp, count));
            measure("reduced", lamp_taps(lamp, count, own));
        }
    }
    add_failure(e, "spectral, N evenly spaced samples", Harder::down,
                "whether a sample meets a line is luck: more samples may do worse");
    add_failure(e, "reduced, for any material", Harder::down, "fewer wavelengths than the lamp has lines");
    add_failure(e, "reduced", Harder::down, "too few for 24 materials at once");
    e.finding = finding(e, "reduced",
                        "Chosen wavelengths fail at N =", "4 chosen wavelengths are enough for line lamps") +
                finding(e, "spectral, N evenly spaced samples", ", evenly spaced ones still at N =", "");
    e.guard = "wavelengths are chosen and weighted for the scene's own lamps; the planner raises N until "
              "the tolerance holds, or refuses";
    return e;
}

} // namespace metamer
