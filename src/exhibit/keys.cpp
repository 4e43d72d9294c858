#include "exhibit/keys.h"

#include <algorithm>
#include <tuple>

#include "base/names.h"
#include "base/numbers.h"
#include "color/working_space.h"
#include "exhibit/exhibit.h"
#include "exhibit/scene_kinds.h"
#include "methods/method.h"
#include "methods/taps.h"

namespace metamer {

namespace {

template <class Table>
std::vector<std::string> names_of(const Table& table) {
    std::vector<std::string> names;
    for (const auto& row : table)
        names.emplace_back(row.name);
    return names;
}

std::vector<std::string> method_choices() {
    std::vector<std::string> names{"auto"};
    for (const MethodInfo& info : kMethods)
        names.emplace_back(info.name);
    return names;
}
std::vector<std::string> tap_counts() {
    std::vector<std::string> names;
    for (const int count : kTapCounts)
        names.push_back(std::to_string(count));
    return names;
}
std::vector<std::string> gamut_names() {
    return {"clip", "keep-hue"};
}
std::vector<std::string> color_depths() {
    return {"24", "16"};
}
std::vector<std::string> quantization_names() {
    return names_of(kQuantizations);
}
std::vector<std::string> space_names() {
    return names_of(working_spaces());
}
std::vector<std::string> kind_names() {
    return names_of(scene_kinds());
}
std::vector<std::string> transfer_names() {
    return {"srgb", "none"};
}
std::vector<std::string> adaptation_names() {
    return {"none", "bradford"};
}
std::vector<std::string> rotations() {
    return {"0", "90", "180", "270"};
}
using enum ValueKind;

// clang-format off
constexpr KeyInfo kKeys[] = {
    {"display", "width", whole, "px", 16, 4096, 1, nullptr, "1280", "width of the picture"},
    {"display", "height", whole, "px", 16, 4096, 1, nullptr, "720", "height of the picture"},
    {"display", "working_space", choice, "", 0, 0, 1, space_names, "sRGB-D65", "RGB space of the picture"},
    {"display", "matrix", numbers, "", -100, 100, 9, nullptr, "the working space's",
     "own linear RGB of XYZ in place of a working space, row by row; not singular"},
    {"display", "transfer", choice, "", 0, 0, 1, transfer_names, "srgb", "curve from light to code values; none: code values are light"},
    {"display", "adaptation", choice, "", 0, 0, 1, adaptation_names, "none",
     "bradford: the eye is adapted to the lamp; none: to the display"},
    {"display", "supersample", whole, "", 1, 2, 1, nullptr, "1", "each pixel from this many squared, averaged in light; in metamer run as codes, where the GPU has room"},
    {"display", "gamut", choice, "", 0, 0, 1, gamut_names, "clip",
     "colors that the space does not hold: cut off by component, or brought in at their hue"},
    {"display", "color_depth", choice, "bits", 0, 0, 1, color_depths, "24", "of the framebuffer; 16 is RGB565"},
    {"display", "dither", yes_no, "", 0, 0, 1, nullptr, "no", "ordered dithering to that depth: no bands in ramps"},
    {"display", "fullscreen", yes_no, "", 0, 0, 1, nullptr, "yes", "metamer run: the whole screen; no: a window of width x height; from the next start"},
    {"display", "rotation", choice, "degrees", 0, 0, 1, rotations, "0", "metamer run: how the screen hangs, clockwise; touch follows"},
    {"display", "diagonal", number, "inches", 2, 200, 1, nullptr, "as the display says", "metamer run: of the screen; sizes of letters and buttons follow it"},

    {"accuracy", "method", choice, "", 0, 0, 1, method_choices, "auto",
     "how color is computed where nothing else says so; auto: by the cheapest method within the tolerance"},
    {"accuracy", "tolerance", number, "CIEDE2000", 0.01, 100, 1, nullptr, "0.5", "error that method auto may make; 1 is just visible"},
    {"accuracy", "taps", choice, "", 0, 0, 1, tap_counts, "8", "wavelengths of method reduced"},

    {"atlas", "file", file, "", 0, 0, 1, nullptr, "none: the atlas is built from what is used",
     "atlas PNG whose lamps and materials are looked up first, by name or key"},
    {"atlas", "quantization", choice, "", 0, 0, 1, quantization_names, "weighted",
     "levels of an atlas that is built: weighted keeps sums, thesis rounds each value; a file has its own"},

    {"scene", "kind", choice, "", 0, 0, 1, kind_names, "crayons", "what is shown"},
    {"scene", "materials", materials, "", 0, 0, 1, nullptr, "the scene's own",
     "material i of the list gets key i; loaf, crayons, patches: one piece each, at most 63; ramp: its two ends; "
     "still-life: what key maps choose from; booth: its samples, at most 12"},

    {"lamp.N", "spectrum", lamp, "", 0, 0, 1, nullptr, "D65", "what it emits"},
    {"lamp.N", "strength", number, "", 0, 1e6, 1, nullptr, "1", "I_source: 1 shows the perfect reflector as white"},
    {"lamp.N", "position", numbers, "scene units", -100, 100, 3, nullptr, "where the scene has its lamp N",
     "point lamp at x y z; x to the right, y up, z to the visitor"},
    {"lamp.N", "direction", numbers, "", -1000, 1000, 3, nullptr, "where the scene has its lamp N",
     "parallel light that travels along x y z, any length but 0; not together with position"},
    {"lamp.N", "falloff", numbers, "", 0, 1e6, 3, nullptr, "1 0 0",
     "a b c of 1 / (a + b d + c d^2), d from the lamp in scene units; not all 0; asks for position"},
    {"lamp.N", "shadow", yes_no, "", 0, 0, 1, nullptr, "no", "whether objects cast shadows in its light; at most 4 lamps"},

    {"object.NAME", "material", material, "", 0, 0, 1, nullptr, "the scene's", "what it is made of (a ramp: at its near end)"},
    {"object.NAME", "method", choice, "", 0, 0, 1, method_choices, "the half's, or [accuracy] method", "how its color is computed; along a ramp also what is mixed: code values, XYZ, reflectances"},
    {"object.NAME", "medium", material, "", 0, 0, 1, nullptr, "the scene's", "scene media: internal transmittance at thickness 1 of what its material is seen through"},
    {"object.NAME", "thickness", number, "", 0, 1000, 1, nullptr, "the scene's", "of the medium where it is thickest"},
    {"object.NAME", "key_map", file, "", 0, 0, 1, nullptr, "none",
     "PNG, power-of-two sides up to 2048; red of a pixel = key of its material"},
    {"object.NAME", "luminance_map", file, "", 0, 0, 1, nullptr, "none",
     "PNG, power-of-two sides up to 2048; red / 255 scales the reflectance"},
    {"object.NAME", "bump", file, "", 0, 0, 1, nullptr, "none", "PNG, power-of-two sides up to 2048; red = height"},
    {"object.NAME", "bump_height", number, "map widths", 0, 1, 1, nullptr, "0.02", "height of the bump map's white over its black"},
    {"object.NAME", "specular", number, "", 0, 1, 1, nullptr, "the scene's", "share of the lamp's light that is mirrored unfiltered"},
    {"object.NAME", "shininess", number, "", 1, 1000, 1, nullptr, "the scene's", "Blinn-Phong exponent: 1 dull, 1000 sharp"},

    {"compare", "split", split, "", 0, 1, 1, nullptr, "0.5", "where the right half begins"},
    {"compare", "line", whole, "px", 0, 64, 1, nullptr, "0", "width of a gray line over the split"},
    {"compare", "left.method", choice, "", 0, 0, 1, method_choices, "[accuracy] method", "how the left half is computed"},
    {"compare", "left.lamp", lamp, "", 0, 0, 1, nullptr, "each lamp's own", "spectrum of every lamp in the left half"},
    {"compare", "left.working_space", choice, "", 0, 0, 1, space_names, "[display] working_space", "RGB space of the left half"},
    {"compare", "left.strength", number, "", 0, 1e6, 1, nullptr, "each lamp's own", "strength of every lamp in the left half"},
    {"compare", "right.method", choice, "", 0, 0, 1, method_choices, "[accuracy] method", "how the right half is computed"},
    {"compare", "right.lamp", lamp, "", 0, 0, 1, nullptr, "each lamp's own", "spectrum of every lamp in the right half"},
    {"compare", "right.working_space", choice, "", 0, 0, 1, space_names, "[display] working_space", "RGB space of the right half"},
    {"compare", "right.strength", number, "", 0, 1e6, 1, nullptr, "each lamp's own", "strength of every lamp in the right half"},

    {"kiosk", "idle_s", number, "s", 5, 3600, 1, nullptr, "60", "without a touch, until the exhibit returns to its start and the tour runs"},
    {"kiosk", "language", text, "", 0, 0, 1, nullptr, "en", "that the exhibit starts with: the name of a file in the folder of strings"},
    {"kiosk", "strings", file, "", 0, 0, 1, nullptr, "the program's own", "folder of the languages"},
    {"kiosk", "lamps", lamps, "", 0, 0, 1, nullptr, "E, D65, A2800, F11, white-LED, krypton", "the shelf of lamps, at most 12"},
    {"kiosk", "booth.left", lamp, "", 0, 0, 1, nullptr, "the second of the shelf", "two lamps: where the pair of cards matches; a lamp of the shelf"},
    {"kiosk", "booth.right", lamp, "", 0, 0, 1, nullptr, "the fourth of the shelf", "two lamps: where it parts; a lamp of the shelf"},
    {"kiosk", "night", hours, "", 0, 0, 1, nullptr, "none", "local time in which the screen is dark until it is touched"},
    {"kiosk", "pixel_shift", whole, "px", 0, 16, 1, nullptr, "4", "how far the picture wanders against burn-in"},
    {"kiosk", "watch_s", number, "s", 0, 3600, 1, nullptr, "60", "how often a known patch is drawn and compared; 0: never"},

    {"tour.N", "lamp", lamp, "", 0, 0, 1, nullptr, "as before", "a lamp of the shelf"},
    {"tour.N", "materials", materials, "", 0, 0, 1, nullptr, "as before", "in place of [scene] materials"},
    {"tour.N", "split", number, "", 0, 1, 1, nullptr, "as before", "where the right half begins"},
    {"tour.N", "seconds", number, "s", 1, 600, 1, nullptr, "8", "how long the step stays"},
    {"tour.N", "caption", text, "", 0, 0, 1, nullptr, "none", "words below the picture, in every language without its own"},
    {"tour.N", "caption.LANGUAGE", text, "", 0, 0, 1, nullptr, "caption", "the same in a language, as in caption.de"},
};
// clang-format on

} // namespace

std::span<const KeyInfo> keys() {
    return kKeys;
}

std::string_view section_pattern(std::string_view section) {
    for (const auto& [head, pattern, most] :
         {std::tuple("lamp.", "lamp.N", kMostLamps), std::tuple("tour.", "tour.N", kMostTourSteps)}) {
        if (!section.starts_with(head))
            continue;
        const auto number = parse_whole(section.substr(5));
        const bool fits =
            number && *number >= 1 && *number <= most && std::to_string(*number) == section.substr(5);
        return fits ? pattern : std::string_view();
    }
    if (section.starts_with("object."))
        return section.size() > 7 ? "object.NAME" : std::string_view();
    for (const KeyInfo& info : kKeys)
        if (info.section == section && section.find('.') == std::string_view::npos)
            return info.section;
    return {};
}

const KeyInfo* find_key(std::string_view section, std::string_view key) {
    const std::string_view pattern = section_pattern(section);
    const bool is_language = key.starts_with("caption.") && key.size() > 8;
    const auto found = std::find_if(std::begin(kKeys), std::end(kKeys), [&](const KeyInfo& info) {
        return info.section == pattern &&
               (info.key == key || (is_language && info.key == "caption.LANGUAGE"));
    });
    return found == std::end(kKeys) ? nullptr : found;
}

std::string unknown_section(std::string_view section) {
    const std::size_t dot = std::min(section.find('.'), section.size());
    const std::string_view head = section.substr(0, dot), tail = section.substr(dot);
    const std::string text = "unknown section [" + std::string(section) + "]";
    if (head == "tour")
        return text + "; steps of the tour are [tour.1] .. [tour." + std::to_string(kMostTourSteps) + "]";
    if (head == "lamp")
        return text + "; lamps are [lamp.1] .. [lamp." + std::to_string(kMostLamps) + "]";
    if (head == "object")
        return text + "; objects are [object.NAME]";
    std::vector<std::string> heads;
    for (const KeyInfo& info : kKeys)
        heads.emplace_back(info.section.substr(0, info.section.find('.')));
    std::string near = nearest_name(head, heads);
    if (near == "lamp" || near == "object" || near == "tour")
        near += tail.size() > 1 ? std::string(tail) : near == "object" ? ".NAME" : ".1";
    return near.empty() ? text : text + "; did you mean [" + near + "]?";
}

std::string unknown_key(std::string_view section, std::string_view key) {
    std::vector<std::string> known;
    for (const KeyInfo& info : kKeys)
        if (info.section == section_pattern(section))
            known.emplace_back(info.key);
    return "unknown key \"" + std::string(key) + "\" in [" + std::string(section) + "]" +
           did_you_mean(key, known);
}

} // namespace metamer
