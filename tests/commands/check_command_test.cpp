// metamer check: every kind of file, valid and not.
#include "commands/command_test.h"

namespace metamer::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class Check : public CommandTest {
protected:
    Check() {
        write("lamp.csv", kFlatLamp);
        write("two.csv", kTwoMaterials);
        write("one.ini", "[scene]\nkind = patches\nmaterials = crayon-red\n[lamp.1]\nspectrum = lamp.csv\n");
        write("typo.ini", "[scene]\nknd = patches\n");
    }
};

TEST_F(Check, SaysWhatValidFilesHold) {
    write("grays.csv", "wavelength_nm,light,dark\n400,0.5,0.1\n700,0.5,0.1\n");
    write("power.csv", "wavelength_nm,tube\n400,30\n700,50\n");
    output_of({"atlas", "build", "--lamps", "F11", "--materials", "crayons", "-o", "a.png"});
    EXPECT_EQ(
        output_of({"check", "one.ini", "a.png", "grays.csv", "power.csv"}),
        "one.ini: valid exhibit, 1 object, 1 lamp\n"
        "a.png: valid atlas, 1 lamp, 15 materials\n"
        "grays.csv: valid spectra, 2 columns, for lamps and materials\n"
        "power.csv: valid spectra, 1 column, for lamps only: reflectance 30 is above 1: fluorescence is not "
        "taken, percent must be named (`# unit: percent`)\n");
}

TEST_F(Check, EveryShippedExhibitIsValid) {
    std::vector<std::string> arguments = {"check"};
    for (const auto& entry : fs::recursive_directory_iterator(METAMER_SOURCE_DIR "/config"))
        if (entry.path().extension() == ".ini" && entry.path().parent_path().filename() != "strings")
            arguments.push_back(entry.path().string());
    ASSERT_GT(arguments.size(), 40u);
    const std::string out = output_of(arguments);
    for (std::size_t i = 1; i < arguments.size(); ++i)
        EXPECT_THAT(out, HasSubstr(arguments[i] + ": valid exhibit, "));
}

TEST_F(Check, EveryShippedLanguageIsValid) {
    const std::string folder = METAMER_SOURCE_DIR "/config/strings/";
    EXPECT_THAT(output_of({"check", folder + "de.ini"}),
                StartsWith(folder + "de.ini: valid language, Deutsch, "));
    for (const auto& entry : fs::directory_iterator(folder))
        EXPECT_THAT(output_of({"check", entry.path().string()}), HasSubstr(": valid language, "));
}

TEST_F(Check, ALanguageThatLacksAWord) {
    write("it.ini", "[language]\nname = Italiano\n");
    expect_failure_like(2, {"check", "it.ini"},
                        StartsWith("metamer: cannot read it.ini: \"half.numbers\" is missing; English: "));
    write("1.ini", "[language]\nname = Italiano\n");
    expect_failure(2, {"check", "1.ini"},
                   "cannot read 1.ini: the file's name is no language code such as en.ini");
}

// What metamer run would refuse.
TEST_F(Check, ALampThatNoEyeAdaptsTo) {
    write("kiosk.ini",
          "[display]\nadaptation = bradford\n" + read("one.ini") + "[kiosk]\nlamps = E, NIST-LPS\n");
    expect_failure_like(2, {"check", "kiosk.ini"},
                        HasSubstr("lamps: NIST-LPS does not go with adaptation = bradford"));
}

TEST_F(Check, TheWordsOfAnExhibit) {
    write("kiosk.ini", read("one.ini") + "[kiosk]\nlanguage = xx\n");
    expect_failure(2, {"check", "kiosk.ini"},
                   "cannot read kiosk.ini:7: language = xx has no file in the folder of strings, which has "
                   "en, ar, de, es, fr, ja");
    fs::create_directory(folder_ / "strings");
    write("strings/xx.ini", "[language]\nname = X\n");
    write("kiosk.ini", read("one.ini") + "[kiosk]\nlanguage = xx\nstrings = strings\n");
    expect_failure_like(2, {"check", "kiosk.ini"}, StartsWith("metamer: cannot read ./strings/xx.ini: \""));
    fs::copy_file(METAMER_SOURCE_DIR "/config/strings/en.ini", folder_ / "strings/xx.ini",
                  fs::copy_options::overwrite_existing);
    EXPECT_EQ(output_of({"check", "kiosk.ini"}), "kiosk.ini: valid exhibit, 1 object, 1 lamp\n");
}

TEST_F(Check, OneBadFileIsOneLine) {
    expect_failure(2, {"check", "typo.ini"},
                   "cannot read typo.ini:2: unknown key \"knd\" in [scene]; did you mean \"kind\"?");
    expect_failure(2, {"check", "none.csv"}, "cannot read none.csv: there is no such file");
}

TEST_F(Check, AllFilesAreLookedAt) {
    write("cut.png", "\x89PNG");
    write("late.csv", "wavelength_nm,a\n400,1\n390,1\n");
    const Outcome outcome = metamer({"check", "typo.ini", "one.ini", "cut.png", "late.csv", "two.csv"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "one.ini: valid exhibit, 1 object, 1 lamp\n"
                           "two.csv: valid spectra, 2 columns, for lamps and materials\n");
    for (const char* part : {"metamer: cannot read typo.ini:2: ", "metamer: cannot read cut.png: ",
                             "metamer: cannot read late.csv:3: "})
        EXPECT_THAT(outcome.err, HasSubstr(part));
    EXPECT_TRUE(outcome.err.ends_with("\nmetamer: cannot accept 3 of 5 files: see above\n")) << outcome.err;
}

TEST_F(Check, KindsGoByTheNamesEnding) {
    write("notes.md", "");
    expect_failure(2, {"check", "notes.md"},
                   "cannot check notes.md: its name ends in none of .ini (exhibit, language), .png (atlas), "
                   ".csv and .txt (spectra)");
    write("LAMP.CSV", kFlatLamp);
    EXPECT_THAT(output_of({"check", "LAMP.CSV"}), StartsWith("LAMP.CSV: valid spectra, "));
}

TEST_F(Check, DoubtsAreWarnings) {
    write("wide.csv", "wavelength_nm,wide\n300,2\n1000,2\n");
    const Outcome outcome = metamer({"check", "wide.csv"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.err, StartsWith("metamer: warning: wide.csv#wide: "));
    EXPECT_THAT(outcome.out, StartsWith("wide.csv: valid spectra, 1 column, "));
}

TEST_F(Check, AnAdaptationThatCannotBeIsFound) {
    write("sodium.ini", "[display]\nadaptation = bradford\n[scene]\nkind = patches\n[lamp.1]\n"
                        "spectrum = line:589.3\n");
    expect_failure_like(2, {"check", "sodium.ini"}, StartsWith("metamer: cannot adapt "));
}

TEST_F(Check, NeedsNoGl) {
    const World world{.environment = {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent"}}};
    EXPECT_EQ(metamer({"check", "one.ini"}, world).status, 0);
}

} // namespace
} // namespace metamer::test
