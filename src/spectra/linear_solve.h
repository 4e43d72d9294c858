// Small systems of linear equations.
#pragma once

#include <optional>
#include <vector>

namespace metamer {

/// A square matrix, row by row.
struct SquareMatrix {
    std::size_t size;
    std::vector<double> m = std::vector<double>(size * size, 0.0);

    double& operator()(std::size_t row, std::size_t column) { return m[row * size + column]; }
};

/// x of a x = b by Gaussian elimination with partial pivoting; none when a pivot is 0 or not finite. Zeros
/// are skipped, so that a band costs what a band should.
std::optional<std::vector<double>> solve(SquareMatrix a, std::vector<double> b);

} // namespace metamer
