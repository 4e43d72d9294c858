#include "service/log.h"

#include <cstdio>
#include <cstdlib>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

#include "image/utf8.h"

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
    if (value.empty() || !is_utf8(value))
        return true;
    for (std::size_t i = 0; i < value.size(); ++i)
        if (value[i] == ' ' || value[i] == '"' || value[i] == '=' || value[i] == '\\' ||
            is_control(static_cast<unsigned char>(value[i])) || is_c1_control(value, i))
            return true;
    return false;
}

std::string written(std::string_view value) {
    return needs_quotes(value) ? quoted(value) : std::string(value);
}

} // namespace

Log::Log() : Log(write_stderr, std::chrono::steady_clock::now, stderr_is_journal()) {}

Log::Log(Sink sink, Clock clock, bool priorities)
    : sink_(std::move(sink)), clock_(std::move(clock)), priorities_(priorities) {}

void Log::write(Priority priority, std::string_view event, std::initializer_list<LogField> fields) {
    const auto now = clock_();
    auto kind = kinds_.find(event);
    if (kind == kinds_.end()) {
        kind = kinds_.emplace(event, Kind{now, 0}).first;
    } else if (now - kind->second.last < kBetween) {
        ++kind->second.suppressed;
        return;
    }
    std::string line = priorities_ ? '<' + std::to_string(static_cast<int>(priority)) + '>' : std::string();
    line += "event=" + written(event);
    for (const LogField& field : fields)
        line.append(" ").append(field.key).append("=").append(written(field.value));
    if (kind->second.suppressed > 0)
        line += " suppressed=" + std::to_string(kind->second.suppressed);
    kind->second = {now, 0};
    sink_(line);
}

} // namespace metamer
