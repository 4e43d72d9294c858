// Too much light, and light that the eye hardly sees.
#include "color/gamut.h"
#include "color/transfer.h"
#include "color/working_space.h"
#include "report/stability_groups.h"
#include "report/stability_kit.h"

namespace metamer {

namespace {

const Matrix3& matrix() {
    static const Matrix3 m = rgb_from_xyz(working_spaces()[0]);
    return m;
}

double seen_difference(const LinearRgb& a, const LinearRgb& b) {
    static const Matrix3 back = inverse(matrix()).value();
    return delta_e_2000(to_xyz(back, a), to_xyz(back, b));
}

double clipped(double v) {
    return std::isnan(v) ? 0 : std::clamp(v, 0.0, 1.0);
}

LinearRgb clipped(const LinearRgb& c) {
    return {clipped(c.r), clipped(c.g), clipped(c.b)};
}

// The loop in half as it would be without a bound on light: what overflows stays so through the matrix.
LinearRgb unbounded_in_half(const Pixel& pixel) {
    const PixelLamp& lamp = pixel.lamps.front();
    const std::vector<LitEmission<Float16>> lit{{lamp.row, Float16(1), {}}};
    const BasicXyz<Float16> one =
        spectral<Float16>(lit, SpectralLayers<Float16>{pixel.material.row}, *sight().seen);
    const auto stronger = [&](Float16 v) {
        return static_cast<Float16>(v * static_cast<Float16>(lamp.strength));
    };
    const BasicLinearRgb<Float16> c = kept_hue(
        to_linear_rgb(matrix(), BasicXyz<Float16>{stronger(one.x), stronger(one.y), stronger(one.z)}));
    return clipped({static_cast<double>(c.r), static_cast<double>(c.g), static_cast<double>(c.b)});
}

LinearRgb bounded_in_half(const Pixel& pixel) {
    const BasicLinearRgb<Float16> c = kept_hue(shade<Float16>(Method::spectral, pixel, sight()));
    return clipped({static_cast<double>(c.r), static_cast<double>(c.g), static_cast<double>(c.b)});
}

// Colors that the working space holds at strength 1, so that what is clipped is too bright, nothing else.
void measure_strength(ExperimentPoint& point, const Pixel& pixel) {
    const LinearRgb exact = to_linear_rgb(matrix(), exact_xyz(pixel, *sight().exact));
    const LinearRgb target = clipped(kept_hue(exact));
    raise(point, "spectral in fp16, unbounded", seen_difference(unbounded_in_half(pixel), target));
    raise(point, "spectral in fp16", seen_difference(bounded_in_half(pixel), target));
    if (!in_gamut(exact))
        return;
    raise(point, "folded, gamut = clip", seen_difference(clipped(exact), target));
    raise(point, "folded",
          seen_difference(decode_rgb8(Transfer::srgb, encode_rgb8(Transfer::srgb, target)), target));
}

Experiment dim_lamps(const std::string& name, const std::vector<double>& places_nm, Harder harder) {
    Experiment e{
        .name = name, .swept = "wavelength of a lamp of one line, on the grid", .unit = "nm", .log_x = false};
    for (const double nm : places_nm) {
        const LampForms weighted = lamp_forms(line_lamp(nm)),
                        thesis = lamp_forms(line_lamp(nm), Quantization::thesis);
        ExperimentPoint& point = e.points.emplace_back(ExperimentPoint{nm});
        raise(point, "spectral, thesis's atlas",
              worst<float>(Method::spectral, thesis, patches(Quantization::thesis),
                           sight(Quantization::thesis)));
        raise(point, "spectral", worst<float>(Method::spectral, weighted, patches(), sight()));
        raise(point, "spectral in fp16", worst<Float16>(Method::spectral, weighted, patches(), sight()));
        raise(point, "packed in fp16", worst<Float16>(Method::packed, weighted, patches(), sight()));
        raise(point, "folded in fp16", worst<Float16>(Method::folded, weighted, patches(), sight()));
    }
    for (const char* loop : {"spectral, thesis's atlas", "spectral", "spectral in fp16", "packed in fp16"})
        add_failure(e, loop, harder,
                    "an 8-bit observer has few levels of Y there, in the end none: X and Z over k' err");
    add_failure(e, "folded in fp16", harder, "light without Y is brighter than half precision holds");
    e.guard =
        "k' never falls below 1/4096: such a lamp is dark instead of infinite; folded divides at 1 nm, in "
        "double; a lamp with no Y at all is refused";
    return e;
}

} // namespace

Experiment strength() {
    Experiment e{.name = "Strength of the light",
                 .swept = "strength; patches under A2800, D65 and a blue band at 450 nm",
                 .unit = ""};
    std::vector<LampForms> lamps;
    for (const char* name : {"A2800", "D65", "gauss:450:20"})
        lamps.push_back(lamp_forms(name));
    for (const double strength : logarithmically(1e-4, 1e4, 33)) {
        ExperimentPoint& point = e.points.emplace_back(ExperimentPoint{strength});
        for (const LampForms& lamp : lamps)
            for (const MaterialForms& patch : patches()) {
                Pixel pixel = pair(lamp, patch);
                pixel.lamps.front().strength = strength;
                measure_strength(point, pixel);
            }
    }
    add_failure(e, "folded, gamut = clip", Harder::up,
                "channels clip one after the other: the hue turns, then all is white");
    add_failure(e, "spectral in fp16, unbounded", Harder::up,
                "above 65504 half precision is infinite, and infinity less infinity no number");
    add_failure(e, "spectral in fp16", Harder::up, "light is bounded to 4096 per component");
    add_failure(e, "folded", Harder::up, "steps of 8 bits");
    e.finding =
        finding(e, "folded, gamut = clip", "Clipping turns hues from strength", "Clipping turns no hue") +
        finding(e, "spectral in fp16, unbounded", "; unbounded fp16 overflows from", "; fp16 holds");
    e.guard =
        "gamut = keep-hue brings all channels down together; light is bounded before the matrix, so that no "
        "pixel is infinite";
    return e;
}

Experiment violet_lamps() {
    Experiment e = dim_lamps("Violet lamps with next to no Y", evenly(365, 480, 24), Harder::down);
    e.finding = finding(e, "spectral, thesis's atlas", "Violet: the thesis's rows fail below",
                        "Violet: the thesis's rows hold") +
                finding(e, "spectral", ", weighted rows below", ", weighted rows hold");
    return e;
}

Experiment red_lamps() {
    Experiment e = dim_lamps("Red lamps with next to no Y", evenly(620, 780, 33), Harder::up);
    e.finding = finding(e, "spectral, thesis's atlas", "Red: the thesis's rows fail above",
                        "Red: the thesis's rows hold") +
                finding(e, "spectral", ", weighted rows above", ", weighted rows hold");
    return e;
}

} // namespace metamer
