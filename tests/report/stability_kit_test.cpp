#include <cmath>
#include <gmock/gmock.h>

#include "atlas/atlas.h"
#include "report/stability_kit.h"

namespace metamer {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::Optional;

Experiment curve(std::vector<ExperimentPoint> points, bool log_x = true, bool discrete = false) {
    return {.name = "n", .unit = "nm", .log_x = log_x, .discrete = discrete, .points = std::move(points)};
}

TEST(FailureAt, LiesOnTheLineOfThePlot) {
    const Experiment e = curve({{1, {{"m", 100}}}, {100, {{"m", 0.01}}}});
    EXPECT_THAT(failure_at(e, "m", Harder::down), Optional(DoubleNear(10, 1e-9)));
    const Experiment linear = curve({{0, {{"m", 0.01}}}, {1, {{"m", 100}}}}, false);
    EXPECT_THAT(failure_at(linear, "m", Harder::up), Optional(DoubleNear(0.5, 1e-9)));
    const Experiment from_zero = curve({{0, {{"m", 0}}}, {1, {{"m", 4}}}}, false);
    EXPECT_THAT(failure_at(from_zero, "m", Harder::up), Optional(DoubleNear(0.25, 1e-9)));
}

TEST(FailureAt, IsTheFirstOnTheWayToTheHarderEnd) {
    const Experiment e =
        curve({{1, {{"m", 0.1}}}, {2, {{"m", 2}}}, {3, {{"m", 0.1}}}, {4, {{"m", 0.1}}}, {5, {{"m", 2}}}},
              false, true);
    EXPECT_THAT(failure_at(e, "m", Harder::up), Optional(2.0));
    EXPECT_THAT(failure_at(e, "m", Harder::down), Optional(5.0)) << "the easy end fails already";
    Experiment easier = e;
    easier.points.pop_back();
    EXPECT_THAT(failure_at(easier, "m", Harder::down), Optional(2.0));
}

TEST(FailureAt, IsNoneAtTheLimitAndForOtherMethods) {
    const Experiment e = curve({{1, {{"m", kFailsAbove}}}, {2, {{"m", 0.5}}}});
    EXPECT_EQ(failure_at(e, "m", Harder::up), std::nullopt);
    EXPECT_EQ(failure_at(e, "other", Harder::up), std::nullopt);
    const Experiment infinite = curve({{1, {{"m", 0.5}}}, {2, {{"m", HUGE_VAL}}}}, true, true);
    EXPECT_THAT(failure_at(infinite, "m", Harder::up), Optional(2.0));
}

TEST(AddFailure, SaysWhereAndWhyOnlyIfThereIsOne) {
    Experiment e = curve({{1, {{"m", 0.1}, {"n", 2}}}, {2, {{"m", 0.1}, {"n", 3}}}});
    add_failure(e, "m", Harder::up, "why");
    EXPECT_TRUE(e.fails.empty());
    add_failure(e, "n", Harder::up, "because");
    ASSERT_EQ(e.fails.size(), 1u);
    EXPECT_EQ(e.fails[0].why, "because");
    EXPECT_EQ(finding(e, "n", "n fails from", "-"), "n fails from 1 nm");
    EXPECT_EQ(finding(e, "m", "m fails from", "m holds"), "m holds");
}

TEST(Raise, KeepsTheWorstAndTakesNoNumberForIt) {
    ExperimentPoint point;
    raise(point, "m", 2);
    raise(point, "m", 1);
    EXPECT_EQ(point.delta_e.at("m"), 2);
    raise(point, "m", std::nan(""));
    raise(point, "m", 3);
    EXPECT_EQ(point.delta_e.at("m"), HUGE_VAL);
}

TEST(AsShown, IsAlwaysANumber) {
    EXPECT_EQ(as_shown(std::nan("")), 0);
    EXPECT_EQ(as_shown(HUGE_VAL), kMostLight);
    EXPECT_EQ(as_shown(-HUGE_VAL), -kMostLight);
    EXPECT_EQ(as_shown(0.5), 0.5);
}

TEST(Sweeps, KeepTheirEnds) {
    EXPECT_THAT(evenly(1, 3, 3), ElementsAre(1, 2, 3));
    EXPECT_THAT(logarithmically(0.1, 10, 3),
                ElementsAre(DoubleNear(0.1, 1e-12), DoubleNear(1, 1e-12), DoubleNear(10, 1e-12)));
}

TEST(Forms, AreWhatTheAtlasAddsOfLampsAndMaterials) {
    const Lamp lamp = find_lamp("F11");
    const Material material = find_material("crayon-black");
    for (const Quantization q : {Quantization::weighted, Quantization::thesis}) {
        Atlas atlas = empty_atlas(q);
        EXPECT_EQ(lamp_forms(lamp.spectrum, q).row.value, emission(atlas, add_lamp(atlas, lamp)).value);
        EXPECT_EQ(material_forms(material.spectrum, q).row.value,
                  reflectance(atlas, add_material(atlas, material)).value);
    }
}

} // namespace
} // namespace metamer
