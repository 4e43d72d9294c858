#include "report/labels.h"

#include <cmath>
#include <random>

#include <gmock/gmock.h>

namespace metamer {
namespace {

using ::testing::ElementsAre;

const Box kBounds{0, 0, 600, 400};

std::vector<LabelWish> random_wishes(unsigned seed, int count) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> x(-50, 650), y(-50, 450), width(5, 120), height(8, 30);
    std::vector<LabelWish> out;
    for (int i = 0; i < count; ++i) // anchors off the picture too
        out.push_back({.anchor = {x(random), y(random)}, .width = width(random), .height = height(random)});
    return out;
}

TEST(PlaceLabels, NoTwoOverlapAndNoneLeaves) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const auto wishes = random_wishes(seed, 50);
        std::vector<Obstacle> obstacles;
        for (const LabelWish& wish : wishes)
            obstacles.push_back({around(wish.anchor, 5), 3});
        const auto places = place_labels(wishes, obstacles, kBounds);
        ASSERT_EQ(places.size(), wishes.size());
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (!places[i])
                continue;
            EXPECT_TRUE(inside(*places[i], kBounds)) << seed << ' ' << i;
            EXPECT_NEAR(places[i]->width(), wishes[i].width, 1e-9);
            EXPECT_NEAR(places[i]->height(), wishes[i].height, 1e-9);
            for (std::size_t k = 0; k < i; ++k)
                EXPECT_FALSE(places[k] && overlap(*places[i], *places[k])) << seed << ' ' << i << ' ' << k;
        }
    }
}

TEST(PlaceLabels, StandsBesideItsAnchorWhereThereIsRoom) {
    const std::vector<LabelWish> wishes{{.anchor = {300, 200}, .width = 80, .height = 16}};
    const auto places = place_labels(wishes, {}, kBounds);
    ASSERT_TRUE(places[0]);
    EXPECT_DOUBLE_EQ(places[0]->left, 304);
    EXPECT_DOUBLE_EQ(places[0]->center().y, 200);
}

TEST(PlaceLabels, KeepsOffObstacles) {
    const std::vector<LabelWish> wishes{{.anchor = {300, 200}, .width = 80, .height = 16}};
    const std::vector<Obstacle> obstacles{{{302, 100, 500, 300}, 5}};
    const auto places = place_labels(wishes, obstacles, kBounds);
    ASSERT_TRUE(places[0]);
    EXPECT_FALSE(overlap(*places[0], obstacles[0].box));
}

TEST(PlaceLabels, FindsTheLastFreePlaceHoweverFar) {
    // One label fills all but a strip at the far end.
    const std::vector<LabelWish> wishes{
        {.anchor = {0, 0}, .width = 598, .height = 360, .wanted = Box{0, 0, 598, 360}},
        {.anchor = {5, 5}, .width = 100, .height = 20},
        {.anchor = {5, 5}, .width = 100, .height = 20, .farthest = 40},
        {.anchor = {5, 5}, .width = 100, .height = 50}};
    const auto places = place_labels(wishes, {}, kBounds);
    ASSERT_TRUE(places[0]);
    ASSERT_TRUE(places[1]);
    EXPECT_GE(places[1]->top, 361);
    EXPECT_FALSE(places[2]) << "out of its reach";
    EXPECT_FALSE(places[3]) << "does not fit";
}

TEST(SpreadOut, MovesOnlyWhatCollides) {
    EXPECT_THAT(spread_out(std::vector<Stretch>{{10, 10}, {50, 10}}, 0, 100), ElementsAre(5, 45));
    // Two at one place part by half a length each.
    EXPECT_THAT(spread_out(std::vector<Stretch>{{50, 10}, {50, 10}}, 0, 100), ElementsAre(40, 50));
    // The third joins the two and moves them by a third of what is missing.
    EXPECT_THAT(spread_out(std::vector<Stretch>{{50, 10}, {50, 10}, {53, 10}}, 0, 100),
                ElementsAre(36, 46, 56));
}

TEST(SpreadOut, StaysInTheColumn) {
    EXPECT_THAT(spread_out(std::vector<Stretch>{{1, 10}, {2, 10}}, 0, 100), ElementsAre(0, 10));
    EXPECT_THAT(spread_out(std::vector<Stretch>{{30, 10}, {98, 10}, {99, 10}}, 0, 100),
                ElementsAre(25, 80, 90));
    EXPECT_TRUE(spread_out({}, 0, 100).empty());
}

TEST(SpreadOut, NeverOverlaps) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-20, 420), length(5, 15);
    for (int round = 0; round < 200; ++round) {
        std::vector<Stretch> stretches;
        for (int i = 0; i < 24; ++i)
            stretches.push_back({place(random), length(random)});
        std::sort(stretches.begin(), stretches.end(),
                  [](const Stretch& a, const Stretch& b) { return a.middle < b.middle; });
        const auto starts = spread_out(stretches, 0, 400);
        EXPECT_GE(starts.front(), 0);
        EXPECT_LE(starts.back() + stretches.back().length, 400 + 1e-9);
        for (std::size_t i = 1; i < starts.size(); ++i)
            EXPECT_GE(starts[i], starts[i - 1] + stretches[i - 1].length - 1e-9);
    }
}

TEST(Crosses, SegmentsAndBoxes) {
    const Box box{10, 10, 20, 20};
    EXPECT_TRUE(crosses(box, {0, 15}, {30, 15}));
    EXPECT_TRUE(crosses(box, {15, 15}, {100, 100})) << "from inside";
    EXPECT_FALSE(crosses(box, {5, 14}, {14, 5})) << "past the corner";
    EXPECT_FALSE(crosses(box, {0, 10}, {30, 10})) << "along the edge";
    EXPECT_FALSE(crosses(box, {0, 15}, {9, 15})) << "too short";
    EXPECT_TRUE(crosses(box, {15, 0}, {15, 30}));
    EXPECT_FALSE(crosses(box, {25, 0}, {25, 30}));
}

} // namespace
} // namespace metamer
