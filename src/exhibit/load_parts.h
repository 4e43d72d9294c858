// The loader's parts, section by section; load.cpp puts them together. Each throws bad_input at the setting's
// place.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "exhibit/exhibit.h"
#include "exhibit/rows.h"
#include "exhibit/scene_kinds.h"
#include "exhibit/settings.h"

namespace metamer {

/// [display]
Display load_display(const Settings& settings);

/// [accuracy]
Accuracy load_accuracy(const Settings& settings);

/// A key whose choices are `auto` and the methods.
MethodChoice method_choice(const Setting& setting);

/// The rows to start with: those of [atlas] file, or none.
Rows load_rows(const Settings& settings, std::vector<std::string>* warnings);

/// [scene] kind
SceneKind load_scene_kind(const Settings& settings);

/// [scene] materials and all [object.NAME]. `place`: the exhibit's, for what no setting says.
std::vector<ObjectSetting> load_objects(const Settings& settings, const SceneKindInfo& scene, Rows& rows,
                                        const std::string& place, std::vector<std::string>* warnings);

/// The PNG that a setting names, with power-of-two sides up to 2048.
Image load_map(const Setting& setting);

/// Refuses a key map with a pixel whose key has no material in the atlas.
void check_key_map(const Setting& setting, const Image& map, const Atlas& atlas);

/// All [lamp.N]; one lamp of D65 when there is none.
std::vector<LampSetting> load_lamps(const Settings& settings, const SceneKindInfo& scene, Rows& rows,
                                    const std::string& place, std::vector<std::string>* warnings);

/// [compare]; none without that section.
std::optional<Compare> load_compare(const Settings& settings, const Display& display, Rows& rows);

/// [kiosk], the keys of [display] that only `metamer run` reads, and all [tour.N]. The shelf's lamps get rows
/// after all others: where the exhibit says something of kiosk or tour, or `with_shelf`. `with_materials`
/// gives the exhibit of a tour step's materials.
KioskSetting load_kiosk(const Settings& settings, Rows& rows, bool with_shelf, const std::string& place,
                        const std::function<std::shared_ptr<const Exhibit>(const Setting&)>& with_materials);

/// A setting that nobody wrote: the table's default, or what stands for it. Errors name the exhibit as their
/// place.
Setting unwritten(std::string_view section, std::string_view key, const std::string& value,
                  const std::string& place);

} // namespace metamer
