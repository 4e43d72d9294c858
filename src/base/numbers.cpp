#include "base/numbers.h"

#include <charconv>
#include <cmath>

#include "base/names.h"

namespace metamer {

namespace {

template <class T>
std::optional<T> parse(std::string_view text) {
    text = trimmed(text);
    // from_chars knows no plus; one before a minus is no number.
    if (text.starts_with('+') && !text.starts_with("+-"))
        text.remove_prefix(1);
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || error != std::errc() || end != text.data() + text.size())
        return std::nullopt;
    return value;
}

} // namespace

std::optional<double> parse_number(std::string_view text) {
    const auto value = parse<double>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<int> parse_whole(std::string_view text) {
    return parse<int>(text);
}

std::string to_text(double value) {
    char text[32];
    const auto [end, error] = std::to_chars(text, text + sizeof text, value);
    return error == std::errc() ? std::string(text, end) : std::string("?");
}

} // namespace metamer
