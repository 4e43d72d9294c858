#include "methods/tap_search.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace metamer {

namespace {

// A white wrong by 1 counts as so many CIEDE2000: as good as forbidden.
constexpr double kWhite = 1000;
// Less than this share of a candidate's square, or of the targets', is rounding.
constexpr double kRounding = 1e-10;

// The candidates' and the targets' columns, weighed, the white as one row more. Row by row, since all loops
// run along the candidates.
struct Weighed {
    std::size_t rows, candidates, columns;
    std::vector<double> a, b;
};

Weighed weighed(const TapProblem& p, std::span<const std::size_t> candidates) {
    Weighed w{p.rows + 1, candidates.size(), p.columns, {}, {}};
    std::vector<double> row_weight(p.rows), column_weight(p.columns);
    for (std::size_t r = 0; r < p.rows; ++r) {
        double sum = 0;
        for (std::size_t t = 0; t < p.columns; ++t)
            sum += p.visible[r * p.columns + t] * p.visible[r * p.columns + t];
        row_weight[r] = std::sqrt(sum / static_cast<double>(p.columns));
    }
    for (std::size_t t = 0; t < p.columns; ++t) {
        double sum = 0;
        for (std::size_t r = 0; r < p.rows; ++r)
            sum += std::pow(p.visible[r * p.columns + t] / row_weight[r], 2);
        column_weight[t] = std::sqrt(sum / static_cast<double>(p.rows));
    }
    for (std::size_t r = 0; r < p.rows; ++r) {
        for (const std::size_t i : candidates)
            w.a.push_back(row_weight[r] * p.spectrum[r][i]);
        for (std::size_t t = 0; t < p.columns; ++t)
            w.b.push_back(row_weight[r] * column_weight[t] * p.target[r * p.columns + t]);
    }
    w.a.insert(w.a.end(), candidates.size(), kWhite);
    for (std::size_t t = 0; t < p.columns; ++t)
        w.b.push_back(kWhite * column_weight[t] * p.white[t]);
    return w;
}

// sum over rows of left[row] * a[row][.], the products of all candidates with one column.
template <class Left>
std::vector<double> products(const Weighed& w, const Left& left) {
    std::vector<double> out(w.candidates, 0.0);
    for (std::size_t r = 0; r < w.rows; ++r) {
        const double factor = left(r);
        const double* a = &w.a[r * w.candidates];
        for (std::size_t i = 0; i < w.candidates; ++i)
            out[i] += factor * a[i];
    }
    return out;
}

// What does not change while taps come and go.
class Products {
public:
    explicit Products(const Weighed& w) : w_(w), gram_(w.candidates), square_(w.candidates, 0.0) {
        for (std::size_t t = 0; t < w.columns; ++t) {
            pull_.push_back(products(w, [&](std::size_t r) { return w.b[r * w.columns + t]; }));
            for (std::size_t r = 0; r < w.rows; ++r)
                targets_ += w.b[r * w.columns + t] * w.b[r * w.columns + t];
        }
        for (std::size_t r = 0; r < w.rows; ++r)
            for (std::size_t i = 0; i < w.candidates; ++i)
                square_[i] += w.a[r * w.candidates + i] * w.a[r * w.candidates + i];
    }
    // Of a candidate with all.
    const std::vector<double>& gram(std::size_t i) {
        if (gram_[i].empty())
            gram_[i] = products(w_, [&](std::size_t r) { return w_.a[r * w_.candidates + i]; });
        return gram_[i];
    }
    const std::vector<double>& square() const { return square_; }
    const std::vector<std::vector<double>>& pull() const { return pull_; } // [column][candidate]
    double targets() const { return targets_; }

private:
    const Weighed& w_;
    std::vector<std::vector<double>> gram_, pull_;
    std::vector<double> square_;
    double targets_ = 0;
};

// The span of some taps: what it leaves of every candidate and of its products with the targets (Cholesky's
// factorization of the Gram matrix, row by row, as taps are added).
class Span {
public:
    explicit Span(Products& products)
        : products_(products),
          left_(products.square()),
          pull_(products.pull()),
          taken_(left_.size(), false) {}

    void add(std::size_t tap) {
        taken_[tap] = true;
        if (left_[tap] <= kRounding * products_.square()[tap])
            return; // it is in the span already
        const double length = std::sqrt(left_[tap]);
        std::vector<double> along = products_.gram(tap);
        for (const std::vector<double>& row : rows_)
            subtract(along, row[tap], row);
        for (double& v : along)
            v /= length;
        for (std::size_t i = 0; i < left_.size(); ++i)
            left_[i] -= along[i] * along[i];
        for (std::vector<double>& pull : pull_)
            subtract(pull, pull[tap] / length, along);
        rows_.push_back(std::move(along));
    }

    // The candidate that lowers the targets' error most; none when none does.
    std::optional<std::size_t> best() const {
        std::vector<double> gain(left_.size(), 0.0);
        for (const std::vector<double>& pull : pull_)
            for (std::size_t i = 0; i < gain.size(); ++i)
                gain[i] += pull[i] * pull[i];
        double most = kRounding * products_.targets();
        std::optional<std::size_t> found;
        for (std::size_t i = 0; i < gain.size(); ++i) {
            if (taken_[i] || left_[i] <= kRounding * products_.square()[i] || gain[i] <= most * left_[i])
                continue;
            most = gain[i] / left_[i];
            found = i;
        }
        return found;
    }
    bool taken(std::size_t i) const { return taken_[i]; }

private:
    static void subtract(std::vector<double>& from, double factor, const std::vector<double>& what) {
        for (std::size_t i = 0; i < from.size(); ++i)
            from[i] -= factor * what[i];
    }

    Products& products_;
    std::vector<double> left_;
    std::vector<std::vector<double>> pull_, rows_;
    std::vector<bool> taken_;
};

std::vector<std::size_t> greedy(Products& products, std::size_t count) {
    std::vector<std::size_t> taps;
    Span span(products);
    std::size_t next = 0; // of those that are taken for want of better
    while (taps.size() < count) {
        const auto best = span.best();
        while (!best && span.taken(next))
            ++next;
        taps.push_back(best ? *best : next);
        span.add(taps.back());
    }
    return taps;
}

// Gives up one tap for the best in its place; whether that is another.
bool exchanged(Products& products, std::vector<std::size_t>& taps, std::size_t which) {
    Span others(products);
    for (std::size_t j = 0; j < taps.size(); ++j)
        if (j != which)
            others.add(taps[j]);
    const auto best = others.best();
    if (!best || *best == taps[which])
        return false;
    taps[which] = *best;
    return true;
}

} // namespace

std::vector<std::size_t> search_taps(const TapProblem& problem, std::span<const std::size_t> candidates,
                                     std::size_t count) {
    const Weighed columns = weighed(problem, candidates);
    Products products(columns);
    std::vector<std::size_t> taps = greedy(products, count);
    std::size_t settled = 0;
    for (std::size_t turn = 0; turn < kMostExchanges && settled < count; ++turn)
        settled = exchanged(products, taps, turn % count) ? 0 : settled + 1;
    for (std::size_t& tap : taps)
        tap = candidates[tap];
    std::sort(taps.begin(), taps.end());
    return taps;
}

} // namespace metamer
