#include "atlas/atlas.h"

#include <algorithm>
#include <cmath>

#include "atlas/atlas_check.h"
#include "base/error.h"
#include "base/names.h"
#include "base/numbers.h"
#include "color/resample.h"
#include "image/utf8.h"

namespace metamer {

namespace {

std::uint8_t quantized(double value) {
    return static_cast<std::uint8_t>(std::floor(value * 255 + 0.5));
}

AtlasRow quantized(const std::array<double, kIntervals>& values) {
    AtlasRow row;
    std::transform(values.begin(), values.end(), row.begin(), [](double v) { return quantized(v); });
    return row;
}

void put(Atlas& atlas, int row, AtlasChannel channel, const AtlasRow& values) {
    for (std::size_t i = 0; i < kIntervals; ++i)
        atlas.rgba[atlas_byte(row, i, channel)] = values[i];
}

std::array<double, kIntervals> numbers(const AtlasRow& row, double scale) {
    std::array<double, kIntervals> values;
    std::transform(row.begin(), row.end(), values.begin(), [&](std::uint8_t v) { return v / 255.0 * scale; });
    return values;
}

template <class Entry>
int key_of_name(const std::array<Entry, kAtlasSize>& entries, std::string_view name) {
    for (int key = 1; key <= kAtlasRows; ++key) {
        const Entry& entry = entries[static_cast<std::size_t>(key)];
        if (!entry.name.empty() && same_name(entry.name, name))
            return key;
    }
    return 0;
}

template <class Entry>
int key_of(const std::array<Entry, kAtlasSize>& entries, std::string_view name_or_key) {
    const std::string_view wanted = trimmed(name_or_key);
    if (const int key = key_of_name(entries, wanted))
        return key;
    const int key = parse_whole(wanted).value_or(0);
    const bool taken = key >= 1 && key <= kAtlasRows && !entries[static_cast<std::size_t>(key)].name.empty();
    return taken ? key : 0;
}

// Any bytes may come as a name: only what a terminal can take is shown.
std::string place_of(const std::string& what, const std::string& name) {
    return what + " \"" + quotable(name) + "\"";
}

// The row that these values are in or go to. `what`: "lamp" or "material", for errors.
template <class Entry>
int row_for(const Atlas& atlas, const std::array<Entry, kAtlasSize>& entries, AtlasChannel channel,
            const std::string& what, const Entry& entry, const AtlasRow& values) {
    const std::string place = place_of(what, entry.name);
    if (const auto flaw = flaw_of_name(entry.name, entry.source))
        throw bad_input("add", place, *flaw);
    if (const int key = key_of_name(entries, entry.name)) {
        if (atlas_row(atlas, key, channel) == values)
            return key;
        throw bad_input("add", place,
                        "the atlas holds another spectrum of this name in row " + std::to_string(key));
    }
    const auto free =
        std::find_if(entries.begin() + 1, entries.end(), [](const Entry& e) { return e.name.empty(); });
    if (free == entries.end())
        throw bad_input("add", place, "all 63 " + what + " rows of the atlas are taken");
    return static_cast<int>(free - entries.begin());
}

} // namespace

AtlasRow atlas_row(const Atlas& atlas, int row, AtlasChannel channel) {
    AtlasRow values;
    for (std::size_t i = 0; i < kIntervals; ++i)
        values[i] = atlas.rgba[atlas_byte(row, i, channel)];
    return values;
}

Atlas empty_atlas() {
    Atlas atlas;
    const GridObserver exact = sampled_observer();
    put(atlas, 0, AtlasChannel::lamp, quantized(exact.x));
    put(atlas, 0, AtlasChannel::material, quantized(exact.y));
    put(atlas, 0, AtlasChannel::excitation, quantized(exact.z));
    AtlasRow opaque;
    opaque.fill(255);
    for (int row = 0; row < kAtlasSize; ++row)
        put(atlas, row, AtlasChannel::alpha, opaque);
    return atlas;
}

int add_lamp(Atlas& atlas, const Lamp& lamp) {
    const SampledLamp sampled = sample_lamp(lamp.spectrum);
    if (!(sampled.peak > 0))
        throw bad_input("add", place_of("lamp", lamp.name),
                        "it has no light on the atlas's grid, " + to_text(kThesisGrid.first_nm) + " .. " +
                            to_text(kThesisGrid.last_nm()) + " nm");
    const AtlasLamp entry{lamp.name, lamp.source, sampled.peak};
    const AtlasRow values = quantized(sampled.emission.value);
    if (!has_luminance(atlas, values))
        throw bad_input("add", place_of("lamp", lamp.name),
                        "all of its light lies where the atlas's 8-bit observer has y = 0, so that k' = 0");
    const int key = row_for(atlas, atlas.lamps, AtlasChannel::lamp, "lamp", entry, values);
    AtlasLamp& taken = atlas.lamps[static_cast<std::size_t>(key)];
    if (taken.name.empty()) {
        taken = entry;
        put(atlas, key, AtlasChannel::lamp, values);
    }
    return key;
}

int add_material(Atlas& atlas, const Material& material) {
    const AtlasMaterial entry{material.name, material.source, 1};
    const AtlasRow values = quantized(sample_material(material.spectrum).value);
    const int key = row_for(atlas, atlas.materials, AtlasChannel::material, "material", entry, values);
    AtlasMaterial& taken = atlas.materials[static_cast<std::size_t>(key)];
    if (taken.name.empty()) {
        taken = entry;
        put(atlas, key, AtlasChannel::material, values);
    }
    return key;
}

int find_lamp_key(const Atlas& atlas, std::string_view name_or_key) {
    return key_of(atlas.lamps, name_or_key);
}

int find_material_key(const Atlas& atlas, std::string_view name_or_key) {
    return key_of(atlas.materials, name_or_key);
}

GridObserver observer(const Atlas& atlas) {
    return {numbers(atlas_row(atlas, 0, AtlasChannel::lamp), 1),
            numbers(atlas_row(atlas, 0, AtlasChannel::material), 1),
            numbers(atlas_row(atlas, 0, AtlasChannel::excitation), 1)};
}

Emission emission(const Atlas& atlas, int key) {
    return {numbers(atlas_row(atlas, key, AtlasChannel::lamp), 1)};
}

Reflectance reflectance(const Atlas& atlas, int key) {
    return {numbers(atlas_row(atlas, key, AtlasChannel::material),
                    atlas.materials[static_cast<std::size_t>(key)].scale)};
}

} // namespace metamer
