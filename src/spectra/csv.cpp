#include "spectra/csv.h"

#include <algorithm>
#include <filesystem>

#include "base/error.h"
#include "base/files.h"
#include "base/names.h"
#include "base/numbers.h"
#include "spectra/csv_text.h"
#include "spectra/csv_units.h"

namespace metamer {

namespace {

constexpr std::size_t kMostBytes = 16u << 20;
constexpr double kShortest_nm = 100, kLongest_nm = 5000;
constexpr double kGreatest = 1e30;
// Measured white standards and printed digits overshoot by this much without being fluorescent.
constexpr double kReflectanceSlack = 1e-6;

// How the rows of one file are read.
struct Reading {
    const std::string& place;
    SpectrumKind kind;
    double nm_per_unit = 1;
    double value_scale = 1;
};

void take_comments(SpectrumTable& table, const std::vector<std::string>& comments) {
    for (const std::string& comment : comments) {
        const std::size_t colon = comment.find(':');
        const std::string key = lower_case(trimmed(comment.substr(0, colon)));
        if (colon != std::string::npos && key == "source")
            table.source = trimmed(std::string_view(comment).substr(colon + 1));
        else if (colon != std::string::npos && key == "unit")
            table.unit = trimmed(std::string_view(comment).substr(colon + 1));
        else if (table.title.empty())
            table.title = comment;
    }
}

double number(const Reading& reading, const CsvRow& row, std::size_t column) {
    const std::string& cell = row.cells[column];
    if (const auto value = parse_number(cell))
        return *value;
    const std::string where = "column " + std::to_string(column + 1);
    if (cell.empty())
        refuse_line(reading.place, row.line, where + " is empty");
    const std::string low = lower_case(cell);
    const std::string_view name =
        std::string_view(low).substr(low.starts_with('-') || low.starts_with('+') ? 1 : 0);
    if (name.starts_with("nan") || name.starts_with("inf"))
        refuse_line(reading.place, row.line, where + " is `" + cell + "`; values must be finite");
    if (cell.find(',') != std::string::npos)
        refuse_line(reading.place, row.line,
                    where + " has a decimal comma (`" + cell + "`); the mark is a point");
    refuse_line(reading.place, row.line, where + " is no number: `" + cell + "`");
}

double wavelength_nm(const Reading& reading, const CsvRow& row) {
    const double written = number(reading, row, 0);
    const double nm = written * reading.nm_per_unit;
    if (nm >= kShortest_nm && nm <= kLongest_nm)
        return nm;
    std::string cause = "wavelength " + to_text(written);
    cause += reading.nm_per_unit == 1 ? " cannot be nanometers" : " is not in range";
    cause += " (100..5000 nm)";
    if (reading.nm_per_unit == 1 && written >= 0.1 && written <= 5)
        cause += "; for micrometers call the column wavelength_um";
    if (reading.nm_per_unit == 1 && written > kLongest_nm && written <= 50000)
        cause += "; for angstroms call the column wavelength_angstrom";
    refuse_line(reading.place, row.line, cause);
}

double value(const Reading& reading, const CsvRow& row, std::size_t column) {
    const double written = number(reading, row, column);
    const double v = written * reading.value_scale;
    if (written < 0 && reading.kind != SpectrumKind::component)
        refuse_line(reading.place, row.line, "value " + to_text(written) + " is negative");
    if (v > kGreatest || v < -kGreatest)
        refuse_line(reading.place, row.line, "value " + to_text(written) + " is beyond 1e30");
    if (reading.kind != SpectrumKind::reflectance)
        return v;
    if (v > 1 + kReflectanceSlack)
        refuse_line(
            reading.place, row.line,
            reading.value_scale == 1
                ? "reflectance " + to_text(written) +
                      " is above 1: fluorescence is not taken, percent must be named (`# unit: percent`)"
                : "reflectance " + to_text(written) + " is above 100 percent: fluorescence is not taken");
    return std::min(v, 1.0);
}

// The names of the value columns, from the header if there is one; its row is then done with.
std::vector<std::string> take_names(std::vector<CsvRow>& rows, const std::string& place) {
    const CsvRow& first = rows.front();
    if (!is_wavelength_header(first.cells.front())) {
        if (!parse_number(first.cells.front()))
            refuse_line(place, first.line,
                        "the header must begin with wavelength_nm, not `" + first.cells.front() + "`");
        if (first.cells.size() > 2)
            refuse_line(place, first.line,
                        "there is no header; more than two columns need wavelength_nm,NAME,...");
        return {std::filesystem::path(place).stem().string()};
    }
    std::vector<std::string> names(first.cells.begin() + 1, first.cells.end());
    for (std::size_t i = 0; i < names.size(); ++i) {
        names[i] = std::string(trimmed(names[i])); // quoted blanks: `path#NAME` could not ask for them
        if (names[i].empty())
            refuse_line(place, first.line, "column " + std::to_string(i + 2) + " has no name");
        for (std::size_t j = 0; j < i; ++j)
            if (same_name(names[i], names[j]))
                refuse_line(place, first.line, "two columns are named `" + names[i] + "`");
    }
    rows.erase(rows.begin());
    return names;
}

void check_order(const Reading& reading, const CsvRow& row, const Curve& curve, double nm) {
    if (curve.wavelength_nm.empty() || nm > curve.wavelength_nm.back())
        return;
    const std::string written = row.cells.front();
    if (nm == curve.wavelength_nm.back())
        refuse_line(reading.place, row.line, "wavelength " + written + " is repeated");
    refuse_line(reading.place, row.line,
                "wavelength " + written + " comes after a longer one; they must ascend");
}

void take_row(SpectrumTable& table, const Reading& reading, const CsvRow& row) {
    const std::size_t columns = table.curves.size() + 1;
    if (row.cells.size() != columns)
        refuse_line(reading.place, row.line,
                    "there are " + std::to_string(row.cells.size()) + " cells where " +
                        std::to_string(columns) + " are wanted" +
                        (row.cells.size() > columns ? " (a decimal comma?)" : ""));
    const double nm = wavelength_nm(reading, row);
    check_order(reading, row, table.curves.front(), nm);
    for (std::size_t c = 1; c < columns; ++c) {
        table.curves[c - 1].wavelength_nm.push_back(nm);
        table.curves[c - 1].value.push_back(value(reading, row, c));
    }
}

} // namespace

SpectrumTable parse_spectra(const std::string& text, const std::string& place, SpectrumKind kind) {
    CsvText csv = split_csv(text, place);
    if (csv.rows.empty())
        throw bad_input("read", place,
                        csv.comments.empty() ? "it is empty" : "it has comments only, no rows");
    SpectrumTable table;
    take_comments(table, csv.comments);
    const std::string corner = csv.rows.front().cells.front();
    table.names = take_names(csv.rows, place);
    table.curves.resize(table.names.size());
    const std::string header = is_wavelength_header(corner) ? corner : std::string();
    const Reading reading{place, kind, nm_per_unit(header, table.unit, place),
                          value_scale(table.unit, kind, place)};
    for (const CsvRow& row : csv.rows)
        take_row(table, reading, row);
    if (csv.rows.size() < 2)
        throw bad_input("read", place,
                        std::string("it has ") + (csv.rows.empty() ? "no point" : "one point only") +
                            "; a spectrum needs at least two");
    return table;
}

SpectrumTable read_spectra(const std::string& path, SpectrumKind kind) {
    return parse_spectra(read_file(path, kMostBytes), path, kind);
}

} // namespace metamer
