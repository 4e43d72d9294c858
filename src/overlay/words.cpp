#include "overlay/words.h"

#include <algorithm>
#include <array>
#include <span>

#include "base/error.h"
#include "base/names.h"
#include "base/printed.h"
#include "exhibit/ini.h"
#include "overlay/language_file.h"

namespace metamer_overlay_files {
std::string_view embedded(std::string_view name);
std::span<const std::string_view> embedded_names();
} // namespace metamer_overlay_files

namespace metamer {

namespace {

constexpr std::string_view kEnglish = "en";

Language built_in(std::string_view code, const std::vector<WordKey>& english) {
    const std::string file = std::string(code) + ".ini";
    return parse_language(metamer_overlay_files::embedded(file), std::string(code), "the built-in " + file,
                          english);
}

std::vector<std::filesystem::path> language_files(const std::filesystem::path& folder) {
    std::error_code error;
    std::vector<std::filesystem::path> files;
    for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        // Hidden ones are an editor's or a system's own: `.#de.ini`, `._de.ini`.
        if (at->path().extension() == ".ini" && !at->path().filename().string().starts_with('.'))
            files.push_back(at->path());
    if (error)
        throw bad_input("read", folder.string(), error.message());
    return files;
}

void sort_languages(std::vector<Language>& languages) {
    std::ranges::sort(languages, {}, [](const Language& language) {
        return std::pair(language.code != kEnglish, language.code);
    });
}

} // namespace

const std::vector<WordKey>& word_keys() {
    static const std::vector<WordKey> keys = [] {
        std::vector<WordKey> found;
        const IniFile file = parse_ini(metamer_overlay_files::embedded("en.ini"), "the built-in en.ini");
        for (const IniEntry& entry : file.entries) {
            const std::string key = entry.section + "." + entry.key;
            if (entry.section != "language" && !is_name_key(key))
                found.push_back({key, entry.value});
        }
        return found;
    }();
    return keys;
}

Words::Words() {
    for (const std::string_view file : metamer_overlay_files::embedded_names())
        languages_.push_back(built_in(file.substr(0, file.find('.')), word_keys()));
    sort_languages(languages_);
}

Words::Words(const std::filesystem::path& folder) {
    for (const std::filesystem::path& file : language_files(folder))
        languages_.push_back(read_language(file));
    if (std::ranges::find(languages_, kEnglish, &Language::code) == languages_.end())
        languages_.push_back(built_in(kEnglish, word_keys()));
    sort_languages(languages_);
}

const Language& Words::language(std::string_view code) const {
    const auto found =
        std::ranges::find_if(languages_, [&](const Language& l) { return same_name(l.code, code); });
    return found == languages_.end() ? languages_.front() : *found;
}

std::string Words::text(std::string_view code, std::string_view key,
                        const std::map<std::string, std::string>& values) const {
    const auto& words = language(code).words;
    const auto word = words.find(key);
    if (word == words.end())
        throw failure("find", "the word \"" + std::string(key) + "\"", "no language has such a key");
    std::string out;
    std::string_view rest = word->second;
    while (!rest.empty()) {
        const std::size_t open = std::min(rest.find('{'), rest.size());
        const std::size_t close = rest.find('}', open);
        out += rest.substr(0, open);
        rest.remove_prefix(open);
        if (close == std::string_view::npos) {
            out += rest;
            break;
        }
        const std::string_view whole = rest.substr(0, close - open + 1);
        const auto value = values.find(std::string(whole.substr(1, whole.size() - 2)));
        out += value == values.end() ? whole : std::string_view(value->second);
        rest.remove_prefix(whole.size());
    }
    return out;
}

std::string Words::number(std::string_view code, double value, int decimals) const {
    std::string text = printed("%.*f", decimals, value);
    const std::size_t point = text.find('.');
    if (point != std::string::npos)
        text.replace(point, 1, language(code).decimal);
    return text;
}

std::string Words::name_of(std::string_view code, std::string_view kind, std::string_view name) const {
    std::string key = std::string(kind) + "." + std::string(name);
    std::ranges::replace(key, ':', '-');
    for (const Language* speaker : {&language(code), &languages_.front()})
        if (const auto word = speaker->words.find(key); word != speaker->words.end())
            return word->second;
    return std::string(name);
}

std::string_view difference_key(double delta_e_2000) {
    struct Step {
        double below;
        std::string_view key;
    };
    constexpr std::array<Step, 4> kSteps{{{1, "difference.same"},
                                          {2, "difference.trace"},
                                          {5, "difference.slight"},
                                          {10, "difference.clear"}}};
    for (const Step& step : kSteps)
        if (delta_e_2000 < step.below)
            return step.key;
    return "difference.other";
}

} // namespace metamer
