// What the caller cannot go on from, told in one line: verb, object, place, cause.
#pragma once

#include <stdexcept>
#include <string>

namespace metamer {

/// The exit statuses of the program (DESIGN.md section 6).
enum class Exit { ok = 0, failure = 1, bad_input = 2, no_gl = 3 };

/// Thrown where the caller cannot go on; caught once, in main, which prints `metamer: ` and what().
class Error : public std::runtime_error {
public:
    Error(Exit status, const std::string& what) : std::runtime_error(what), status_(status), cause_(what) {}
    /// `cannot VERB PLACE: CAUSE`.
    Error(Exit status, const std::string& verb, const std::string& place, const std::string& cause);
    Exit status() const { return status_; }

    /// The sentence's parts, for a caller that knows a better place (an INI file's line instead of a
    /// spectrum's name). Without parts, the place is empty and the cause is everything.
    const std::string& place() const { return place_; }
    const std::string& cause() const { return cause_; }

private:
    Exit status_;
    std::string place_, cause_;
};

/// Input that cannot be taken, e.g. bad_input("read", "config/kiosk.ini:12", "strength = -1 is below 0")
/// gives `cannot read config/kiosk.ini:12: strength = -1 is below 0` and exit status 2. Control characters
/// (U+0000 .. U+001F, U+007F .. U+009F) in what is quoted become `?`: the message stays one line, and steers
/// no terminal.
Error bad_input(const std::string& verb, const std::string& place, const std::string& cause);

/// The same sentence with exit status 1: the input is fine, the machine is not (disk full, no permission).
Error failure(const std::string& verb, const std::string& place, const std::string& cause);

/// The same sentence with exit status 3: no usable EGL or OpenGL ES.
Error no_gl(const std::string& verb, const std::string& place, const std::string& cause);

} // namespace metamer
