#include "service/log.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

#include "base/utf8.h"

namespace metamer {

namespace {

constexpr auto kBetween = std::chrono::minutes(1);

/// systemd.exec(5): JOURNAL_STREAM is `device:inode` of the journal's stream; a stderr that was led elsewhere
/// since has others.
bool stderr_is_journal() {
    const char* stream = std::getenv("JOURNAL_STREAM");
    struct stat status {};
    return stream != nullptr && fstat(STDERR_FILENO, &status) == 0 &&
           std::to_string(status.st_dev) + ":" + std::to_string(status.st_ino) == stream;
}

/// In one write(2), so that lines of several processes do not mix.
void write_stderr(std::string_view line) {
    const std::string whole = std::string(line) + '\n';
    // A log that nobody takes is no reason to stop.
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, whole.data(), whole.size());
}

bool is_control(unsigned char byte) {
    return byte < 0x20 || byte == 0x7f;
}

/// U+0080 .. U+009F are 0xc2 and a second byte: terminals obey them.
bool is_c1_control(std::string_view text, std::size_t at) {
    return at + 1 < text.size() && text[at] == '\xc2' && static_cast<unsigned char>(text[at + 1]) < 0xa0;
}

void append_hex(std::string& line, unsigned char byte) {
    constexpr char digits[] = "0123456789abcdef";
    line += {'\\', 'x', digits[byte >> 4], digits[byte & 15]};
}

std::string quoted(std::string_view value) {
    const bool utf8 = is_utf8(value);
    std::string text = "\"";
    for (std::size_t i = 0; i < value.size(); ++i) {
        const auto byte = static_cast<unsigned char>(value[i]);
        if (byte == '\n') {
            text += "\\n";
        } else if (byte == '"' || byte == '\\') {
            text += {'\\', value[i]};
        } else if (is_control(byte) || (!utf8 && byte >= 0x80)) {
            append_hex(text, byte);
        } else if (is_c1_control(value, i)) {
            append_hex(text, byte);
            append_hex(text, static_cast<unsigned char>(value[++i]));
        } else {
            text += value[i];
        }
    }
    return text + '"';
}

bool needs_quotes(std::string_view value) {
    return value.empty() || !is_utf8(value) || has_control(value) ||
           value.find_first_of(" \"=\\") != value.npos;
}

std::string written(std::string_view value) {
    return needs_quotes(value) ? quoted(value) : std::string(value);
}

/// What an event tells of; most are alone with it.
std::string_view subject_of(std::string_view event) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kSubjects{
        {{"reloaded", "exhibit"},
         {"reload_refused", "exhibit"},
         {"shown", "display"},
         {"no_display", "display"},
         {"display_gone", "display"},
         {"display_back", "display"}}};
    const auto found =
        std::ranges::find(kSubjects, event, &std::pair<std::string_view, std::string_view>::first);
    return found == kSubjects.end() ? event : found->second;
}

} // namespace

Log::Log() : Log(write_stderr, std::chrono::steady_clock::now, stderr_is_journal()) {}

Log::Log(Sink sink, Clock clock, bool priorities)
    : sink_(std::move(sink)), clock_(std::move(clock)), priorities_(priorities) {}

Log::~Log() {
    end();
}

void Log::write(Priority priority, std::string_view event, std::initializer_list<LogField> fields) {
    Subject& subject = subjects_[std::string(subject_of(event))];
    subject.kept.reset();
    flush();
    std::string line = priorities_ ? '<' + std::to_string(static_cast<int>(priority)) + '>' : std::string();
    line += "event=" + written(event);
    for (const LogField& field : fields)
        line.append(" ").append(field.key).append("=").append(written(field.value));
    const Time now = clock_();
    Kind& kind = kinds_.try_emplace(std::string(event), Kind{now}).first->second;
    if (now >= kind.free_from) {
        tell(subject, kind, std::move(line), "");
        return;
    }
    ++kind.suppressed;
    if (line != subject.told)
        subject.kept = {&kind, std::move(line), now};
}

void Log::flush() {
    const Time now = clock_();
    for (auto& [name, subject] : subjects_)
        if (subject.kept && now >= subject.kept->kind->free_from)
            tell_kept(subject);
}

void Log::end() {
    for (auto& [name, subject] : subjects_)
        if (subject.kept)
            tell_kept(subject);
}

std::optional<double> Log::due_in_s() const {
    std::optional<Time> due;
    for (const auto& [name, subject] : subjects_)
        if (subject.kept)
            due = due ? std::min(*due, subject.kept->kind->free_from) : subject.kept->kind->free_from;
    if (!due)
        return std::nullopt;
    return std::max(0.0, std::chrono::duration<double>(*due - clock_()).count());
}

void Log::tell(Subject& subject, Kind& kind, std::string line, const std::string& late) {
    subject.told = line;
    if (kind.suppressed > 0)
        line += " suppressed=" + std::to_string(kind.suppressed);
    kind = {clock_() + kBetween, 0};
    sink_(line + late);
}

void Log::tell_kept(Subject& subject) {
    const Kept kept = *std::exchange(subject.kept, std::nullopt);
    const auto late_s = std::chrono::duration_cast<std::chrono::seconds>(clock_() - kept.since).count();
    --kept.kind->suppressed; // it is told after all
    tell(subject, *kept.kind, kept.line, " late_s=" + std::to_string(late_s));
}

} // namespace metamer
