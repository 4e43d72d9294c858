#include "atlas/atlas.h"

#include <algorithm>
#include <cmath>

#include "atlas/atlas_check.h"
#include "atlas/row_levels.h"
#include "base/error.h"
#include "base/names.h"
#include "base/numbers.h"
#include "base/utf8.h"
#include "color/resample.h"

namespace metamer {

namespace {

// Quantization::thesis: round half up.
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

bool same_scale(const AtlasLamp&, const AtlasLamp&) {
    return true;
}
bool same_scale(const AtlasMaterial& a, const AtlasMaterial& b) {
    return a.scale == b.scale;
}

// The row that these values are in or go to. `what`: "lamp" or "material", for errors.
template <class Entry>
int row_for(const Atlas& atlas, const std::array<Entry, kAtlasSize>& entries, AtlasChannel channel,
            const std::string& what, const Entry& entry, const AtlasRow& values) {
    const std::string place = place_of(what, entry.name);
    if (const auto flaw = flaw_of_name(entry.name, entry.source))
        throw bad_input("add", place, *flaw);
    if (const int key = key_of_name(entries, entry.name)) {
        if (atlas_row(atlas, key, channel) == values &&
            same_scale(entries[static_cast<std::size_t>(key)], entry))
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

template <class Entry>
int add(Atlas& atlas, std::array<Entry, kAtlasSize>& entries, AtlasChannel channel, const std::string& what,
        const Entry& entry, const AtlasRow& values) {
    const int key = row_for(atlas, entries, channel, what, entry, values);
    Entry& taken = entries[static_cast<std::size_t>(key)];
    if (taken.name.empty()) {
        taken = entry;
        put(atlas, key, channel, values);
    }
    return key;
}

std::array<AtlasRow, 3> observer_rows(Quantization quantization) {
    if (quantization == Quantization::weighted)
        return observer_levels();
    const GridObserver exact = sampled_observer();
    return {quantized(exact.x), quantized(exact.y), quantized(exact.z)};
}

LampLevels thesis_levels(const Atlas& atlas, const Lamp& lamp) {
    const SampledLamp sampled = sample_lamp(lamp.spectrum);
    if (!(sampled.peak > 0))
        throw bad_input("add", place_of("lamp", lamp.name),
                        "it has no light on the atlas's grid, " + to_text(kThesisGrid.first_nm) + " .. " +
                            to_text(kThesisGrid.last_nm()) + " nm");
    const LampLevels levels{quantized(sampled.emission.value), sampled.peak};
    if (!has_luminance(atlas, levels.level))
        throw bad_input("add", place_of("lamp", lamp.name),
                        "all of its light lies where the atlas's 8-bit observer has y = 0, so that k' = 0");
    return levels;
}

LampLevels weighted_levels(const Lamp& lamp) {
    const LampPower power = lamp_power(lamp.spectrum);
    if (!is_seen(power))
        throw bad_input("add", place_of("lamp", lamp.name),
                        "it has no light that the eye sees, " + to_text(kReferenceGrid.first_nm) + " .. " +
                            to_text(kReferenceGrid.last_nm()) + " nm");
    return lamp_levels(power);
}

std::vector<PriorLamp> own_lamps(const Atlas& atlas, std::span<const Lamp> lamps) {
    std::vector<PriorLamp> own;
    for (const Lamp& lamp : lamps)
        if (const int key = key_of_name(atlas.lamps, lamp.name))
            own.push_back(own_lamp(lamp_power(lamp.spectrum),
                                   row_values(atlas_row(atlas, key, AtlasChannel::lamp)),
                                   1.0 / static_cast<double>(lamps.size())));
    return own;
}

} // namespace

AtlasRow atlas_row(const Atlas& atlas, int row, AtlasChannel channel) {
    AtlasRow values;
    for (std::size_t i = 0; i < kIntervals; ++i)
        values[i] = atlas.rgba[atlas_byte(row, i, channel)];
    return values;
}

std::array<double, kIntervals> row_values(const AtlasRow& row, double scale) {
    std::array<double, kIntervals> values;
    std::transform(row.begin(), row.end(), values.begin(), [&](std::uint8_t v) { return v / 255.0 * scale; });
    return values;
}

Atlas empty_atlas(Quantization quantization) {
    Atlas atlas;
    atlas.quantization = quantization;
    const auto row_0 = observer_rows(quantization);
    put(atlas, 0, AtlasChannel::lamp, row_0[0]);
    put(atlas, 0, AtlasChannel::material, row_0[1]);
    put(atlas, 0, AtlasChannel::excitation, row_0[2]);
    AtlasRow opaque;
    opaque.fill(255);
    for (int row = 0; row < kAtlasSize; ++row)
        put(atlas, row, AtlasChannel::alpha, opaque);
    return atlas;
}

int add_lamp(Atlas& atlas, const Lamp& lamp) {
    const LampLevels levels =
        atlas.quantization == Quantization::thesis ? thesis_levels(atlas, lamp) : weighted_levels(lamp);
    const AtlasLamp entry{lamp.name, lamp.source, levels.peak};
    return add(atlas, atlas.lamps, AtlasChannel::lamp, "lamp", entry, levels.level);
}

int add_material(Atlas& atlas, const Material& material, std::span<const Lamp> lit_by) {
    const MaterialLevels levels = atlas.quantization == Quantization::thesis
                                      ? MaterialLevels{quantized(sample_material(material.spectrum).value), 1}
                                      : material_levels(material.spectrum, own_lamps(atlas, lit_by));
    const AtlasMaterial entry{material.name, material.source, levels.scale};
    return add(atlas, atlas.materials, AtlasChannel::material, "material", entry, levels.level);
}

int find_lamp_key(const Atlas& atlas, std::string_view name_or_key) {
    return key_of(atlas.lamps, name_or_key);
}

int find_material_key(const Atlas& atlas, std::string_view name_or_key) {
    return key_of(atlas.materials, name_or_key);
}

GridObserver observer(const Atlas& atlas) {
    return {row_values(atlas_row(atlas, 0, AtlasChannel::lamp)),
            row_values(atlas_row(atlas, 0, AtlasChannel::material)),
            row_values(atlas_row(atlas, 0, AtlasChannel::excitation))};
}

Emission emission(const Atlas& atlas, int key) {
    return {row_values(atlas_row(atlas, key, AtlasChannel::lamp))};
}

GridObserver exact_observer(const Atlas& atlas) {
    return atlas.quantization == Quantization::thesis ? sampled_observer() : weighted_observer();
}

Reflectance reflectance(const Atlas& atlas, int key) {
    return {row_values(atlas_row(atlas, key, AtlasChannel::material),
                       atlas.materials[static_cast<std::size_t>(key)].scale)};
}

} // namespace metamer
