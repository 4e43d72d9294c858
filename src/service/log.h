// Structured lines for the journal: one event a line, seldom enough to be read.
#pragma once

#include <chrono>
#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
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
/// quotes, `=`, `\`, control characters or what is not UTF-8 (escaped as \n, \", \\, \xHH). UTF-8 stays.
///
/// At most one line per event kind a minute. The last line is true all the same: of what is kept back, the
/// latest is written when its kind's minute is over (`late_s=N`, whole seconds), unless it says what the last
/// line said. Kinds that undo each other (reloaded, reload_refused; shown, no_display, display_gone,
/// display_back) are one in this: what is kept back of one goes when another comes. What is never written is
/// counted: the kind's next line says `suppressed=N`. For one thread.
class Log {
public:
    using Clock = std::function<std::chrono::steady_clock::time_point()>;
    using Sink = std::function<void(std::string_view line)>;

    /// To stderr; with `<N>` before each line where JOURNAL_STREAM says that stderr is the journal
    /// (systemd.exec(5)).
    Log();
    Log(Sink sink, Clock clock, bool priorities);
    Log(const Log&) = delete;
    Log& operator=(const Log&) = delete;
    /// As end().
    ~Log();

    void write(Priority priority, std::string_view event, std::initializer_list<LogField> fields = {});

    /// Writes what is kept back and whose minute is over.
    void flush();
    /// How many seconds from now flush() has something to write; none while nothing is kept back.
    std::optional<double> due_in_s() const;
    /// Writes all that is kept back: at the end no minute is waited for.
    void end();

private:
    using Time = std::chrono::steady_clock::time_point;
    struct Kind {
        Time free_from; ///< when its minute is over
        int suppressed = 0;
    };
    struct Kept {
        Kind* kind;
        std::string line;
        Time since;
    };
    struct Subject {
        std::string told; ///< its last line, as it was before suppressed and late_s
        std::optional<Kept> kept;
    };
    void tell(Subject& subject, Kind& kind, std::string line, const std::string& late);
    void tell_kept(Subject& subject);

    Sink sink_;
    Clock clock_;
    bool priorities_;
    std::map<std::string, Kind, std::less<>> kinds_;
    std::map<std::string, Subject, std::less<>> subjects_;
};

} // namespace metamer
