#include "exhibit/values.h"

#include <algorithm>

#include "base/names.h"
#include "base/numbers.h"

namespace metamer {

namespace {

/// `KEY = VALUE`, the value cut to what a line of a message can hold.
std::string assignment(const Setting& setting) {
    constexpr std::size_t most = 100;
    const bool is_long = setting.value.size() > most;
    return setting.key + " = " + setting.value.substr(0, most) + (is_long ? "..." : "");
}

Error out_of_range(const Setting& setting, const std::string& why) {
    return refused(setting, why + "; it may be " + range_text(*setting.info));
}

void check_range(const Setting& setting, double value) {
    const std::string which = setting.info->count == 1 ? "is" : "has " + to_text(value) + ", which is";
    if (value < setting.info->least)
        throw out_of_range(setting, which + " below " + plain_number(setting.info->least));
    if (value > setting.info->most)
        throw out_of_range(setting, which + " above " + plain_number(setting.info->most));
}

/// A name without what people vary: "sRGB (D65)" is "sRGB-D65".
std::string bare(std::string_view name) {
    std::string out = lower_case(name);
    std::erase_if(out, [](char c) { return std::string_view(" -_()").find(c) != std::string_view::npos; });
    return out;
}

} // namespace

Error refused(const Setting& setting, const std::string& why) {
    return bad_input("read", setting.place, assignment(setting) + " " + why);
}

Error refused_by(const Setting& setting, const std::string& item, const Error& inner) {
    const bool says_more = !inner.place().empty() && !inner.place().ends_with(item) &&
                           !inner.place().ends_with("\"" + item + "\"");
    const std::string at_fault = says_more ? inner.place() + ": " + inner.cause() : inner.cause();
    if (item == setting.value)
        return bad_input("read", setting.place, assignment(setting) + ": " + at_fault);
    return bad_input("read", setting.place,
                     setting.key + ": " + (says_more ? at_fault : item + ": " + at_fault));
}

int whole(const Setting& setting) {
    const auto value = parse_whole(setting.value);
    if (!value)
        throw out_of_range(setting, "is no whole number");
    check_range(setting, *value);
    return *value;
}

double number(const Setting& setting) {
    const auto value = parse_number(setting.value);
    if (!value)
        throw out_of_range(setting, "is no number");
    check_range(setting, *value);
    return *value;
}

std::vector<double> numbers(const Setting& setting) {
    std::string text = setting.value;
    std::ranges::replace_if(
        text, [](char c) { return c == ',' || c == '\t'; }, ' ');
    std::vector<double> values;
    for (const std::string& piece : split(text, ' ')) {
        if (piece.empty())
            continue;
        const auto value = parse_number(piece);
        if (!value)
            throw out_of_range(setting, "has \"" + piece + "\", which is no number");
        check_range(setting, *value);
        values.push_back(*value);
    }
    if (values.size() != static_cast<std::size_t>(setting.info->count))
        throw out_of_range(setting, "is " + std::to_string(values.size()) + " numbers");
    return values;
}

std::size_t choice(const Setting& setting) {
    const std::vector<std::string> choices = setting.info->choices();
    for (std::size_t i = 0; i < choices.size(); ++i)
        if (bare(choices[i]) == bare(setting.value))
            return i;
    throw refused(setting, "is none of " + range_text(*setting.info) + did_you_mean(setting.value, choices));
}

bool yes_no(const Setting& setting) {
    for (const char* yes : {"yes", "true", "on", "1"})
        if (same_name(setting.value, yes))
            return true;
    for (const char* no : {"no", "false", "off", "0"})
        if (same_name(setting.value, no))
            return false;
    throw refused(setting, "is neither yes nor no");
}

} // namespace metamer
