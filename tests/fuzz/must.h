// The fuzzers' oracles: what holds for every input, or the process ends.
#pragma once

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "base/error.h"
#include "fuzz/targets.h"

namespace metamer::fuzz {

/// Prints the promise, and what it is about, and aborts where it does not hold.
inline void must(bool holds, std::string_view promise, std::string_view about = {}) {
    if (holds)
        return;
    std::fprintf(stderr, "not kept: %.*s: %.*s\n", static_cast<int>(promise.size()), promise.data(),
                 static_cast<int>(about.size()), about.data());
    std::abort();
}

/// Aborts unless least <= value <= most; NaN never is.
inline void must_be_within(double value, double least, double most, std::string_view what) {
    if (!(value >= least && value <= most))
        must(false, what,
             std::to_string(value) + " is outside " + std::to_string(least) + " .. " + std::to_string(most));
}

/// Runs it: `taken`, or `refused` where it throws bad input in one sentence of one line.
template <class F>
Outcome outcome_of(const F& run) {
    try {
        run();
        return Outcome::taken;
    } catch (const Error& error) {
        const std::string_view said = error.what();
        must(error.status() == Exit::bad_input, "a bad input ends with status 2", said);
        must(said.starts_with("cannot ") && !error.cause().empty(), "an error has verb, place and cause",
             said);
        must(std::ranges::none_of(said, [](unsigned char c) { return c < 0x20 || c == 0x7f; }),
             "an error is one line, and steers no terminal", said);
        return Outcome::refused;
    }
}

} // namespace metamer::fuzz
