// Whole files in, whole files out.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace metamer {

/// The bytes of a file. Throws bad_input when it is missing, a directory, unreadable, or over `most_bytes`.
std::string read_file(const std::filesystem::path& path, std::size_t most_bytes = 64u << 20);

/// Writes the bytes beside `path` (PATH.part.PID), then renames: a reader sees the old file or the new one,
/// never a half. Behind a link, the file that it leads to is replaced; a device or a pipe is written to as it
/// stands. Throws bad_input when the folder is missing, failure when writing fails; nothing is left behind
/// then.
void write_file(const std::filesystem::path& path, std::string_view bytes);

} // namespace metamer
