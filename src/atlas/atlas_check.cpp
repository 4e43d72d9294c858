#include "atlas/atlas_check.h"

#include <algorithm>
#include <set>

#include "base/names.h"
#include "base/numbers.h"
#include "base/utf8.h"

namespace metamer {

namespace {

using Flaw = std::optional<std::string>;

std::string row_text(int row) {
    return "row " + std::to_string(row) + ": ";
}

std::uint8_t greatest(const Atlas& atlas, int row, AtlasChannel channel) {
    const AtlasRow values = atlas_row(atlas, row, channel);
    return *std::max_element(values.begin(), values.end());
}

Flaw flaw_of_observer(const Atlas& atlas) {
    const Atlas standard = empty_atlas(atlas.quantization);
    const auto end_of_row_0 = static_cast<std::ptrdiff_t>(atlas_byte(1, 0, AtlasChannel::lamp));
    if (!std::equal(atlas.rgba.begin(), atlas.rgba.begin() + end_of_row_0, standard.rgba.begin()))
        return "row 0 is not the CIE 1931 observer of quantization " +
               std::string(name_of(atlas.quantization));
    return {};
}

Flaw flaw_of_lamp(const Atlas& atlas, int row) {
    const AtlasLamp& lamp = atlas.lamps[static_cast<std::size_t>(row)];
    const std::uint8_t most = greatest(atlas, row, AtlasChannel::lamp);
    if (lamp.name.empty())
        return most == 0 ? Flaw() : row_text(row) + "red holds a lamp that has no name";
    if (const Flaw flaw = flaw_of_name(lamp.name, lamp.source))
        return row_text(row) + *flaw;
    if (!(lamp.peak >= kLeastPeak && lamp.peak <= kGreatestPeak))
        return row_text(row) + "the peak " + to_text(lamp.peak) + " is outside " + to_text(kLeastPeak) +
               " .. " + to_text(kGreatestPeak);
    if (most != 255)
        return row_text(row) + "the greatest value of lamp \"" + lamp.name + "\" is " + std::to_string(most) +
               ", not 255";
    if (!has_luminance(atlas, atlas_row(atlas, row, AtlasChannel::lamp)))
        return row_text(row) + "lamp \"" + lamp.name + "\" has light only where the observer's y is 0";
    return {};
}

Flaw flaw_of_material(const Atlas& atlas, int row) {
    const AtlasMaterial& material = atlas.materials[static_cast<std::size_t>(row)];
    if (material.name.empty())
        return greatest(atlas, row, AtlasChannel::material) == 0
                   ? Flaw()
                   : row_text(row) + "green holds a material that has no name";
    if (const Flaw flaw = flaw_of_name(material.name, material.source))
        return row_text(row) + *flaw;
    if (atlas.quantization == Quantization::thesis && material.scale != 1)
        return row_text(row) + "the scale " + to_text(material.scale) +
               " is not 1, as quantization thesis has it";
    if (!(material.scale > 0 && material.scale <= 1))
        return row_text(row) + "the scale " + to_text(material.scale) + " is outside 0 .. 1";
    return {};
}

Flaw flaw_of_row(const Atlas& atlas, int row) {
    if (greatest(atlas, row, AtlasChannel::excitation) != 0)
        return row_text(row) + "blue is not 0";
    if (const Flaw flaw = flaw_of_lamp(atlas, row))
        return flaw;
    return flaw_of_material(atlas, row);
}

template <class Entry>
Flaw flaw_of_names(const std::array<Entry, kAtlasSize>& entries, const std::string& what) {
    std::set<std::string> seen;
    for (const Entry& entry : entries)
        if (!entry.name.empty() && !seen.insert(lower_case(entry.name)).second)
            return "two rows hold a " + what + " of the name \"" + entry.name + "\"";
    return {};
}

} // namespace

bool has_luminance(const Atlas& atlas, const AtlasRow& lamp) {
    if (atlas.quantization == Quantization::weighted) // no weight y is 0
        return std::any_of(lamp.begin(), lamp.end(), [](std::uint8_t level) { return level != 0; });
    for (std::size_t i = 0; i < kIntervals; ++i)
        if (lamp[i] != 0 && atlas.rgba[atlas_byte(0, i, AtlasChannel::material)] != 0) // green: y
            return true;
    return false;
}

std::optional<std::string> flaw_of_name(const std::string& name, const std::string& source) {
    if (name.empty())
        return "the name is empty";
    if (name != trimmed(name))
        return "the name begins or ends with a blank";
    // Refused by name where the name itself could not be printed.
    if (!is_utf8(name) || !is_utf8(source))
        return "the name or its source is not UTF-8";
    if (has_control(name) || has_control(source))
        return "the name or its source holds a control character";
    return {};
}

std::optional<std::string> flaw_of(const Atlas& atlas) {
    for (std::size_t i = static_cast<std::size_t>(AtlasChannel::alpha); i < atlas.rgba.size(); i += 4)
        if (atlas.rgba[i] != 255)
            return row_text(static_cast<int>(i / (4 * kAtlasSize))) + "alpha is not 255";
    if (const Flaw flaw = flaw_of_observer(atlas))
        return flaw;
    if (!atlas.lamps[0].name.empty() || !atlas.materials[0].name.empty())
        return "row 0 has a name";
    for (int row = 1; row <= kAtlasRows; ++row)
        if (const Flaw flaw = flaw_of_row(atlas, row))
            return flaw;
    if (const Flaw flaw = flaw_of_names(atlas.lamps, "lamp"))
        return flaw;
    return flaw_of_names(atlas.materials, "material");
}

} // namespace metamer
