// What the outside does to a kiosk that runs: signals, changed files, nobody there, nothing to do.
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>
#include <unistd.h>

#include "screens/on_screen.h"
#include "service/notify_socket.h"

namespace metamer {
namespace {

using test::Json;
using test::widget;

constexpr PxSize kScreen{640, 480};

class Service : public test::OnScreen {
protected:
    using Clock = std::chrono::steady_clock;

    /// For people: how long it took is the machine's affair.
    static void print(const std::string& what, Clock::time_point since) {
        std::cout << what << ": "
                  << std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - since).count()
                  << " ms\n";
    }
    /// An exhibit with its lamps in another order.
    static std::string with_shelf(const std::string& lamps) {
        std::string text = test::kPatches;
        const std::string written = "lamps = D65, F11, A2800, krypton";
        return text.replace(text.find(written), written.size(), "lamps = " + lamps);
    }
    static auto first_lamp(const std::string& name) {
        return [name](const Json& now) { return widget(now, "lamp", 0).at("text") == name; };
    }
};

TEST_F(Service, EndsBySignals) {
    start(kScreen);
    const auto began = Clock::now();
    EXPECT_EQ(kiosk_->end_by(SIGTERM), 0) << kiosk_->log();
    print("from SIGTERM to the end", began);
    EXPECT_THAT(kiosk_->log(), testing::HasSubstr("event=stopped"));
    kiosk_.emplace(folder_, std::vector<std::string>{"exhibit.ini"});
    kiosk_->told();
    EXPECT_EQ(kiosk_->end_by(SIGINT), 0) << kiosk_->log();
}

// Whoever starts it anew where it hangs hears of it all the time.
TEST_F(Service, TellsSystemdThatItLives) {
    const test::NotifySocket systemd;
    const auto await = [&](const std::string& word) {
        constexpr int kLong_ms = 40'000;
        std::string all;
        for (std::string said; (said = systemd.heard(kLong_ms)) != "";) {
            if (said.starts_with(word))
                return;
            all += said + "; ";
        }
        FAIL() << "never said " << word << ": " << all << kiosk_->log();
    };
    open_screen(kScreen);
    start_kiosk(test::kPatches, 0, {{"NOTIFY_SOCKET", systemd.path()}, {"WATCHDOG_USEC", "4000000"}});
    ASSERT_NO_FATAL_FAILURE(await("READY=1"));
    ASSERT_NO_FATAL_FAILURE(await("STATUS=running"));
    for (int i = 0; i < 3; ++i) // nothing happens meanwhile
        ASSERT_NO_FATAL_FAILURE(await("WATCHDOG=1"));
    kiosk_->send(SIGHUP);
    ASSERT_NO_FATAL_FAILURE(await("RELOADING=1"));
    ASSERT_NO_FATAL_FAILURE(await("READY=1"));
    ASSERT_NO_FATAL_FAILURE(await("WATCHDOG=1"));
    EXPECT_EQ(kiosk_->end_by(SIGTERM), 0) << kiosk_->log();
    ASSERT_NO_FATAL_FAILURE(await("STOPPING=1"));
}

TEST_F(Service, ShowsAWindowWhereAskedTo) {
    start(kScreen);
    const auto size = [&] {
        const Json told = kiosk_->told();
        return std::pair(told.at("width_px"), told.at("height_px"));
    };
    EXPECT_EQ(size(), std::pair(Json(640), Json(480))) << "all of the screen";
    write_exhibit(test::kPatches);
    kiosk_.emplace(folder_, std::vector<std::string>{"exhibit.ini", "--size", "320x240"});
    EXPECT_EQ(size(), std::pair(Json(320), Json(240)));
    write_exhibit("[display]\nfullscreen = no\nwidth = 400\nheight = 300\n" + std::string(test::kPatches));
    kiosk_.emplace(folder_, std::vector<std::string>{"exhibit.ini"});
    EXPECT_EQ(size(), std::pair(Json(400), Json(300)));
}

TEST_F(Service, TakesChangesOver) {
    start(kScreen);
    kiosk_->await("D65 first", first_lamp("Daylight"));
    auto began = Clock::now();
    write_exhibit(with_shelf("A2800, D65"));
    Json told = kiosk_->await("A2800 first", first_lamp("Light bulb"));
    print("from a changed file to its picture", began);
    EXPECT_TRUE(widget(told, "lamp", 2).is_null());
    EXPECT_TRUE(widget(told, "notice").is_null());

    write_exhibit(with_shelf("A2800, no-such-lamp"));
    told = kiosk_->await("a notice", [](const Json& now) { return !widget(now, "notice").is_null(); });
    EXPECT_THAT(widget(told, "notice").at("text").get<std::string>(),
                testing::AllOf(testing::HasSubstr("exhibit.ini:12"), testing::HasSubstr("no-such-lamp")));
    EXPECT_EQ(widget(told, "lamp", 1).at("text"), "Daylight");
    expect_all_inside(told);
    EXPECT_THAT(kiosk_->log(), testing::HasSubstr("event=reload_refused"));

    // Also by hand; and the notice goes.
    write_exhibit(with_shelf("krypton, D65"));
    began = Clock::now();
    kiosk_->send(SIGHUP);
    told = kiosk_->await("krypton first", [](const Json& now) {
        return widget(now, "lamp", 0).at("text") != "Light bulb" && widget(now, "notice").is_null();
    });
    print("from SIGHUP to the picture", began);
    EXPECT_EQ(wrong_colors(), "");
    EXPECT_EQ(kiosk_->end_by(SIGTERM), 0) << kiosk_->log();
}

/// What mends a refused exhibit need not be its INI file.
TEST_F(Service, AwaitsWhatARefusedExhibitNames) {
    start(kScreen);
    const auto noticed = [](const std::string& what) {
        return [what](const Json& now) {
            const Json notice = widget(now, "notice");
            return !notice.is_null() && notice.at("text").get<std::string>().find(what) != std::string::npos;
        };
    };
    write_exhibit(with_shelf("A2800, own.csv"));
    kiosk_->await("a lamp that is not there", noticed("no such file"));
    std::ofstream(folder_ / "own.csv") << "wavelength_nm,own\n400,1\n390,1\n";
    kiosk_->await("a lamp that is wrong", noticed("own.csv:3"));
    std::ofstream(folder_ / "own.csv") << "wavelength_nm,own\n390,1\n700,1\n";
    const Json told = kiosk_->await("A2800 first", first_lamp("Light bulb"));
    EXPECT_TRUE(widget(told, "notice").is_null());
    EXPECT_EQ(kiosk_->end_by(SIGTERM), 0) << kiosk_->log();
}

TEST_F(Service, GoesOnATour) {
    start(kScreen,
          std::string(test::kPatches) +
              "idle_s = 5\n[tour.1]\nlamp = A2800\nsplit = 0.25\nseconds = 60\ncaption = Warm light\n");
    tap("expert");
    kiosk_->await("the expert's panel",
                  [](const Json& now) { return !widget(now, "expert-panel").is_null(); });
    Json told = kiosk_->await("the tour", [](const Json& now) { return now.at("phase") == "tour"; });
    // What the visitor left open is gone, the step stands.
    EXPECT_TRUE(widget(told, "expert-panel").is_null());
    EXPECT_EQ(widget(told, "caption").at("text"), "Warm light");
    EXPECT_EQ(told.at("split"), 0.25);
    EXPECT_EQ(wrong_colors({"lamp.1.spectrum=A2800"}), "");
    tap("lamp", 3);
    told =
        kiosk_->await("the visitor's lamp", [](const Json& now) { return widget(now, "lamp", 3).at("on"); });
    EXPECT_EQ(told.at("phase"), "visitor");
    EXPECT_TRUE(widget(told, "caption").is_null());
    EXPECT_EQ(told.at("split"), 0.5);
}

/// utime + stime of proc_pid_stat(5), s.
double cpu_s(pid_t process) {
    std::ifstream in("/proc/" + std::to_string(process) + "/stat");
    std::string text;
    std::getline(in, text);
    std::istringstream fields(text.substr(text.rfind(')') + 1));
    std::string skipped;
    for (int i = 0; i < 11; ++i) // from the third field to the thirteenth
        fields >> skipped;
    double user = 0, system = 0;
    fields >> user >> system;
    return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

TEST_F(Service, RestsWhileNothingChanges) {
    start(kScreen);
    EXPECT_EQ(wrong_colors(), "");
    constexpr double kRest_s = 10;
    const double before = cpu_s(kiosk_->id());
    ASSERT_GT(before, 0);
    std::this_thread::sleep_for(std::chrono::duration<double>(kRest_s));
    const double share = (cpu_s(kiosk_->id()) - before) / kRest_s;
    std::cout << "at rest: " << 100 * share << " % of a core\n";
    // A kiosk that draws all the time, or waits in a circle, is far above that.
    EXPECT_LT(share, 0.05);
}

} // namespace
} // namespace metamer
