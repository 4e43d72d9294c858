// Files of rows by their fields: a context, then rows, as CSV and JSON, the same for every chart. Private to
// this room.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "base/names.h"
#include "base/utf8.h"
#include "report/fields.h"
#include "spectra/csv_text.h"

namespace metamer {

/// Throws bad_input `cannot write WHAT: WHERE NAME ...` for what no file should hold.
void check_field(std::string_view name, const nlohmann::ordered_json& value, const std::string& what,
                 const std::string& where);

/// A cell as RFC 4180 section 2 writes it.
std::string csv_cell(const std::string& text);

/// For each cell of the header the place of its name in `names`. Throws bad_input at its line for a name that
/// is missing, unknown or there twice.
std::vector<std::size_t> header_columns(const CsvRow& header, const std::vector<std::string>& names,
                                        const std::string& place);

template <class Context, class Row>
void check_fields(const Context& context, const std::vector<Row>& rows, const std::string& what) {
    for (const auto& field : fields_of<Context>())
        check_field(field.name, field.get(context), what, "");
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (const auto& field : fields_of<Row>())
            check_field(field.name, field.get(rows[i]), what, "row " + std::to_string(i + 1) + ": ");
}

/// `# key: value` lines, a header, a line per row. `what` names them in errors.
template <class Context, class Row>
std::string fields_csv(const Context& context, const std::vector<Row>& rows, const std::string& what) {
    check_fields(context, rows, what);
    std::string out;
    for (const auto& field : fields_of<Context>())
        out += "# " + std::string(field.name) + ": " + field_text(field.get(context)) + "\n";
    std::string line;
    for (const auto& field : fields_of<Row>())
        line += (line.empty() ? "" : ",") + std::string(field.name);
    out += line + "\n";
    for (const Row& row : rows) {
        line.clear();
        for (const auto& field : fields_of<Row>())
            line += (&field == &fields_of<Row>().front() ? "" : ",") + csv_cell(field_text(field.get(row)));
        out += line + "\n";
    }
    return out;
}

/// {"context": {...}, "rows": [{...}]}; ends in a line break.
template <class Context, class Row>
std::string fields_json(const Context& context, const std::vector<Row>& rows, const std::string& what) {
    using Json = nlohmann::ordered_json;
    check_fields(context, rows, what);
    Json out{{"context", Json::object()}, {"rows", Json::array()}};
    for (const auto& field : fields_of<Context>())
        out["context"][std::string(field.name)] = field.get(context);
    for (const Row& row : rows) {
        Json object = Json::object();
        for (const auto& field : fields_of<Row>())
            object[std::string(field.name)] = field.get(row);
        out["rows"].push_back(std::move(object));
    }
    return out.dump(2) + "\n";
}

template <class Context>
void read_comment(Context& context, const std::string& comment, const std::string& place) {
    for (const auto& field : fields_of<Context>()) {
        const std::string key = std::string(field.name) + ":";
        if (!comment.starts_with(key))
            continue;
        const std::string value(trimmed(std::string_view(comment).substr(key.size())));
        if (const std::string cause = field.set(context, value); !cause.empty())
            throw bad_input("read", place, std::string(field.name) + ": " + quotable(value) + " " + cause);
    }
}

/// Reads what fields_csv wrote, columns in any order, and calls `took(row, line)` after each row. Throws
/// bad_input `cannot read PLACE:LINE: ...`.
template <class Context, class Row, class Took>
void read_fields_csv(const std::string& text, const std::string& place, Context& context,
                     std::vector<Row>& rows, const Took& took) {
    if (!is_utf8(text))
        throw bad_input("read", place, "it is not UTF-8");
    const CsvText csv = split_csv(text, place);
    if (csv.rows.empty())
        throw bad_input("read", place, "it has no header line");
    for (const std::string& comment : csv.comments)
        read_comment(context, comment, place);
    std::vector<std::string> names;
    for (const auto& field : fields_of<Row>())
        names.emplace_back(field.name);
    const auto columns = header_columns(csv.rows.front(), names, place);
    for (std::size_t i = 1; i < csv.rows.size(); ++i) {
        const CsvRow& row = csv.rows[i];
        if (row.cells.size() != columns.size())
            refuse_line(place, row.line,
                        std::to_string(row.cells.size()) + " cells under " + std::to_string(columns.size()) +
                            " columns");
        Row& out = rows.emplace_back();
        for (std::size_t c = 0; c < columns.size(); ++c) {
            const Field<Row>& field = fields_of<Row>()[columns[c]];
            if (const std::string cause = field.set(out, row.cells[c]); !cause.empty())
                refuse_line(place, row.line,
                            std::string(field.name) + " = " + quotable(row.cells[c]) + " " + cause);
        }
        took(out, row.line);
    }
}

} // namespace metamer
