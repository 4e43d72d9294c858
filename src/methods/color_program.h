// The greatest weighted sum of a reflectance that has a given color: a linear program of three equations.
//
// Maximize sum w[i] r[i] with 0 <= r[i] <= 1 and sum color[i] r[i] = target. Its dual has three unknowns, the
// price p: minimize p . target + sum max(0, w[i] - p . color[i]), convex and made of planes. At the least
// price r is 1 where w[i] > p . color[i], 0 where it is less, and in between at no more than three
// wavelengths.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace metamer {

using Triple = std::array<double, 3>;

inline double dot(const Triple& a, const Triple& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct ColorProgram {
    std::vector<Triple> color; ///< XYZ per unit of reflectance, one per wavelength
    Triple target;             ///< XYZ
};

struct Extreme {
    std::vector<double> reflectance; ///< 0 .. 1
    Triple price;
};

/// Walks down the dual's edges from corner to corner, each edge to its lowest point (the
/// dual simplex method with bound flipping). It stays at its corner: the next, with similar weights, is near.
class ColorExtremes {
public:
    /// The program must outlive it.
    explicit ColorExtremes(const ColorProgram& program);

    /// `weight`: one per wavelength. The color is met to 1e-11 and the sum is the greatest to 1e-8 of
    /// the greatest weight; none where no reflectance has the color. Throws
    /// failure where rounding keeps the walk from an end.
    std::optional<Extreme> greatest(std::span<const double> weight);

private:
    struct Corner;
    struct Edge;
    struct Crossing;
    Triple color(std::size_t i) const;
    Corner corner(std::span<const double> weight) const;
    std::optional<Edge> way_down(const Corner& corner) const;
    std::vector<Crossing> crossings(const Corner& corner, const Edge& edge,
                                    std::span<const double> weight) const;
    bool walk(const Corner& corner, const Edge& edge, std::span<const double> weight);

    const ColorProgram& program_;
    std::size_t count_; ///< of wavelengths
    /// The three wavelengths in between. From count_ on: what is missing in X, Y and Z, of which only 0 will
    /// do; with these it starts, and keeps those that a lamp of one or two lines cannot replace.
    std::array<std::size_t, 3> between_;
    std::vector<double> reflectance_; ///< 0 or 1, whatever those in between will be
};

} // namespace metamer
