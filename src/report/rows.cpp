#include "report/rows.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/names.h"
#include "image/utf8.h"
#include "report/fields.h"
#include "spectra/csv_text.h"

namespace metamer {

namespace {

using Json = nlohmann::ordered_json;

void check(std::string_view name, const Json& value, const std::string& where) {
    const auto refuse = [&](const std::string& cause) {
        throw bad_input("write", "chart rows", where + std::string(name) + " " + cause);
    };
    if (value.is_number() && !(std::isfinite(value.get<double>()) && value.get<double>() >= 0))
        refuse("is no number of at least 0");
    if (value.is_string()) {
        const auto& text = value.get_ref<const std::string&>();
        if (!is_utf8(text) || has_control(text))
            refuse("is not one line of UTF-8: " + quotable(text));
    }
}

// Throws for what no file should hold, before anything is written.
void check(const Chart& chart) {
    for (const auto& field : context_fields())
        check(field.name, field.get(chart.context), "");
    for (std::size_t i = 0; i < chart.rows.size(); ++i)
        for (const auto& field : row_fields())
            check(field.name, field.get(chart.rows[i]), "row " + std::to_string(i + 1) + ": ");
}

// RFC 4180 section 2; the reader takes `;` and `#` for more than text, and trims.
std::string cell(const std::string& text) {
    if (text.find_first_of(",;\"#") == std::string::npos && trimmed(text) == text)
        return text;
    std::string out = "\"";
    for (const char c : text)
        out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + "\"";
}

// For each column the field that it holds.
std::vector<const Field<ChartRow>*> columns_of(const CsvRow& header, const std::string& place) {
    const auto fields = row_fields();
    std::vector<std::string> names;
    for (const auto& field : fields)
        names.emplace_back(field.name);
    std::vector<const Field<ChartRow>*> columns;
    for (const std::string& name : header.cells) {
        const auto at = std::find(names.begin(), names.end(), name) - names.begin();
        if (static_cast<std::size_t>(at) == names.size())
            refuse_line(place, header.line,
                        "no column is named \"" + quotable(name) + "\"" + did_you_mean(name, names));
        columns.push_back(&fields[static_cast<std::size_t>(at)]);
        if (std::count(columns.begin(), columns.end(), columns.back()) > 1)
            refuse_line(place, header.line, "the column " + name + " is there twice");
    }
    for (const auto& field : fields)
        if (std::find(columns.begin(), columns.end(), &field) == columns.end())
            refuse_line(place, header.line, "the column " + std::string(field.name) + " is missing");
    return columns;
}

void read_comment(ChartContext& context, const std::string& comment, const std::string& place) {
    for (const auto& field : context_fields()) {
        const std::string key = std::string(field.name) + ":";
        if (!comment.starts_with(key))
            continue;
        const std::string value(trimmed(std::string_view(comment).substr(key.size())));
        if (const std::string cause = field.set(context, value); !cause.empty())
            throw bad_input("read", place, std::string(field.name) + ": " + quotable(value) + " " + cause);
    }
}

} // namespace

std::string chart_csv(const Chart& chart) {
    check(chart);
    std::string out;
    for (const auto& field : context_fields())
        out += "# " + std::string(field.name) + ": " + field_text(field.get(chart.context)) + "\n";
    std::string line;
    for (const auto& field : row_fields())
        line += (line.empty() ? "" : ",") + std::string(field.name);
    out += line + "\n";
    for (const ChartRow& row : chart.rows) {
        line.clear();
        for (const auto& field : row_fields())
            line += (field.name == row_fields().front().name ? "" : ",") + cell(field_text(field.get(row)));
        out += line + "\n";
    }
    return out;
}

std::string chart_json(const Chart& chart) {
    check(chart);
    Json out{{"context", Json::object()}, {"rows", Json::array()}};
    for (const auto& field : context_fields())
        out["context"][std::string(field.name)] = field.get(chart.context);
    for (const ChartRow& row : chart.rows) {
        Json object = Json::object();
        for (const auto& field : row_fields())
            object[std::string(field.name)] = field.get(row);
        out["rows"].push_back(std::move(object));
    }
    return out.dump(2) + "\n";
}

Chart read_chart_csv(const std::string& text, const std::string& place) {
    if (!is_utf8(text))
        throw bad_input("read", place, "it is not UTF-8");
    const CsvText csv = split_csv(text, place);
    if (csv.rows.empty())
        throw bad_input("read", place, "it has no header line");
    Chart chart;
    for (const std::string& comment : csv.comments)
        read_comment(chart.context, comment, place);
    const auto columns = columns_of(csv.rows.front(), place);
    for (std::size_t i = 1; i < csv.rows.size(); ++i) {
        const CsvRow& row = csv.rows[i];
        if (row.cells.size() != columns.size())
            refuse_line(place, row.line,
                        std::to_string(row.cells.size()) + " cells under " + std::to_string(columns.size()) +
                            " columns");
        ChartRow& out = chart.rows.emplace_back();
        for (std::size_t c = 0; c < columns.size(); ++c)
            if (const std::string cause = columns[c]->set(out, row.cells[c]); !cause.empty())
                refuse_line(place, row.line,
                            std::string(columns[c]->name) + " = " + quotable(row.cells[c]) + " " + cause);
    }
    return chart;
}

} // namespace metamer
