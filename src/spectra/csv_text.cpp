#include "spectra/csv_text.h"

#include <string_view>

#include "base/error.h"
#include "base/names.h"
#include "base/numbers.h"

namespace metamer {

namespace {

// Takes the next line off the front; LF, CRLF and a lone CR end it.
std::string_view next_line(std::string_view& rest) {
    const std::size_t end = rest.find_first_of("\r\n");
    const std::string_view line = rest.substr(0, end);
    if (end == std::string_view::npos)
        rest = {};
    else
        rest.remove_prefix(end + (rest.substr(end).starts_with("\r\n") ? 2 : 1));
    return line;
}

struct Cells {
    std::vector<std::string> cells;
    bool semicolon = false; // outside quotes
    bool open_quote = false;
};

Cells split_cells(std::string_view line) {
    Cells out;
    std::string cell;
    bool quoted = false, was_quoted = false;
    const auto finish = [&] {
        out.cells.emplace_back(was_quoted ? cell : std::string(trimmed(cell)));
        cell.clear();
        was_quoted = false;
    };
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"')
            cell += line[++i];
        else if (quoted && c == '"')
            quoted = false;
        else if (!quoted && c == '"' && trimmed(cell).empty()) {
            cell.clear();
            quoted = was_quoted = true;
        } else if (!quoted && c == ',')
            finish();
        else if (quoted || !was_quoted || !trimmed(std::string_view(&c, 1)).empty()) {
            cell += c;
            out.semicolon = out.semicolon || (!quoted && c == ';');
        }
    }
    out.open_quote = quoted;
    finish();
    return out;
}

// Why a line without a comma is none of ours.
std::string single_cell_cause(const std::string& cell) {
    const std::string rule = "; the separator must be a comma, the decimal mark a point";
    if (cell.find('\t') != std::string::npos)
        return "cells are separated by tabs" + rule;
    const std::size_t blank = cell.find(' ');
    if (blank != std::string::npos && parse_number(cell.substr(0, blank)))
        return "cells are separated by blanks" + rule;
    return "there is one column only; a spectrum has a wavelength and at least one value";
}

} // namespace

void refuse_line(const std::string& place, int line, const std::string& cause) {
    throw bad_input("read", place + ":" + std::to_string(line), cause);
}

CsvText split_csv(const std::string& text, const std::string& place) {
    std::string_view rest = text;
    if (rest.starts_with("\xEF\xBB\xBF"))
        rest.remove_prefix(3);
    if (rest.starts_with("\xFF\xFE") || rest.starts_with("\xFE\xFF"))
        throw bad_input("read", place, "it is UTF-16; save it as UTF-8");
    if (rest.find('\0') != std::string_view::npos)
        throw bad_input("read", place, "it is no text file");
    CsvText out;
    for (int number = 1; !rest.empty(); ++number) {
        const std::string_view line = trimmed(next_line(rest));
        if (line.empty())
            continue;
        if (line.front() == '#') {
            out.comments.emplace_back(trimmed(line.substr(1)));
            continue;
        }
        Cells cells = split_cells(line);
        if (cells.open_quote)
            refuse_line(place, number, "a double quote is not closed");
        if (cells.semicolon)
            refuse_line(
                place, number,
                "cells are separated by `;`; the separator must be a comma, the decimal mark a point");
        if (cells.cells.size() == 1)
            refuse_line(place, number, single_cell_cause(cells.cells.front()));
        out.rows.push_back({number, std::move(cells.cells)});
    }
    return out;
}

} // namespace metamer
