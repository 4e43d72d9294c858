// Lamps, media and errors for the tests of taps.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "color/difference.h"
#include "color/resample.h"
#include "methods/taps.h"
#include "spectra/library.h"

namespace metamer::test {

using Spectrum = std::vector<double>;

// Lamps with the pointers that choose_taps takes.
struct Lamps {
    std::vector<ReferenceLamp> lamp;
    std::vector<const ReferenceLamp*> view;

    explicit Lamps(std::vector<ReferenceLamp> all) : lamp(std::move(all)) {
        for (const ReferenceLamp& one : lamp)
            view.push_back(&one);
    }
};

inline ReferenceLamp lamp_of(const std::string& name) {
    return reference_lamp(find_lamp(name).spectrum);
}

inline ReferenceLamp lines(std::vector<EmissionLine> all) {
    return reference_lamp(LampSpectrum{{}, std::move(all)});
}

inline Spectrum spectrum_of(const std::string& material) {
    return resample(find_material(material).spectrum, kReferenceGrid);
}

inline const Spectrum& perfect() {
    static const Spectrum ones(kReferenceGrid.count, 1.0);
    return ones;
}

// R T^d at evenly spaced thicknesses 0 .. most; media have density 1 at thickness 1.
inline std::vector<Spectrum> wedge(const Spectrum& medium, const Spectrum& wall, int count, double most = 3) {
    std::vector<Spectrum> out;
    for (int k = 0; k < count; ++k) {
        const double thickness = most * k / (count - 1);
        out.emplace_back(wall);
        for (std::size_t i = 0; i < wall.size(); ++i)
            out.back()[i] *= std::pow(medium[i], thickness);
    }
    return out;
}

struct Errors {
    double mean = 0, most = 0;
};

inline Errors errors(const Taps& taps, const Lamps& lamps, const std::vector<Spectrum>& seen) {
    Errors out;
    for (std::size_t l = 0; l < lamps.lamp.size(); ++l)
        for (const Spectrum& f : seen) {
            const double e = delta_e_2000(reference_xyz(lamps.lamp[l], f), taps_xyz(taps, l, f));
            out.most = std::max(out.most, e);
            out.mean += e / static_cast<double>(seen.size() * lamps.lamp.size());
        }
    return out;
}

struct Scene {
    const char* name;
    std::vector<std::string> lamps;
};

// What a visitor may choose: smooth, banded and line lamps, alone and together.
inline const std::vector<Scene>& scenes() {
    static const std::vector<Scene> all{{"A", {"A"}},
                                        {"D65", {"D65"}},
                                        {"LED", {"white-LED"}},
                                        {"F2", {"F2"}},
                                        {"F11", {"F11"}},
                                        {"krypton", {"krypton"}},
                                        {"LPS", {"NIST-LPS"}},
                                        {"A+F11+krypton", {"A", "F11", "krypton"}},
                                        {"D65+F2+LED", {"D65", "F2", "white-LED"}}};
    return all;
}

inline Lamps lamps_of(const Scene& scene) {
    std::vector<ReferenceLamp> lamps;
    for (const std::string& name : scene.lamps)
        lamps.push_back(lamp_of(name));
    return Lamps(std::move(lamps));
}

} // namespace metamer::test
