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
    EXPECT_EQ(names.size(), all_variants().size() + 5)
        << "the shadow pass, two pictures, two probes, and the table";
}

TEST(Variants, ReachTheLimitsOfExhibits) {
    const auto variants = all_variants();
    const auto has = [&](const Variant& variant) {
        return std::find(variants.begin(), variants.end(), variant) != variants.end();
    };
    for (const MethodInfo& info : kMethods) {
        EXPECT_TRUE(has(
            {.method = info.method, .lamps = kMostLamps, .shadows = kMostShadows, .surface = Surface::maps}));
        EXPECT_TRUE(has({.method = info.method, .shadows = 1}));
        for (const OutputCurve curve : {OutputCurve::none, OutputCurve::srgb, OutputCurve::srgb_pow})
            EXPECT_TRUE(has({.method = info.method, .output = {curve, true, true}})) << info.name;
    }
    EXPECT_TRUE(has({.method = Method::spectral,
                     .lamps = kMostLamps,
                     .lit = false,
                     .mirrors = false,
                     .placed = false,
                     .surface = Surface::medium}));
    EXPECT_TRUE(has({.method = Method::rgb,
                     .lit = false,
                     .mirrors = false,
                     .placed = false,
                     .surface = Surface::ramp_codes}));
    EXPECT_FALSE(has({.method = Method::spectral,
                      .lit = false,
                      .mirrors = false,
                      .placed = false,
                      .surface = Surface::ramp_codes}));
    EXPECT_FALSE(has({.method = Method::spectral, .shadows = 2})) << "more shadows than lamps";
}

TEST(Variants, LiteralsAreFloats) {
    for (const auto& [name, value] : shader_variant({}).defines)
        if (name.starts_with("SRGB") || name.starts_with("LEAST") || name.starts_with("MOST")) {
            EXPECT_NE(value.find_first_of(".e"), std::string::npos) << name << ' ' << value;
        }
}

TEST(Surfaces, FollowTheObject) {
    Exhibit exhibit;
    ObjectSetting object;
    const auto surface = [&](Method method) { return surface_of(exhibit, object, method); };
    EXPECT_EQ(surface(Method::rgb), Surface::plain);
    object.luminance_map = Image{1, 1, {255, 255, 255, 255}};
    EXPECT_EQ(surface(Method::rgb), Surface::maps);
    object.medium.emplace();
    EXPECT_EQ(surface(Method::rgb), Surface::medium);
    object.material_end.emplace();
    EXPECT_EQ(surface(Method::spectral), Surface::ramp);
    EXPECT_EQ(surface(Method::rgb), Surface::ramp_codes);
}

/// The variant of which this one only leaves something out.
Variant whole(Variant variant) {
    variant.mirrors = variant.lit;
    variant.smooth = true;
    variant.placed = variant.lit && variant.surface != Surface::bounce;
    return variant;
}

// Every variant that the shipped exhibits ask for, by any method, was seen by the conformance tests, or the
// one that holds all of it.
TEST(Variants, HoldWhateverAnExhibitAsksFor) {
    const auto list = all_variants();
    const std::set<Variant> all(list.begin(), list.end());
    EXPECT_EQ(all.size(), list.size());
    for (const char* ini :
         {"still-life.ini", "crayons.ini", "figures/ch84-keymap.ini", "figures/ch83-ramp.ini"})
        for (const MethodInfo& info : kMethods) {
            Exhibit exhibit = load_exhibit(std::string(METAMER_SOURCE_DIR "/config/") + ini, {});
            exhibit.compare.reset();
            exhibit.accuracy.method = info.method;
            const ExhibitSpectra spectra(exhibit);
            const Plan plan = plan_exhibit(exhibit, spectra);
            const Scene scene = build_scene(exhibit);
            const std::vector<ShadowTile> tiles(static_cast<std::size_t>(plan.halves[0].view.shadows));
            for (const Draw& draw : half_draws(exhibit, spectra, plan.halves[0], scene, tiles).objects)
                EXPECT_TRUE(all.contains(draw.variant) || all.contains(whole(draw.variant)))
                    << ini << ' ' << shader_variant(draw.variant).name;
        }
}

} // namespace
} // namespace metamer
