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
    std::map<std::string, std::string, std::less<>> words; ///< by key
};

/// Every key that a language file must hold, each with what it says in English and a remark for translators.
struct WordKey {
    std::string_view key, english, remark;
};
/// In the order of the files.
const std::vector<WordKey>& word_keys();

class Words {
public:
    /// Every *.ini of the folder, English first, then by code. Throws bad_input with file and line: an
    /// unknown key (the nearest named), a key that is missing, a placeholder `{x}` that the English text does
    /// not have or that is missing, text that is not UTF-8. English is built in and beats no file.
    explicit Words(const std::filesystem::path& folder);
    /// English alone.
    Words();

    const std::vector<Language>& languages() const { return languages_; }
    /// The language of this code; English where there is none.
    const Language& language(std::string_view code) const;

    /// The text of a key, `{name}` replaced by what is given. The key must exist (asserted).
    std::string text(std::string_view language, std::string_view key,
                     const std::map<std::string, std::string>& values = {}) const;

    /// A lamp's or material's name in people's words: `lamp.F11` where the language has it, else what is
    /// given.
    std::string name_of(std::string_view language, std::string_view kind, std::string_view name) const;

private:
    std::vector<Language> languages_;
};

} // namespace metamer
