#include "base/utf8.h"

#include <algorithm>
#include <cstdint>

namespace metamer {

namespace {

bool is_tail(unsigned char byte) {
    return (byte & 0xC0) == 0x80;
}

// The bytes that a sequence with this first byte takes; 0 if no sequence starts with it.
std::size_t sequence_length(unsigned char first) {
    if (first < 0x80)
        return 1;
    if (first >= 0xC2 && first <= 0xDF)
        return 2;
    if ((first & 0xF0) == 0xE0)
        return 3;
    return first >= 0xF0 && first <= 0xF4 ? 4 : 0;
}

// The second byte's range excludes overlong forms (E0, F0), surrogates (ED) and what lies above U+10FFFF
// (F4).
bool second_fits(unsigned char first, unsigned char second) {
    switch (first) {
    case 0xE0:
        return second >= 0xA0;
    case 0xED:
        return second <= 0x9F;
    case 0xF0:
        return second >= 0x90;
    case 0xF4:
        return second <= 0x8F;
    default:
        return true;
    }
}

// The bytes of the well-formed sequence that the text begins with; 0 if it begins with none.
std::size_t well_formed_length(std::string_view text) {
    const auto first = static_cast<unsigned char>(text[0]);
    const std::size_t length = sequence_length(first);
    if (length == 0 || length > text.size())
        return 0;
    for (std::size_t i = 1; i < length; ++i)
        if (!is_tail(static_cast<unsigned char>(text[i])))
            return 0;
    return length == 1 || second_fits(first, static_cast<unsigned char>(text[1])) ? length : 0;
}

// The bytes of the control character that the text begins with; 0 if it begins with another. U+0080 .. U+009F
// are C2 80 .. C2 9F.
std::size_t control_length(std::string_view utf8) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(utf8[i]); };
    if (byte(0) < 0x20 || byte(0) == 0x7F)
        return 1;
    return byte(0) == 0xC2 && utf8.size() > 1 && byte(1) >= 0x80 && byte(1) <= 0x9F ? 2 : 0;
}

} // namespace

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = well_formed_length(text);
        if (length == 0)
            return false;
        text.remove_prefix(length);
    }
    return true;
}

bool has_control(std::string_view utf8) {
    for (std::size_t i = 0; i < utf8.size(); ++i)
        if (control_length(utf8.substr(i)) > 0)
            return true;
    return false;
}

std::string without_control(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const std::size_t length = control_length(text);
        out += length > 0 ? '?' : text[0];
        text.remove_prefix(std::max<std::size_t>(1, length));
    }
    return out;
}

std::string utf8_from_latin1(std::string_view latin1) {
    std::string utf8;
    for (const char c : latin1) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80) {
            utf8 += c;
        } else {
            utf8 += static_cast<char>(0xC0 | (byte >> 6));
            utf8 += static_cast<char>(0x80 | (byte & 0x3F));
        }
    }
    return utf8;
}

std::size_t code_points(std::string_view utf8) {
    return static_cast<std::size_t>(std::count_if(
        utf8.begin(), utf8.end(), [](char c) { return !is_tail(static_cast<unsigned char>(c)); }));
}

std::string quotable(std::string_view text) {
    constexpr std::size_t most_bytes = 40;
    std::string out;
    while (!text.empty()) {
        const std::size_t length = std::max<std::size_t>(1, well_formed_length(text));
        const bool shown = well_formed_length(text) > 0 && control_length(text) == 0;
        const std::string_view piece = shown ? text.substr(0, length) : std::string_view("?");
        if (out.size() + piece.size() > most_bytes)
            return out + "...";
        out += piece;
        text.remove_prefix(length);
    }
    return out;
}

} // namespace metamer
