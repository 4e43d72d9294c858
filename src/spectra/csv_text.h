// CSV text taken apart: comments, and rows of cells with their line numbers.
#pragma once

#include <string>
#include <vector>

namespace metamer {

struct CsvRow {
    int line; ///< 1 for the file's first
    std::vector<std::string> cells;
};

struct CsvText {
    std::vector<std::string> comments; ///< without `#` and blanks around
    std::vector<CsvRow> rows;
};

/// Splits CSV text (RFC 4180, but no line breaks inside quotes). Takes LF, CRLF and CR, a UTF-8 byte order
/// mark, blank lines and lines that start with `#`. Throws bad_input `cannot read PLACE:LINE: ...` for bytes
/// that are no text, an open quote, and a separator that is no comma.
CsvText split_csv(const std::string& text, const std::string& place);

/// `cannot read PLACE:LINE: CAUSE`, thrown.
[[noreturn]] void refuse_line(const std::string& place, int line, const std::string& cause);

} // namespace metamer
