// Extreme lamps on the blackest things, drawn by any method into a small frame.
#pragma once

#include "frames/extreme_lamps.h"
#include "frames/frames.h"
#include "methods/shade.h"
#include "render/draws.h"

namespace metamer {

/// A scene whose first object is of a surface; two materials, white, and a black of reflectance 0.
inline Exhibit exhibit_with(Surface surface, const std::string& lamps) {
    const bool media = surface == Surface::medium;
    const std::string kind = media                                                        ? "media"
                             : surface == Surface::ramp || surface == Surface::ramp_codes ? "ramp"
                             : surface == Surface::bounce                                 ? "corner"
                                                                                          : "loaf";
    Exhibit exhibit = exhibit_of("[scene]\nkind = " + kind + "\nmaterials = rgb:FFFFFF" +
                                 (media ? "" : ", rgb:000000") + "\n" + lamps);
    if (media)
        exhibit.objects = {exhibit.objects[1]};
    if (kind == "ramp")
        exhibit.objects.resize(1);
    const auto make_black = [&](int key, std::size_t step) {
        for (std::size_t i = 0; i < kIntervals; i += step)
            exhibit.atlas.rgba[atlas_byte(key, i, AtlasChannel::material)] = 0;
        exhibit.materials.erase(key);
    };
    ObjectSetting& object = exhibit.objects[0];
    if (media)
        make_black(object.medium->key, 2);
    else
        make_black(kind == "ramp" ? object.material_end->key : exhibit.objects[1].material.key, 1);
    if (surface == Surface::maps) {
        const auto key = static_cast<std::uint8_t>(object.material.key),
                   black = static_cast<std::uint8_t>(exhibit.objects[1].material.key);
        object.key_map = Image{2, 1, {key, 0, 0, 255, black, 0, 0, 255}};
        object.bump_map = Image{2, 2, {0, 0, 0, 255, 255, 0, 0, 255, 255, 0, 0, 255, 0, 0, 0, 255}};
        object.bump = 1;
    }
    return exhibit;
}

/// One surface under some lamps by one method: what stays while lamps get brighter and move.
class Subject {
public:
    Subject(Surface surface, Method method, const std::string& lamps)
        : exhibit(exhibit_with(surface, lamps)),
          method_(method),
          spectra_(exhibit),
          scene_(build_scene(exhibit)) {
        if (method != Method::reduced)
            return;
        const HalfView view = half_views(exhibit).front();
        Pixel pixel = pixel_of(view);
        pixel.material = spectra_.material(object().material.key);
        if (object().medium) {
            pixel.medium = spectra_.material(object().medium->key);
            pixel.thickness = 2;
        }
        taps_ = taps_for(pixel, 8);
    }

    ObjectSetting& object() { return exhibit.objects[0]; }

    HalfDraws draws() const {
        HalfPlan plan{half_views(exhibit).front(), {}};
        for (const ObjectSetting& each : exhibit.objects) {
            ObjectPlan& of = plan.objects.emplace_back();
            of.object = each.name;
            of.method = method_;
            of.taps = taps_;
        }
        return half_draws(exhibit, spectra_, plan, scene_, {});
    }

    Exhibit exhibit;

private:
    Method method_;
    ExhibitSpectra spectra_;
    Scene scene_;
    Taps taps_;
};

} // namespace metamer
