// Structured lines for the journal: one event a line, seldom enough to be read.
#pragma once

#include <chrono>
#include <functional>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>

namespace metamer {

/// syslog(3)'s priorities; sd-daemon(3) reads them from `<N>` before a line.
enum class Priority { error = 3, warning = 4, notice = 5, info = 6 };

struct LogField {
    std::string_view key;
    std::string value;
};

/// Writes `event=KIND key=value ...`; a value stands in double quotes where it is empty or holds blanks,
/// quotes,
/// `=`, `\`, control characters or what is not UTF-8 (escaped as \n, \", \\, \xHH). UTF-8 stays. At most one
/// line per event kind a minute: what is kept back is counted, and the kind's next line says `suppressed=N`.
/// For one thread.
class Log {
public:
    using Clock = std::function<std::chrono::steady_clock::time_point()>;
    using Sink = std::function<void(std::string_view line)>;

    /// To stderr; with `<N>` before each line where JOURNAL_STREAM says that stderr is the journal
    /// (systemd.exec(5)).
    Log();
    Log(Sink sink, Clock clock, bool priorities);

    void write(Priority priority, std::string_view event, std::initializer_list<LogField> fields = {});

private:
    struct Kind {
        std::chrono::steady_clock::time_point last;
        int suppressed = 0;
    };
    Sink sink_;
    Clock clock_;
    bool priorities_;
    std::map<std::string, Kind, std::less<>> kinds_;
};

} // namespace metamer
