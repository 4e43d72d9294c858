// The rows of `metamer chart`: what each method costs and how wrong it is, as CSV and JSON.
#pragma once

#include <string>
#include <vector>

namespace metamer {

enum class Precision { fp16, fp32 };
enum class Levels { eight_bit, unquantized }; ///< how the spectra are stored; `8-bit` in files

/// One way to compute, measured. Times and ratios are medians over the rounds with their quartiles; a
/// difference is CIEDE2000 against the reference, over all pairs of the chart.
struct ChartRow {
    std::string method{};
    int taps = 0; ///< wavelengths or sums per pixel; at least 0
    Precision precision = Precision::fp32;
    Levels atlas = Levels::eight_bit;
    double ms = 0, ms_q1 = 0, ms_q3 = 0;                         ///< per frame
    double cost_ratio = 0, cost_ratio_q1 = 0, cost_ratio_q3 = 0; ///< to `rgb` of the same round
    double delta_e_mean = 0, delta_e_p95 = 0, delta_e_max = 0;
    std::string worst_lamp{}, worst_material{}; ///< the pair of delta_e_max
    bool on_frontier = false;
    bool chosen = false; ///< by the planner

    bool operator==(const ChartRow&) const = default;
};

/// What accuracy means on the frontier.
enum class FrontierBy { mean, max };

/// What the rows were measured with and on; in files too, so that pictures can be made from them alone.
struct ChartContext {
    std::string exhibit{}, gl_renderer{}, date{}, command{}; ///< free text, one line each
    std::string timer{};                                     ///< what the clock was
    std::string left_out{};          ///< what could not be drawn or planned, and why; empty: nothing
    int width_px = 0, height_px = 0; ///< of the frame measured
    int rounds = 0;                  ///< of all frames, one after another
    int lamps = 0, materials = 0;    ///< every lamp with every material
    double tolerance = 0;            ///< CIEDE2000; 0: none
    FrontierBy frontier_by = FrontierBy::max;

    bool operator==(const ChartContext&) const = default;
};

struct Chart {
    ChartContext context;
    std::vector<ChartRow> rows{};

    bool operator==(const Chart&) const = default;
};

/// Sets on_frontier of every row: no other is at most as costly (cost_ratio) and at most as wrong, and less
/// of one of them. Equal rows stand together.
void mark_frontier(std::vector<ChartRow>& rows, FrontierBy by);

/// The value that `by` names.
double accuracy(const ChartRow& row, FrontierBy by);

/// CSV (RFC 4180, LF): the context as `# key: value` lines, a header with the names of DESIGN.md section 6
/// and the quartiles beside their medians, one line per row. Numbers read back as the same doubles. Throws
/// bad_input `cannot write chart rows: ...` for a number that is not finite or below 0, and text that is not
/// UTF-8 or holds a control character.
std::string chart_csv(const Chart& chart);

/// {"context": {...}, "rows": [{...}]} with the same names and values; ends in a line break. Throws as above.
std::string chart_json(const Chart& chart);

/// Reads what chart_csv wrote; columns in any order. Throws bad_input `cannot read PLACE:LINE: ...` for a
/// column that is missing, unknown or there twice, a row of another length, a value that its column cannot
/// take.
Chart read_chart_csv(const std::string& text, const std::string& place);

} // namespace metamer
