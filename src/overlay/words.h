// The words on the screen, in the languages of config/strings/*.ini.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace metamer {

/// One language.
struct Language {
    std::string code;                                      ///< BCP 47, the file's name: `en`, `ar`
    std::string name;                                      ///< in itself: `English`, `العربية`
    bool right_to_left = false;                            ///< the layout is mirrored as well as the text
    std::string decimal = ".";                             ///< what parts whole numbers from decimals
    std::map<std::string, std::string, std::less<>> words; ///< by key: `section.key` of the file
};

/// What a language file must hold, and what it says in English.
struct WordKey {
    std::string key, english;
};
/// Every key but the names of lamps and materials, in the order of config/strings/en.ini, whose comments
/// explain them to translators.
const std::vector<WordKey>& word_keys();

class Words {
public:
    /// The languages that the project ships, built in.
    Words();
    /// Every *.ini of the folder instead, English first (the built-in one where the folder has no en.ini),
    /// then by code. Throws bad_input with file and line: an unknown key (the nearest named), a key that is
    /// missing, a placeholder `{x}` that the English text does not have or that is missing, text that is
    /// empty, not UTF-8 or has control characters, a file's name that is no language code; and what
    /// read_file() and parse_ini() throw.
    explicit Words(const std::filesystem::path& folder);

    const std::vector<Language>& languages() const { return languages_; }
    /// The language of this code; English where there is none.
    const Language& language(std::string_view code) const;

    /// The text of a key, each `{name}` replaced by what is given, which is not searched again. Throws
    /// failure for a key that does not exist.
    std::string text(std::string_view language, std::string_view key,
                     const std::map<std::string, std::string>& values = {}) const;

    /// A number with so many decimals, as the language parts them: `12,3`.
    std::string number(std::string_view language, double value, int decimals) const;

    /// A lamp's or material's name in people's words: `lamp.F11` of the language (`:` of a formula written
    /// `-`), else of English, else the name itself. `kind`: `lamp`, `material`.
    std::string name_of(std::string_view language, std::string_view kind, std::string_view name) const;

private:
    std::vector<Language> languages_;
};

/// How a difference is said: the key `difference.same` below 1 CIEDE2000, `.trace` below 2, `.slight` below
/// 5, `.clear` below 10, `.other` from there on (the steps of Mokrzycki and Tatol 2011, "Color difference
/// Delta E", Machine Graphics and Vision 20(4), section 4, the last two wider).
std::string_view difference_key(double delta_e_2000);

} // namespace metamer
