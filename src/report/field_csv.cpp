#include "report/field_csv.h"

namespace metamer {

void check_field(std::string_view name, const nlohmann::ordered_json& value, const std::string& what,
                 const std::string& where) {
    const auto refuse = [&](const std::string& cause) {
        throw bad_input("write", what, where + std::string(name) + " " + cause);
    };
    if (value.is_number() && !(std::isfinite(value.get<double>()) && value.get<double>() >= 0))
        refuse("is no number of at least 0");
    if (value.is_string()) {
        const auto& text = value.get_ref<const std::string&>();
        if (!is_utf8(text) || has_control(text))
            refuse("is not one line of UTF-8: " + quotable(text));
    }
}

// The reader takes `;` and `#` for more than text, and trims.
std::string csv_cell(const std::string& text) {
    if (text.find_first_of(",;\"#") == std::string::npos && trimmed(text) == text)
        return text;
    std::string out = "\"";
    for (const char c : text)
        out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + "\"";
}

std::vector<std::size_t> header_columns(const CsvRow& header, const std::vector<std::string>& names,
                                        const std::string& place) {
    std::vector<std::size_t> columns;
    for (const std::string& name : header.cells) {
        const auto at = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
        if (at == names.size())
            refuse_line(place, header.line,
                        "no column is named \"" + quotable(name) + "\"" + did_you_mean(name, names));
        if (std::find(columns.begin(), columns.end(), at) != columns.end())
            refuse_line(place, header.line, "the column " + name + " is there twice");
        columns.push_back(at);
    }
    for (std::size_t i = 0; i < names.size(); ++i)
        if (std::find(columns.begin(), columns.end(), i) == columns.end())
            refuse_line(place, header.line, "the column " + names[i] + " is missing");
    return columns;
}

} // namespace metamer
