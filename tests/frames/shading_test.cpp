// Frames against closed forms: a pixel's place in the world, the light that reaches it, and its color, all by
// hand.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "frames/frames.h"
#include "frames/places.h"
#include "plan/twin.h"
#include "render/draws.h"

namespace metamer {
namespace {

using Vector = glm::dvec3;

/// The pixel that the twin expects at a point of a flat surface under the exhibit's lamps.
EncodedRgb8 expected(const Twin& twin, const Exhibit& exhibit, const Scene& scene,
                     const ObjectSetting& object, const Vector& at, const Vector& normal) {
    const double aspect = static_cast<double>(exhibit.display.width_px) / exhibit.display.height_px;
    const SurfacePoint<double> point{.position = array_of(at),
                                     .normal = array_of(normal),
                                     .eye = array_of(Vector(view_of(scene.camera, aspect).eye)),
                                     .specular = object.specular,
                                     .shininess = object.shininess};
    Pixel pixel = twin.pixel_on(object);
    for (std::size_t l = 0; l < pixel.lamps.size(); ++l) {
        const HalfLamp& lamp = twin.view().lamps[l];
        const glm::vec4 place = lamp_place(exhibit, lamp, scene);
        const Falloff& falloff = exhibit.lamps[lamp.setting].falloff;
        pixel.lamps[l].light = arriving_light<double>(
            {array_of(Vector(place)), place.w == 0, {falloff.constant, falloff.linear, falloff.quadratic}},
            point);
    }
    return twin.rgb8(object, pixel);
}

const double kRoot = std::sqrt(0.5);

// The loaf of one slice is a box of 2 x 1.88 x 2, edge on; its right face has the normal (1, 0, 1)/sqrt 2.
void compare_right_face(const std::string& lamps, Method method) {
    Exhibit exhibit =
        exhibit_of("[display]\nwidth = 200\nheight = 160\n[scene]\nkind = loaf\nmaterials = cc-orange\n" +
                   lamps + "[object.slice-1]\nspecular = 0.3\nshininess = 20\n");
    exhibit.accuracy.method = method;
    const Scene scene = build_scene(exhibit);
    const Twin twins(exhibit);
    const Image image = frame_of(exhibit);
    const Vector normal(kRoot, 0, kRoot), on = normal;
    int bright = 0;
    for (const auto& [x, y] : {std::pair{104, 80}, {110, 60}, {120, 90}, {140, 50}, {150, 100}, {165, 70}}) {
        const Vector at = on_plane(exhibit, scene, x, y, on, normal);
        ASSERT_LT(std::abs(at.y), 0.93) << "the pixel shows the face";
        const EncodedRgb8 twin = expected(twins, exhibit, scene, exhibit.objects[0], at, normal),
                          drawn = pixel(image, x, y);
        EXPECT_LE(steps(drawn, twin), 1)
            << method_name(method) << ' ' << x << ' ' << y << ": drawn " << int(drawn.r) << ' '
            << int(drawn.g) << ' ' << int(drawn.b) << ", expected " << int(twin.r) << ' ' << int(twin.g)
            << ' ' << int(twin.b);
        bright += twin.r > 20;
    }
    EXPECT_GE(bright, 3) << "the light reaches the face";
}

void compare_right_face(const std::string& lamps) {
    for (const MethodInfo& info : kMethods)
        compare_right_face(lamps, info.method);
}

TEST(Shading, ParallelLightIsTheCosine) {
    compare_right_face("[lamp.1]\nspectrum = D65\ndirection = -1 -0.5 -2\n");
}

TEST(Shading, PointLightFallsOffWithDistance) {
    compare_right_face(
        "[lamp.1]\nspectrum = A2800\nstrength = 3\nposition = 2 1 3\nfalloff = 0.2 0.1 0.15\n");
}

// The falloff's least value keeps points near a lamp finite; here it holds all over the face.
TEST(Shading, FalloffHasALeastValue) {
    compare_right_face(
        "[lamp.1]\nspectrum = D65\nstrength = 0.0006\nposition = 2 1 3\nfalloff = 0 0 0.00005\n");
}

TEST(Shading, SeveralLampsAddUp) {
    compare_right_face(
        "[lamp.1]\nspectrum = A2800\nstrength = 0.4\nposition = 2 1 3\n[lamp.2]\nspectrum = F11\nstrength = "
        "0.3\ndirection = -1 0 -1\n[lamp.3]\nspectrum = krypton\nstrength = 0.2\nposition = 4 0 1\n");
}

TEST(Shading, HighlightsAreTheLampsOwnColor) {
    // Lamp and eye mirrored about the face's normal: the black loaf shows the lamp's color there.
    compare_right_face("[lamp.1]\nspectrum = D65\nposition = 8 1.6 0\n");
}

// The lamp stands behind the face's plane; a mirror as dull as this would show it otherwise.
TEST(Shading, HighlightsEndWhereTheLightDoes) {
    Exhibit exhibit =
        exhibit_of("[display]\nwidth = 200\nheight = 160\n[scene]\nkind = loaf\nmaterials = cc-orange\n"
                   "[lamp.1]\nspectrum = D65\ndirection = 1 -0.2 -0.8\n[object.slice-1]\nspecular = "
                   "1\nshininess = 1\n");
    for (const MethodInfo& info : kMethods) {
        exhibit.accuracy.method = info.method;
        const Image image = frame_of(exhibit);
        EXPECT_EQ(pixel(image, 150, 100), (EncodedRgb8{0, 0, 0})) << info.name;
        EXPECT_GT(pixel(image, 50, 100).r, 100) << "the other face is lit";
    }
}

TEST(Shading, EightLampsDraw) {
    std::string lamps;
    for (int i = 1; i <= 8; ++i)
        lamps += "[lamp." + std::to_string(i) + "]\nspectrum = F" + std::to_string(i) +
                 "\nstrength = 0.15\ndirection = -1 0 -" + std::to_string(i) + "\n";
    compare_right_face(lamps);
}

// A sphere of triangles is lit as a sphere: its normals are of unit length between the vertices too.
TEST(Shading, TheBallIsRound) {
    const Exhibit exhibit =
        exhibit_of("[display]\nwidth = 320\nheight = 180\n[scene]\nkind = still-life\n[lamp.1]\nspectrum = "
                   "D65\nstrength = "
                   "0.5\ndirection = 0.2 -0.5 -1\n[object.ball]\nspecular = 0.9\nshininess = 120\n");
    const Scene scene = build_scene(exhibit);
    const Twin twins(exhibit);
    const Image image = frame_of(exhibit);
    const auto ball = std::find_if(exhibit.objects.begin(), exhibit.objects.end(),
                                   [](const ObjectSetting& object) { return object.name == "ball"; });
    const Vector center(-1.35, 0.55, 0.05), eye(view_of(scene.camera, 320.0 / 180).eye);
    int pixels = 0, brightest = 0;
    for (int y = 0; y < 180; y += 2)
        for (int x = 0; x < 160; x += 2) {
            const Vector ray = glm::normalize(on_plane(exhibit, scene, x, y, center, {0, 0, 1}) - eye);
            const double along = glm::dot(center - eye, ray);
            const Vector nearest = eye + along * ray;
            const double miss = glm::distance(nearest, center);
            const Vector at = nearest - std::sqrt(std::max(0.55 * 0.55 - miss * miss, 0.0)) * ray;
            if (miss > 0.5 || at.y < 0.65) // its rim, and where the orange stands before it
                continue;
            const EncodedRgb8 twin = expected(twins, exhibit, scene, *ball, at, (at - center) / 0.55);
            // Between its vertices a ball of triangles lies up to 0.002 of its radius inside the sphere.
            EXPECT_LE(steps(pixel(image, x, y), twin), 2) << x << ' ' << y;
            brightest = std::max<int>(brightest, twin.b);
            ++pixels;
        }
    EXPECT_GT(pixels, 200);
    EXPECT_GT(brightest, 150) << "the highlight";
    EXPECT_LT(brightest, 250) << "unclamped";
}

// Patches and ramps: I_shading is 1, whatever the object and the lamp say.
TEST(Shading, FlatScenesKnowNone) {
    Exhibit exhibit = exhibit_of("[display]\nwidth = 64\nheight = 64\n[scene]\nkind = patches\nmaterials = "
                                 "cc-black\n[lamp.1]\nspectrum = D65\n");
    const Image plain = frame_of(exhibit);
    exhibit.objects[0].specular = 1;
    exhibit.lamps[0].direction = {1, 0, -1};
    exhibit.lamps[0].falloff = {2, 0, 0};
    EXPECT_EQ(frame_of(exhibit).rgba, plain.rgba);
}

TEST(Shading, NothingIsLitByNoLight) {
    const Image image =
        frame_of(exhibit_of("[display]\nwidth = 64\nheight = 64\n[scene]\nkind = patches\nmaterials = "
                            "cc-white\n[lamp.1]\nspectrum = E\nstrength = 0\n"));
    EXPECT_EQ(pixel(image, 32, 32), (EncodedRgb8{0, 0, 0}));
}

TEST(Shading, TheBrightestLightIsWhiteNotNothing) {
    for (const MethodInfo& info : kMethods) {
        const Image image = frame_of(
            exhibit_of("[display]\nwidth = 64\nheight = 64\n[accuracy]\nmethod = " + std::string(info.name) +
                       "\n[scene]\nkind = patches\nmaterials = cc-white\n[lamp.1]\nspectrum = "
                       "E\nstrength = 1000000\n"));
        EXPECT_EQ(pixel(image, 32, 32), (EncodedRgb8{255, 255, 255})) << info.name;
    }
}

// Red has a negative green as long as light is bounded nowhere; bounded, X and Y are equal and green is not.
TEST(Shading, LightBeyondTheBoundIsTheTwins) {
    for (const Method method : {Method::tristimulus, Method::spectral}) {
        Exhibit exhibit =
            exhibit_of("[display]\nwidth = 64\nheight = 64\n[scene]\nkind = patches\nmaterials = "
                       "cc-white\n[lamp.1]\nspectrum = line:650\n");
        exhibit.accuracy.method = method;
        EXPECT_EQ(pixel(frame_of(exhibit), 32, 32).g, 0) << method_name(method);
        exhibit.lamps[0].strength = 1e6;
        EXPECT_EQ(pixel(frame_of(exhibit), 32, 32).g, 255) << method_name(method);
    }
}

// A still life under one lamp from the left: the table behind the orange, as the lamp sees it, lies in
// shadow.
std::string table_under(const std::string& lamp) {
    return "[display]\nwidth = 640\nheight = 360\n[scene]\nkind = still-life\n[lamp.1]\nspectrum = D65\n" +
           lamp + "[object.table]\nspecular = 0.4\nshininess = 2\n";
}

EncodedRgb8 at_world(const Exhibit& exhibit, const Image& image, const Vector& world) {
    const Scene scene = build_scene(exhibit);
    const View view = view_of(scene.camera, static_cast<double>(image.width) / image.height);
    const glm::dvec4 clip = glm::dmat4(view.clip_from_world) * glm::dvec4(world, 1);
    return pixel(image, static_cast<int>((clip.x / clip.w + 1) / 2 * image.width),
                 static_cast<int>((1 - clip.y / clip.w) / 2 * image.height));
}

void compare_shadow(const std::string& lamp) {
    const Exhibit with = exhibit_of(table_under(lamp + "shadow = yes\n")),
                  without = exhibit_of(table_under(lamp));
    const Image shadowed = frame_of(with), lit = frame_of(without);
    // The orange: center (-0.78, 0.3, 1.05), radius 0.3. Light falls at 45 degrees towards +x.
    const Vector in_shadow(-0.40, 0, 1.05), beside(-0.40, 0, 1.5);
    EXPECT_EQ(at_world(with, shadowed, in_shadow), (EncodedRgb8{0, 0, 0}));
    EXPECT_GT(at_world(without, lit, in_shadow).r, 40);
    EXPECT_EQ(at_world(with, shadowed, beside), at_world(without, lit, beside));
}

TEST(Shadow, FallsWhereTheOrangeStandsInParallelLight) {
    compare_shadow("direction = 1 -1 0\n");
}

TEST(Shadow, FallsWhereTheOrangeStandsBeforeAPointLamp) {
    compare_shadow("position = -3.78 3.3 1.05\nstrength = 1\n");
}

TEST(Shadow, FallsUnderWhatOverhangsInLightFromAbove) {
    const std::string above = "direction = 0 -1 0\n";
    const Exhibit with = exhibit_of(table_under(above + "shadow = yes\n")),
                  without = exhibit_of(table_under(above));
    const Image shadowed = frame_of(with), lit = frame_of(without);
    // Before the feet of the orange and of the ring, which is 0.19 high there: the eye still sees the table.
    for (const Vector& under : {Vector(-0.78, 0, 1.27), Vector(0.55, 0, 1.30)}) {
        EXPECT_EQ(at_world(with, shadowed, under), (EncodedRgb8{0, 0, 0})) << under.x;
        EXPECT_GT(at_world(without, lit, under).r, 40) << under.x;
    }
}

// The table is drawn before the wall: what is nearest to the lamp counts, not what was drawn last.
TEST(Shadow, FallsFromTheTableOnTheWallInLightFromBelow) {
    const std::string below = "direction = 0 1 -1\n";
    const Exhibit with = exhibit_of(table_under(below + "shadow = yes\n")),
                  without = exhibit_of(table_under(below));
    const Vector wall(-1, 1.5, -1.8);
    EXPECT_EQ(at_world(with, frame_of(with), wall), (EncodedRgb8{0, 0, 0}));
    EXPECT_GT(at_world(without, frame_of(without), wall).r, 40);
}

TEST(Shadow, NoSurfaceShadowsItself) {
    // Straight from above only what lies under something may darken: the table's free places do not.
    const std::string above = "direction = 0 -1 0\n";
    const Exhibit with = exhibit_of(table_under(above + "shadow = yes\n")),
                  without = exhibit_of(table_under(above));
    const Image shadowed = frame_of(with), lit = frame_of(without);
    for (const Vector& free : {Vector(-1.5, 0, 1.2), Vector(0.0, 0, 1.5), Vector(1.0, 0, 0.4),
                               Vector(-1.9, 0, 0.9), Vector(2, 0, 0.5)})
        EXPECT_LE(steps(at_world(with, shadowed, free), at_world(without, lit, free)), 1)
            << free.x << ' ' << free.z;
}

} // namespace
} // namespace metamer
