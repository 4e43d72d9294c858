#include "methods/color_program.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace metamer {

namespace {

constexpr double kSlack = 1e-11; ///< what the color may miss, in XYZ
constexpr int kMostEdges = 2000;
constexpr double kTieBreak = 1e-10; ///< of the greatest weight

using Rows = std::array<Triple, 3>;

Triple cross(const Triple& a, const Triple& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

void add(Triple& sum, double s, const Triple& a) {
    for (std::size_t k = 0; k < 3; ++k)
        sum[k] += s * a[k];
}

// Rows of the inverse: row i . column j is 1 where i = j, else 0. The one in color/matrix3.h refuses what
// neighboring wavelengths make.
Rows inverse_of_columns(const Rows& column) {
    Rows rows{cross(column[1], column[2]), cross(column[2], column[0]), cross(column[0], column[1])};
    for (std::size_t p = 0; p < 3; ++p) {
        const double volume = dot(rows[p], column[p]);
        for (double& v : rows[p])
            v /= volume;
    }
    return rows;
}

double greatest_size(std::span<const Triple> colors) {
    double most = 0;
    for (const Triple& c : colors)
        most = std::max(most, dot(c, c));
    return std::sqrt(most);
}

// Equal lamps, or a lamp of one line, leave planes that all meet in one point: a corner of the dual that no
// walk leaves. A slow wave, far below what counts, parts them; slow, so that spectra stay in few pieces.
std::vector<double> without_ties(std::span<const double> weight, std::span<const Triple> colors) {
    double most = 0;
    for (const double w : weight)
        most = std::max(most, std::abs(w));
    const double height = kTieBreak * most / greatest_size(colors);
    std::vector<double> out(weight.begin(), weight.end());
    for (std::size_t i = 0; i < out.size(); ++i) {
        const double turn = 14 * static_cast<double>(i) / static_cast<double>(out.size());
        out[i] += height * std::sin(turn) * std::sqrt(dot(colors[i], colors[i]));
    }
    return out;
}

} // namespace

/// Where three planes of the dual meet.
struct ColorExtremes::Corner {
    Rows inverse; ///< of the colors in between; its rows are the edges' directions
    Triple price;
    Triple share; ///< of the colors in between that the target asks for, in bounds or not
};

/// Leaves the plane of one of the three, who goes to the bound that it is beyond.
struct ColorExtremes::Edge {
    std::size_t leaving; ///< 0 .. 2
    double sign;         ///< 1: it leaves to 1, -1: to 0
    double fall;         ///< how far it is beyond: the dual's slope along the edge, downward
};

/// A wavelength that changes sides further down the edge.
struct ColorExtremes::Crossing {
    double way;
    std::size_t wavelength;
    double rise; ///< of the slope there
};

ColorExtremes::ColorExtremes(const ColorProgram& program)
    : program_(program),
      count_(program.color.size()),
      between_{count_, count_ + 1, count_ + 2},
      reflectance_(count_, 0.0) {}

Triple ColorExtremes::color(std::size_t i) const {
    if (i < count_)
        return program_.color[i];
    Triple missing{};
    missing[i - count_] = 1;
    return missing;
}

ColorExtremes::Corner ColorExtremes::corner(std::span<const double> weight) const {
    const Rows columns{color(between_[0]), color(between_[1]), color(between_[2])};
    Corner corner{inverse_of_columns(columns), {}, {}};
    for (std::size_t p = 0; p < 3; ++p)
        if (between_[p] < count_)
            add(corner.price, weight[between_[p]], corner.inverse[p]);
    Triple rest = program_.target;
    for (std::size_t i = 0; i < count_; ++i)
        if (reflectance_[i] != 0 && std::ranges::find(between_, i) == between_.end())
            add(rest, -1, program_.color[i]);
    // Twice: what the first round leaves is the inverse's rounding.
    for (int round = 0; round < 2; ++round) {
        const Triple left = rest;
        for (std::size_t p = 0; p < 3; ++p) {
            const double share = dot(corner.inverse[p], left);
            corner.share[p] += share;
            add(rest, -share, columns[p]);
        }
    }
    return corner;
}

std::optional<ColorExtremes::Edge> ColorExtremes::way_down(const Corner& corner) const {
    std::optional<Edge> steepest;
    double most = kSlack;
    for (std::size_t p = 0; p < 3; ++p) {
        const double bound = std::clamp(corner.share[p], 0.0, between_[p] < count_ ? 1.0 : 0.0);
        const double beyond = corner.share[p] - bound;
        // Per unit of price: how much of the color is amiss.
        const double slope = std::abs(beyond) / std::sqrt(dot(corner.inverse[p], corner.inverse[p]));
        if (slope > most) {
            most = slope;
            steepest = {p, beyond > 0 ? 1.0 : -1.0, std::abs(beyond)};
        }
    }
    return steepest;
}

std::vector<ColorExtremes::Crossing> ColorExtremes::crossings(const Corner& corner, const Edge& edge,
                                                              std::span<const double> weight) const {
    std::vector<Crossing> out;
    const Triple& direction = corner.inverse[edge.leaving];
    for (std::size_t i = 0; i < count_; ++i) {
        const double rate = edge.sign * dot(direction, program_.color[i]);
        const bool falls_out = reflectance_[i] != 0 && rate < 0, comes_in = reflectance_[i] == 0 && rate > 0;
        if ((falls_out || comes_in) && std::ranges::find(between_, i) == between_.end())
            out.push_back({std::max(0.0, (dot(corner.price, program_.color[i]) - weight[i]) / rate), i,
                           std::abs(rate)});
    }
    return out;
}

// To the edge's lowest point, where another wavelength is in between. False: it falls without end, as no
// reflectance has the color.
bool ColorExtremes::walk(const Corner& corner, const Edge& edge, std::span<const double> weight) {
    std::vector<Crossing> ahead = crossings(corner, edge, weight);
    const auto further = [](const Crossing& a, const Crossing& b) { return a.way > b.way; };
    std::ranges::make_heap(ahead, further);
    const Triple& direction = corner.inverse[edge.leaving];
    const double flat = kSlack * std::sqrt(dot(direction, direction));
    double fall = edge.fall;
    while (!ahead.empty()) {
        std::ranges::pop_heap(ahead, further);
        const Crossing next = ahead.back();
        ahead.pop_back();
        fall -= next.rise;
        if (fall > flat) {
            reflectance_[next.wavelength] = 1 - reflectance_[next.wavelength];
            continue;
        }
        const std::size_t left = between_[edge.leaving];
        if (left < count_)
            reflectance_[left] = edge.sign > 0 ? 1 : 0;
        between_[edge.leaving] = next.wavelength;
        return true;
    }
    return false;
}

std::optional<Extreme> ColorExtremes::greatest(std::span<const double> asked) {
    if (!std::isfinite(dot(program_.target, program_.target)))
        return std::nullopt;
    const std::vector<double> weight = without_ties(asked, program_.color);
    const Triple start = corner(weight).price;
    for (std::size_t i = 0; i < count_; ++i)
        reflectance_[i] = weight[i] > dot(start, program_.color[i]) ? 1 : 0;
    for (int edges = 0; edges < kMostEdges; ++edges) {
        const Corner at = corner(weight);
        const std::optional<Edge> edge = way_down(at);
        if (!edge) {
            Extreme found{reflectance_, at.price};
            for (std::size_t p = 0; p < 3; ++p)
                if (between_[p] < count_)
                    found.reflectance[between_[p]] = std::clamp(at.share[p], 0.0, 1.0);
            return found;
        }
        if (!walk(at, *edge, weight))
            return std::nullopt;
    }
    throw failure("find", "the extreme of a color", "rounding keeps it from an end");
}

} // namespace metamer
