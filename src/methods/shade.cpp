#include "methods/shade.h"

#include <algorithm>
#include <cmath>

#include "methods/three_numbers.h"

namespace metamer {

namespace {

template <Scalar T>
std::array<T, 3> narrowed(const std::array<double, 3>& v) {
    return {uploaded<T>(v[0]), uploaded<T>(v[1]), uploaded<T>(v[2])};
}

template <Scalar T>
Light<T> narrowed(const Light<double>& light) {
    return {uploaded<T>(light.diffuse), uploaded<T>(light.mirrored), uploaded<T>(light.bounced)};
}

std::array<double, 3> numbers(const Xyz& c) {
    return {c.x, c.y, c.z};
}

OutputSpace with_dominant(const Pixel& pixel, const Sight& sight) {
    OutputSpace output = sight.output;
    if (!output.dominant)
        output.dominant = pixel.lamps.front().row;
    return output;
}

template <Scalar T>
BasicLinearRgb<T> shade_product(Method method, const Pixel& pixel, const Sight& sight) {
    const OutputSpace output = with_dominant(pixel, sight);
    const auto of = [&](const Layer& layer) {
        return material_numbers(method, *layer.row, *sight.seen, output);
    };
    std::vector<LitColor<T>> lit;
    for (const PixelLamp& lamp : pixel.lamps) {
        auto color = lamp_numbers(method, *lamp.row, *sight.seen, output);
        for (double& c : color)
            c *= lamp.strength;
        lit.push_back({narrowed<T>(color), narrowed<T>(lamp.light)});
    }
    ProductLayers<T> layers{.material = narrowed<T>(of(pixel.material))};
    if (pixel.medium) {
        layers.medium_log2 = narrowed<T>(medium_log2(of(*pixel.medium)));
        layers.thickness = static_cast<T>(pixel.thickness);
    }
    if (pixel.other)
        layers.other = narrowed<T>(of(*pixel.other));
    const auto [a, b, c] = product<T>(lit, layers);
    if (method == Method::rgb)
        return {a, b, c};
    return to_output(rgb_from_numbers(method, output), BasicXyz<T>{a, b, c});
}

template <Scalar T>
BasicLinearRgb<T> shade_loop(Method method, const Pixel& pixel, const Sight& sight) {
    std::vector<LitEmission<T>> lit;
    for (const PixelLamp& lamp : pixel.lamps)
        lit.push_back({lamp.row, uploaded<T>(lamp.strength), narrowed<T>(lamp.light)});
    SpectralLayers<T> layers{pixel.material.row};
    if (pixel.medium) {
        layers.medium = pixel.medium->row;
        layers.thickness = static_cast<T>(pixel.thickness);
    }
    if (pixel.other)
        layers.other = pixel.other->row;
    const Matrix3 matrix = sight.output.adapted_rgb_from_xyz();
    return to_output(matrix, method == Method::packed ? packed<T>(lit, layers, *sight.seen)
                                                      : spectral<T>(lit, layers, *sight.seen));
}

template <Scalar T>
BasicLinearRgb<T> shade_folded(const Pixel& pixel, const Sight& sight) {
    std::vector<FoldedLamp<T>> lit;
    for (const FoldedLamp<double>& lamp :
         folded_lamps(pixel, *sight.exact, sight.output.adapted_rgb_from_xyz()))
        lit.push_back({narrowed<T>(lamp.reflected), narrowed<T>(lamp.mirrored), narrowed<T>(lamp.bounced),
                       narrowed<T>(lamp.light)});
    const auto [r, g, b] = folded<T>(lit);
    return {r, g, b};
}

template <Scalar T>
BasicLinearRgb<T> shade_reduced(const Pixel& pixel, const Sight& sight) {
    const Taps own = sight.taps ? Taps{} : taps_for(pixel, sight.tap_count);
    const Taps& taps = sight.taps ? *sight.taps : own;
    const Matrix3 matrix = sight.output.adapted_rgb_from_xyz();
    const auto colors = tap_colors(pixel, taps, matrix);
    std::vector<std::vector<TapWeight<T>>> weights(colors.size());
    std::vector<ReducedLamp<T>> lit;
    for (std::size_t l = 0; l < colors.size(); ++l) {
        for (const auto& rgb : colors[l])
            weights[l].push_back({narrowed<T>(rgb)});
        const PixelLamp& lamp = pixel.lamps[l];
        auto mirrored = matrix * numbers(lamp_white(lamp, *sight.exact));
        for (double& c : mirrored)
            c *= lamp.strength;
        lit.push_back({weights[l], narrowed<T>(mirrored), narrowed<T>(lamp.light)});
    }
    std::vector<TapLayers<T>> layers;
    for (const TapLayers<double>& layer : tap_layers(pixel, taps))
        layers.push_back({static_cast<T>(layer.medium_log2), static_cast<T>(layer.other)});
    const auto [r, g, b] = reduced<T>(lit, layers, static_cast<T>(pixel.medium ? pixel.thickness : 0));
    return {r, g, b};
}

// What each lamp alone makes of the pixel if this is its light.
std::vector<std::array<double, 3>> folded_under(const Pixel& pixel, const Light<double>& light,
                                                const GridObserver& exact, const Matrix3& rgb_from_xyz) {
    std::vector<std::array<double, 3>> colors;
    Pixel one = pixel;
    for (const PixelLamp& lamp : pixel.lamps) {
        one.lamps = {{lamp.row, lamp.full, lamp.strength, light}};
        colors.push_back(rgb_from_xyz * numbers(exact_xyz(one, exact)));
    }
    return colors;
}

} // namespace

std::array<double, 3> medium_log2(const std::array<double, 3>& numbers) {
    std::array<double, 3> out{};
    for (std::size_t c = 0; c < 3; ++c)
        out[c] = std::log2(std::clamp(numbers[c], kLeastTransmittance, 1.0));
    return out;
}

std::vector<std::vector<double>> own_spectra(const Pixel& pixel) {
    constexpr int kThicknesses = 16, kMixtures = 4;
    const std::vector<double> material = full_values(pixel.material);
    std::vector<std::vector<double>> spectra;
    const auto add = [&](const auto& factor) {
        spectra.push_back(material);
        for (std::size_t i = 0; i < material.size(); ++i)
            spectra.back()[i] *= factor(i);
    };
    if (pixel.medium) {
        const std::vector<double> t = full_values(*pixel.medium);
        for (int step = 0; step <= kThicknesses; ++step)
            add([&](std::size_t i) {
                return std::pow(std::max(t[i], kLeastTransmittance), pixel.thickness * step / kThicknesses);
            });
    } else if (pixel.other) {
        const std::vector<double> other = full_values(*pixel.other);
        for (int step = 0; step <= kMixtures; ++step)
            add([&](std::size_t i) {
                const double t = static_cast<double>(step) / kMixtures;
                return 1 - t + t * other[i];
            });
    } else {
        spectra.push_back(material);
    }
    return spectra;
}

Taps taps_for(const Pixel& pixel, int count) {
    return taps_for(pixel, own_spectra(pixel), count);
}

Taps taps_for(const Pixel& pixel, const std::vector<std::vector<double>>& own, int count) {
    std::vector<ReferenceLamp> made(pixel.lamps.size());
    std::vector<const ReferenceLamp*> lamps;
    for (std::size_t l = 0; l < pixel.lamps.size(); ++l) {
        const PixelLamp& lamp = pixel.lamps[l];
        if (!lamp.full)
            made[l] = reference_lamp(*lamp.row);
        lamps.push_back(lamp.full ? lamp.full : &made[l]);
    }
    return choose_taps(lamps, own, count);
}

std::vector<std::vector<std::array<double, 3>>> tap_colors(const Pixel& pixel, const Taps& taps,
                                                           const Matrix3& rgb_from_xyz) {
    std::vector<std::vector<std::array<double, 3>>> colors(pixel.lamps.size());
    for (std::size_t l = 0; l < colors.size(); ++l)
        for (std::size_t i = 0; i < taps.wavelength_nm.size(); ++i) {
            auto rgb = rgb_from_xyz * numbers(taps.weight[l][i]);
            const double share = pixel.lamps[l].strength * pixel.material.at(taps.wavelength_nm[i]);
            colors[l].push_back({share * rgb[0], share * rgb[1], share * rgb[2]});
        }
    return colors;
}

std::vector<TapLayers<double>> tap_layers(const Pixel& pixel, const Taps& taps) {
    std::vector<TapLayers<double>> layers;
    for (const double nm : taps.wavelength_nm) {
        const double t = pixel.medium ? std::max(pixel.medium->at(nm), kLeastTransmittance) : 1;
        layers.push_back({std::log2(t), pixel.other ? pixel.other->at(nm) : 0});
    }
    return layers;
}

std::vector<std::array<double, 3>> reflected_colors(const Pixel& pixel, const GridObserver& exact,
                                                    const Matrix3& rgb_from_xyz) {
    return folded_under(pixel, {1, 0, 0}, exact, rgb_from_xyz);
}

std::vector<FoldedLamp<double>> folded_lamps(const Pixel& pixel, const GridObserver& exact,
                                             const Matrix3& rgb_from_xyz) {
    const auto reflected = reflected_colors(pixel, exact, rgb_from_xyz);
    const auto mirrored = folded_under(pixel, {0, 1, 0}, exact, rgb_from_xyz);
    std::vector<std::array<double, 3>> bounced(pixel.lamps.size());
    if (pixel.other)
        bounced = folded_under(pixel, {0, 0, 1}, exact, rgb_from_xyz);
    std::vector<FoldedLamp<double>> out;
    for (std::size_t l = 0; l < pixel.lamps.size(); ++l)
        out.push_back({reflected[l], mirrored[l], bounced[l], pixel.lamps[l].light});
    return out;
}

template <Scalar T>
BasicLinearRgb<T> shade(Method method, const Pixel& pixel, const Sight& sight) {
    if (is_product(method))
        return shade_product<T>(method, pixel, sight);
    if (method == Method::folded)
        return shade_folded<T>(pixel, sight);
    if (method == Method::reduced)
        return shade_reduced<T>(pixel, sight);
    return shade_loop<T>(method, pixel, sight);
}

template <Scalar T>
Xyz shade_xyz(Method method, const Pixel& pixel, const Sight& sight) {
    Sight unadapted = sight;
    unadapted.output.adaptation = Matrix3::identity();
    const BasicLinearRgb<T> rgb = shade<T>(method, pixel, unadapted);
    return to_xyz(inverse(sight.output.rgb_from_xyz).value(),
                  {static_cast<double>(rgb.r), static_cast<double>(rgb.g), static_cast<double>(rgb.b)});
}

#define METAMER_SHADE(T)                                                                                     \
    template BasicLinearRgb<T> shade<T>(Method, const Pixel&, const Sight&);                                 \
    template Xyz shade_xyz<T>(Method, const Pixel&, const Sight&);
METAMER_SHADE(double)
METAMER_SHADE(float)
METAMER_SHADE(Float16)
#undef METAMER_SHADE

} // namespace metamer
