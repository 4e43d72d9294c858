// From an INI file to an Exhibit.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "exhibit/exhibit.h"

namespace metamer {

/// What an exhibit is loaded for: `kiosk` has the default shelf of lamps where the INI says nothing of it.
enum class Use { frame, kiosk };

/// Reads an exhibit: the file, then the overrides of `--set`, then every name in it, first in the atlas that
/// [atlas] file names, then in the library, as a formula or as a file.
///
/// Keys: with [atlas] file, its rows. Without, [scene] materials come first: key i is the i-th different
/// material of that list; then the objects' own materials and, apart from those, the lamps, each in order of
/// appearance.
///
/// `sets`: `section.key=value` each, e.g. `lamp.1.spectrum=F11`; later ones win, an empty value takes a key
/// out. Paths in them start at the current folder, paths in the file at the file's. `warnings`, if given,
/// receives one sentence per doubt, with its place. Throws bad_input as `cannot read FILE:LINE: CAUSE` or
/// `cannot read --set ...: CAUSE`.
Exhibit load_exhibit(const std::filesystem::path& path, const std::vector<std::string>& sets = {},
                     std::vector<std::string>* warnings = nullptr, Use use = Use::frame);

/// The same from text; `place` is its name for errors, `folder` where its relative paths start.
Exhibit parse_exhibit(std::string_view text, const std::string& place, const std::filesystem::path& folder,
                      const std::vector<std::string>& sets = {}, std::vector<std::string>* warnings = nullptr,
                      Use use = Use::frame);

/// The built-in exhibit (config/crayons.ini), for commands called without a file.
Exhibit default_exhibit(const std::vector<std::string>& sets = {},
                        std::vector<std::string>* warnings = nullptr, Use use = Use::frame);

/// Every file that such an exhibit is read from, there or not: the INI file, and what it and `sets` name:
/// atlas, maps, spectra, the folder of strings. What is wrong with them does not matter; where the INI file
/// cannot be read, or has a key that is unknown, it is the only one. Without a path: of the built-in exhibit.
std::vector<std::filesystem::path> exhibit_files(const std::filesystem::path& path,
                                                 const std::vector<std::string>& sets = {});

} // namespace metamer
