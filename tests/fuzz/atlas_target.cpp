#include <algorithm>

#include "atlas/atlas_check.h"
#include "atlas/atlas_file.h"
#include "atlas/atlas_picture.h"
#include "atlas/atlas_table.h"
#include "base/utf8.h"
#include "color/colorimetry.h"
#include "color/resample.h"
#include "fuzz/must.h"
#include "image/png.h"
#include "methods/pixel.h"

namespace metamer::fuzz {

namespace {

constexpr const char* kPlace = "fuzz.png";

/// Whether the header claims so many pixels that the fuzzer would do little but clear memory.
bool claims_much(std::string_view bytes) {
    const auto side = [&](std::size_t at) { // PNG 1.2 section 4.1.1, big-endian
        std::size_t value = 0;
        for (std::size_t i = at; i < at + 4; ++i)
            value = value << 8 | static_cast<unsigned char>(bytes[i]);
        return value;
    };
    constexpr std::size_t kSides = 16;
    return bytes.size() >= kSides + 8 && (side(kSides) > 512 || side(kSides + 4) > 512);
}

void check_png(const Png& png) {
    const Image& image = png.image;
    must(image.width > 0 && image.height > 0, "a picture has sides");
    must(image.rgba.size() == std::size_t{4} * static_cast<std::size_t>(image.width * image.height),
         "a picture has all of its pixels");
    for (const auto& [key, text] : png.text)
        must(is_utf8(key) && is_utf8(text), "texts are UTF-8");
}

void check_lamp(const Atlas& atlas, int key) {
    const AtlasLamp& row = atlas.lamps[static_cast<std::size_t>(key)];
    must(find_lamp_key(atlas, row.name) == key, "a lamp is found by its name", row.name);
    const Emission values = emission(atlas, key);
    must(*std::ranges::max_element(values.value) == 1, "an emission's greatest value is 1");
    must(reference_lamp(values).k > 0, "a lamp of an atlas has a k'");
    // As an exhibit takes it (exhibit/rows.cpp), and a booth from there.
    const Lamp lamp{row.name, {}, row.source, {curve_of(values.value, row.peak), {}}};
    must(std::isfinite(sample_lamp(lamp.spectrum).peak), "a lamp's light is finite", row.name);
    must_be_within(lost_share(lamp.spectrum, kThesisGrid), 0, 1, "the lost share of a lamp");
    must(reference_lamp(lamp.spectrum).k > 0, "a lamp of an atlas has a k' with its peak");
    Atlas booth = empty_atlas(atlas.quantization);
    must(add_lamp(booth, lamp) == 1 && !flaw_of(booth), "a lamp of an atlas makes one again", row.name);
}

void check_material(const Atlas& atlas, int key) {
    const AtlasMaterial& row = atlas.materials[static_cast<std::size_t>(key)];
    must(find_material_key(atlas, row.name) == key, "a material is found by its name", row.name);
    for (const double value : reflectance(atlas, key).value)
        must_be_within(value, 0, row.scale, "a reflectance");
}

void check_same(const Atlas& a, const Atlas& b) {
    must(a.rgba == b.rgba && a.quantization == b.quantization, "an atlas's pixels are the same again");
    for (std::size_t i = 0; i < a.lamps.size(); ++i) {
        const AtlasLamp &l = a.lamps[i], &m = b.lamps[i];
        must(l.name == m.name && l.source == m.source && l.peak == m.peak, "lamps are the same again");
        const AtlasMaterial &p = a.materials[i], &q = b.materials[i];
        must(p.name == q.name && p.source == q.source && p.scale == q.scale, "materials are the same again");
    }
}

void check_atlas(const Atlas& atlas) {
    must(!flaw_of(atlas), "an atlas has no flaw", flaw_of(atlas).value_or(""));
    const std::string bytes = encode_atlas(atlas);
    check_same(decode_atlas(bytes, kPlace), atlas);
    for (int key = 1; key < kAtlasSize; ++key) {
        if (!atlas.lamps[static_cast<std::size_t>(key)].name.empty())
            check_lamp(atlas, key);
        if (!atlas.materials[static_cast<std::size_t>(key)].name.empty())
            check_material(atlas, key);
    }
    must(is_utf8(describe(atlas)), "an atlas can be printed");
    must(is_utf8(describe_json(atlas).dump()), "an atlas can be printed as JSON");
    must(picture(atlas).width == 928, "an atlas can be drawn");
}

} // namespace

Outcome try_atlas(std::string_view bytes) {
    const std::string file(bytes);
    Png png;
    if (!claims_much(bytes) && outcome_of([&] { png = decode_png(file, kPlace); }) == Outcome::taken)
        check_png(png);
    Atlas atlas;
    const Outcome outcome = outcome_of([&] { atlas = decode_atlas(file, kPlace); });
    if (outcome == Outcome::taken)
        check_atlas(atlas);
    return outcome;
}

} // namespace metamer::fuzz
