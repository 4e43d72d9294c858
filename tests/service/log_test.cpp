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
