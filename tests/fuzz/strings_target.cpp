#include <algorithm>

#include "base/names.h"
#include "base/utf8.h"
#include "fuzz/must.h"
#include "overlay/language_file.h"

namespace metamer::fuzz {

namespace {

constexpr const char* kPlace = "fuzz.ini";

/// Keys that stay what they are when English changes.
const std::vector<WordKey>& few_keys() {
    static const std::vector<WordKey> keys{{"few.plain", "Lamp"},
                                           {"few.filled", "{number} of {lamp}, {number}"}};
    return keys;
}

bool same(const Language& a, const Language& b) {
    return a.code == b.code && a.name == b.name && a.right_to_left == b.right_to_left &&
           a.decimal == b.decimal && a.words == b.words;
}

/// The language as a text that says the same. Without blanks about the `=`: a `;` behind one is a comment.
std::string canonical(const Language& language) {
    std::string text = "[language]\nname=" + language.name + "\ndecimal=" + language.decimal +
                       "\ndirection=" + (language.right_to_left ? "rtl" : "ltr") + "\n";
    for (const auto& [key, word] : language.words) {
        const std::size_t dot = key.find('.');
        text += "[" + key.substr(0, dot) + "]\n" + key.substr(dot + 1) + "=" + word + "\n";
    }
    return text;
}

void check_text(const std::string& text) {
    must(!text.empty() && is_utf8(text) && !has_control(text), "words can be painted", text);
}

/// What the English text has filled in, the other has too.
void check_filled(std::string_view english, std::string_view word) {
    for (std::size_t open = english.find('{'); open != std::string_view::npos;
         open = english.find('{', open + 1))
        must(word.find(english.substr(open, english.find('}', open) - open + 1)) != std::string_view::npos,
             "a placeholder stays", word);
}

Outcome try_against(std::string_view bytes, const std::vector<WordKey>& english) {
    Language language;
    const Outcome outcome = outcome_of([&] { language = parse_language(bytes, "xx", kPlace, english); });
    if (outcome == Outcome::refused)
        return outcome;
    check_text(language.name);
    check_text(language.decimal);
    for (const auto& [key, word] : language.words)
        check_text(word);
    for (const WordKey& key : english) {
        const auto word = language.words.find(key.key);
        must(word != language.words.end(), "no key is missing", key.key);
        check_filled(key.english, word->second);
    }
    must(same(parse_language(canonical(language), "xx", kPlace, english), language),
         "a language is the same again");
    return outcome;
}

} // namespace

Outcome try_strings(std::string_view bytes) {
    const Outcome of_few = try_against(bytes, few_keys());
    return try_against(bytes, word_keys()) == Outcome::taken ? Outcome::taken : of_few;
}

} // namespace metamer::fuzz
