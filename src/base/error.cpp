#include "base/error.h"

namespace metamer {

Error::Error(Exit status, const std::string& verb, const std::string& place, const std::string& cause)
    : std::runtime_error("cannot " + verb + " " + place + ": " + cause),
      status_(status),
      place_(place),
      cause_(cause) {}

Error bad_input(const std::string& verb, const std::string& place, const std::string& cause) {
    return {Exit::bad_input, verb, place, cause};
}

Error failure(const std::string& verb, const std::string& place, const std::string& cause) {
    return {Exit::failure, verb, place, cause};
}

Error no_gl(const std::string& verb, const std::string& place, const std::string& cause) {
    return {Exit::no_gl, verb, place, cause};
}

} // namespace metamer
