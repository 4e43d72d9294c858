// A kiosk that finds no screen, and is told to wait for one.
#include <csignal>
#include <gmock/gmock.h>

#include "screens/running_kiosk.h"
#include "service/temporary_folder.h"

namespace metamer {
namespace {

using testing::HasSubstr;

const std::map<std::string, std::string> kNoScreen{{"SDL_VIDEODRIVER", "x11"}, {"DISPLAY", ":4711"}};

TEST(WaitingKiosk, EndsInOrder) {
    const test::TemporaryFolder folder;
    test::RunningKiosk kiosk(folder.path(), {"--wait"}, kNoScreen);
    kiosk.await_log("event=no_display");
    EXPECT_EQ(kiosk.end_by(SIGTERM), 0) << kiosk.log();
    EXPECT_THAT(kiosk.log(), HasSubstr("event=stopped"));
}

/// At one line a kind and minute, as all that happens.
TEST(WaitingKiosk, LogsWhatItDoubts) {
    const test::TemporaryFolder folder;
    test::write(folder / "exhibit.ini", "[scene]\nkind = patches\n[lamp.1]\nspectrum = wide.csv\n"
                                        "[compare]\nright.lamp = wider.csv\n");
    test::write(folder / "wide.csv", "wavelength_nm,wide\n300,2\n1000,2\n");
    test::write(folder / "wider.csv", "wavelength_nm,wider\n300,2\n2000,2\n");
    test::RunningKiosk kiosk(folder.path(), {"--wait", "exhibit.ini"}, kNoScreen);
    kiosk.await_log("event=no_display");
    EXPECT_EQ(kiosk.end_by(SIGTERM), 0) << kiosk.log();
    const std::string log = kiosk.log();
    EXPECT_THAT(log, HasSubstr("event=doubt doubt=\"exhibit.ini:4: wide.csv: "));
    EXPECT_EQ(log.find("event=doubt"), log.rfind("event=doubt")) << log;
    EXPECT_THAT(log, testing::Not(HasSubstr("metamer: "))) << "every line is an event";
}

} // namespace
} // namespace metamer
