// The fields of a chart by name, once for CSV and JSON. Private to this room.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "report/growth_rows.h"
#include "report/paper.h"
#include "report/rows.h"

namespace metamer {

/// One field of `Of`: its name, its value as JSON, and how text sets it. `set` gives the cause why it cannot,
/// or an empty text.
template <class Of>
struct Field {
    std::string_view name;
    nlohmann::ordered_json (*get)(const Of&);
    std::string (*set)(Of&, const std::string& text);
};

/// The fields of ChartContext, ChartRow, GrowthRow, PaperContext, PaperRow.
template <class Of>
std::span<const Field<Of>> fields_of();

/// A field's value as CSV writes it: text as it is, numbers shortest, `true` and `false`.
std::string field_text(const nlohmann::ordered_json& value);

} // namespace metamer
