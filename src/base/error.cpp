#include "base/error.h"

namespace metamer {

namespace {
std::string sentence(const std::string& verb, const std::string& place, const std::string& cause) {
    return "cannot " + verb + " " + place + ": " + cause;
}
} // namespace

Error bad_input(const std::string& verb, const std::string& place, const std::string& cause) {
    return {Exit::bad_input, sentence(verb, place, cause)};
}

Error failure(const std::string& verb, const std::string& place, const std::string& cause) {
    return {Exit::failure, sentence(verb, place, cause)};
}

Error no_gl(const std::string& verb, const std::string& place, const std::string& cause) {
    return {Exit::no_gl, sentence(verb, place, cause)};
}

} // namespace metamer
