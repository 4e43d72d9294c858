#include "exhibit/scene_kinds.h"

#include <gmock/gmock.h>

#include "exhibit/support.h"

namespace metamer {
namespace {

using testing::ElementsAre;

std::vector<std::string> names(SceneKind kind, const std::vector<std::string>& materials) {
    std::vector<std::string> out;
    for (const ObjectDefault& object : scene_objects(kind, materials))
        out.push_back(object.name + "=" + object.material);
    return out;
}

TEST(SceneKinds, AreFoundByNameAndByKind) {
    for (const SceneKindInfo& info : scene_kinds()) {
        EXPECT_EQ(find_scene_kind(info.name), &info);
        EXPECT_EQ(&scene_kind(info.kind), &info);
        EXPECT_FALSE(info.description.empty());
    }
    EXPECT_EQ(find_scene_kind("Still-Life")->kind, SceneKind::still_life);
    EXPECT_EQ(find_scene_kind("bread"), nullptr);
}

TEST(SceneKinds, OnePieceForEachMaterialInOrder) {
    EXPECT_THAT(names(SceneKind::loaf, {"a", "b"}), ElementsAre("slice-1=a", "slice-2=b"));
    EXPECT_THAT(names(SceneKind::crayons, {"a", "b"}), ElementsAre("crayon-1=a", "crayon-2=b"));
    EXPECT_THAT(names(SceneKind::patches, {"a"}), ElementsAre("patch-1=a"));
}

TEST(SceneKinds, ARampMixesThreeWays) {
    const auto ramps = scene_objects(SceneKind::ramp, std::vector<std::string>{"a", "b"});
    ASSERT_EQ(ramps.size(), 3u);
    for (const ObjectDefault& ramp : ramps) {
        EXPECT_EQ(ramp.material, "a");
        EXPECT_EQ(ramp.material_end, "b");
    }
    EXPECT_EQ(ramps[0].name, "ramp-reflectance");
    ASSERT_TRUE(ramps[0].method);
    EXPECT_FALSE(*ramps[0].method) << "auto: whatever mixes reflectances, whatever the halves ask for";
    EXPECT_EQ(ramps[1].name, "ramp-xyz");
    EXPECT_EQ(ramps[1].method, MethodChoice(Method::tristimulus));
    EXPECT_EQ(ramps[2].name, "ramp-rgb");
    EXPECT_EQ(ramps[2].method, MethodChoice(Method::rgb));
}

TEST(SceneKinds, TheStillLifeHasItsTenThings) {
    std::vector<std::string> things;
    for (const ObjectDefault& object : scene_objects(SceneKind::still_life, {}))
        things.push_back(object.name);
    EXPECT_THAT(things, ElementsAre("table", "wall", "ball", "orange", "apple", "box", "vase", "cone", "ring",
                                    "cloth"));
}

TEST(SceneKinds, EveryKindLoadsAsItIs) {
    for (const SceneKindInfo& info : scene_kinds()) {
        const Exhibit exhibit = exhibit_of("[scene]\nkind = " + std::string(info.name) + "\n");
        EXPECT_EQ(exhibit.scene, info.kind);
        EXPECT_FALSE(exhibit.objects.empty()) << info.name;
    }
}

} // namespace
} // namespace metamer
