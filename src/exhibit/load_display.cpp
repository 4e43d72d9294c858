// [display], [accuracy] and [atlas].
#include "atlas/atlas_file.h"
#include "exhibit/load_parts.h"
#include "exhibit/values.h"
#include "methods/taps.h"

namespace metamer {

namespace {

Matrix3 matrix(const Setting& setting) {
    const std::vector<double> values = numbers(setting);
    Matrix3 matrix;
    for (std::size_t i = 0; i < 9; ++i)
        matrix.m[i / 3][i % 3] = values[i];
    if (!inverse(matrix))
        throw refused(setting, "is singular: some colors would be lost");
    return matrix;
}

} // namespace

Display load_display(const Settings& settings) {
    Display display;
    if (const Setting* s = settings.find("display", "width"))
        display.width_px = whole(*s);
    if (const Setting* s = settings.find("display", "height"))
        display.height_px = whole(*s);
    const Setting* space = settings.find("display", "working_space");
    if (space)
        display.working_space = &working_spaces()[choice(*space)];
    if (const Setting* s = settings.find("display", "matrix")) {
        if (space)
            throw bad_input("read", s->place,
                            "matrix stands in place of working_space, which " + space->place + " gives");
        display.matrix = matrix(*s);
    }
    if (const Setting* s = settings.find("display", "transfer"))
        display.transfer = std::array{Transfer::srgb, Transfer::none}[choice(*s)];
    if (const Setting* s = settings.find("display", "adaptation"))
        display.adaptation = std::array{Adaptation::none, Adaptation::bradford}[choice(*s)];
    if (const Setting* s = settings.find("display", "supersample"))
        display.supersample = whole(*s);
    if (const Setting* s = settings.find("display", "gamut"))
        display.gamut = std::array{Gamut::clip, Gamut::keep_hue}[choice(*s)];
    if (const Setting* s = settings.find("display", "color_depth"))
        display.color_depth_bits = std::array{24, 16}[choice(*s)];
    if (const Setting* s = settings.find("display", "dither"))
        display.dither = yes_no(*s);
    return display;
}

MethodChoice method_choice(const Setting& setting) {
    const std::size_t chosen = choice(setting); // 0 is auto
    return chosen == 0 ? MethodChoice() : kMethods[chosen - 1].method;
}

Accuracy load_accuracy(const Settings& settings) {
    Accuracy accuracy;
    if (const Setting* s = settings.find("accuracy", "method"))
        accuracy.method = method_choice(*s);
    if (const Setting* s = settings.find("accuracy", "tolerance"))
        accuracy.tolerance = number(*s);
    if (const Setting* s = settings.find("accuracy", "taps"))
        accuracy.taps = kTapCounts[choice(*s)];
    return accuracy;
}

Rows load_rows(const Settings& settings, std::vector<std::string>* warnings) {
    const Setting* s = settings.find("atlas", "file");
    const Setting* built = settings.find("atlas", "quantization");
    if (!s)
        return Rows(warnings, built ? kQuantizations[choice(*built)].quantization : Quantization::weighted);
    if (built)
        throw bad_input("read", built->place,
                        "quantization is of an atlas that is built; the file that " + s->place +
                            " names has its own");
    const std::filesystem::path path = s->folder / s->value;
    try {
        return Rows(read_atlas(path), path.string(), warnings);
    } catch (const Error& inner) {
        throw refused_by(*s, s->value, inner);
    }
}

} // namespace metamer
