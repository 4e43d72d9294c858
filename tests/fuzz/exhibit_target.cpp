#include <algorithm>

#include "exhibit/ini.h"
#include "exhibit/keys.h"
#include "exhibit/load.h"
#include "fuzz/exhibit_oracle.h"
#include "fuzz/must.h"
#include "overlay/words.h"

namespace metamer::fuzz {

namespace {

constexpr const char* kPlace = "fuzz.ini";

std::filesystem::path folder() {
    return std::filesystem::path(METAMER_SOURCE_DIR) / "tests" / "fuzz" / "folder";
}

/// The file as a text that says the same. Without blanks about the `=`: a `;` behind one is a comment.
std::string canonical(const IniFile& file) {
    std::string text, open;
    for (const IniEntry& entry : file.entries) {
        if (entry.section != open)
            text += "[" + entry.section + "]\n";
        open = entry.section;
        text += entry.key + "=" + entry.value + "\n";
    }
    return text;
}

void check_canonical(const IniFile& file) {
    const IniFile again = parse_ini(canonical(file), kPlace);
    must(std::ranges::equal(file.entries, again.entries,
                            [](const IniEntry& a, const IniEntry& b) {
                                return a.section == b.section && a.key == b.key && a.value == b.value;
                            }),
         "an INI file is the same again", canonical(file));
}

/// Whether a value may be looked up: no path that leads out of the folder.
bool stays_inside(const IniEntry& entry) {
    using enum ValueKind;
    const KeyInfo* info = find_key(entry.section, entry.key);
    const bool may_be_path = info && (info->kind == file || info->kind == lamp || info->kind == lamps ||
                                      info->kind == material || info->kind == materials);
    return !may_be_path || entry.value.find('/') == std::string::npos;
}

/// Rows as the thesis has them take no time; the fit of weighted ones is try_spectrum's.
std::vector<std::string> quick_rows(const IniFile& file) {
    const bool has_file = std::ranges::any_of(
        file.entries, [](const IniEntry& entry) { return entry.section == "atlas" && entry.key == "file"; });
    return has_file ? std::vector<std::string>() : std::vector<std::string>{"atlas.quantization=thesis"};
}

} // namespace

Outcome try_exhibit(std::string_view bytes) {
    IniFile file;
    const Outcome parsed = outcome_of([&] { file = parse_ini(bytes, kPlace); });
    if (parsed == Outcome::refused)
        return parsed;
    check_canonical(file);
    if (!std::ranges::all_of(file.entries, stays_inside))
        return Outcome::refused;
    Exhibit exhibit;
    std::vector<std::string> warnings;
    const Outcome loaded = outcome_of([&] {
        exhibit = parse_exhibit(bytes, kPlace, folder(), quick_rows(file), &warnings, Use::kiosk);
        if (!exhibit.kiosk.strings.empty())
            Words words(exhibit.kiosk.strings);
    });
    if (loaded == Outcome::taken)
        check_exhibit(exhibit);
    return loaded;
}

} // namespace metamer::fuzz
