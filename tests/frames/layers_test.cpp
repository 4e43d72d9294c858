// Scenes whose pixels know more than one material: a medium of varying thickness, two walls that light each
// other; every method that draws them, against its twin.
#include <gtest/gtest.h>

#include "frames/frames.h"
#include "frames/places.h"
#include "plan/twin.h"
#include "render/draws.h"

namespace metamer {
namespace {

struct Case {
    Method method;
    int lamps;
    int taps = 8;           ///< of method reduced
    bool rows_only = false; ///< no spectrum at full resolution
};

std::vector<Case> cases(bool with_folded) {
    std::vector<Case> all;
    for (const MethodInfo& info : kMethods)
        for (const int lamps : {1, 2, 8})
            for (const bool rows_only : {false, true})
                if (with_folded || info.method != Method::folded)
                    all.push_back({info.method, lamps, 8, rows_only});
    for (const int taps : kTapCounts)
        for (const int lamps : {1, 3})
            all.push_back({Method::reduced, lamps, taps});
    return all;
}

std::string case_name(const testing::TestParamInfo<Case>& info) {
    const Case& c = info.param;
    return std::to_string(info.index) + "_" + std::string(method_name(c.method)) + "_" +
           std::to_string(c.lamps) + "_lamps" +
           (c.method == Method::reduced ? "_" + std::to_string(c.taps) + "_taps" : "") +
           (c.rows_only ? "_rows" : "");
}

Exhibit exhibit_by(const Case& c, const std::string& scene) {
    Exhibit exhibit = exhibit_of(
        "[display]\nwidth = 256\nheight = 64\n[accuracy]\nmethod = " + std::string(method_name(c.method)) +
        "\ntaps = " + std::to_string(c.taps) + "\n[scene]\n" + scene + lamps_of(c.lamps));
    if (c.rows_only)
        forget_full_spectra(exhibit);
    return exhibit;
}

class Media : public testing::TestWithParam<Case> {};

TEST_P(Media, AreTheTwinsAtEveryThickness) {
    Exhibit exhibit = exhibit_by(GetParam(), "kind = media\n[object.board]\nmethod = tristimulus\n");
    const Image image = frame_of(exhibit);
    const Twin twins(exhibit);
    const ObjectSetting& wedge = object_of(exhibit, "wedge");
    for (int y = 4; y < 33; ++y) {
        Pixel pixel_there = twins.pixel_on(wedge);
        // The wedge goes from 0.06 of the frame's height to 0.52.
        pixel_there.thickness = wedge.thickness * ((y + 0.5) / 64 - 0.06) / 0.46;
        const EncodedRgb8 drawn = pixel(image, 100, y), twin = twins.rgb8(wedge, pixel_there);
        // 24 and 32 taps too, whose weights come from a texture and cancel in the dark.
        EXPECT_LE(steps(drawn, twin), 1) << y << ": drawn " << text_of(drawn) << ", twin " << text_of(twin);
    }
    EXPECT_GT(steps(pixel(image, 100, 4), pixel(image, 100, 32)), 60) << "thick is not thin";
    const ObjectSetting& vessel = object_of(exhibit, "vessel"); // its middle, 128 +- 0.5 of 82 columns
    EXPECT_LE(steps(pixel(image, 128, 50), twins.rgb8(vessel)), 1);
}

INSTANTIATE_TEST_SUITE_P(By, Media, testing::ValuesIn(cases(false)), case_name);

class Corner : public testing::TestWithParam<Case> {};

TEST_P(Corner, IsTheTwinsAtEveryPlace) {
    const Exhibit exhibit =
        exhibit_by(GetParam(), "kind = corner\nmaterials = cc-red, cc-yellow\n[object.floor]\nspecular = "
                               "0.2\nshininess = 12\n");
    const Scene scene = build_scene(exhibit);
    const Image image = frame_of(exhibit);
    const Twin twins(exhibit);
    const double aspect = 256.0 / 64;
    const glm::dvec3 up(0, 1, 0), forward(0, 0, 1);
    for (const int y : {12, 18, 24, 30, 42, 46, 50, 54})
        for (const int x : {110, 140}) {
            const bool wall = y < 36; // the edge lies between
            const ObjectSetting& object = exhibit.objects[wall ? 0 : 1];
            const glm::dvec3 normal = wall ? forward : up, facing = wall ? up : forward;
            const glm::dvec3 at = on_plane(exhibit, scene, x, y, {0, 0, 0}, normal);
            const double off_edge = wall ? at.y : at.z;
            ASSERT_GT(off_edge, 0) << y;
            ASSERT_LT(off_edge, 1) << "the pixel shows the plane: " << y;
            Pixel there = twins.pixel_on(object);
            for (std::size_t l = 0; l < there.lamps.size(); ++l) {
                const glm::vec4 place = lamp_place(exhibit, twins.view().lamps[l], scene);
                there.lamps[l].light = arriving_light<double>(
                    {array_of(glm::dvec3(place)), true, {1, 0, 0}},
                    {array_of(at), array_of(normal), array_of(glm::dvec3(view_of(scene.camera, aspect).eye)),
                     object.specular, object.shininess});
                there.lamps[l].light.bounced =
                    std::max(glm::dot(facing, glm::dvec3(place)), 0.0) * bounce_share(off_edge);
            }
            const EncodedRgb8 drawn = pixel(image, x, y), twin = twins.rgb8(object, there);
            EXPECT_LE(steps(drawn, twin), 1)
                << x << ' ' << y << ": drawn " << text_of(drawn) << ", twin " << text_of(twin);
        }
}

INSTANTIATE_TEST_SUITE_P(By, Corner, testing::ValuesIn(cases(true)), case_name);

} // namespace
} // namespace metamer
