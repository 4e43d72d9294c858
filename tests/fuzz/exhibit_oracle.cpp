#include "fuzz/exhibit_oracle.h"

#include <bit>
#include <cmath>

#include "atlas/atlas_check.h"
#include "fuzz/must.h"
#include "plan/half_view.h"

namespace metamer::fuzz {

namespace {

bool is_row(int key) {
    return key >= 1 && key <= kAtlasRows;
}

void check_key(const Exhibit& exhibit, const LampSetting& lamp) {
    must(is_row(lamp.key) && !exhibit.atlas.lamps[static_cast<std::size_t>(lamp.key)].name.empty(),
         "a lamp has a row", lamp.lamp.name);
}

void check_key(const Exhibit& exhibit, const MaterialSetting& material) {
    must(is_row(material.key) &&
             !exhibit.atlas.materials[static_cast<std::size_t>(material.key)].name.empty(),
         "a material has a row", material.material.name);
}

void check_map(const std::optional<Image>& map) {
    if (!map)
        return;
    for (const int side : {map->width, map->height})
        must(side >= 1 && side <= 2048 && std::has_single_bit(static_cast<unsigned>(side)),
             "the sides of a map are powers of two");
    must(map->rgba.size() == std::size_t{4} * static_cast<std::size_t>(map->width * map->height),
         "a map has all of its pixels");
}

void check_object(const Exhibit& exhibit, const ObjectSetting& object) {
    check_key(exhibit, object.material);
    if (object.material_end)
        check_key(exhibit, *object.material_end);
    if (object.medium)
        check_key(exhibit, *object.medium);
    must_be_within(object.thickness, 0, 1000, "thickness");
    must_be_within(object.bump, 0, 1, "bump_height");
    must_be_within(object.specular, 0, 1, "specular");
    must_be_within(object.shininess, 1, 1000, "shininess");
    check_map(object.key_map);
    check_map(object.luminance_map);
    check_map(object.bump_map);
    if (object.key_map)
        for (std::size_t i = 0; i < object.key_map->rgba.size(); i += 4) {
            const std::size_t key = object.key_map->rgba[i];
            must(key < kAtlasSize && !exhibit.atlas.materials[key].name.empty(),
                 "a pixel's key has a material");
        }
}

void check_lamp(const Exhibit& exhibit, const LampSetting& lamp) {
    check_key(exhibit, lamp);
    must_be_within(lamp.strength, 0, 1e6, "strength");
    for (const double at : lamp.position.value_or(Vec3{}))
        must_be_within(at, -100, 100, "position");
    if (lamp.direction) {
        const Vec3& d = *lamp.direction;
        must_be_within(std::hypot(d[0], d[1], d[2]), 1 - 1e-9, 1 + 1e-9, "the length of direction");
    }
    must(!(lamp.position && lamp.direction), "a lamp has a place or a direction");
    const Falloff& f = lamp.falloff;
    must(f.constant >= 0 && f.linear >= 0 && f.quadratic >= 0 && f.constant + f.linear + f.quadratic > 0,
         "light falls off");
}

void check_half(const Exhibit& exhibit, const Half& half) {
    if (half.lamp)
        check_key(exhibit, *half.lamp);
    must_be_within(half.strength.value_or(1), 0, 1e6, "a half's strength");
}

void check_display(const Display& display) {
    must_be_within(display.width_px, 16, 4096, "width");
    must_be_within(display.height_px, 16, 4096, "height");
    must_be_within(display.supersample, 1, 2, "supersample");
    must(display.working_space != nullptr, "there is a working space");
    must(!display.matrix || inverse(*display.matrix), "a matrix is not singular");
}

void check_kiosk(const Exhibit& exhibit) {
    const KioskSetting& kiosk = exhibit.kiosk;
    must(!kiosk.lamps.empty() && kiosk.lamps.size() <= kMostShelfLamps, "there is a shelf");
    for (const LampSetting& lamp : kiosk.lamps)
        check_key(exhibit, lamp);
    must(kiosk.booth_left < kiosk.lamps.size() && kiosk.booth_right < kiosk.lamps.size(),
         "the booth's lamps are on the shelf");
    must_be_within(kiosk.idle_s, 5, 3600, "idle_s");
    must_be_within(kiosk.watch_s, 0, 3600, "watch_s");
    must_be_within(kiosk.pixel_shift_px, 0, 16, "pixel_shift");
    if (kiosk.night)
        for (const int minute : {kiosk.night->from_min, kiosk.night->to_min})
            must_be_within(minute, 0, 24 * 60 - 1, "an hour of night");
    must(kiosk.tour.size() <= kMostTourSteps, "a tour has an end");
    for (const TourStep& step : kiosk.tour) {
        must(step.lamp.value_or(0) < kiosk.lamps.size(), "the tour's lamps are on the shelf");
        must_be_within(step.split.value_or(0), 0, 1, "a step's split");
        must_be_within(step.seconds, 1, 600, "seconds");
        if (step.scene)
            check_exhibit(*step.scene);
    }
}

void check_views(const Exhibit& exhibit) {
    for (const HalfView& view : half_views(exhibit)) {
        must(view.lamps.size() == exhibit.lamps.size() && view.dominant < view.lamps.size(),
             "a half has lamps");
        for (const HalfLamp& lamp : view.lamps)
            must(!lamp.full || (lamp.full->k > 0 && std::isfinite(lamp.full->k)), "a lamp has a k'",
                 lamp.name);
        for (const auto& row : view.output.adaptation.m)
            for (const double value : row)
                must(std::isfinite(value), "adaptation is finite");
    }
}

} // namespace

void check_exhibit(const Exhibit& exhibit) {
    check_display(exhibit.display);
    must_be_within(exhibit.accuracy.tolerance, 0.01, 100, "tolerance");
    must(!flaw_of(exhibit.atlas), "an exhibit's atlas has no flaw", flaw_of(exhibit.atlas).value_or(""));
    must(!exhibit.objects.empty(), "there are objects");
    for (const ObjectSetting& object : exhibit.objects)
        check_object(exhibit, object);
    must(!exhibit.lamps.empty() && exhibit.lamps.size() <= kMostLamps, "there are lamps");
    for (const LampSetting& lamp : exhibit.lamps)
        check_lamp(exhibit, lamp);
    must(std::ranges::count(exhibit.lamps, true, &LampSetting::shadow) <= kMostShadows,
         "few lamps cast shadows");
    for (const auto& [key, material] : exhibit.materials) {
        must(is_row(key), "a material's key is a row");
        for (const double value : material.spectrum.curve.value)
            must_be_within(value, 0, 1, "a reflectance");
    }
    if (exhibit.compare) {
        must_be_within(exhibit.compare->split, 0, 1, "split");
        must_be_within(exhibit.compare->split_px.value_or(0), 0, exhibit.display.width_px, "split in px");
        must_be_within(exhibit.compare->line_px, 0, 64, "line");
        check_half(exhibit, exhibit.compare->left);
        check_half(exhibit, exhibit.compare->right);
    }
    check_kiosk(exhibit);
    outcome_of([&] { check_views(exhibit); }); // no eye adapts to some lights
}

} // namespace metamer::fuzz
