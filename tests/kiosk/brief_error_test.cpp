#include "kiosk/brief_error.h"

#include <gtest/gtest.h>

namespace metamer {
namespace {

TEST(BriefError, IsTheFileItsLineAndTheCause) {
    EXPECT_EQ(brief_error("Not taken over: cannot read /srv/museum/kiosk.ini:12: strength = -1 is below 0"),
              "Not taken over: kiosk.ini:12: strength = -1 is below 0");
    EXPECT_EQ(brief_error("cannot read /srv/our museum/kiosk.ini:12: text that is not UTF-8"),
              "kiosk.ini:12: text that is not UTF-8");
}

TEST(BriefError, KeepsTheVerbWhereThereIsNoLine) {
    EXPECT_EQ(brief_error("cannot read /srv/museum/kiosk.ini: Permission denied"),
              "cannot read kiosk.ini: Permission denied");
    EXPECT_EQ(brief_error("cannot plan object \"wedge\" of /srv/m/media.ini: no method holds 0.01"),
              "cannot plan object \"wedge\" of media.ini: no method holds 0.01");
}

TEST(BriefError, LeavesOutOfALongValueAndNeverOfTheCause) {
    EXPECT_EQ(
        brief_error("cannot read k.ini:3: lamps = E, D65, A2800, white-LED, F11, krypton, far.csv: far.csv: "
                    "there is no such file"),
        "k.ini:3: lamps = E, D65, A280…: far.csv: there is no such file");
    EXPECT_EQ(brief_error("cannot read k.ini:3: lamps = E, far.csv: far.csv: there is no such file"),
              "k.ini:3: lamps = E, far.csv: far.csv: there is no such file");
    const std::string spoken =
        "cannot read k.ini:3: the key = sign of a line that is longer than a value: why";
    EXPECT_EQ(brief_error(spoken), "k.ini:3: the key = sign of a line that is longer than a value: why");
}

TEST(BriefError, CutsNoCharacterInTwo) {
    EXPECT_EQ(brief_error("cannot read k.ini:3: file = äääääxxääääääää: none"),
              "k.ini:3: file = äääääxx…: none");
    EXPECT_EQ(brief_error("cannot read k.ini:3: file = xäääääääääääää: none"),
              "k.ini:3: file = xäääää…: none");
}

TEST(BriefError, LeavesOtherWordsAlone) {
    for (const char* words :
         {"", "cannot", "cannot ", "cannot read", "cannot read x", "gone", ": ", "cannot : "})
        EXPECT_EQ(brief_error(words), words);
}

} // namespace
} // namespace metamer
