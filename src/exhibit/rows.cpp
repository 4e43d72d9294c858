#include "exhibit/rows.h"

#include <algorithm>

#include "base/error.h"
#include "base/numbers.h"
#include "exhibit/values.h"
#include "spectra/library.h"

namespace metamer {

namespace {

LampSetting lamp_of_row(const Atlas& atlas, int key, const std::string& place) {
    const AtlasLamp& row = atlas.lamps[static_cast<std::size_t>(key)];
    LampSetting found;
    found.lamp = {row.name,
                  "row " + std::to_string(key) + " of " + place,
                  row.source,
                  {curve_of(emission(atlas, key).value, row.peak), {}}};
    found.full_resolution = false;
    found.key = key;
    return found;
}

MaterialSetting material_of_row(const Atlas& atlas, int key, const std::string& place) {
    const AtlasMaterial& row = atlas.materials[static_cast<std::size_t>(key)];
    return {{row.name,
             "row " + std::to_string(key) + " of " + place,
             row.source,
             {curve_of(reflectance(atlas, key).value)}},
            false,
            key};
}

/// What `look_up` gives; its errors placed at the setting.
template <class F>
auto placed(const Setting& setting, const std::string& text, F look_up) {
    try {
        return look_up();
    } catch (const Error& inner) {
        throw refused_by(setting, text, inner);
    }
}

} // namespace

Rows::Rows(Atlas file, std::string file_place, std::vector<std::string>* warnings)
    : atlas_(file), file_(std::move(file)), file_place_(std::move(file_place)), warnings_(warnings) {}

LampSetting Rows::lamp(const Setting& setting, const std::string& text) {
    if (const int key = file_ ? find_lamp_key(*file_, text) : 0)
        return lamp_of_row(*file_, key, file_place_);
    return placed(setting, text, [&] {
        refuse_key(text, "lamp");
        std::vector<std::string> doubts;
        LampSetting found;
        found.lamp = find_lamp(text, setting.folder.string(), &doubts);
        found.key = add_lamp(atlas_, found.lamp);
        if (!file_ && found.key > static_cast<int>(lit_by_.size())) // keys run from 1
            lit_by_.push_back(found.lamp);
        warn(setting, doubts);
        return found;
    });
}

MaterialSetting Rows::material(const Setting& setting, const std::string& text) {
    if (const int key = file_ ? find_material_key(*file_, text) : 0)
        return material_of_row(*file_, key, file_place_);
    return placed(setting, text, [&] {
        refuse_key(text, "material");
        std::vector<std::string> doubts;
        MaterialSetting found;
        found.material = find_material(text, setting.folder.string(), &doubts);
        found.key = add_material(atlas_, found.material, lit_by_);
        full_materials_.emplace(found.key, found.material);
        warn(setting, doubts);
        return found;
    });
}

void Rows::refuse_key(const std::string& text, const std::string& what) const {
    if (!parse_whole(text))
        return;
    if (!file_)
        throw bad_input("find", text, "a key names a row of an atlas; [atlas] file names none");
    throw bad_input("find", text, file_place_ + " has no " + what + " in row " + text);
}

std::vector<std::string> Rows::file_materials() const {
    std::vector<std::string> names;
    if (file_)
        for (const AtlasMaterial& row : file_->materials)
            if (!row.name.empty())
                names.push_back(row.name);
    return names;
}

void Rows::warn(const Setting& setting, const std::vector<std::string>& doubts) {
    if (warnings_)
        for (const std::string& doubt : doubts)
            warnings_->push_back(setting.place + ": " + doubt);
}

} // namespace metamer
