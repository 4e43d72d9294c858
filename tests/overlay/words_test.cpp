#include "overlay/words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "base/error.h"
#include "base/files.h"

namespace metamer {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

const std::filesystem::path kShipped = std::filesystem::path(METAMER_SOURCE_DIR) / "config/strings";

/// A folder of its own that goes with the test.
class WordsFolder : public testing::Test {
protected:
    WordsFolder()
        : folder_(std::filesystem::path(testing::TempDir()) /
                  ("words-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()))) {
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    ~WordsFolder() override { std::filesystem::remove_all(folder_); }

    /// The shipped German with one piece of text exchanged.
    void write_german(const std::string& from, const std::string& to, const std::string& file = "de.ini") {
        std::string text = read_file(kShipped / "de.ini");
        const std::size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        text.replace(at, from.size(), to);
        std::ofstream(folder_ / file) << text;
    }

    std::string error() const {
        try {
            Words words(folder_);
        } catch (const Error& e) {
            EXPECT_EQ(e.status(), Exit::bad_input);
            return e.what();
        }
        return "no error";
    }

    std::filesystem::path folder_;
};

std::vector<std::string> codes(const Words& words) {
    std::vector<std::string> found;
    for (const Language& language : words.languages())
        found.push_back(language.code);
    return found;
}

TEST(Words, ShippedLanguagesAreBuiltInEnglishFirst) {
    const Words words;
    EXPECT_THAT(codes(words), ElementsAre("en", "ar", "de", "es", "fr", "ja"));
    EXPECT_EQ(words.language("ar").name, "العربية");
    for (const Language& language : words.languages())
        EXPECT_EQ(language.right_to_left, language.code == "ar") << language.code;
}

TEST(Words, BuiltInOnesAreTheFiles) {
    const Words built_in, files(kShipped);
    ASSERT_EQ(codes(built_in), codes(files));
    for (std::size_t i = 0; i < files.languages().size(); ++i)
        EXPECT_EQ(built_in.languages()[i].words, files.languages()[i].words) << files.languages()[i].code;
}

TEST(Words, EveryShippedLanguageNamesTheSameLampsAndMaterialsAndNothingElse) {
    const Words words;
    const auto keys = [](const Language& language) {
        std::set<std::string> found;
        for (const auto& [key, text] : language.words)
            found.insert(key);
        return found;
    };
    for (const Language& language : words.languages())
        EXPECT_EQ(keys(language), keys(words.language("en"))) << language.code;
    EXPECT_GT(keys(words.language("en")).size(), word_keys().size() + 40);
}

TEST(Words, NoLanguageIsLeftInEnglish) {
    const Words words;
    for (const Language& language : words.languages()) {
        if (language.code == "en")
            continue;
        int same = 0;
        for (const WordKey& word : word_keys())
            same += language.words.at(word.key) == word.english;
        EXPECT_LE(same, 3) << language.code; // `ΔE {number}` and the like
    }
}

TEST(Words, SayWhatTheHalvesAre) {
    const Words words;
    EXPECT_EQ(words.text("en", "half.numbers"), "the way screens guess: three numbers");
    EXPECT_EQ(words.text("en", "half.wavelengths"), "the way light works: wavelength by wavelength");
    EXPECT_EQ(words.text("de", "half.numbers"), "wie Bildschirme raten: drei Zahlen");
}

TEST(Words, FillPlaceholdersOnceAndLeaveUnknownOnes) {
    const Words words;
    EXPECT_EQ(words.text("en", "panel.title", {{"material", "Red crayon"}, {"lamp", "{material}"}}),
              "Red crayon – {material}");
    EXPECT_EQ(words.text("en", "panel.title", {{"lamp", "F11"}}), "{material} – F11");
}

TEST(Words, UnknownLanguageIsEnglishAndCaseDoesNotMatter) {
    const Words words;
    EXPECT_EQ(words.language("tlh").code, "en");
    EXPECT_EQ(words.language("DE").code, "de");
    EXPECT_EQ(words.text("tlh", "button.close"), "Close");
}

TEST(Words, UnknownKeyIsAFault) {
    try {
        Words().text("en", "button.clsoe");
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "cannot find the word \"button.clsoe\": no language has such a key");
    }
}

TEST(Words, NumbersArePartedAsTheLanguageDoes) {
    const Words words;
    EXPECT_EQ(words.number("en", 12.34, 1), "12.3");
    EXPECT_EQ(words.number("de", 12.34, 1), "12,3");
    EXPECT_EQ(words.number("fr", 3, 0), "3");
    EXPECT_EQ(words.number("en", -0.5, 2), "-0.50");
}

TEST(Words, NamesFallBackToEnglishThenToThemselves) {
    const Words words;
    EXPECT_EQ(words.name_of("de", "lamp", "D65"), "Tageslicht");
    EXPECT_EQ(words.name_of("ja", "material", "crayon-red"), "赤のクレヨン");
    EXPECT_EQ(words.name_of("de", "lamp", "planck:2700"), "planck:2700");
}

TEST(DifferenceKey, HasItsStepsWhereTheTableHasThem) {
    EXPECT_EQ(difference_key(0), "difference.same");
    EXPECT_EQ(difference_key(0.999), "difference.same");
    EXPECT_EQ(difference_key(1), "difference.trace");
    EXPECT_EQ(difference_key(2), "difference.slight");
    EXPECT_EQ(difference_key(4.99), "difference.slight");
    EXPECT_EQ(difference_key(5), "difference.clear");
    EXPECT_EQ(difference_key(10), "difference.other");
    for (const double delta_e : {0.0, 1.0, 2.0, 5.0, 10.0})
        EXPECT_FALSE(Words().text("fr", difference_key(delta_e)).empty());
}

TEST_F(WordsFolder, HoldsTheLanguagesAndEnglishIsThereAnyway) {
    write_german("name = Deutsch", "name = Deutsch");
    EXPECT_THAT(codes(Words(folder_)), ElementsAre("en", "de"));
}

TEST_F(WordsFolder, MayNameLampsOfItsOwnAndLeaveOthersOut) {
    write_german("D65 = Tageslicht\n", "planck-2700 = Kerze\n");
    const Words words(folder_);
    EXPECT_EQ(words.name_of("de", "lamp", "planck:2700"), "Kerze");
    EXPECT_EQ(words.name_of("de", "lamp", "D65"), "Daylight");
}

TEST_F(WordsFolder, UnknownKeyIsRefusedWithTheNearest) {
    write_german("expert = ", "exprt = ");
    EXPECT_THAT(error(), HasSubstr("/de.ini:17: unknown key \"button.exprt\"; did you mean "
                                   "\"button.expert\"?"));
}

TEST_F(WordsFolder, MissingKeyIsRefusedWithItsEnglish) {
    write_german("close = Schließen\n", "");
    EXPECT_THAT(error(), EndsWith("/de.ini: \"button.close\" is missing; English: \"Close\""));
}

TEST_F(WordsFolder, PlaceholdersMustBeThoseOfEnglish) {
    write_german("strength = Helligkeit × {factor}", "strength = Helligkeit");
    EXPECT_THAT(error(), EndsWith("/de.ini:22: \"slider.strength\" lacks {factor}"));
    write_german("close = Schließen", "close = {lamp} weg");
    EXPECT_THAT(error(), EndsWith("\"button.close\" has {lamp}, which the English text does not"));
}

TEST_F(WordsFolder, WrongDirectionIsRefused) {
    write_german("direction = ltr", "direction = down");
    EXPECT_THAT(error(), EndsWith("/de.ini:5: direction = down is neither ltr nor rtl"));
}

TEST_F(WordsFolder, TextMustBeThereAndBeUtf8WithoutControls) {
    write_german("close = Schließen", "close =");
    EXPECT_THAT(error(), EndsWith("/de.ini:18: \"close\" has no text"));
    write_german("close = Schließen", "close = Schlie\xDF"
                                      "en");
    EXPECT_THAT(error(), EndsWith("/de.ini:18: text that is not UTF-8"));
    write_german("close = Schließen", "close = Schlie\x1B[31mßen");
    EXPECT_THAT(error(), EndsWith("/de.ini:18: \"close\" has control characters"));
}

TEST_F(WordsFolder, LanguageMustHaveAName) {
    write_german("name = Deutsch\n", "");
    EXPECT_THAT(error(), EndsWith("/de.ini: \"language.name\" is missing"));
}

TEST_F(WordsFolder, FileMustBeNamedByALanguage) {
    write_german("name = Deutsch", "name = Deutsch", "my words.ini");
    EXPECT_THAT(error(), EndsWith("my words.ini: the file's name is no language code such as en.ini"));
}

TEST_F(WordsFolder, OtherFilesAreNotLookedAt) {
    std::ofstream(folder_ / "README.txt") << "not an INI file";
    std::ofstream(folder_ / "._de.ini") << '\0' << "macOS's own";
    std::filesystem::create_symlink("curator@desk.4711:1", folder_ / ".#de.ini"); // Emacs: it is being edited
    EXPECT_THAT(codes(Words(folder_)), ElementsAre("en"));
}

TEST(WordsOfNoFolder, AreRefused) {
    try {
        Words words(std::filesystem::path("/nowhere/strings"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "cannot read /nowhere/strings: No such file or directory");
    }
}

} // namespace
} // namespace metamer
