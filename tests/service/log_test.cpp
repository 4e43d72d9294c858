#include "service/log.h"

#include <cstdlib>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace metamer {
namespace {

using testing::ElementsAre;
using namespace std::chrono_literals;

/// A log with a clock that the test turns.
class LogTest : public testing::Test {
protected:
    Log log(bool priorities = false) {
        return {[this](std::string_view line) { lines_.emplace_back(line); }, [this] { return now_; },
                priorities};
    }
    /// How a value stands in its line.
    std::string written(const std::string& value) {
        Log one = log();
        one.write(Priority::info, "a", {{"v", value}});
        return lines_.back().substr(std::string("event=a v=").size());
    }

    std::chrono::steady_clock::time_point now_{1h};
    std::vector<std::string> lines_;
};

TEST_F(LogTest, WritesFieldsInOrder) {
    Log out = log();
    out.write(Priority::notice, "start", {{"driver", "x11"}, {"size", "1280x720"}});
    out.write(Priority::notice, "ready");
    EXPECT_THAT(lines_, ElementsAre("event=start driver=x11 size=1280x720", "event=ready"));
}

TEST_F(LogTest, SaysThePriorityAsSystemdReadsIt) {
    Log out = log(true);
    out.write(Priority::error, "a");
    out.write(Priority::info, "b", {{"c", "d"}});
    EXPECT_THAT(lines_, ElementsAre("<3>event=a", "<6>event=b c=d"));
}

TEST_F(LogTest, QuotesWhatWouldBeReadOtherwise) {
    EXPECT_EQ(written("plain-1.5%"), "plain-1.5%");
    EXPECT_EQ(written(""), R"("")");
    EXPECT_EQ(written("two words"), R"("two words")");
    EXPECT_EQ(written("a=b"), R"("a=b")");
    EXPECT_EQ(written(R"(say "no")"), R"("say \"no\"")");
    EXPECT_EQ(written(R"(C:\a)"), R"("C:\\a")");
    EXPECT_EQ(written("one\ntwo"), R"("one\ntwo")");
    EXPECT_EQ(written("\t\x1b[31m\x7f"), R"("\x09\x1b[31m\x7f")");
    EXPECT_EQ(written(std::string("a\0b", 3)), R"("a\x00b")");
}

TEST_F(LogTest, KeepsUtf8AndNothingElseBeyondAscii) {
    EXPECT_EQ(written("Glühlampe"), "Glühlampe");
    EXPECT_EQ(written("灯 ランプ"), "\"灯 ランプ\"");
    EXPECT_EQ(written("lat\xedn"), R"("lat\xedn")");
    EXPECT_EQ(written("ü\xff"), R"("\xc3\xbc\xff")");
    // U+009B is a terminal's CSI.
    EXPECT_EQ(written("ü\xc2\x9b"), "\"ü\\xc2\\x9b\"");
}

TEST_F(LogTest, WritesAKindOnceAMinute) {
    Log out = log();
    out.write(Priority::error, "refused", {{"n", "1"}});
    now_ += 59s;
    out.write(Priority::error, "refused", {{"n", "2"}});
    out.write(Priority::error, "refused", {{"n", "3"}});
    out.write(Priority::error, "other");
    now_ += 1s;
    out.write(Priority::error, "refused", {{"n", "4"}});
    now_ += 60s;
    out.write(Priority::error, "refused", {{"n", "5"}});
    EXPECT_THAT(lines_, ElementsAre("event=refused n=1", "event=other", "event=refused n=4 suppressed=2",
                                    "event=refused n=5"));
}

TEST_F(LogTest, AMinuteBeginsWithTheLineThatWasWritten) {
    Log out = log();
    for (int second = 0; second < 180; ++second, now_ += 1s)
        out.write(Priority::info, "tick");
    EXPECT_THAT(lines_, ElementsAre("event=tick", "event=tick suppressed=59", "event=tick suppressed=59"));
}

/// What is kept back is told late, and a line of its kind begins another minute.
TEST_F(LogTest, TellsTheLatestWhenTheMinuteIsOver) {
    Log out = log();
    out.write(Priority::error, "refused", {{"n", "1"}});
    now_ += 10s;
    out.write(Priority::error, "refused", {{"n", "2"}});
    now_ += 10s;
    out.write(Priority::error, "refused", {{"n", "3"}});
    now_ += 39s;
    out.flush();
    EXPECT_THAT(lines_, ElementsAre("event=refused n=1"));
    now_ += 1s;
    out.flush();
    out.flush();
    EXPECT_THAT(lines_, ElementsAre("event=refused n=1", "event=refused n=3 suppressed=1 late_s=40"));
    now_ += 59s;
    out.write(Priority::error, "refused", {{"n", "4"}});
    EXPECT_EQ(lines_.size(), 2u);
    now_ += 1s;
    out.write(Priority::info, "other");
    EXPECT_EQ(lines_.at(2), "event=refused n=4 late_s=1") << "whatever is written next";
}

TEST_F(LogTest, SaysWhenSomethingIsDue) {
    Log out = log();
    EXPECT_EQ(out.due_in_s(), std::nullopt);
    out.write(Priority::info, "a", {{"n", "1"}});
    EXPECT_EQ(out.due_in_s(), std::nullopt) << "nothing is kept back";
    now_ += 20s;
    out.write(Priority::info, "b", {{"n", "1"}});
    out.write(Priority::info, "b", {{"n", "2"}});
    EXPECT_EQ(out.due_in_s(), 60.0);
    out.write(Priority::info, "a", {{"n", "2"}});
    EXPECT_EQ(out.due_in_s(), 40.0) << "the first of two";
    now_ += 50s;
    EXPECT_EQ(out.due_in_s(), 0.0) << "overdue";
    out.flush();
    EXPECT_EQ(out.due_in_s(), 10.0);
}

TEST_F(LogTest, RepeatsNothing) {
    Log out = log();
    for (int i = 0; i < 3; ++i, now_ += 1s)
        out.write(Priority::warning, "hot", {{"c", "90"}});
    EXPECT_EQ(out.due_in_s(), std::nullopt);
    out.write(Priority::warning, "hot", {{"c", "91"}});
    EXPECT_NE(out.due_in_s(), std::nullopt);
    out.write(Priority::warning, "hot", {{"c", "90"}});
    EXPECT_EQ(out.due_in_s(), std::nullopt) << "as was told";
    now_ += 60s;
    out.write(Priority::warning, "hot", {{"c", "92"}});
    EXPECT_THAT(lines_, ElementsAre("event=hot c=90", "event=hot c=92 suppressed=4"));
}

/// Wrong, mended, wrong again and mended again, all within a minute: the log must not end with `refused`.
TEST_F(LogTest, EndsWithWhatHolds) {
    Log out = log();
    const auto after = [&](std::chrono::seconds pause, std::string_view event, const char* text) {
        now_ += pause;
        out.write(Priority::info, event, {{"text", text}});
    };
    after(0s, "reloaded", "kiosk.ini");
    after(10s, "reload_refused", "line 3");
    after(10s, "reloaded", "kiosk.ini");
    EXPECT_EQ(lines_.back(), "event=reload_refused text=\"line 3\"");
    now_ += 40s;
    out.flush();
    EXPECT_EQ(lines_.back(), "event=reloaded text=kiosk.ini late_s=40");
    after(5s, "reload_refused", "line 4");
    EXPECT_EQ(lines_.back(), "event=reloaded text=kiosk.ini late_s=40");
    after(10s, "reload_refused", "line 5");
    EXPECT_EQ(lines_.back(), "event=reload_refused text=\"line 5\" suppressed=1");
    after(5s, "reload_refused", "line 6");
    after(50s, "reloaded", "kiosk.ini");
    EXPECT_EQ(lines_.back(), "event=reloaded text=kiosk.ini");
    EXPECT_EQ(out.due_in_s(), std::nullopt) << "what was wrong with line 6 is over";
}

TEST_F(LogTest, NeverSpeaksOfTheDisplayThatWasAway) {
    Log out = log();
    out.write(Priority::warning, "no_display", {{"error", "no /dev/dri"}});
    out.write(Priority::warning, "no_display", {{"error", "no connector"}});
    out.write(Priority::info, "shown");
    now_ += 60s;
    out.flush();
    out.write(Priority::warning, "display_gone");
    out.write(Priority::notice, "display_back");
    out.write(Priority::warning, "display_gone");
    out.write(Priority::notice, "display_back");
    now_ += 60s;
    out.flush();
    EXPECT_THAT(lines_, ElementsAre("event=no_display error=\"no /dev/dri\"", "event=shown",
                                    "event=display_gone", "event=display_back"));
}

TEST_F(LogTest, KeepsNothingToItselfAtTheEnd) {
    {
        Log out = log(true);
        out.write(Priority::error, "refused", {{"n", "1"}});
        now_ += 5s;
        out.write(Priority::warning, "refused", {{"n", "2"}});
        now_ += 2s;
        out.end();
        out.write(Priority::info, "stopped", {{"n", "1"}});
        out.write(Priority::info, "stopped", {{"n", "2"}});
    }
    EXPECT_THAT(lines_, ElementsAre("<3>event=refused n=1", "<4>event=refused n=2 late_s=2",
                                    "<6>event=stopped n=1", "<6>event=stopped n=2 late_s=0"));
}

/// What a default log says on stderr where JOURNAL_STREAM is `stream`; empty: where it names stderr's own
/// file.
std::string on_stderr(std::string stream) {
    testing::internal::CaptureStderr();
    struct stat status {};
    fstat(STDERR_FILENO, &status);
    if (stream.empty())
        stream = std::to_string(status.st_dev) + ":" + std::to_string(status.st_ino);
    setenv("JOURNAL_STREAM", stream.c_str(), 1);
    Log().write(Priority::warning, "hot", {{"c", "90"}});
    unsetenv("JOURNAL_STREAM");
    return testing::internal::GetCapturedStderr();
}

TEST(Log, KnowsTheJournal) {
    EXPECT_EQ(on_stderr(""), "<4>event=hot c=90\n");
    EXPECT_EQ(on_stderr("8:1"), "event=hot c=90\n");
}

} // namespace
} // namespace metamer
