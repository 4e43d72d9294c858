#include "base/error.h"

#include "base/utf8.h"

namespace metamer {

Error::Error(Exit status, const std::string& verb, const std::string& place, const std::string& cause)
    : std::runtime_error("cannot " + verb + " " + place + ": " + cause),
      status_(status),
      place_(place),
      cause_(cause) {}

// Input is quoted as it came; it must neither break the line nor steer the terminal.
Error bad_input(const std::string& verb, const std::string& place, const std::string& cause) {
    return {Exit::bad_input, verb, without_control(place), without_control(cause)};
}

Error failure(const std::string& verb, const std::string& place, const std::string& cause) {
    return {Exit::failure, verb, place, cause};
}

Error no_gl(const std::string& verb, const std::string& place, const std::string& cause) {
    return {Exit::no_gl, verb, place, cause};
}

} // namespace metamer
