// The watchdog sees what a broken GPU does: here a color mask that hides red from the drawing.
#include "kiosk/picture_watch.h"

#include <GLES2/gl2.h>
#include <gmock/gmock.h>

#include "base/error.h"
#include "kiosk/kiosks.h"

namespace metamer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::MatchesRegex;

void break_red(bool broken) {
    glColorMask(broken ? GL_FALSE : GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

TEST(PictureWatch, SeesRightColors) {
    const Surfaceless context;
    PictureWatch watch;
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(watch.look(), "");
}

TEST(PictureWatch, SeesAWrongColorAndWhenItIsGone) {
    const Surfaceless context;
    PictureWatch watch;
    break_red(true);
    EXPECT_THAT(watch.look(),
                MatchesRegex("spectral shows [0-9]+ [0-9]+ [0-9]+ where [0-9]+ [0-9]+ [0-9]+ belongs"));
    break_red(false);
    EXPECT_EQ(watch.look(), "");
}

TEST(PictureWatch, SeesAPictureThatIsStuck) {
    const Surfaceless context;
    PictureWatch watch;
    ASSERT_EQ(watch.look(), "");
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    EXPECT_THAT(watch.look(), HasSubstr("belongs"));
}

TEST(PictureWatch, SeesAGlError) {
    const Surfaceless context;
    PictureWatch watch;
    glEnable(0xFFFF);
    EXPECT_THAT(watch.look(), HasSubstr("GL"));
    EXPECT_EQ(watch.look(), "");
}

std::string watched() {
    return patches("idle_s = 3600\nwatch_s = 30\n");
}

TEST(Watchdog, LooksWithoutShowingAFrame) {
    TestKiosk at(watched());
    const long frames = at.stage.frames_shown();
    at.pass(600);
    EXPECT_EQ(at.stage.frames_shown(), frames);
    EXPECT_THAT(at.lines, ElementsAre(HasSubstr("event=shown")));
}

TEST(Watchdog, MakesEverythingAnewOnce) {
    TestKiosk at(watched());
    at.pass(120);
    EXPECT_EQ(at.kiosk.rebuilds(), 0);
    const std::vector<std::uint8_t> before = at.stage.read_rgba();
    break_red(true);
    at.pass(31);
    EXPECT_EQ(at.kiosk.rebuilds(), 1);
    EXPECT_THAT(at.lines,
                ElementsAre(HasSubstr("event=shown"), HasSubstr("event=picture_wrong what=\"spectral shows"),
                            HasSubstr("event=context_rebuilt why=\"the picture was wrong\"")));
    at.pass(600);
    EXPECT_EQ(at.kiosk.rebuilds(), 1) << "a new context draws as it should";
    EXPECT_EQ(at.stage.read_rgba(), before);
    break_red(true);
    at.pass(31);
    EXPECT_EQ(at.kiosk.rebuilds(), 2) << "and the next time it is made anew again";
}

TEST(Watchdog, GivesUpWhereThePictureStaysWrong) {
    TestKiosk at(watched());
    at.pass(10);
    at.stage.on_idle([] { break_red(true); });
    std::string error;
    try {
        at.pass(100);
    } catch (const Error& thrown) {
        error = thrown.what();
        EXPECT_EQ(thrown.status(), Exit::failure);
    }
    EXPECT_THAT(error, HasSubstr("cannot go on drawing: spectral shows"));
    EXPECT_THAT(error, HasSubstr("even after everything was made anew"));
    EXPECT_EQ(at.kiosk.rebuilds(), 1);
    EXPECT_LT(at.stage.now_s(), 32) << "the second look follows at once";
}

TEST(Watchdog, ComesAndGoesWithTheSetting) {
    TestKiosk at(watched());
    at.text = patches("idle_s = 3600\n");
    at.turn(ReloadEvent{});
    break_red(true);
    at.pass(100);
    EXPECT_EQ(at.kiosk.rebuilds(), 0) << "nobody looks";
    break_red(false);
    at.text = watched();
    at.turn(ReloadEvent{});
    break_red(true);
    at.pass(31);
    EXPECT_EQ(at.kiosk.rebuilds(), 1);
}

} // namespace
} // namespace metamer
