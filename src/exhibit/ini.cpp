#include "exhibit/ini.h"

#include <algorithm>
#include <cstring>
#include <ini.h>
#include <map>

#include "base/error.h"
#include "base/names.h"
#include "base/utf8.h"

namespace metamer {

namespace {

/// What inih's two callbacks share. They are called from C: they must not throw, and note the first fault
/// instead.
struct Parse {
    std::string_view rest;
    IniFile file;
    std::map<std::pair<std::string, std::string>, int> first_line;
    std::string_view line_text;
    int line = 0;
    int fault_line = 0;
    std::string fault;

    void refuse(std::string cause) {
        if (fault_line == 0) {
            fault_line = line;
            fault = std::move(cause);
        }
    }
};

/// Notes `[name]`; inih itself tells a missing `]`, but neither an empty section nor text behind one.
void note_section(Parse& parse, std::string_view text) {
    const std::size_t close = text.find(']');
    if (!text.starts_with('[') || close == std::string_view::npos)
        return;
    const std::string_view name = trimmed(text.substr(1, close - 1));
    const std::string_view behind = trimmed(text.substr(close + 1));
    if (name.empty())
        parse.refuse("a section needs a name");
    else if (name.size() > kLongestIniSection)
        parse.refuse("the section's name is over " + std::to_string(kLongestIniSection) + " bytes");
    else if (!behind.empty() && behind[0] != ';' && behind[0] != '#')
        parse.refuse("text after the \"]\" of [" + std::string(name) + "]; each value has a line of its own");
    else
        parse.file.sections.push_back({std::string(name), parse.line});
}

/// inih's reader: hands out one line a call, so that inih's count of lines and ours agree.
char* next_line(char* buffer, int size, void* user) {
    auto& parse = *static_cast<Parse*>(user);
    if (parse.rest.empty() || parse.fault_line != 0)
        return nullptr;
    ++parse.line;
    const std::size_t end = std::min(parse.rest.find('\n'), parse.rest.size());
    // Leading blanks off: to inih an indented line would continue the value above it.
    const std::string_view text = trimmed(parse.rest.substr(0, end));
    parse.rest.remove_prefix(std::min(end + 1, parse.rest.size()));
    parse.line_text = text;
    if (text.find('\0') != std::string_view::npos)
        parse.refuse("a NUL byte; this is no text file");
    else if (text.size() > kLongestIniLine || static_cast<int>(text.size()) + 2 > size)
        parse.refuse("the line is over " + std::to_string(kLongestIniLine) + " bytes");
    if (parse.fault_line != 0)
        return nullptr;
    note_section(parse, text);
    char* end_of_text = std::ranges::copy(text, buffer).out;
    std::memcpy(end_of_text, "\n", 2);
    return buffer;
}

/// inih's handler: 1 goes on, 0 marks the line as wrong.
int take_value(void* user, const char* section, const char* key, const char* value) {
    auto& parse = *static_cast<Parse*>(user);
    IniEntry entry{std::string(trimmed(section)), key, value, parse.line};
    if (entry.key.empty())
        parse.refuse("a value needs a key before the \"=\"");
    else if (!is_utf8(entry.section) || !is_utf8(entry.key) || !is_utf8(entry.value))
        parse.refuse("text that is not UTF-8");
    else if (entry.section.empty())
        parse.refuse("key \"" + entry.key + "\" stands outside any section");
    else if (const auto [first, is_new] =
                 parse.first_line.try_emplace({entry.section, entry.key}, parse.line);
             !is_new)
        parse.refuse("key \"" + entry.key + "\" is given twice in [" + entry.section + "], first at line " +
                     std::to_string(first->second));
    else
        parse.file.entries.push_back(std::move(entry));
    return parse.fault_line == 0;
}

/// The text of line `number`, short enough for a message.
std::string quoted_line(std::string_view text, int number) {
    for (int i = 1; i < number; ++i)
        text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    const std::string_view line = trimmed(text.substr(0, text.find('\n')));
    return '"' + std::string(line.substr(0, 60)) + (line.size() > 60 ? "...\"" : "\"");
}

/// Debian's inih takes its limits from variables; they are set to the same values by every call.
void set_limits() {
    ini_max_line = kLongestIniLine + 3;
    ini_stop_on_first_error = true;
}

} // namespace

IniFile parse_ini(std::string_view text, const std::string& place) {
    if (text.starts_with("\xEF\xBB\xBF"))
        text.remove_prefix(3);
    set_limits();
    Parse parse;
    parse.rest = text;
    const int wrong_line = ini_parse_stream(next_line, &parse, take_value, &parse);
    const auto at = [&](int line) { return place + ":" + std::to_string(line); };
    if (parse.fault_line != 0)
        throw bad_input("read", at(parse.fault_line), parse.fault);
    if (wrong_line > 0)
        throw bad_input("read", at(wrong_line),
                        quoted_line(text, wrong_line) + " is neither [section] nor key = value");
    if (wrong_line < 0)
        throw failure("read", place, "inih is out of memory");
    return std::move(parse.file);
}

} // namespace metamer
