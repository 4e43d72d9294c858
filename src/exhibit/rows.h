// The rows of an exhibit's atlas: every lamp and material in use gets one, and is found again by the same
// name.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "atlas/atlas.h"
#include "exhibit/exhibit.h"
#include "exhibit/settings.h"

namespace metamer {

/// With an atlas file its rows stay as they are: names and keys are looked up there first, and what it does
/// not hold goes into its free rows. Without one rows are filled in the order of the calls, and a material's
/// levels are chosen for the lamps asked for before it: ask for the lamps first.
class Rows {
public:
    /// `warnings` may be nullptr; else it receives one sentence per doubt about a spectrum file, with the
    /// setting's place.
    explicit Rows(std::vector<std::string>* warnings, Quantization quantization = Quantization::weighted)
        : atlas_(empty_atlas(quantization)), warnings_(warnings) {}
    Rows(Atlas file, std::string file_place, std::vector<std::string>* warnings);

    /// The lamp that `text` (all or part of the setting's value) names, only `lamp` and `key` filled in.
    /// Throws bad_input at the setting's place.
    LampSetting lamp(const Setting& setting, const std::string& text);
    MaterialSetting material(const Setting& setting, const std::string& text);

    /// The names of the atlas file's materials in the order of their keys; empty without a file.
    std::vector<std::string> file_materials() const;

    /// Materials by key, without those that only the file knows.
    const std::map<int, Material>& full_materials() const { return full_materials_; }

    const Atlas& atlas() const { return atlas_; }

private:
    void refuse_key(const std::string& text, const std::string& what) const;
    void warn(const Setting& setting, const std::vector<std::string>& doubts);

    Atlas atlas_;
    std::optional<Atlas> file_;
    std::string file_place_;
    std::map<int, Material> full_materials_;
    std::vector<Lamp>
        lit_by_; ///< in the order of their keys; none with an atlas file, whose rows know no lamps
    std::vector<std::string>* warnings_;
};

} // namespace metamer
