#include "kiosk/brief_error.h"

#include <algorithm>
#include <cctype>

namespace metamer {

namespace {

/// `object "wedge" of /srv/museum/media.ini` -> `object "wedge" of media.ini`
std::string without_folder(std::string place) {
    const std::size_t slash = place.find('/');
    if (slash == std::string::npos)
        return place;
    const std::size_t space = place.rfind(' ', slash);
    const std::size_t from = space == std::string::npos ? 0 : space + 1;
    return place.erase(from, place.rfind('/') + 1 - from);
}

bool ends_with_line(std::string_view place) {
    const std::size_t colon = place.rfind(':');
    return colon != std::string_view::npos && colon + 1 < place.size() &&
           std::ranges::all_of(place.substr(colon + 1), [](unsigned char c) { return std::isdigit(c); });
}

/// The first bytes of a text, no character cut in two.
std::string_view beginning(std::string_view text, std::size_t bytes) {
    while (bytes > 0 && (static_cast<unsigned char>(text[bytes]) & 0xC0) == 0x80)
        --bytes;
    return text.substr(0, bytes);
}

std::string without_long_value(std::string_view cause) {
    constexpr std::string_view kIs = " = ", kThen = ": ";
    constexpr std::size_t kMostValue = 24, kKept = 12;
    const std::size_t is = cause.find(kIs);
    const std::size_t then = is == cause.find(' ') ? cause.find(kThen, is) : std::string_view::npos;
    if (then == std::string_view::npos || then - is - kIs.size() <= kMostValue)
        return std::string(cause);
    const std::size_t value = is + kIs.size();
    return std::string(cause.substr(0, value)) + std::string(beginning(cause.substr(value), kKept)) +
           "\u2026" + std::string(cause.substr(then));
}

} // namespace

std::string brief_error(std::string_view words) {
    constexpr std::string_view kCannot = "cannot ", kThen = ": ";
    const std::size_t cannot = words.find(kCannot);
    if (cannot == std::string_view::npos)
        return std::string(words);
    const std::size_t verb_end = words.find(' ', cannot + kCannot.size());
    const std::size_t then = words.find(kThen, verb_end);
    if (then == std::string_view::npos)
        return std::string(words);
    const std::string place = without_folder(std::string(words.substr(verb_end + 1, then - verb_end - 1)));
    const std::string_view before = words.substr(0, ends_with_line(place) ? cannot : verb_end + 1);
    return std::string(before) + place + std::string(kThen) +
           without_long_value(words.substr(then + kThen.size()));
}

} // namespace metamer
