// The settings of an exhibit before their values are understood: the INI file's, then those of --set in their
// order.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "exhibit/ini.h"
#include "exhibit/keys.h"

namespace metamer {

/// One value, where it was written, and what the table says of it.
struct Setting {
    std::string section, key, value;
    std::string place; ///< `config/kiosk.ini:12` or `--set lamp.1.strength=2`
    std::filesystem::path
        folder; ///< where its relative paths start: the INI file's folder; for --set the current one
    const KeyInfo* info;
};

class Settings {
public:
    struct Section {
        std::string name;
        std::string place;
    };

    /// Throws bad_input for unknown sections and keys, with the nearest known name.
    Settings(const IniFile& file, const std::string& place, const std::filesystem::path& folder);

    /// Takes `section.key=value`: replaces the value or adds it; an empty value takes the key out again. The
    /// section of an object may hold dots, its key is what follows the last. Throws bad_input placed as
    /// `--set TEXT`.
    void set(const std::string& text);

    /// Puts the setting in the place of what its section and key had before.
    void replace(Setting setting);

    /// A copy without the sections that fit a pattern.
    Settings without(std::string_view pattern) const;

    /// Every setting, in order of appearance.
    void each(const std::function<void(const Setting&)>& visit) const {
        for (const Setting& setting : settings_)
            visit(setting);
    }

    /// All settings of a section, in order of appearance.
    std::vector<const Setting*> of(std::string_view section) const;

    /// The setting of this key; nullptr when nothing sets it.
    const Setting* find(std::string_view section, std::string_view key) const;

    /// Sections in order of appearance, those without values too, that fit a pattern (`lamp.N`).
    std::vector<Section> sections(std::string_view pattern) const;

private:
    std::vector<Section> sections_;
    std::vector<Setting> settings_;
};

} // namespace metamer
