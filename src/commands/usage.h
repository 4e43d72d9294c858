// What is wrong with a command line, in the house's words.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace metamer {

/// The cause of a parse error: the first word that nothing takes, with the nearest known name; a missing
/// command, with those that there are; else what CLI11 says. Ends in a question or in where to read on.
/// `app`: after parsing failed.
std::string usage_cause(const CLI::App& app, const CLI::ParseError& error);

} // namespace metamer
