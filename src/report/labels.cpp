#include "report/labels.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace metamer {

namespace {

constexpr double kApart = 1; // px between two labels
constexpr int kAngles = 24;  // places on a ring
constexpr int kRings = 12;
constexpr double kLeaderCost = 60; // as many px farther rather than a leader across another label

struct Leader {
    Px from, to;
};

class Placer {
public:
    Placer(std::span<const Obstacle> obstacles, const Box& bounds) : obstacles_(obstacles), bounds_(bounds) {}

    std::optional<Box> place(const LabelWish& wish) {
        std::optional<Box> best = wish.wanted && is_free(*wish.wanted) ? wish.wanted : on_rings(wish);
        if (!best && wish.farthest == 0)
            best = anywhere(wish);
        if (best) {
            taken_.push_back(grown(*best, kApart));
            leaders_.push_back({wish.anchor, nearest_point(*best, wish.anchor)});
        }
        return best;
    }

private:
    bool is_free(const Box& box) const {
        if (!inside(box, bounds_))
            return false;
        for (const Box& other : taken_)
            if (overlap(box, other))
                return false;
        return true;
    }

    double cost(const LabelWish& wish, const Box& box, double distance) const {
        const Px to = nearest_point(box, wish.anchor);
        double sum = distance;
        for (const Obstacle& obstacle : obstacles_)
            sum += obstacle.weight * shared_area(box, obstacle.box) / wish.height;
        for (const Box& other : taken_)
            sum += crosses(other, wish.anchor, to) ? kLeaderCost : 0;
        for (const Leader& leader : leaders_)
            sum += crosses(box, leader.from, leader.to) ? kLeaderCost : 0;
        return sum;
    }

    // The box that the ring around the anchor touches from inside, in the direction of the angle.
    static Box beside(const LabelWish& wish, double radius, double angle) {
        const double x = std::cos(angle), y = std::sin(angle);
        // One of the two is always +-1: the anchor stays outside.
        const double aside = std::clamp(x * std::numbers::sqrt2 * 1.01, -1.0, 1.0);
        const double above = std::clamp(y * std::numbers::sqrt2 * 1.01, -1.0, 1.0);
        const double left = wish.anchor.x + x * radius + (aside - 1) * wish.width / 2;
        const double top = wish.anchor.y + y * radius + (above - 1) * wish.height / 2;
        return {left, top, left + wish.width, top + wish.height};
    }

    std::optional<Box> on_rings(const LabelWish& wish) const {
        std::optional<Box> best;
        double least = std::numeric_limits<double>::infinity();
        for (int ring = 0; ring < kRings; ++ring) {
            const double radius = wish.gap + ring * wish.height * (0.35 + 0.05 * ring);
            if ((wish.farthest > 0 && radius > wish.farthest) || radius > least)
                break;
            for (int k = 0; k < kAngles; ++k) {
                // To the right first: that is where people look for a name.
                const double angle = (k % 2 ? 1 : -1) * (k + 1) / 2 * 2 * std::numbers::pi / kAngles;
                const Box box = beside(wish, radius, angle);
                if (!is_free(box))
                    continue;
                if (const double price = cost(wish, box, radius) + 0.02 * k; price < least) {
                    least = price;
                    best = box;
                }
            }
        }
        return best;
    }

    std::optional<Box> anywhere(const LabelWish& wish) const {
        std::optional<Box> best;
        double least = std::numeric_limits<double>::infinity();
        for (double y = bounds_.top; y + wish.height <= bounds_.bottom; y += wish.height / 4)
            for (double x = bounds_.left; x + wish.width <= bounds_.right; x += wish.height / 2) {
                const Box box{x, y, x + wish.width, y + wish.height};
                if (!is_free(box))
                    continue;
                const Px to = nearest_point(box, wish.anchor);
                const double distance = std::hypot(to.x - wish.anchor.x, to.y - wish.anchor.y);
                if (const double price = cost(wish, box, distance); price < least) {
                    least = price;
                    best = box;
                }
            }
        return best;
    }

    std::span<const Obstacle> obstacles_;
    Box bounds_;
    std::vector<Box> taken_;
    std::vector<Leader> leaders_;
};

// Neighbors that stand close, as one: where its start would be on average, and its length.
struct Pool {
    double start, length;
    std::size_t members;
};

} // namespace

std::vector<double> spread_out(std::span<const Stretch> stretches, double from, double to) {
    std::vector<Pool> pools;
    for (const Stretch& stretch : stretches) {
        pools.push_back({stretch.middle - stretch.length / 2, stretch.length, 1});
        while (pools.size() > 1 && pools.end()[-2].start + pools.end()[-2].length > pools.back().start) {
            const Pool last = pools.back();
            pools.pop_back();
            Pool& pool = pools.back();
            // A member's wish, carried back to the pool's start by the lengths before it.
            const auto weight = static_cast<double>(pool.members), added = static_cast<double>(last.members);
            pool.start = (pool.start * weight + (last.start - pool.length) * added) / (weight + added);
            pool.length += last.length;
            pool.members += last.members;
        }
    }
    std::vector<double> starts;
    // From the far end back: nothing runs over it; then forward: nothing begins before the column.
    double end = to;
    for (auto pool = pools.rbegin(); pool != pools.rend(); ++pool)
        end = pool->start = std::min(pool->start, end - pool->length);
    double at = from;
    std::size_t next = 0;
    for (const Pool& pool : pools) {
        at = std::max(at, pool.start);
        for (std::size_t i = 0; i < pool.members; ++i) {
            starts.push_back(at);
            at += stretches[next++].length;
        }
    }
    return starts;
}

std::vector<std::optional<Box>> place_labels(std::span<const LabelWish> wishes,
                                             std::span<const Obstacle> obstacles, const Box& bounds) {
    Placer placer(obstacles, bounds);
    std::vector<std::optional<Box>> out;
    for (const LabelWish& wish : wishes)
        out.push_back(placer.place(wish));
    return out;
}

} // namespace metamer
