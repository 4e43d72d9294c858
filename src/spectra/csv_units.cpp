#include "spectra/csv_units.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "base/error.h"
#include "base/names.h"

namespace metamer {

namespace {

using Words = std::vector<std::string_view>;

const Words kNanometers{"nm", "nanometer", "nanometers", "nanometre", "nanometres"};
// The micro sign is U+00B5 or the Greek letter U+03BC; the angstrom is U+00C5 or U+212B.
const Words kMicrometers{"um",         "\xC2\xB5m",   "\xCE\xBCm",  "micron",     "microns",
                         "micrometer", "micrometers", "micrometre", "micrometres"};
const Words kAngstroms{"angstrom", "angstroms", "\xC3\x85", "\xC3\xA5", "\xE2\x84\xAB"};
const Words kNotWavelengths{"wavenumber", "wavenumbers", "frequency", "hz", "ghz", "thz", "ev"};
const Words kPhotons{"photon", "photons", "quanta", "mol", "umol", "\xC2\xB5mol", "\xCE\xBCmol"};
const Words kOfMaterials{"reflectance", "reflectivity", "transmittance", "transmission", "absorbance"};
const Words kOfLamps{"w",     "mw", "uw", "\xC2\xB5w", "\xCE\xBCw", "watt",       "watts",     "power",
                     "lumen", "lm", "lx", "lux",       "radiance",  "irradiance", "absorbance"};

// Lower-case words: runs of ASCII letters and non-ASCII bytes.
std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    bool inside = false;
    for (const char c : lower_case(text)) {
        const bool letter = (c >= 'a' && c <= 'z') || (static_cast<unsigned char>(c) & 0x80u) != 0;
        if (letter && !inside)
            words.emplace_back();
        if (letter)
            words.back() += c;
        inside = letter;
    }
    return words;
}

std::optional<std::string> first_of(std::string_view text, Words wanted) {
    for (const std::string& word : words_of(text))
        if (std::find(wanted.begin(), wanted.end(), word) != wanted.end())
            return word;
    return std::nullopt;
}

std::optional<std::string> wavenumber_or_frequency(std::string_view text) {
    for (const std::string_view written : {"cm-1", "cm^-1", "1/cm "})
        if ((lower_case(text) + " ").find(written) != std::string::npos)
            return std::string(trimmed(written));
    return first_of(text, kNotWavelengths);
}

std::optional<double> named_nm_per_unit(std::string_view text) {
    if (first_of(text, kNanometers))
        return 1.0;
    if (first_of(text, kMicrometers))
        return 1000.0;
    if (first_of(text, kAngstroms))
        return 0.1;
    return std::nullopt;
}

} // namespace

bool is_wavelength_header(std::string_view cell) {
    if (named_nm_per_unit(cell) || wavenumber_or_frequency(cell))
        return true;
    const std::vector<std::string> words = words_of(cell);
    if (words.empty())
        return false;
    for (const std::string_view start : {"wave", "lambda", "wl", "\xCE\xBB"})
        if (words.front().starts_with(start))
            return true;
    return false;
}

double nm_per_unit(std::string_view header, std::string_view unit_line, const std::string& place) {
    for (const std::string_view text : {header, unit_line})
        if (const auto word = wavenumber_or_frequency(text))
            throw bad_input("read", place,
                            "its unit names `" + *word + "`; convert it to nm and power per nm");
    if (const auto named = named_nm_per_unit(header))
        return *named;
    for (const Words& length : {kMicrometers, kAngstroms})
        if (const auto word = first_of(unit_line, length))
            throw bad_input(
                "read", place,
                "`# unit:` names `" + *word +
                    "`, the header no unit; call the first column wavelength_nm, wavelength_um or "
                    "wavelength_angstrom");
    return 1;
}

double value_scale(std::string_view unit_line, SpectrumKind kind, const std::string& place) {
    if (const auto word = first_of(unit_line, kPhotons))
        throw bad_input("read", place,
                        "its unit counts photons (`" + *word + "`); divide by the wavelength for power");
    if (kind == SpectrumKind::emission)
        if (const auto word = first_of(unit_line, kOfMaterials))
            throw bad_input("read", place, "its unit is that of a material (`" + *word + "`), not of a lamp");
    if (kind != SpectrumKind::reflectance)
        return 1;
    if (const auto word = first_of(unit_line, kOfLamps))
        throw bad_input("read", place, "its unit cannot be a reflectance (`" + *word + "`)");
    const bool percent = unit_line.find('%') != std::string_view::npos || first_of(unit_line, {"percent"});
    return percent ? 0.01 : 1;
}

} // namespace metamer
