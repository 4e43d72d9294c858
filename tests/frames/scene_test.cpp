// Where things stand: the order of objects, the lamps that the INI does not place, the eye.
#include "render/scene.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <set>

#include "frames/frames.h"
#include "render/draws.h"

namespace metamer {
namespace {

struct Box {
    glm::vec3 least{std::numeric_limits<float>::max()}, most{std::numeric_limits<float>::lowest()};
};

Box box_of(const MeshData& mesh) {
    Box box;
    for (std::size_t v = 0; v < mesh.vertices.size(); v += kVertexFloats) {
        const glm::vec3 p(mesh.vertices[v], mesh.vertices[v + 1], mesh.vertices[v + 2]);
        box.least = glm::min(box.least, p);
        box.most = glm::max(box.most, p);
    }
    return box;
}

Exhibit three(const std::string& kind) {
    return exhibit_of("[scene]\nkind = " + kind + "\nmaterials = cc-red, cc-green, cc-blue\n");
}

TEST(Scenes, ListsAreReadFromTheTop) {
    for (const char* kind : {"loaf", "crayons"}) {
        const Exhibit exhibit = three(kind);
        const Scene scene = build_scene(exhibit);
        ASSERT_EQ(scene.objects.size(), 3u);
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(scene.objects[i].setting, &exhibit.objects[i]) << kind;
            const Box box = box_of(scene.objects[i].mesh);
            // Three objects share the height from -1 to 1.
            EXPECT_LT(box.most.y, 1 - 2 * static_cast<float>(i) / 3) << kind << i;
            EXPECT_GT(box.least.y, 1 - 2 * static_cast<float>(i + 1) / 3) << kind << i;
        }
    }
}

TEST(Scenes, TheLoafStandsEdgeOn) {
    const Exhibit exhibit = three("loaf");
    const Box box = box_of(build_scene(exhibit).objects[0].mesh);
    // A square of side 2 turned by 45 degrees: its corners lie at sqrt 2 on both axes.
    for (float side : {box.most.x, box.most.z, -box.least.x, -box.least.z})
        EXPECT_NEAR(side, std::sqrt(2.0), 1e-5);
}

TEST(Scenes, CrayonsLieTipToTheRight) {
    const Exhibit exhibit = three("crayons");
    const MeshData mesh = build_scene(exhibit).objects[0].mesh;
    const Box box = box_of(mesh);
    EXPECT_GT(box.most.x - box.least.x, 5 * (box.most.y - box.least.y));
    const float middle = (box.most.y + box.least.y) / 2;
    for (std::size_t v = 0; v < mesh.vertices.size(); v += kVertexFloats)
        if (mesh.vertices[v] > box.most.x - 1e-4f) {
            EXPECT_NEAR(mesh.vertices[v + 1], middle, 1e-3) << "the tip is a point";
        }
}

TEST(Scenes, PatchesFillTheFrameRowByRow) {
    const Exhibit exhibit =
        exhibit_of("[display]\nwidth = 200\nheight = 100\n[scene]\nkind = patches\nmaterials = "
                   "cc-red, cc-green, cc-blue, cc-white, cc-cyan, cc-orange, cc-yellow\n");
    const Scene scene = build_scene(exhibit);
    ASSERT_EQ(scene.objects.size(), 7u);
    // In a frame twice as wide as high, seven patches are four beside each other, two above each other.
    for (std::size_t i = 0; i < 7; ++i) {
        const Box box = box_of(scene.objects[i].mesh);
        const auto column = static_cast<float>(i % 4), row = static_cast<float>(i / 4);
        EXPECT_EQ(box.least.x, -1 + column / 2) << i;
        EXPECT_EQ(box.most.x, -0.5f + column / 2) << i;
        EXPECT_EQ(box.most.y, 1 - row) << i;
        EXPECT_EQ(box.least.y, -row) << i;
    }
}

TEST(Scenes, EveryLampHasADirectionOfItsOwn) {
    for (const char* kind : {"loaf", "crayons", "still-life"}) {
        const Exhibit exhibit = exhibit_of(std::string("[scene]\nkind = ") + kind + "\n");
        const Scene scene = build_scene(exhibit);
        ASSERT_EQ(scene.lamp_directions.size(), static_cast<std::size_t>(kMostLamps)) << kind;
        std::set<std::array<float, 3>> different;
        for (const glm::vec3& direction : scene.lamp_directions) {
            EXPECT_NEAR(glm::length(direction), 1, 1e-6) << kind;
            different.insert({direction.x, direction.y, direction.z});
        }
        EXPECT_EQ(different.size(), static_cast<std::size_t>(kMostLamps)) << kind;
    }
}

// The halves of a split are mirror images there: a lamp from the side would make them differ by light alone.
TEST(Scenes, TheFirstLampIsFairToBothHalves) {
    for (const char* kind : {"loaf", "crayons"}) {
        const Exhibit exhibit = three(kind);
        EXPECT_EQ(build_scene(exhibit).lamp_directions[0].x, 0) << kind;
    }
}

// At any aspect the box stays in view and touches the frame; the target is its middle.
TEST(View, KeepsTheBoxInViewAtAnyAspect) {
    const Camera camera{
        .eye = {0, 0, 9}, .target = {1, 2, 3}, .field_of_view_deg = 40, .half_size = {2, 1.5f}};
    for (double aspect : {0.4, 1.0, 4.0 / 3, 3.0}) {
        Camera ahead = camera;
        ahead.eye = camera.target + glm::vec3(0, 0, 1);
        const View view = view_of(ahead, aspect);
        const auto project = [&](const glm::vec3& p) {
            const glm::vec4 clip = view.clip_from_world * glm::vec4(p, 1);
            return glm::vec3(clip) / clip.w;
        };
        const glm::vec3 middle = project(ahead.target),
                        corner = project(ahead.target + glm::vec3(2, 1.5f, 0));
        EXPECT_NEAR(middle.x, 0, 1e-6);
        EXPECT_NEAR(middle.y, 0, 1e-6);
        EXPECT_NEAR(std::max(corner.x, corner.y), 1, 1e-5) << aspect;
        EXPECT_GT(std::min(corner.x, corner.y), 0);
        EXPECT_NEAR(static_cast<double>(corner.x) * static_cast<double>(aspect) /
                        static_cast<double>(corner.y),
                    2 / 1.5, 1e-5)
            << "no distortion";
        EXPECT_LT(std::abs(middle.z), 1) << "between the near and the far plane";
    }
}

TEST(View, TheEyeIsWhereTheMatrixLooksFrom) {
    const Camera camera{.eye = {3, 2, 6}, .target = {1, 0, 0}, .field_of_view_deg = 30, .half_size = {1, 1}};
    const View view = view_of(camera, 1.5);
    EXPECT_NEAR((view.clip_from_world * glm::vec4(view.eye, 1)).w, 0, 1e-5);
    EXPECT_NEAR(
        glm::dot(glm::normalize(view.eye - camera.target), glm::normalize(camera.eye - camera.target)), 1,
        1e-6);
}

TEST(Scenes, LampsWithoutAPlaceStandWhereTheSceneWantsThem) {
    const Exhibit exhibit =
        exhibit_of("[scene]\nkind = still-life\n[lamp.1]\nspectrum = A\n[lamp.2]\nspectrum = "
                   "F11\n[lamp.3]\nspectrum = E\nposition = 1 2 3\n[lamp.4]\nspectrum = "
                   "E\ndirection = 0 -1 0\n");
    const Scene scene = build_scene(exhibit);
    const auto lamps = half_views(exhibit)[0].lamps;
    ASSERT_EQ(lamps.size(), 4u);
    const auto place = [&](std::size_t lamp) { return lamp_place(exhibit, lamps[lamp], scene); };
    EXPECT_EQ(place(0), glm::vec4(scene.lamp_directions[0], 0));
    EXPECT_EQ(place(1), glm::vec4(scene.lamp_directions[1], 0));
    EXPECT_EQ(place(2), glm::vec4(1, 2, 3, 1));
    EXPECT_EQ(place(3), glm::vec4(0, 1, 0, 0)) << "light falls down, the lamp is up";
}

} // namespace
} // namespace metamer
