// A kiosk that finds no screen, and is told to wait for one.
#include <csignal>
#include <gmock/gmock.h>

#include "screens/running_kiosk.h"
#include "service/temporary_folder.h"

namespace metamer {
namespace {

using testing::HasSubstr;

TEST(WaitingKiosk, EndsInOrder) {
    const test::TemporaryFolder folder;
    test::RunningKiosk kiosk(folder.path(), {"--wait"}, {{"SDL_VIDEODRIVER", "x11"}, {"DISPLAY", ":4711"}});
    kiosk.await_log("event=no_display");
    EXPECT_EQ(kiosk.end_by(SIGTERM), 0) << kiosk.log();
    EXPECT_THAT(kiosk.log(), HasSubstr("event=stopped"));
}

} // namespace
} // namespace metamer
