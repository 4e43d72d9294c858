// Light that meets several things on its way: a second wall, a medium.
#include "report/stability_groups.h"
#include "report/stability_kit.h"
#include "spectra/library.h"

namespace metamer {

namespace {

Layer layer(const MaterialForms& forms) {
    return {&forms.row, &forms.full};
}

void raise_all(ExperimentPoint& point, const Pixel& pixel, const Taps& taps, bool constant_too) {
    const auto raise_by = [&](Method method) {
        raise(point, std::string(method_name(method)), difference<float>(method, pixel, sight(taps)));
    };
    for (const Method method : {Method::rgb, Method::tristimulus, Method::spectral, Method::reduced})
        raise_by(method);
    if (constant_too)
        raise_by(Method::folded);
}

} // namespace

Experiment two_bounces() {
    Experiment e{.name = "Two bounces under sodium",
                 .swept = "share of the light that comes by way of the other wall",
                 .unit = "",
                 .log_x = false};
    const LampForms sodium = lamp_forms("NIST-LPS");
    // Blue, green, red, yellow of the ColorChecker, each lit by each.
    const std::span<const MaterialForms> walls = std::span(patches()).subspan(12, 4);
    for (const double share : evenly(0, 1, 21)) {
        ExperimentPoint& point = e.points.emplace_back(ExperimentPoint{share});
        for (const MaterialForms& wall : walls)
            for (const MaterialForms& other : walls) {
                Pixel pixel = pair(sodium, wall);
                pixel.other = layer(other);
                pixel.lamps.front().light = {1 - share, 0, share};
                raise_all(point, pixel, taps_for(pixel, 8), true);
            }
    }
    for (const char* product : {"rgb", "tristimulus"})
        add_failure(
            e, product, Harder::up,
            "three numbers, known under white light, are multiplied with a lamp that has one wavelength");
    add_failure(e, "spectral", Harder::up, "5 nm are coarser than the line");
    add_failure(e, "reduced", Harder::up, "8 wavelengths are too few");
    e.finding = finding(e, "tristimulus", "Under sodium products fail from the first bounce, at a share of",
                        "Products hold") +
                finding(e, "spectral", "; spectra from", "; spectra hold");
    e.guard = "a wall's light on a wall is linear in both shares: folded sums each product of two "
              "reflectances once";
    return e;
}

Experiment thickness() {
    Experiment e{.name = "Thickness of a medium",
                 .swept = "optical density at 590 nm, band 50 nm wide; D65 and F11",
                 .unit = "",
                 .log_x = false};
    constexpr double kDensestPixel = 6;
    const MaterialForms medium = material_forms(find_material("absorb:590:50:1").spectrum);
    MaterialForms wall{{}, std::vector<double>(kReferenceGrid.count, 1.0)};
    wall.row.value.fill(1);
    for (const char* name : {"D65", "F11"}) {
        const LampForms lamp = lamp_forms(name);
        Pixel pixel = pair(lamp, wall);
        pixel.medium = layer(medium);
        pixel.thickness = kDensestPixel;
        const Taps four = taps_for(pixel, 4), eight = taps_for(pixel, 8);
        std::size_t i = 0;
        for (const double density : evenly(0, kDensestPixel, 25)) {
            if (i == e.points.size())
                e.points.push_back({density});
            ExperimentPoint& point = e.points[i++];
            pixel.thickness = density;
            raise_all(point, pixel, eight, false);
            raise(point, "reduced, 4 wavelengths", difference<float>(Method::reduced, pixel, sight(four)));
            raise(point, "spectral in fp16", difference<Float16>(Method::spectral, pixel, sight()));
            raise(point, "reduced in fp16", difference<Float16>(Method::reduced, pixel, sight(eight)));
        }
    }
    for (const char* product : {"rgb", "tristimulus"})
        add_failure(e, product, Harder::up, "three transmittances to a power are no band to a power");
    add_failure(e, "spectral", Harder::up,
                "8-bit transmittances are raised to the density: their steps grow with it");
    add_failure(e, "spectral in fp16", Harder::up, "so do the steps of half precision");
    add_failure(e, "reduced, 4 wavelengths", Harder::up, "too few wavelengths");
    add_failure(e, "reduced", Harder::up, "too few wavelengths");
    add_failure(e, "reduced in fp16", Harder::up,
                "exponents in half precision have few digits behind the point");
    e.finding = finding(e, "tristimulus", "In a medium products fail from density", "Products hold") +
                finding(e, "reduced", "; 8 wavelengths from", "; 8 chosen wavelengths hold");
    e.guard = "the planner tries every thickness of the scene and takes the fewest wavelengths that hold, or "
              "refuses by name; transmittances below 1/65536 count as that";
    return e;
}

} // namespace metamer
