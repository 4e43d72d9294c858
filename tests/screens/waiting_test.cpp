// A kiosk that finds no screen, and is told to wait for one.
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <gmock/gmock.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

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

/// `metamer run 2>&1 | logger`, and the logger goes.
TEST(WaitingKiosk, OutlivesTheReaderOfItsLog) {
    const test::TemporaryFolder folder;
    const std::string pipe = folder / "log.txt";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    test::RunningKiosk kiosk(folder.path(), {"--wait"}, kNoScreen);
    std::string heard;
    char bytes[4096];
    pollfd ready{reader, POLLIN, 0};
    while (heard.find("event=no_display") == std::string::npos && poll(&ready, 1, 40'000) == 1)
        if (const auto size = read(reader, bytes, sizeof bytes); size > 0)
            heard.append(bytes, static_cast<std::size_t>(size));
        else if (size == 0)
            break;
    std::filesystem::remove(pipe);
    close(reader);
    EXPECT_THAT(heard, HasSubstr("event=no_display"));
    EXPECT_EQ(kiosk.end_by(SIGTERM), 0) << "it has a last word";
}

/// At one line a kind and minute, as all that happens; what was kept back until then, at the end.
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
    EXPECT_THAT(log, HasSubstr("event=doubt doubt=\"exhibit.ini:6: wider.csv: "));
    EXPECT_LT(log.find("event=no_display"), log.rfind("event=doubt")) << log;
    EXPECT_THAT(log, testing::Not(HasSubstr("metamer: "))) << "every line is an event";
}

} // namespace
} // namespace metamer
