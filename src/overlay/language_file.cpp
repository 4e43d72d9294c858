#include "overlay/language_file.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "base/error.h"
#include "base/files.h"
#include "base/names.h"
#include "base/utf8.h"
#include "exhibit/ini.h"

namespace metamer {

namespace {

/// The sections that are read into Language's own members.
constexpr std::string_view kSelf = "language";
constexpr std::size_t kMostFileBytes = 1u << 20;

// BCP 47 (RFC 5646 section 2.1): subtags of 1 .. 8 letters and digits with hyphens between; the first one
// letters.
bool is_code(std::string_view code) {
    const std::vector<std::string> subtags = split(code, '-');
    const auto is_subtag = [](const std::string& tag) {
        return !tag.empty() && tag.size() <= 8 &&
               std::ranges::all_of(tag, [](unsigned char c) { return c < 128 && std::isalnum(c); });
    };
    return !subtags.empty() && std::ranges::all_of(subtags, is_subtag) && subtags[0].size() >= 2 &&
           std::ranges::none_of(subtags[0], [](unsigned char c) { return std::isdigit(c); });
}

std::set<std::string> placeholders(std::string_view text) {
    std::set<std::string> found;
    for (std::size_t open = text.find('{'); open != std::string_view::npos; open = text.find('{', open + 1)) {
        const std::size_t close = text.find('}', open);
        if (close == std::string_view::npos)
            break;
        found.emplace(text.substr(open, close - open + 1));
    }
    return found;
}

/// What is wrong with a text; empty: nothing.
std::string fault_of(const IniEntry& entry) {
    if (entry.value.empty())
        return "\"" + quotable(entry.key) + "\" has no text";
    if (has_control(entry.value))
        return "\"" + quotable(entry.key) + "\" has control characters";
    return {};
}

std::string placeholder_fault(const std::string& key, std::string_view text, std::string_view english) {
    const std::set<std::string> here = placeholders(text), there = placeholders(english);
    for (const std::string& name : here)
        if (!there.contains(name))
            return "\"" + key + "\" has " + quotable(name) + ", which the English text does not";
    for (const std::string& name : there)
        if (!here.contains(name))
            return "\"" + key + "\" lacks " + name;
    return {};
}

/// `[language]`; false: no key of it.
bool take_self(const IniEntry& entry, Language& language, std::string& fault) {
    if (entry.section != kSelf)
        return false;
    if (entry.key == "name")
        language.name = entry.value;
    else if (entry.key == "decimal")
        language.decimal = entry.value;
    else if (entry.key == "direction") {
        language.right_to_left = entry.value == "rtl";
        if (entry.value != "rtl" && entry.value != "ltr")
            fault = "direction = " + quotable(entry.value) + " is neither ltr nor rtl";
    } else
        return false;
    return true;
}

std::string unknown_key(const std::string& key, const std::vector<WordKey>& english) {
    std::vector<std::string> known{"language.name", "language.direction", "language.decimal"};
    for (const WordKey& word : english)
        known.push_back(word.key);
    return "unknown key \"" + quotable(key) + "\"" + did_you_mean(key, known);
}

/// What is wrong with an entry, which is taken over where nothing is.
std::string take(const IniEntry& entry, const std::vector<WordKey>& english, Language& language) {
    std::string fault = fault_of(entry);
    if (!fault.empty() || take_self(entry, language, fault))
        return fault;
    const std::string key = entry.section + "." + entry.key;
    const auto word = std::ranges::find(english, key, &WordKey::key);
    if (word != english.end())
        fault = placeholder_fault(key, entry.value, word->english);
    else if (!english.empty() && !is_name_key(key))
        fault = unknown_key(key, english);
    if (fault.empty())
        language.words[key] = entry.value;
    return fault;
}

} // namespace

bool is_name_key(std::string_view key) {
    return key.starts_with("lamp.") || key.starts_with("material.");
}

Language parse_language(std::string_view text, const std::string& code, const std::string& place,
                        const std::vector<WordKey>& english) {
    Language language{code, {}, false, ".", {}};
    for (const IniEntry& entry : parse_ini(text, place).entries) {
        const std::string fault = take(entry, english, language);
        if (!fault.empty())
            throw bad_input("read", place + ":" + std::to_string(entry.line), fault);
    }
    if (language.name.empty())
        throw bad_input("read", place, "\"language.name\" is missing");
    for (const WordKey& word : english)
        if (!language.words.contains(word.key))
            throw bad_input("read", place,
                            "\"" + word.key + "\" is missing; English: \"" + word.english + "\"");
    return language;
}

Language read_language(const std::filesystem::path& file) {
    const std::string code = file.stem().string();
    if (!is_code(code))
        throw bad_input("read", file.string(), "the file's name is no language code such as en.ini");
    return parse_language(read_file(file, kMostFileBytes), code, file.string(), word_keys());
}

} // namespace metamer
