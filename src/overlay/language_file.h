// One file of config/strings: read and held against the English one.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "overlay/words.h"

namespace metamer {

/// A language from the text of its file. `place`: the file, for errors. `english`: the keys and placeholders
/// that it must have; empty only for the built-in English itself. Throws bad_input as Words() says.
Language parse_language(std::string_view text, const std::string& code, const std::string& place,
                        const std::vector<WordKey>& english);

/// The language of a file, whose name says its code. Throws bad_input as Words() says.
Language read_language(const std::filesystem::path& file);

/// Whether a key is a lamp's or a material's name: free to be there or not.
bool is_name_key(std::string_view key);

} // namespace metamer
