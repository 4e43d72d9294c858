#include "plan/object_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace metamer {

namespace {

bool has_maps(const ObjectSetting& object) {
    return object.key_map || object.luminance_map || object.bump_map;
}

std::vector<int> keys_shown(const ObjectSetting& object) {
    if (!object.key_map)
        return {object.material.key};
    std::array<bool, 256> seen{};
    for (std::size_t i = 0; i < object.key_map->rgba.size(); i += 4)
        seen[object.key_map->rgba[i]] = true;
    std::vector<int> keys;
    for (int key = 1; key <= kAtlasRows; ++key)
        if (seen[static_cast<std::size_t>(key)])
            keys.push_back(key);
    return keys;
}

/// The half's lamps one by one at strength 1, then all together as bright as one.
std::vector<NamedPixel> lit_pixels(const HalfView& view) {
    const Pixel all = pixel_of(view);
    std::vector<NamedPixel> out;
    double strengths = 0;
    std::set<int> keys;
    for (std::size_t l = 0; l < all.lamps.size(); ++l) {
        strengths += all.lamps[l].strength;
        if (!keys.insert(view.lamps[l].key).second)
            continue;
        Pixel one;
        one.lamps = {all.lamps[l]};
        one.lamps[0].strength = 1;
        out.push_back({one, {view.lamps[l].name, {}, {}, 0}, {l}});
    }
    if (out.size() > 1 && strengths > 0) {
        out.push_back({all, {}, {}});
        for (std::size_t l = 0; l < all.lamps.size(); ++l)
            out.back().lamps.push_back(l);
        for (PixelLamp& lamp : out.back().pixel.lamps)
            lamp.strength /= strengths;
    }
    return out;
}

void add_medium(std::vector<NamedPixel>& out, const NamedPixel& pixel, const Layer& medium,
                const ObjectSetting& object) {
    for (int step = 0; step <= kThicknesses; ++step) {
        NamedPixel through = pixel;
        through.pixel.medium = medium;
        through.pixel.thickness = object.thickness * step / kThicknesses;
        through.name.medium = object.medium->material.name;
        through.name.thickness = through.pixel.thickness;
        out.push_back(through);
    }
}

void add_bounces(std::vector<NamedPixel>& out, const NamedPixel& pixel, const Layer& other) {
    for (const auto& [diffuse, bounced] : {std::pair{1.0, 0.0}, {0.7, 0.5}, {0.3, 0.5}, {0.0, 0.5}}) {
        NamedPixel lit = pixel;
        lit.pixel.other = other;
        for (PixelLamp& lamp : lit.pixel.lamps)
            lamp.light = {diffuse, 0, bounced};
        out.push_back(lit);
    }
}

} // namespace

Surface surface_of(const Exhibit& exhibit, const ObjectSetting& object, Method method) {
    if (object.material_end)
        return method == Method::rgb ? Surface::ramp_codes : Surface::ramp;
    if (object.medium)
        return Surface::medium;
    if (other_wall(exhibit, object))
        return Surface::bounce;
    return has_maps(object) ? Surface::maps : Surface::plain;
}

const ObjectSetting* other_wall(const Exhibit& exhibit, const ObjectSetting& object) {
    if (exhibit.scene != SceneKind::corner)
        return nullptr;
    return &exhibit.objects[exhibit.objects[0].name == object.name ? 1 : 0];
}

Pixel pixel_of(const Exhibit& exhibit, const HalfView& view, const ExhibitSpectra& spectra,
               const ObjectSetting& object, const MaterialSetting& material) {
    Pixel pixel = pixel_of(view);
    pixel.material = spectra.material(material.key);
    if (object.medium) {
        pixel.medium = spectra.material(object.medium->key);
        pixel.thickness = object.thickness;
    }
    if (const ObjectSetting* other = other_wall(exhibit, object))
        pixel.other = spectra.material(other->material.key);
    return pixel;
}

Sight sight_of(const HalfView& view, const ExhibitSpectra& spectra, const Taps* taps) {
    Sight sight{&spectra.seen(), &spectra.exact(), view.output_of()};
    sight.taps = taps;
    return sight;
}

std::vector<NamedPixel> pixels_of(const Exhibit& exhibit, const HalfView& view, const ExhibitSpectra& spectra,
                                  const ObjectSetting& object) {
    std::vector<int> keys = keys_shown(object);
    if (object.material_end)
        keys.push_back(object.material_end->key);
    const ObjectSetting* other = other_wall(exhibit, object);
    std::vector<NamedPixel> out;
    for (const NamedPixel& lit : lit_pixels(view))
        for (const int key : keys) {
            NamedPixel pixel = lit;
            pixel.pixel.material = spectra.material(key);
            pixel.name.material = exhibit.atlas.materials[static_cast<std::size_t>(key)].name;
            if (object.medium)
                add_medium(out, pixel, spectra.material(object.medium->key), object);
            else if (other)
                add_bounces(out, pixel, spectra.material(other->material.key));
            else
                out.push_back(pixel);
        }
    return out;
}

} // namespace metamer
