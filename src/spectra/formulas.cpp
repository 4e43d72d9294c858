#include "spectra/formulas.h"

#include <array>

#include "base/error.h"
#include "base/names.h"
#include "base/numbers.h"
#include "base/printed.h"
#include "spectra/absorption.h"
#include "spectra/blackbody.h"
#include "spectra/daylight.h"
#include "spectra/gaussian.h"
#include "spectra/srgb_reflectance.h"

namespace metamer {

namespace {

const std::vector<std::string>& formula_names() {
    static const std::vector<std::string> names{"planck", "daylight", "gauss", "line", "rgb", "absorb"};
    return names;
}

struct Formula {
    std::string name;                  // lower case
    std::vector<std::string> operands; // after the colons
    std::string written;               // all of it, for errors
};

std::optional<Formula> take_apart(std::string_view name) {
    if (name.find(':') == std::string_view::npos)
        return std::nullopt;
    std::vector<std::string> pieces = split(name, ':');
    return Formula{lower_case(pieces.front()), {pieces.begin() + 1, pieces.end()}, std::string(name)};
}

Error refused(const Formula& formula, const std::string& cause) {
    return bad_input("compute", formula.written, cause);
}

Error unknown(const Formula& formula) {
    return refused(formula, "there is no formula " + formula.name + ":" +
                                did_you_mean(formula.name, formula_names()) +
                                " (planck:K, daylight:K, gauss:CENTER:FWHM, line:NM, rgb:RRGGBB, "
                                "absorb:CENTER:FWHM:DENSITY...)");
}

// What an operand is called, its unit and its range.
struct Operand {
    const char* what;
    const char* unit;
    double least, most;
};

constexpr Operand kPlanckTemperature{"temperature", "K", kColdestBlackbody_k, kHottestBlackbody_k};
constexpr Operand kDaylightTemperature{"color temperature", "K", kLowestDaylight_k, kHighestDaylight_k};
constexpr Operand kWavelength{"wavelength", "nm", kReferenceGrid.first_nm, kReferenceGrid.last_nm()};
constexpr Operand kFwhm{"width (FWHM)", "nm", kNarrowest_nm, kWidest_nm};
constexpr Operand kDensity{"density", "", 0, kDensest};

// Without an exponent: 100000, where to_text prefers the shorter 1e+05.
std::string plain(double value) {
    return printed("%.10g", value);
}

double number(const Formula& formula, const std::string& text, const Operand& wanted) {
    const auto& [what, unit, least, most] = wanted;
    const auto value = parse_number(text);
    if (!value)
        throw refused(formula, std::string(what) + " is no number: `" + text + "`");
    const std::string units = *unit ? std::string(" ") + unit : "";
    if (*value < least || *value > most)
        throw refused(formula, std::string(what) + " " + to_text(*value) + units + " is outside " +
                                   plain(least) + ".." + plain(most) + units);
    return *value;
}

template <std::size_t n>
std::array<double, n> numbers(const Formula& formula, const std::array<Operand, n>& wanted) {
    if (formula.operands.size() != n)
        throw refused(formula, formula.name + ": takes " + std::to_string(n) +
                                   (n == 1 ? " number" : " numbers") + ", here are " +
                                   std::to_string(formula.operands.size()));
    std::array<double, n> out{};
    for (std::size_t i = 0; i < n; ++i)
        out[i] = number(formula, formula.operands[i], wanted[i]);
    return out;
}

struct Band {
    double center_nm, fwhm_nm;
    std::string name() const { return "gauss:" + to_text(center_nm) + ":" + to_text(fwhm_nm); }
    std::string description() const {
        return "Gaussian band at " + to_text(center_nm) + " nm, " + to_text(fwhm_nm) +
               " nm wide at half its height";
    }
};

Band band(const Formula& formula) {
    const auto [center_nm, fwhm_nm] = numbers<2>(formula, {kWavelength, kFwhm});
    return {center_nm, fwhm_nm};
}

Lamp planck_lamp(double temperature_k) {
    const std::string k = to_text(temperature_k);
    return {"planck:" + k,
            "black body of " + k + " K, computed",
            "Planck's law, c2 = 1.438776877e-2 m K",
            {blackbody(temperature_k), {}}};
}

Lamp daylight_lamp(double cct_k) {
    const std::string k = to_text(cct_k);
    return {"daylight:" + k,
            "CIE daylight of " + k + " K, computed",
            "CIE 15:2004 eq. 3.2-3.6, components of Table T.2",
            {daylight(cct_k), {}}};
}

Lamp line_lamp(double wavelength_nm) {
    const std::string nm = to_text(wavelength_nm);
    return {"line:" + nm, "one line at " + nm + " nm, computed", "a line", {{}, {{wavelength_nm, 1}}}};
}

Material srgb_material(const Formula& formula) {
    const std::string digits = formula.operands.size() == 1 ? formula.operands.front() : std::string();
    const auto code = parse_srgb_code(digits);
    if (!code)
        throw refused(formula, "rgb: takes six hexadecimal digits, RRGGBB");
    auto spectrum = srgb_reflectance(*code);
    if (!spectrum)
        throw refused(formula, "no reflectance in 0..1 has this color under D65");
    const std::string text = srgb_code_text(*code);
    return {"rgb:" + text,
            "modelled from sRGB " + text + ": the smoothest reflectance of this color under D65",
            "Burns's LHTSS for sRGB " + text + " under D65", std::move(*spectrum)};
}

Material absorbing_material(const Formula& formula) {
    const auto& operands = formula.operands;
    if (operands.empty() || operands.size() % 3 != 0)
        throw refused(formula, "absorb: takes three numbers a band, CENTER:FWHM:DENSITY, here are " +
                                   std::to_string(operands.size()));
    std::vector<AbsorptionBand> bands;
    std::string name = "absorb", at;
    for (std::size_t i = 0; i < operands.size(); i += 3) {
        const AbsorptionBand band{number(formula, operands[i], kWavelength),
                                  number(formula, operands[i + 1], kFwhm),
                                  number(formula, operands[i + 2], kDensity)};
        name += ":" + to_text(band.center_nm) + ":" + to_text(band.fwhm_nm) + ":" + to_text(band.density);
        at += (at.empty() ? "" : ", ") + to_text(band.center_nm);
        bands.push_back(band);
    }
    return {name,
            "absorbing medium with " + std::string(bands.size() == 1 ? "a band" : "bands") + " at " + at +
                " nm, internal transmittance at thickness 1, computed",
            "Gaussian bands of optical density", transmittance(bands)};
}

} // namespace

std::optional<Lamp> lamp_by_formula(std::string_view name) {
    const auto formula = take_apart(name);
    if (!formula)
        return std::nullopt;
    if (formula->name == "planck")
        return planck_lamp(numbers<1>(*formula, {kPlanckTemperature})[0]);
    if (formula->name == "daylight")
        return daylight_lamp(numbers<1>(*formula, {kDaylightTemperature})[0]);
    if (formula->name == "line")
        return line_lamp(numbers<1>(*formula, {kWavelength})[0]);
    if (formula->name == "gauss") {
        const Band b = band(*formula);
        return Lamp{
            b.name(), b.description() + ", computed", "a Gaussian", {gaussian(b.center_nm, b.fwhm_nm), {}}};
    }
    if (formula->name == "rgb" || formula->name == "absorb")
        throw refused(*formula, formula->name + ": makes a material, not a lamp");
    throw unknown(*formula);
}

std::optional<Material> material_by_formula(std::string_view name) {
    const auto formula = take_apart(name);
    if (!formula)
        return std::nullopt;
    if (formula->name == "gauss") {
        const Band b = band(*formula);
        return Material{
            b.name(), b.description() + ", computed", "a Gaussian", {gaussian(b.center_nm, b.fwhm_nm)}};
    }
    if (formula->name == "rgb")
        return srgb_material(*formula);
    if (formula->name == "absorb")
        return absorbing_material(*formula);
    if (formula->name == "line")
        throw refused(*formula, "a line has no width that a material could reflect; take gauss:CENTER:FWHM");
    if (formula->name == "planck" || formula->name == "daylight")
        throw refused(*formula, formula->name + ": makes a lamp, not a material");
    throw unknown(*formula);
}

} // namespace metamer
