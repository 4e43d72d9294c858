#include <algorithm>

#include "report/rows.h"

namespace metamer {

double accuracy(const ChartRow& row, FrontierBy by) {
    return by == FrontierBy::mean ? row.delta_e_mean : row.delta_e_max;
}

void mark_frontier(std::vector<ChartRow>& rows, FrontierBy by) {
    for (ChartRow& row : rows)
        row.on_frontier = std::none_of(rows.begin(), rows.end(), [&](const ChartRow& other) {
            const double error = accuracy(row, by), other_error = accuracy(other, by);
            return other.cost_ratio <= row.cost_ratio && other_error <= error &&
                   (other.cost_ratio < row.cost_ratio || other_error < error);
        });
}

} // namespace metamer
