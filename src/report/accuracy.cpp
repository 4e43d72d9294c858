#include "report/accuracy.h"

#include <cmath>
#include <map>
#include <set>

#include "atlas/lamp_fit.h"
#include "atlas/material_fit.h"
#include "color/difference.h"
#include "color/resample.h"
#include "report/chart_exhibits.h"

namespace metamer {

namespace {

Emission unrounded(const Lamp& lamp, Quantization quantization) {
    if (quantization == Quantization::thesis)
        return sample_lamp(lamp.spectrum).emission;
    const RowValues best = fit_lamp(lamp_power(lamp.spectrum)).best;
    const double peak = *std::max_element(best.begin(), best.end());
    Emission out;
    for (std::size_t i = 0; i < kIntervals; ++i)
        out.value[i] = best[i] / peak;
    return out;
}

Reflectance unrounded(const Material& material, Quantization quantization) {
    if (quantization == Quantization::thesis)
        return sample_material(material.spectrum);
    return {fit_material(material.spectrum).best};
}

/// What tells a pixel from others of the exhibit.
std::string signature(const NamedPixel& named) {
    const Light<double>& light = named.pixel.lamps[0].light;
    const auto wall = reinterpret_cast<std::uintptr_t>(named.pixel.other ? named.pixel.other->row : nullptr);
    return in_english(named.name) + "|" + std::to_string(wall) + "|" + std::to_string(light.diffuse) + "|" +
           std::to_string(light.bounced);
}

} // namespace

/// The exhibit as one of the Levels knows it, with the pixels of each object.
struct AccuracyProbe::Stock {
    explicit Stock(Exhibit known)
        : exhibit(std::move(known)), spectra(exhibit), view(half_views(exhibit)[0]) {
        std::set<std::string> seen;
        for (const ObjectSetting& object : exhibit.objects) {
            auto& pixels = objects.emplace_back();
            for (const NamedPixel& named : pixels_of(exhibit, view, spectra, object))
                if (named.lamps.size() == 1 && seen.insert(signature(named)).second)
                    pixels.push_back(named);
        }
        for (const HalfLamp& lamp : view.lamps)
            if (lamp.full)
                emissions[&lamp.emission] =
                    unrounded(exhibit.lamps[lamp.setting].lamp, exhibit.atlas.quantization);
        for (const auto& [key, material] : exhibit.materials)
            reflectances[spectra.material(key).row] = unrounded(material, exhibit.atlas.quantization);
    }

    Pixel with_unrounded_rows(Pixel pixel) const {
        for (PixelLamp& lamp : pixel.lamps)
            if (const auto found = emissions.find(lamp.row); found != emissions.end())
                lamp.row = &found->second;
        const auto replace = [&](Layer& layer) {
            if (const auto found = reflectances.find(layer.row); found != reflectances.end())
                layer.row = &found->second;
        };
        replace(pixel.material);
        if (pixel.medium)
            replace(*pixel.medium);
        if (pixel.other)
            replace(*pixel.other);
        return pixel;
    }

    /// `unrounded_rows`: for loops and products.
    Sight sight(bool unrounded_rows) const {
        Sight out = sight_of(view, spectra);
        if (unrounded_rows)
            out.seen = &spectra.exact();
        if (const auto found = emissions.find(out.output.dominant);
            unrounded_rows && found != emissions.end())
            out.output.dominant = &found->second;
        out.output.adaptation = Matrix3::identity();
        return out;
    }

    Exhibit exhibit;
    ExhibitSpectra spectra;
    HalfView view;
    std::vector<std::vector<NamedPixel>> objects;
    std::map<const Emission*, Emission> emissions; ///< rows before their levels, by the row
    std::map<const Reflectance*, Reflectance> reflectances;
};

AccuracyProbe::AccuracyProbe(const Exhibit& exhibit)
    : full_(std::make_unique<Stock>(drawn_by(exhibit, std::nullopt, 0))),
      rows_(std::make_unique<Stock>(from_atlas_alone(drawn_by(exhibit, std::nullopt, 0)))) {
    for (const auto& pixels : full_->objects) {
        auto& exact = exact_.emplace_back();
        for (const NamedPixel& named : pixels)
            exact.push_back(exact_xyz(named.pixel, full_->spectra.exact()));
    }
}

AccuracyProbe::AccuracyProbe(AccuracyProbe&&) noexcept = default;
AccuracyProbe& AccuracyProbe::operator=(AccuracyProbe&&) noexcept = default;
AccuracyProbe::~AccuracyProbe() = default;

int AccuracyProbe::bits_of(Precision precision) {
    return precision == Precision::fp16 ? kHalfBits : kSingleBits;
}

const AccuracyProbe::Stock& AccuracyProbe::stock(Levels levels) const {
    return levels == Levels::eight_bit ? *rows_ : *full_;
}

Plan AccuracyProbe::plan(const Way& way, int fragment_bits) const {
    const Stock& known = stock(way.levels);
    return plan_exhibit(drawn_by(known.exhibit, way.method, way.taps), known.spectra, fragment_bits);
}

std::vector<PairDifference> AccuracyProbe::differences(const Way& way) const {
    const Stock& known = stock(way.levels);
    const Plan planned = plan(way, bits_of(way.precision));
    const bool unrounded_rows = way.method && way.levels == Levels::unquantized;
    Sight sight = known.sight(unrounded_rows);
    std::vector<PairDifference> out;
    for (std::size_t o = 0; o < known.objects.size(); ++o) {
        const ObjectPlan& object = planned.halves[0].objects[o];
        for (std::size_t p = 0; p < known.objects[o].size(); ++p) {
            const NamedPixel& named = known.objects[o][p];
            const Pixel pixel = unrounded_rows ? known.with_unrounded_rows(named.pixel) : named.pixel;
            const Taps taps = object.method == Method::reduced ? of_lamps(object.taps, named.lamps) : Taps{};
            sight.taps = &taps;
            const double difference =
                delta_e_2000(shown_xyz(object.method, pixel, sight, planned.fragment_bits), exact_[o][p]);
            out.push_back({std::isfinite(difference) ? difference : kNotANumber, named.name.lamp,
                           named.name.surface()});
        }
    }
    return out;
}

} // namespace metamer
