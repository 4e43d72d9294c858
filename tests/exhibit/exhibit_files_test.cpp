// What an exhibit is read from: what must be watched while it is shown, or while it is refused.
#include <fstream>
#include <gmock/gmock.h>

#include "exhibit/support.h"

namespace metamer {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

class ExhibitFiles : public testing::Test {
protected:
    std::vector<fs::path> files_of(const std::string& text, const std::vector<std::string>& sets = {}) const {
        std::ofstream(folder_ / "k.ini") << text;
        return exhibit_files(folder_ / "k.ini", sets);
    }
    TestFolder folder_;
};

TEST_F(ExhibitFiles, AreThoseThatItNamesThereOrNot) {
    EXPECT_THAT(files_of("[atlas]\nfile = own.png\n"
                         "[scene]\nmaterials = crayons, paints.csv#red, cc-blue, more/paints.TXT\n"
                         "[lamp.1]\nspectrum = a,b#1.csv#tube\n[lamp.2]\nspectrum = planck:2856\n"
                         "[object.ball]\nmaterial = ../paint.csv\nkey_map = keys,1.png\n"
                         "[kiosk]\nstrings = strings\nlamps = F11, ./own lamp.csv, 3\nlanguage = de\n"
                         "[tour.1]\nmaterials = tour.csv\ncaption = see notes.txt\n"),
                ElementsAre(folder_ / "k.ini", folder_ / "own.png", folder_ / "paints.csv",
                            folder_ / "more/paints.TXT", folder_ / "a,b#1.csv",
                            folder_.path().parent_path() / "paint.csv", folder_ / "keys,1.png",
                            folder_ / "strings", folder_ / "own lamp.csv", folder_ / "tour.csv"));
}

TEST_F(ExhibitFiles, WhatIsWrongWithTheExhibitDoesNotMatter) {
    EXPECT_THAT(files_of("[scene]\nkind = patches\nmaterials = no-such-paint, own.csv\n"
                         "[lamp.1]\nspectrum = lamp.csv\nstrength = -1\n"),
                ElementsAre(folder_ / "k.ini", folder_ / "own.csv", folder_ / "lamp.csv"));
}

TEST_F(ExhibitFiles, AreTheIniAloneWhereItIsNotUnderstood) {
    EXPECT_THAT(files_of("[lamp.1]\nspectrum = lamp.csv\nstrenght = 1\n"), ElementsAre(folder_ / "k.ini"));
    EXPECT_THAT(files_of("[lamp.1]\nspectrum = lamp.csv\n[["), ElementsAre(folder_ / "k.ini"));
    EXPECT_THAT(exhibit_files(folder_ / "none.ini"), ElementsAre(folder_ / "none.ini"));
}

TEST_F(ExhibitFiles, OfSetsFromTheCurrentFolder) {
    EXPECT_THAT(
        files_of("[lamp.1]\nspectrum = lamp.csv\n", {"lamp.1.spectrum=tube.csv", "kiosk.strings=/words"}),
        ElementsAre(folder_ / "k.ini", "tube.csv", "/words"));
    EXPECT_THAT(exhibit_files("", {"lamp.1.spectrum=tube.csv"}), ElementsAre("tube.csv"));
    EXPECT_THAT(exhibit_files(""), IsEmpty());
}

} // namespace
} // namespace metamer
