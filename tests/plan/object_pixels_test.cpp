#include "plan/object_pixels.h"

#include <gtest/gtest.h>

#include "plan/planned.h"

namespace metamer::test {
namespace {

Pixel first_pixel(const Planned& planned, std::size_t object) {
    const ObjectSetting& setting = planned.exhibit.objects.at(object);
    return pixel_of(planned.exhibit, planned.plan.halves[0].view, planned.spectra, setting, setting.material);
}

TEST(PixelOf, HasTheMaterialUnderAllLampsAtTheirStrengths) {
    const Planned planned("[scene]\nkind = patches\nmaterials = cc-red, cc-blue\n[lamp.1]\nspectrum = A\n"
                          "strength = 2\n[lamp.2]\nspectrum = D65\nstrength = 3\n");
    const Pixel pixel = first_pixel(planned, 1);
    EXPECT_EQ(pixel.material.row, planned.spectra.material(planned.exhibit.objects[1].material.key).row);
    EXPECT_NE(pixel.material.row, first_pixel(planned, 0).material.row);
    ASSERT_EQ(pixel.lamps.size(), 2u);
    EXPECT_EQ(pixel.lamps[0].strength, 2);
    EXPECT_EQ(pixel.lamps[1].strength, 3);
    EXPECT_FALSE(pixel.medium);
    EXPECT_FALSE(pixel.other);
}

TEST(PixelOf, IsBehindTheMediumWhereItIsThickest) {
    const Planned planned("[scene]\nkind = media\n[object.wedge]\nmedium = glass-cobalt\nthickness = 3\n"
                          "[lamp.1]\nspectrum = D65\n");
    for (std::size_t i = 0; i < planned.exhibit.objects.size(); ++i) {
        const ObjectSetting& object = planned.exhibit.objects[i];
        const Pixel pixel = first_pixel(planned, i);
        ASSERT_EQ(pixel.medium.has_value(), object.medium.has_value()) << object.name;
        if (object.medium) {
            EXPECT_EQ(pixel.medium->row, planned.spectra.material(object.medium->key).row) << object.name;
            EXPECT_EQ(pixel.thickness, object.thickness) << object.name;
        }
    }
}

TEST(PixelOf, OfAWallKnowsTheOther) {
    const Planned planned("[scene]\nkind = corner\nmaterials = cc-red, cc-yellow\n[lamp.1]\nspectrum = A\n");
    for (const std::size_t i : {0u, 1u}) {
        const Pixel pixel = first_pixel(planned, i);
        ASSERT_TRUE(pixel.other);
        EXPECT_EQ(pixel.other->row, first_pixel(planned, 1 - i).material.row);
        EXPECT_NE(pixel.other->row, pixel.material.row);
    }
}

} // namespace
} // namespace metamer::test
