#include "report/stability_kit.h"

#include "atlas/atlas.h"
#include "atlas/row_levels.h"
#include "color/resample.h"
#include "color/working_space.h"
#include "methods/three_numbers.h"
#include "report/number_text.h"

namespace metamer {

namespace {

struct Observers {
    GridObserver seen, exact;
};

const Observers& observers(Quantization quantization) {
    const auto made = [](Quantization q) {
        const Atlas atlas = empty_atlas(q);
        return Observers{observer(atlas), exact_observer(atlas)};
    };
    static const Observers thesis = made(Quantization::thesis), weighted = made(Quantization::weighted);
    return quantization == Quantization::thesis ? thesis : weighted;
}

} // namespace

LampForms lamp_forms(const LampSpectrum& lamp, Quantization quantization) {
    ReferenceLamp full = reference_lamp(lamp);
    if (quantization == Quantization::thesis)
        return {{rounded(sample_lamp(lamp).emission.value)}, std::move(full)};
    return {{row_values(lamp_levels(lamp_power(lamp)).level)}, std::move(full)};
}

LampForms lamp_forms(const std::string& name) {
    return lamp_forms(find_lamp(name).spectrum);
}

MaterialForms material_forms(const MaterialSpectrum& material, Quantization quantization) {
    std::vector<double> full = resample(material, kReferenceGrid);
    if (quantization == Quantization::thesis)
        return {{rounded(sample_material(material).value)}, std::move(full)};
    const MaterialLevels levels = material_levels(material);
    return {{row_values(levels.level, levels.scale)}, std::move(full)};
}

Taps lamp_taps(const LampForms& lamp, int count, std::span<const std::vector<double>> own) {
    const ReferenceLamp* full = &lamp.full;
    return choose_taps({&full, 1}, own, count);
}

std::array<double, kIntervals> rounded(std::array<double, kIntervals> values, int levels) {
    for (double& v : values)
        v = std::floor(v * levels + 0.5) / levels;
    return values;
}

const std::vector<Material>& patch_materials() {
    static const std::vector<Material> found = [] {
        std::vector<Material> out;
        for (const std::string& name : find_material_set("colorchecker")->materials)
            out.push_back(find_material(name));
        return out;
    }();
    return found;
}

const std::vector<MaterialForms>& patches(Quantization quantization) {
    const auto made = [](Quantization q) {
        std::vector<MaterialForms> out;
        for (const Material& material : patch_materials())
            out.push_back(material_forms(material.spectrum, q));
        return out;
    };
    static const auto thesis = made(Quantization::thesis), weighted = made(Quantization::weighted);
    return quantization == Quantization::thesis ? thesis : weighted;
}

LampSpectrum line_lamp(double wavelength_nm) {
    return {{}, {{wavelength_nm, 1}}};
}

std::span<const std::string> line_lamps() {
    static const std::vector<std::string> names{"krypton", "F11", "NIST-LPS"};
    return names;
}

Pixel pair(const LampForms& lamp, const MaterialForms& material) {
    Pixel pixel;
    pixel.lamps = {{&lamp.row, &lamp.full, 1, {}}};
    pixel.material = {&material.row, &material.full};
    return pixel;
}

Sight sight(Quantization quantization) {
    const WorkingSpace& space = working_spaces()[0];
    const Observers& both = observers(quantization);
    Sight out{&both.seen, &both.exact, {}};
    out.output.rgb_from_xyz = rgb_from_xyz(space);
    out.output.white = &white_emission(space);
    return out;
}

Sight sight(const Taps& taps) {
    Sight out = sight();
    out.taps = &taps;
    return out;
}

template <Scalar T>
double difference(Method method, const Pixel& pixel, const Sight& sight) {
    const Xyz c = shade_xyz<T>(method, pixel, sight);
    return delta_e_2000({as_shown(c.x), as_shown(c.y), as_shown(c.z)}, exact_xyz(pixel, *sight.exact));
}

template <Scalar T>
double worst(Method method, const LampForms& lamp, std::span<const MaterialForms> materials,
             const Sight& sight) {
    double most = 0;
    for (const MaterialForms& material : materials)
        most = std::max(most, difference<T>(method, pair(lamp, material), sight));
    return most;
}

#define METAMER_DIFFERENCES(T)                                                                               \
    template double difference<T>(Method, const Pixel&, const Sight&);                                       \
    template double worst<T>(Method, const LampForms&, std::span<const MaterialForms>, const Sight&);
METAMER_DIFFERENCES(double)
METAMER_DIFFERENCES(float)
METAMER_DIFFERENCES(Float16)
#undef METAMER_DIFFERENCES

std::vector<double> evenly(double low, double high, int count) {
    std::vector<double> out;
    for (int i = 0; i < count; ++i)
        out.push_back(low + (high - low) * i / (count - 1));
    return out;
}

std::vector<double> logarithmically(double low, double high, int count) {
    std::vector<double> out;
    for (const double v : evenly(std::log10(low), std::log10(high), count))
        out.push_back(std::pow(10, v));
    return out;
}

std::optional<double> failure_at(const Experiment& experiment, const std::string& method, Harder harder) {
    std::vector<const ExperimentPoint*> way;
    for (const ExperimentPoint& point : experiment.points)
        if (point.delta_e.contains(method))
            way.push_back(&point);
    if (harder == Harder::down)
        std::reverse(way.begin(), way.end());
    const auto fails = [&](const ExperimentPoint* p) { return !(p->delta_e.at(method) <= kFailsAbove); };
    const auto first = std::find_if(way.begin(), way.end(), fails);
    if (first == way.end())
        return {};
    if (first == way.begin() || experiment.discrete)
        return (*first)->x;
    const ExperimentPoint &before = **(first - 1), &after = **first;
    const double low = before.delta_e.at(method), high = after.delta_e.at(method);
    // As the plot draws it: straight on its axes; from 0 a logarithm has no straight line.
    const double share = low > 0 ? std::log(kFailsAbove / low) / std::log(high / low) : kFailsAbove / high;
    if (!experiment.log_x)
        return std::lerp(before.x, after.x, share);
    return std::exp(std::lerp(std::log(before.x), std::log(after.x), share));
}

void add_failure(Experiment& experiment, const std::string& method, Harder harder, const std::string& why) {
    if (const auto at = failure_at(experiment, method, harder))
        experiment.fails.push_back({method, *at, why});
}

std::string finding(const Experiment& experiment, const std::string& method, const std::string& what,
                    const std::string& otherwise) {
    for (const Failure& fail : experiment.fails)
        if (fail.method == method)
            return what + (what.empty() ? "" : " ") + short_number(fail.at, experiment.discrete ? 4 : 3) +
                   (experiment.unit.empty() ? "" : " " + experiment.unit);
    return otherwise;
}

} // namespace metamer
