#include "exhibit/settings.h"

#include <algorithm>

#include "base/error.h"
#include "base/names.h"

namespace metamer {

namespace {

/// The row of a key, or the error that names the nearest.
const KeyInfo* known(std::string_view section, std::string_view key, const std::string& place) {
    if (section_pattern(section).empty())
        throw bad_input("read", place, unknown_section(section));
    const KeyInfo* info = find_key(section, key);
    if (!info)
        throw bad_input("read", place, unknown_key(section, key));
    return info;
}

/// Where the dot between section and key is: after the number of a lamp or a tour's step, the last one of an
/// object, else the first.
std::size_t section_end(std::string_view name) {
    if (name.starts_with("object."))
        return name.size() > 7 ? name.rfind('.') : std::string_view::npos;
    const std::size_t first = name.find('.');
    const bool numbered = (name.substr(0, first) == "lamp" || name.substr(0, first) == "tour") &&
                          name.find('.', first + 1) != std::string_view::npos;
    return numbered ? name.find('.', first + 1) : first;
}

} // namespace

Settings::Settings(const IniFile& file, const std::string& place, const std::filesystem::path& folder) {
    const auto at = [&](int line) { return place + ":" + std::to_string(line); };
    for (const IniSection& section : file.sections) {
        if (section_pattern(section.name).empty())
            throw bad_input("read", at(section.line), unknown_section(section.name));
        if (std::ranges::find(sections_, section.name, &Section::name) == sections_.end())
            sections_.push_back({section.name, at(section.line)});
    }
    for (const IniEntry& entry : file.entries)
        settings_.push_back({entry.section, entry.key, entry.value, at(entry.line), folder,
                             known(entry.section, entry.key, at(entry.line))});
}

void Settings::set(const std::string& text) {
    const std::string place = "--set " + text;
    const std::size_t equals = text.find('=');
    const std::string_view name = trimmed(std::string_view(text).substr(0, equals));
    const std::size_t dot = section_end(name);
    if (equals == std::string::npos || dot == std::string_view::npos || dot + 1 == name.size())
        throw bad_input("read", place, "it must be section.key=value, as in lamp.1.spectrum=F11");
    const std::string section(name.substr(0, dot)), key(name.substr(dot + 1));
    const std::string value(trimmed(std::string_view(text).substr(equals + 1)));
    const Setting setting{section, key, value, place, ".", known(section, key, place)};
    if (value.empty())
        std::erase_if(settings_, [&](const Setting& s) { return s.section == section && s.key == key; });
    else
        replace(setting);
}

void Settings::replace(Setting setting) {
    std::erase_if(settings_,
                  [&](const Setting& s) { return s.section == setting.section && s.key == setting.key; });
    if (std::ranges::find(sections_, setting.section, &Section::name) == sections_.end())
        sections_.push_back({setting.section, setting.place});
    settings_.push_back(std::move(setting));
}

const Setting* Settings::find(std::string_view section, std::string_view key) const {
    const auto found = std::ranges::find_if(
        settings_, [&](const Setting& setting) { return setting.section == section && setting.key == key; });
    return found == settings_.end() ? nullptr : &*found;
}

Settings Settings::without(std::string_view pattern) const {
    Settings rest = *this;
    std::erase_if(rest.sections_, [&](const Section& s) { return section_pattern(s.name) == pattern; });
    std::erase_if(rest.settings_, [&](const Setting& s) { return section_pattern(s.section) == pattern; });
    return rest;
}

std::vector<const Setting*> Settings::of(std::string_view section) const {
    std::vector<const Setting*> out;
    for (const Setting& setting : settings_)
        if (setting.section == section)
            out.push_back(&setting);
    return out;
}

std::vector<Settings::Section> Settings::sections(std::string_view pattern) const {
    std::vector<Section> fitting;
    std::ranges::copy_if(sections_, std::back_inserter(fitting),
                         [&](const Section& section) { return section_pattern(section.name) == pattern; });
    return fitting;
}

} // namespace metamer
