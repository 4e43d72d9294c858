#include "report/fields.h"

#include <array>

#include "base/names.h"
#include "base/numbers.h"
#include "base/utf8.h"

namespace metamer {

namespace {

using Json = nlohmann::ordered_json;

std::string take(std::string& field, const std::string& text) {
    field = text;
    return {};
}

std::string take(double& field, const std::string& text) {
    const auto value = parse_number(text);
    if (!value || *value < 0)
        return "is no number of at least 0";
    field = *value;
    return {};
}

std::string take(int& field, const std::string& text) {
    const auto value = parse_whole(text);
    if (!value || *value < 0)
        return "is no whole number of at least 0";
    field = *value;
    return {};
}

std::string take(bool& field, const std::string& text) {
    field = text == "true";
    return field || text == "false" ? "" : "is neither true nor false";
}

// The two values of each enum by name.
template <class Enum>
constexpr std::array<std::string_view, 2> kNames{};
template <>
constexpr std::array<std::string_view, 2> kNames<Precision>{"fp16", "fp32"};
template <>
constexpr std::array<std::string_view, 2> kNames<Levels>{"8-bit", "unquantized"};
template <>
constexpr std::array<std::string_view, 2> kNames<FrontierBy>{"delta_e_mean", "delta_e_max"};

template <class Enum>
requires std::is_enum_v<Enum> std::string take(Enum& field, const std::string& text) {
    field = text == kNames<Enum>[1] ? Enum{1} : Enum{0};
    return text == kNames<Enum>[0] || text == kNames<Enum>[1]
               ? ""
               : "is neither " + std::string(kNames<Enum>[0]) + " nor " + std::string(kNames<Enum>[1]);
}

template <class T>
Json to_json(const T& value) {
    if constexpr (std::is_enum_v<T>)
        return kNames<T>[static_cast<std::size_t>(value)];
    else
        return value;
}

template <class Of, auto member>
constexpr Field<Of> field(std::string_view name) {
    return {name, [](const Of& of) { return to_json(of.*member); },
            [](Of& of, const std::string& text) { return take(of.*member, text); }};
}

using R = ChartRow;
constexpr std::array kRowFields{
    field<R, &R::method>("method"),
    field<R, &R::taps>("taps"),
    field<R, &R::precision>("precision"),
    field<R, &R::atlas>("atlas"),
    field<R, &R::ms>("ms"),
    field<R, &R::ms_q1>("ms_q1"),
    field<R, &R::ms_q3>("ms_q3"),
    field<R, &R::cost_ratio>("cost_ratio"),
    field<R, &R::cost_ratio_q1>("cost_ratio_q1"),
    field<R, &R::cost_ratio_q3>("cost_ratio_q3"),
    field<R, &R::delta_e_mean>("delta_e_mean"),
    field<R, &R::delta_e_p95>("delta_e_p95"),
    field<R, &R::delta_e_max>("delta_e_max"),
    field<R, &R::worst_lamp>("worst_lamp"),
    field<R, &R::worst_material>("worst_material"),
    field<R, &R::on_frontier>("on_frontier"),
    field<R, &R::chosen>("chosen"),
};

using C = ChartContext;
constexpr std::array kContextFields{
    field<C, &C::exhibit>("exhibit"),
    field<C, &C::gl_renderer>("gl_renderer"),
    field<C, &C::date>("date"),
    field<C, &C::command>("command"),
    field<C, &C::timer>("timer"),
    field<C, &C::left_out>("left_out"),
    field<C, &C::rounds>("rounds"),
    field<C, &C::width_px>("width_px"),
    field<C, &C::height_px>("height_px"),
    field<C, &C::lamps>("lamps"),
    field<C, &C::materials>("materials"),
    field<C, &C::tolerance>("tolerance"),
    field<C, &C::frontier_by>("frontier_by"),
};

using G = GrowthRow;
constexpr std::array kGrowthFields{
    field<G, &G::panel>("panel"),
    field<G, &G::swept>("swept"),
    field<G, &G::log_x>("log_x"),
    field<G, &G::method>("method"),
    field<G, &G::x>("x"),
    field<G, &G::ms>("ms"),
    field<G, &G::cost_ratio>("cost_ratio"),
    field<G, &G::cost_ratio_q1>("cost_ratio_q1"),
    field<G, &G::cost_ratio_q3>("cost_ratio_q3"),
    field<G, &G::cost_ratio_here>("cost_ratio_here"),
};

using PC = PaperContext;
constexpr std::array kPaperContextFields{
    field<PC, &PC::assumption>("assumption"),
    field<PC, &PC::compilers>("compilers"),
    field<PC, &PC::date>("date"),
    field<PC, &PC::command>("command"),
};

using P = PaperRow;
constexpr std::array kPaperFields{
    field<P, &P::gpu>("gpu"),
    field<P, &P::method>("method"),
    field<P, &P::straight>("straight"),
    field<P, &P::loop>("loop"),
    field<P, &P::rounds>("rounds"),
    field<P, &P::clock_mhz>("clock_mhz"),
    field<P, &P::instructions_per_clock>("instructions_per_clock"),
    field<P, &P::source>("source"),
};

} // namespace

template <>
std::span<const Field<ChartRow>> fields_of() {
    return kRowFields;
}

template <>
std::span<const Field<ChartContext>> fields_of() {
    return kContextFields;
}

template <>
std::span<const Field<GrowthRow>> fields_of() {
    return kGrowthFields;
}

template <>
std::span<const Field<PaperContext>> fields_of() {
    return kPaperContextFields;
}

template <>
std::span<const Field<PaperRow>> fields_of() {
    return kPaperFields;
}

std::string field_text(const Json& value) {
    if (value.is_string())
        return value.get<std::string>();
    if (value.is_boolean())
        return value.get<bool>() ? "true" : "false";
    return to_text(value.get<double>());
}

} // namespace metamer
