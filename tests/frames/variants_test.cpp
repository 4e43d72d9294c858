#include "render/variants.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

#include "frames/frames.h"
#include "render/frame_renderer.h"

namespace metamer {
namespace {

TEST(Variants, NamesAreTheirOwn) {
    std::set<std::string> names;
    for (const ShaderVariant& variant : shader_variants())
        EXPECT_TRUE(names.insert(variant.name).second) << variant.name;
    EXPECT_EQ(names.size(), all_variants().size() + 1) << "the shadow pass and the table";
}

TEST(Variants, ReachTheLimitsOfExhibits) {
    const auto variants = all_variants();
    const auto has = [&](const Variant& variant) {
        return std::find(variants.begin(), variants.end(), variant) != variants.end();
    };
    for (const MethodInfo& info : kMethods)
        for (Transfer transfer : {Transfer::srgb, Transfer::none}) {
            EXPECT_TRUE(has({info.method, kMostLamps, true, kMostShadows, Surface::maps, transfer}));
            EXPECT_TRUE(has({info.method, 1, true, 1, Surface::plain, transfer}));
            EXPECT_TRUE(has({info.method, kMostLamps, false, 0, Surface::ramp, transfer}));
        }
    EXPECT_TRUE(has({Method::rgb, 1, false, 0, Surface::ramp_codes, Transfer::srgb}));
    EXPECT_FALSE(has({Method::spectral, 1, false, 0, Surface::ramp_codes, Transfer::srgb}));
    EXPECT_FALSE(has({Method::spectral, 1, true, 2, Surface::plain, Transfer::srgb}))
        << "more shadows than lamps";
}

TEST(Variants, LiteralsAreFloats) {
    for (const auto& [name, value] : shader_variant({}).defines)
        if (name.starts_with("SRGB") || name.starts_with("LEAST") || name.starts_with("MOST")) {
            EXPECT_NE(value.find_first_of(".e"), std::string::npos) << name << ' ' << value;
        }
}

TEST(Surfaces, FollowTheObject) {
    ObjectSetting object;
    EXPECT_EQ(surface_of(object, Method::rgb), Surface::plain);
    object.luminance_map = Image{1, 1, {255, 255, 255, 255}};
    EXPECT_EQ(surface_of(object, Method::rgb), Surface::maps);
    object.material_end.emplace();
    EXPECT_EQ(surface_of(object, Method::spectral), Surface::ramp);
    EXPECT_EQ(surface_of(object, Method::rgb), Surface::ramp_codes);
    EXPECT_EQ(surface_of(object, Method::spectral), Surface::ramp);
}

} // namespace
} // namespace metamer
