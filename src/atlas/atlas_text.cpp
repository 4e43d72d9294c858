#include "atlas/atlas_text.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/utf8.h"

namespace metamer {

namespace {

using Texts = std::map<std::string, std::string>;

constexpr const char* kVersionKey = "metamer:atlas";
constexpr const char* kObserverKey = "metamer:observer";
constexpr const char* kQuantizationKey = "metamer:quantization";
constexpr const char* kLampsKey = "metamer:lamps";
constexpr const char* kMaterialsKey = "metamer:materials";
constexpr const char* kVersion = "1";

// The number that stands beside a name: a lamp's peak, a material's scale.
double& number_of(AtlasLamp& lamp) {
    return lamp.peak;
}
double& number_of(AtlasMaterial& material) {
    return material.scale;
}

template <class Entry>
std::string lines_of(std::array<Entry, kAtlasSize> entries) {
    std::string lines;
    for (std::size_t row = 1; row < entries.size(); ++row) {
        Entry& entry = entries[row];
        if (!entry.name.empty())
            lines += std::to_string(row) + '\t' + entry.name + '\t' + to_text(number_of(entry)) + '\t' +
                     entry.source + '\n';
    }
    return lines;
}

const std::string& text_of(const Texts& texts, const std::string& key, const std::string& place) {
    const auto at = texts.find(key);
    if (at == texts.end())
        throw bad_input("read", place, "it is no atlas: it has no text " + key);
    return at->second;
}

void demand(const Texts& texts, const std::string& key, const std::string& wanted, const std::string& place) {
    const std::string& there = text_of(texts, key, place);
    if (there != wanted)
        throw bad_input("read", place,
                        key + " is \"" + quotable(there) + "\"; only \"" + wanted + "\" is known");
}

// Without its text an atlas is the thesis's, which knew no other.
Quantization read_quantization(const Texts& texts, const std::string& place) {
    const auto at = texts.find(kQuantizationKey);
    if (at == texts.end())
        return Quantization::thesis;
    if (const auto known = find_quantization(at->second))
        return *known;
    throw bad_input("read", place,
                    std::string(kQuantizationKey) + " is \"" + quotable(at->second) +
                        "\"; only \"thesis\" and \"weighted\" are known");
}

// The text up to the separator, which goes too; none when there is no separator.
std::optional<std::string_view> taken_until(std::string_view& rest, char separator) {
    const std::size_t at = rest.find(separator);
    if (at == std::string_view::npos)
        return {};
    const std::string_view piece = rest.substr(0, at);
    rest.remove_prefix(at + 1);
    return piece;
}

template <class Entry>
void read_line(std::array<Entry, kAtlasSize>& entries, std::string_view line, const std::string& number_name,
               const std::string& line_place) {
    std::string_view source = line;
    const auto row_text = taken_until(source, '\t');
    const auto name = taken_until(source, '\t');
    const auto number_text = taken_until(source, '\t');
    if (!row_text || !name || !number_text)
        throw bad_input("read", line_place,
                        "it is not row, name, " + number_name + ", source, with tabs between");
    const int row = parse_whole(*row_text).value_or(0);
    if (row < 1 || row > kAtlasRows)
        throw bad_input("read", line_place, "row \"" + quotable(*row_text) + "\" is not 1 .. 63");
    const auto number = parse_number(*number_text);
    if (!number)
        throw bad_input("read", line_place,
                        number_name + " \"" + quotable(*number_text) + "\" is not a number");
    if (name->empty())
        throw bad_input("read", line_place, "the name is empty");
    Entry& entry = entries[static_cast<std::size_t>(row)];
    if (!entry.name.empty())
        throw bad_input("read", line_place, "row " + std::to_string(row) + " comes twice");
    entry.name = *name;
    entry.source = source;
    number_of(entry) = *number;
}

template <class Entry>
void read_lines(std::array<Entry, kAtlasSize>& entries, const Texts& texts, const std::string& key,
                const std::string& number_name, const std::string& place) {
    std::string_view rest = text_of(texts, key, place);
    for (int count = 1; !rest.empty(); ++count) {
        const std::string line_place = place + ": " + key + " line " + std::to_string(count);
        const auto line = taken_until(rest, '\n');
        if (!line)
            throw bad_input("read", line_place, "it has no line feed");
        read_line(entries, *line, number_name, line_place);
    }
}

} // namespace

std::map<std::string, std::string> atlas_texts(const Atlas& atlas) {
    Texts texts{{kVersionKey, kVersion},
                {kObserverKey, kObserverName},
                {kLampsKey, lines_of(atlas.lamps)},
                {kMaterialsKey, lines_of(atlas.materials)}};
    if (atlas.quantization != Quantization::thesis)
        texts.emplace(kQuantizationKey, name_of(atlas.quantization));
    return texts;
}

void read_atlas_texts(Atlas& atlas, const std::map<std::string, std::string>& texts,
                      const std::string& place) {
    demand(texts, kVersionKey, kVersion, place);
    demand(texts, kObserverKey, kObserverName, place);
    atlas.quantization = read_quantization(texts, place);
    read_lines(atlas.lamps, texts, kLampsKey, "peak", place);
    read_lines(atlas.materials, texts, kMaterialsKey, "scale", place);
}

} // namespace metamer
