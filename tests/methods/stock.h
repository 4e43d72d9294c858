// The library's lamps and materials as pixels hold them, each looked up once for the whole program.
#pragma once

#include <cmath>
#include <map>
#include <string>

#include "atlas/atlas.h"
#include "color/resample.h"
#include "color/working_space.h"
#include "methods/shade.h"
#include "methods/three_numbers.h"

namespace metamer::test {

/// Rows of an atlas of the default quantization, and the same spectra at 1 nm. What it returns points into
/// it.
class Stock {
public:
    PixelLamp lamp(const std::string& name, double strength = 1, const Light<double>& light = {}) {
        auto found = lamps_.find(name);
        if (found == lamps_.end()) {
            const Lamp lamp = find_lamp(name);
            Atlas atlas = empty_atlas();
            const int key = add_lamp(atlas, lamp);
            found =
                lamps_.emplace(name, LampForms{emission(atlas, key), reference_lamp(lamp.spectrum)}).first;
        }
        return {&found->second.row, &found->second.full, strength, light};
    }

    Layer layer(const std::string& name) {
        auto found = layers_.find(name);
        if (found == layers_.end()) {
            const Material material = find_material(name);
            Atlas atlas = empty_atlas();
            const int key = add_material(atlas, material);
            const LayerForms forms{reflectance(atlas, key), resample(material.spectrum, kReferenceGrid)};
            found = layers_.emplace(name, forms).first;
        }
        return {&found->second.row, &found->second.full};
    }

    Pixel pair(const std::string& lamp_name, const std::string& material, double strength = 1) {
        Pixel pixel;
        pixel.lamps = {lamp(lamp_name, strength)};
        pixel.material = layer(material);
        return pixel;
    }

    /// Both observers of the atlas; sRGB-D65.
    Sight sight() const {
        Sight sight{&seen_, &exact_, {}};
        sight.output.rgb_from_xyz = rgb_from_xyz(working_spaces()[0]);
        sight.output.white = &white_emission(working_spaces()[0]);
        return sight;
    }

    const GridObserver& seen() const { return seen_; }
    const GridObserver& exact() const { return exact_; }

private:
    struct LampForms {
        Emission row;
        ReferenceLamp full;
    };
    struct LayerForms {
        Reflectance row;
        std::vector<double> full;
    };
    GridObserver seen_ = observer(empty_atlas()), exact_ = exact_observer(empty_atlas());
    std::map<std::string, LampForms> lamps_;
    std::map<std::string, LayerForms> layers_;
};

inline Stock& stock() {
    static Stock shared;
    return shared;
}

/// The pixel as an exhibit knows it that has an atlas file and nothing else.
inline Pixel rows_only(Pixel pixel) {
    for (PixelLamp& lamp : pixel.lamps)
        lamp.full = nullptr;
    pixel.material.full = nullptr;
    if (pixel.medium)
        pixel.medium->full = nullptr;
    if (pixel.other)
        pixel.other->full = nullptr;
    return pixel;
}

/// The greatest difference of two colors in steps of 8 bits.
inline int steps(const EncodedRgb8& a, const EncodedRgb8& b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

} // namespace metamer::test
