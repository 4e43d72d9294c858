// The table of keys in words.
#include "exhibit/keys.h"

#include <cmath>

#include "base/numbers.h"

namespace metamer {

namespace {

std::string numbers_text(const KeyInfo& info) {
    const std::string range = plain_number(info.least) + " .. " + plain_number(info.most);
    const std::string unit = info.unit.empty() ? "" : " " + std::string(info.unit);
    return info.count == 1 ? range + unit : std::to_string(info.count) + " numbers, " + range + unit;
}

std::string choices_text(const KeyInfo& info) {
    std::string text;
    for (const std::string& choice : info.choices())
        text += (text.empty() ? "" : ", ") + choice;
    return text;
}

} // namespace

std::string plain_number(double value) {
    return value == std::floor(value) ? std::to_string(static_cast<long>(value)) : to_text(value);
}

std::string range_text(const KeyInfo& info) {
    switch (info.kind) {
    case ValueKind::whole:
    case ValueKind::number:
    case ValueKind::numbers:
        return numbers_text(info);
    case ValueKind::choice:
        return choices_text(info);
    case ValueKind::yes_no:
        return "yes, no";
    case ValueKind::split:
        return "0 .. 1 of the width, or 0px .. the width";
    case ValueKind::lamp:
        return "a lamp: name, formula, file or key";
    case ValueKind::material:
        return "a material: name, formula, file or key";
    case ValueKind::materials:
        return "a set's name, or materials with commas between";
    case ValueKind::lamps:
        return "lamps with commas between";
    case ValueKind::hours:
        return "from-to, as in 22:00-07:00";
    case ValueKind::text:
        return "text";
    case ValueKind::file:
        return "a path relative to the INI file";
    }
    return {};
}

std::string keys_table() {
    std::string text = "# The keys of an exhibit\n\n"
                       "Written by the program's own table (src/exhibit/keys.cpp); a test keeps it so. "
                       "config/reference.ini shows every key in place.\n";
    std::string_view section;
    for (const KeyInfo& info : keys()) {
        if (info.section != section)
            text += "\n## [" + std::string(info.section) +
                    "]\n\n| key | value | default | what |\n|---|---|---|---|\n";
        section = info.section;
        text += "| " + std::string(info.key) + " | " + range_text(info) + " | " + std::string(info.fallback) +
                " | " + std::string(info.doc) + " |\n";
    }
    return text;
}

} // namespace metamer
