#include "base/error.h"

#include <algorithm>

namespace metamer {

namespace {

// Input is quoted in messages as it came; it must neither break the line nor steer the terminal.
std::string printable(std::string text) {
    std::ranges::replace_if(
        text, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
    for (std::size_t at = text.find('\xC2'); at != std::string::npos; at = text.find('\xC2', at + 1))
        if (at + 1 < text.size() && static_cast<unsigned char>(text[at + 1]) >= 0x80 &&
            static_cast<unsigned char>(text[at + 1]) < 0xA0)
            text.replace(at, 2, "?"); // U+0080 .. U+009F
    return text;
}

} // namespace

Error::Error(Exit status, const std::string& verb, const std::string& place, const std::string& cause)
    : std::runtime_error("cannot " + verb + " " + place + ": " + cause),
      status_(status),
      place_(place),
      cause_(cause) {}

Error bad_input(const std::string& verb, const std::string& place, const std::string& cause) {
    return {Exit::bad_input, verb, printable(place), printable(cause)};
}

Error failure(const std::string& verb, const std::string& place, const std::string& cause) {
    return {Exit::failure, verb, place, cause};
}

Error no_gl(const std::string& verb, const std::string& place, const std::string& cause) {
    return {Exit::no_gl, verb, place, cause};
}

} // namespace metamer
