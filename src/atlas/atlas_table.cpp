#include "atlas/atlas_table.h"

#include <algorithm>
#include <charconv>

#include "atlas/atlas_text.h"
#include "base/numbers.h"
#include "base/utf8.h"

namespace metamer {

namespace {

constexpr std::size_t kCurveColumns = 32;

std::string curve(const Atlas& atlas, int row, AtlasChannel channel) {
    static constexpr const char* kEighths[] = {" ", "▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
    constexpr std::size_t together = kIntervals / kCurveColumns;
    std::string out;
    for (std::size_t column = 0; column < kCurveColumns; ++column) {
        int most = 0;
        for (std::size_t i = column * together; i < (column + 1) * together; ++i)
            most = std::max<int>(most, atlas.rgba[atlas_byte(row, i, channel)]);
        // Rounded up: what is not 0 shows.
        out += kEighths[(most * 8 + 254) / 255];
    }
    return out;
}

std::string padded(const std::string& text, std::size_t columns) {
    const std::size_t there = code_points(text);
    return text + std::string(columns > there ? columns - there : 0, ' ');
}

// Four digits are enough for people; the file keeps them all.
std::string short_text(double value) {
    char text[32];
    const auto [end, error] = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 4);
    return error == std::errc() ? std::string(text, end) : to_text(value);
}

std::string lamp_text(const AtlasLamp& lamp) {
    return lamp.name.empty() ? "" : lamp.name + " (peak " + short_text(lamp.peak) + ")";
}

std::string material_text(const AtlasMaterial& material) {
    return material.scale == 1 || material.name.empty()
               ? material.name
               : material.name + " (scale " + short_text(material.scale) + ")";
}

std::size_t widest_lamp(const Atlas& atlas) {
    std::size_t widest = 0;
    for (const AtlasLamp& lamp : atlas.lamps)
        widest = std::max(widest, code_points(lamp_text(lamp)));
    return widest;
}

void add_line(std::string& table, const std::string& line) {
    table += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
}

} // namespace

std::string describe(const Atlas& atlas) {
    std::string table;
    add_line(table, std::string("observer: ") + kObserverName +
                        "; quantization: " + std::string(name_of(atlas.quantization)));
    add_line(table, "  x  " + curve(atlas, 0, AtlasChannel::lamp));
    add_line(table, "  y  " + curve(atlas, 0, AtlasChannel::material));
    add_line(table, "  z  " + curve(atlas, 0, AtlasChannel::excitation));
    const std::string grid = to_text(kThesisGrid.first_nm) + " .. " + to_text(kThesisGrid.last_nm()) + " nm";
    const std::size_t width = std::max<std::size_t>(4, widest_lamp(atlas));
    add_line(table, "row  " + padded(grid, kCurveColumns) + "  " + padded("lamp", width) + "  " +
                        padded(grid, kCurveColumns) + "  material");
    for (int row = 1; row <= kAtlasRows; ++row) {
        const std::string lamp = lamp_text(atlas.lamps[static_cast<std::size_t>(row)]);
        const std::string material = material_text(atlas.materials[static_cast<std::size_t>(row)]);
        if (lamp.empty() && material.empty())
            continue;
        add_line(table, (row < 10 ? "  " : " ") + std::to_string(row) + "  " +
                            curve(atlas, row, AtlasChannel::lamp) + "  " + padded(lamp, width) + "  " +
                            curve(atlas, row, AtlasChannel::material) + "  " + material);
    }
    return table;
}

nlohmann::json describe_json(const Atlas& atlas) {
    nlohmann::json rows = nlohmann::json::array();
    for (std::size_t key = 1; key < kAtlasSize; ++key) {
        const AtlasLamp& lamp = atlas.lamps[key];
        const AtlasMaterial& material = atlas.materials[key];
        if (lamp.name.empty() && material.name.empty())
            continue;
        nlohmann::json row{{"key", key}, {"lamp", nullptr}, {"material", nullptr}};
        if (!lamp.name.empty())
            row["lamp"] = {{"name", lamp.name}, {"peak", lamp.peak}, {"source", lamp.source}};
        if (!material.name.empty())
            row["material"] = {
                {"name", material.name}, {"scale", material.scale}, {"source", material.source}};
        rows.push_back(row);
    }
    return {{"rows", rows},
            {"observer", kObserverName},
            {"quantization", name_of(atlas.quantization)},
            {"grid",
             {{"first_nm", kThesisGrid.first_nm},
              {"step_nm", kThesisGrid.step_nm},
              {"count", kThesisGrid.count}}}};
}

} // namespace metamer
