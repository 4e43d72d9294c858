#include "report/canvas.h"

#include <algorithm>

#include "base/names.h"
#include "base/utf8.h"

namespace metamer {

namespace {

// Longer than any line of a picture; keeps the search for a fitting length short.
constexpr std::size_t kMostBytes = 4096;

bool continues(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0) == 0x80;
}

// The length in bytes of the well-formed code point at the front; 0 where there is none.
std::size_t front_length(std::string_view text) {
    for (std::size_t length = 1; length <= std::min<std::size_t>(4, text.size()); ++length)
        if (is_utf8(text.substr(0, length)))
            return length;
    return 0;
}

} // namespace

std::string drawable(std::string_view text) {
    std::string out;
    text = text.substr(0, kMostBytes);
    while (!text.empty()) {
        const std::size_t length = front_length(text);
        const std::string_view front = text.substr(0, std::max<std::size_t>(length, 1));
        out += length == 0 || has_control(front) ? std::string_view("?") : front;
        text.remove_prefix(front.size());
    }
    return out;
}

std::string Canvas::fitted(std::string_view text, const Font& font, double most) {
    const std::string whole = drawable(text);
    if (width(whole, font) <= most)
        return whole;
    std::vector<std::size_t> ends; // after each code point
    for (std::size_t i = 1; i < whole.size(); ++i)
        if (!continues(whole[i]))
            ends.push_back(i);
    const auto cut = [&](std::size_t end) { return std::string(trimmed(whole.substr(0, end))) + "…"; };
    const auto beyond = std::partition_point(ends.begin(), ends.end(),
                                             [&](std::size_t end) { return width(cut(end), font) <= most; });
    return beyond == ends.begin() ? std::string() : cut(*std::prev(beyond));
}

std::vector<std::string> Canvas::wrapped(std::string_view text, const Font& font, double most,
                                         std::size_t lines) {
    std::vector<std::string> out;
    std::string line;
    const std::string whole = drawable(text);
    std::string_view rest = trimmed(whole);
    while (!rest.empty() && out.size() + 1 < lines) {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        const std::string longer = (line.empty() ? "" : line + " ") + std::string(rest.substr(0, end));
        if (line.empty() || width(longer, font) <= most) {
            line = longer;
            rest = trimmed(rest.substr(end));
        } else {
            out.push_back(fitted(line, font, most));
            line.clear();
        }
    }
    line += (line.empty() || rest.empty() ? "" : " ") + std::string(rest);
    if (!line.empty())
        out.push_back(fitted(line, font, most));
    return out;
}

} // namespace metamer
