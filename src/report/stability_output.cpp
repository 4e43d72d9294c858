// On the way to the screen: matrices, the white of CIELAB, colors that the screen cannot show.
#include <numbers>

#include "color/gamut.h"
#include "color/working_space.h"
#include "report/number_text.h"
#include "report/stability_groups.h"
#include "report/stability_kit.h"
#include "spectra/gaussian.h"
#include "spectra/library.h"

namespace metamer {

namespace {

double frobenius(const Matrix3& a) {
    double sum = 0;
    for (const auto& row : a.m)
        for (const double v : row)
            sum += v * v;
    return std::sqrt(sum);
}

// Through the matrix in T, and back without loss.
template <Scalar T>
double there_and_back(const Matrix3& xyz_from_rgb, const Matrix3& rgb_from_xyz, const Xyz& c) {
    const auto t = [](double v) { return static_cast<T>(v); };
    const BasicLinearRgb<T> rgb = to_linear_rgb(rgb_from_xyz, BasicXyz<T>{t(c.x), t(c.y), t(c.z)});
    // What is infinite or no number, as black: bounds would hide what the matrix itself does.
    const auto shown = [](T v) { return std::isfinite(static_cast<double>(v)) ? static_cast<double>(v) : 0; };
    const Xyz back = to_xyz(xyz_from_rgb, {shown(rgb.r), shown(rgb.g), shown(rgb.b)});
    return delta_e_2000(back, c);
}

// sRGB whose primaries have been moved level towards the upright through its white, `distance` of the way
// left.
std::optional<Matrix3> squeezed(double distance) {
    WorkingSpace space = working_spaces()[0];
    for (Chromaticity* primary : {&space.red, &space.green, &space.blue})
        primary->x = std::lerp(space.white.x, primary->x, distance);
    return xyz_from_rgb(space);
}

double hue_turn_deg(const Lab& a, const Lab& b) {
    const double turn = (std::atan2(a.b, a.a) - std::atan2(b.b, b.a)) * 180 / std::numbers::pi;
    return std::abs(std::remainder(turn, 360));
}

// One lamp over the patches, as bright as the display's greatest channel bears.
ExperimentPoint outside_under(const Lamp& lamp) {
    const Matrix3 matrix = rgb_from_xyz(working_spaces()[0]), back = inverse(matrix).value();
    const ReferenceLamp full = reference_lamp(lamp.spectrum);
    const LinearRgb white = to_linear_rgb(matrix, reference_white(lamp.spectrum));
    const double peak = std::max({white.r, white.g, white.b});
    ExperimentPoint point{.x = 0, .delta_e = {{"clip", 0}, {"keep-hue", 0}}, .name = lamp.name};
    double count = 0, turns[2] = {0, 0};
    for (const MaterialForms& patch : patches()) {
        const Xyz exact = (1 / peak) * reference_xyz(full, patch.full);
        const LinearRgb c = to_linear_rgb(matrix, exact);
        if (in_gamut(c))
            continue;
        ++count;
        const LinearRgb clip{std::clamp(c.r, 0.0, 1.0), std::clamp(c.g, 0.0, 1.0), std::clamp(c.b, 0.0, 1.0)};
        const Xyz shown[2] = {to_xyz(back, clip), to_xyz(back, kept_hue(c))};
        point.delta_e["clip"] += delta_e_2000(shown[0], exact);
        point.delta_e["keep-hue"] += delta_e_2000(shown[1], exact);
        for (int i = 0; i < 2; ++i)
            turns[i] += hue_turn_deg(lab(shown[i], display_white()), lab(exact, display_white()));
    }
    for (auto& [method, sum] : point.delta_e)
        sum /= std::max(count, 1.0);
    point.also = {{"outside", count},
                  {"materials", static_cast<double>(patches().size())},
                  {"hue_turn_deg_clip", turns[0] / std::max(count, 1.0)},
                  {"hue_turn_deg_keep_hue", turns[1] / std::max(count, 1.0)}};
    return point;
}

double greatest(const Experiment& e, const std::string& method) {
    double most = 0;
    for (const ExperimentPoint& point : e.points)
        most = std::max(most, point.delta_e.at(method));
    return most;
}

std::string outside_text(const ExperimentPoint& point) {
    return point.name + " puts " + short_number(point.also.at("outside")) + " of " +
           short_number(point.also.at("materials"));
}

} // namespace

Experiment matrix_condition() {
    Experiment e{.name = "Near-singular matrices",
                 .swept = "condition number (Frobenius) of sRGB as its primaries close in on a line",
                 .unit = ""};
    const LampForms lamp = lamp_forms("D65");
    for (const double distance : logarithmically(1, 1e-12, 49)) {
        const auto forward = squeezed(distance);
        const auto back = forward ? inverse(*forward) : std::nullopt;
        if (!back)
            break;
        ExperimentPoint& point =
            e.points.emplace_back(ExperimentPoint{frobenius(*forward) * frobenius(*back)});
        for (const MaterialForms& patch : patches()) {
            const Xyz c = reference_xyz(lamp.full, patch.full);
            raise(point, "matrix in fp16", there_and_back<Float16>(*forward, *back, c));
            raise(point, "matrix in fp32", there_and_back<float>(*forward, *back, c));
            raise(point, "matrix in double", there_and_back<double>(*forward, *back, c));
        }
    }
    const std::string why = "RGB is a small difference of numbers as large as the condition";
    for (const char* precision : {"matrix in fp16", "matrix in fp32", "matrix in double"})
        add_failure(e, precision, Harder::up, why);
    e.finding = finding(e, "matrix in fp16", "Matrices fail in fp16 from condition", "Half precision holds") +
                finding(e, "matrix in fp32", ", in fp32 from", "");
    e.guard = "primaries that lie on a line to a billionth are refused by name, here above condition " +
              short_number(e.points.back().x, 2);
    return e;
}

Experiment lightness_white() {
    constexpr double kInvisible = 0.001;
    Experiment e{.name = "The white of CIELAB",
                 .swept = "full width at half maximum of a lamp at 589 nm; Z of the patches raised by 0.001",
                 .unit = "nm"};
    for (const double fwhm_nm : logarithmically(kNarrowest_nm, 300, 29)) {
        const LampSpectrum spectrum{gaussian(589, std::clamp(fwhm_nm, kNarrowest_nm, 300.0)), {}};
        const ReferenceLamp lamp = reference_lamp(spectrum);
        const Xyz lamp_white = reference_white(spectrum);
        ExperimentPoint& point = e.points.emplace_back(ExperimentPoint{fwhm_nm});
        for (const MaterialForms& patch : patches()) {
            const Xyz c = reference_xyz(lamp, patch.full), raised{c.x, c.y, c.z + kInvisible};
            raise(point, "the lamp's white", delta_e_2000(lab(c, lamp_white), lab(raised, lamp_white)));
            raise(point, "the display's white", delta_e_2000(c, raised));
        }
    }
    add_failure(e, "the lamp's white", Harder::down,
                "Z is divided by that of a lamp that has none: nothing becomes everything");
    add_failure(e, "the display's white", Harder::down, "dark colors are counted as the brightest are");
    e.finding = "An unseen Z of 0.001 counts " + short_number(greatest(e, "the lamp's white")) +
                " by the lamp's white, " + short_number(greatest(e, "the display's white")) +
                " by the display's";
    e.guard =
        "every figure is taken against the display's white; adaptation to a lamp without blue is refused";
    return e;
}

Experiment outside_gamut() {
    Experiment e{.name = "Colors outside the working space",
                 .swept = "lamps of the library, by how many of 24 patches they put outside sRGB",
                 .log_x = false,
                 .discrete = true};
    for (const Lamp& lamp : library_lamps())
        e.points.push_back(outside_under(lamp));
    const auto order = [](const ExperimentPoint& p) {
        return std::pair(p.also.at("outside"), p.delta_e.at("clip"));
    };
    std::stable_sort(e.points.begin(), e.points.end(),
                     [&](const ExperimentPoint& a, const ExperimentPoint& b) { return order(a) < order(b); });
    for (std::size_t i = 0; i < e.points.size(); ++i)
        e.points[i].x = static_cast<double>(i + 1);
    add_failure(e, "clip", Harder::up, "channels below 0 are cut one by one, which turns hues");
    add_failure(e, "keep-hue", Harder::up, "to keep the hue, chroma is given up");
    e.finding = outside_text(e.points.front()) + " patches outside sRGB, " + outside_text(e.points.back());
    e.guard = "gamut = clip | keep-hue: the exhibit decides between brighter color and the right hue";
    return e;
}

} // namespace metamer
