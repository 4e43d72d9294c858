#include "report/chart_table.h"

#include "base/printed.h"
#include "report/context_note.h"

namespace metamer {

namespace {

std::string row_line(const ChartRow& row) {
    return printed("%-12s %4d  %-4s %-11s %8.2f %7.3f  %6.3f..%6.3f %8.4f %8.4f %8.4f %c%c ",
                   row.method.c_str(), row.taps, row.precision == Precision::fp16 ? "fp16" : "fp32",
                   row.atlas == Levels::eight_bit ? "8-bit" : "unquantized", row.ms, row.cost_ratio,
                   row.cost_ratio_q1, row.cost_ratio_q3, row.delta_e_mean, row.delta_e_p95, row.delta_e_max,
                   row.on_frontier ? '*' : ' ', row.chosen ? '<' : ' ') +
           row.worst_material + " under " + row.worst_lamp + "\n";
}

} // namespace

std::string chart_table(const Chart& chart) {
    const ChartContext& context = chart.context;
    std::string out = context.exhibit + ": " + pairs_text(context) + ", tolerance " +
                      printed("%g", context.tolerance) + " CIEDE2000\n" + context_note(context) + "\n" +
                      printed("timed by %s, %d rounds; cost: median and quartiles of the ratios to rgb-pow, "
                              "round by round\n\n",
                              context.timer.c_str(), context.rounds) +
                      printed("%-12s %4s  %-4s %-11s %8s %7s  %14s %8s %8s %8s    %s\n", "method", "sums",
                              "prec", "atlas", "ms", "cost", "quartiles", "mean", "p95", "max", "worst pair");
    for (const ChartRow& row : chart.rows)
        out += row_line(row);
    out += "\n* nothing is both cheaper and closer   < the planner's choice\n";
    if (!context.left_out.empty())
        out += "left out: " + context.left_out + "\n";
    return out;
}

} // namespace metamer
