#include "spectra/linear_solve.h"

#include <algorithm>
#include <cmath>

namespace metamer {

namespace {

std::size_t pivot_row(SquareMatrix& a, std::size_t column) {
    std::size_t best = column;
    for (std::size_t row = column + 1; row < a.size; ++row)
        if (std::abs(a(row, column)) > std::abs(a(best, column)))
            best = row;
    return best;
}

// Subtracts multiples of row `from` so that its column `from` vanishes in the rows below.
void eliminate(SquareMatrix& a, std::vector<double>& b, std::size_t from) {
    for (std::size_t row = from + 1; row < a.size; ++row) {
        if (a(row, from) == 0)
            continue;
        const double factor = a(row, from) / a(from, from);
        for (std::size_t column = from; column < a.size; ++column)
            a(row, column) -= factor * a(from, column);
        b[row] -= factor * b[from];
    }
}

} // namespace

std::optional<std::vector<double>> solve(SquareMatrix a, std::vector<double> b) {
    for (std::size_t i = 0; i < a.size; ++i) {
        const std::size_t p = pivot_row(a, i);
        if (!std::isfinite(a(p, i)) || a(p, i) == 0)
            return std::nullopt;
        if (p != i) {
            const auto row = [&](std::size_t r) {
                return a.m.begin() + static_cast<std::ptrdiff_t>(r * a.size);
            };
            std::swap_ranges(row(i), row(i + 1), row(p));
            std::swap(b[i], b[p]);
        }
        eliminate(a, b, i);
    }
    for (std::size_t i = a.size; i-- > 0;) {
        for (std::size_t column = i + 1; column < a.size; ++column)
            b[i] -= a(i, column) * b[column];
        b[i] /= a(i, i);
    }
    return b;
}

} // namespace metamer
