// The ways to make an atlas's 8-bit rows of spectra.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace metamer {

enum class Quantization {
    /// The thesis's: values at the grid's wavelengths, rounded half up, on their own; materials at scale 1.
    thesis,
    /// Intervals weigh as ASTM E308 forms its weights (weighted_observer), what lies outside the grid folded
    /// onto
    /// its ends; the levels of a row are chosen together, so that sums over the row come out right; materials
    /// are stored at full scale with their scale apart.
    weighted
};

struct QuantizationName {
    Quantization quantization;
    std::string_view name;
};

/// What they are called in files, options and exhibits.
inline constexpr std::array<QuantizationName, 2> kQuantizations{
    {{Quantization::thesis, "thesis"}, {Quantization::weighted, "weighted"}}};

constexpr std::string_view name_of(Quantization quantization) {
    for (const QuantizationName& known : kQuantizations)
        if (known.quantization == quantization)
            return known.name;
    return {};
}

/// The quantization of this name (case counts); none when there is none.
constexpr std::optional<Quantization> find_quantization(std::string_view name) {
    for (const QuantizationName& known : kQuantizations)
        if (known.name == name)
            return known.quantization;
    return {};
}

} // namespace metamer
