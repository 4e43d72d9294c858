// Scenes without shading: ramps and patches, drawn in clip space.
#include <algorithm>
#include <cmath>

#include "render/meshes.h"
#include "render/scene_kinds.h"

namespace metamer {

namespace {

// A rectangle given in shares of the frame, (0, 0) top left; texture coordinate u runs from left to right.
SceneObject rectangle(const ObjectSetting& setting, double left, double top, double right, double bottom) {
    const auto at = [](double x, double y) { return glm::vec3(2 * x - 1, 1 - 2 * y, 0); };
    SceneObject object{&setting, {}};
    add_quad(object.mesh, at(left, bottom), at(right, bottom), at(right, top), at(left, top));
    return object;
}

Scene flat_scene() {
    Scene scene;
    scene.camera.flat = true;
    scene.lit = false;
    scene.lamp_directions.assign(kMostLamps, glm::vec3(0, 0, 1));
    return scene;
}

// The chord of a circle seen from the front, as thickness (texture coordinate u, 0 .. 1): a round vessel.
SceneObject vessel(const ObjectSetting& setting, double left, double top, double right, double bottom) {
    constexpr int kColumns = 96;
    const auto chord = [](double u) { return std::sqrt(std::max(0.0, 1 - (2 * u - 1) * (2 * u - 1))); };
    SceneObject object{&setting, {}};
    const auto point = [&](double u, double v) {
        const double bulge = 0.012 * chord(u); // its rims, seen a little from above and below
        const double y = bottom + bulge + (top - bottom - 2 * bulge) * v;
        return glm::vec3(2 * (left + (right - left) * u) - 1, 1 - 2 * y, 0);
    };
    add_surface(object.mesh, point, kColumns, 1);
    for (std::size_t v = 0; v < object.mesh.vertices.size(); v += kVertexFloats) {
        float& thickness = object.mesh.vertices[v + kUvAt];
        thickness = static_cast<float>(chord(thickness));
    }
    return object;
}

// As thick as it is far down: 0 at the top, 1 at the bottom, as texture coordinate u.
SceneObject wedge(const ObjectSetting& setting, double left, double top, double right, double bottom) {
    SceneObject object = rectangle(setting, left, top, right, bottom);
    for (std::size_t v = 0; v < object.mesh.vertices.size(); v += kVertexFloats)
        object.mesh.vertices[v + kUvAt] = 1 - object.mesh.vertices[v + kUvAt + 1];
    return object;
}

} // namespace

Scene build_media(const Exhibit& exhibit) {
    Scene scene = flat_scene();
    // Both lie across the middle: the halves of a comparison see the same thicknesses.
    for (const ObjectSetting& setting : exhibit.objects)
        scene.objects.push_back(setting.name == "wedge"    ? wedge(setting, 0.1, 0.06, 0.9, 0.52)
                                : setting.name == "vessel" ? vessel(setting, 0.34, 0.6, 0.66, 0.94)
                                                           : rectangle(setting, 0, 0, 1, 1));
    // Nearer to the eye in clip space: the box is behind.
    for (SceneObject& object : scene.objects)
        if (object.setting->medium)
            for (std::size_t v = 2; v < object.mesh.vertices.size(); v += kVertexFloats)
                object.mesh.vertices[v] = -0.5f;
    return scene;
}

Scene build_ramp(const Exhibit& exhibit) {
    Scene scene = flat_scene();
    const double n = static_cast<double>(exhibit.objects.size()), gap = 0.03;
    for (std::size_t i = 0; i < exhibit.objects.size(); ++i) {
        const double top = (static_cast<double>(i) + gap) / n,
                     bottom = (static_cast<double>(i) + 1 - gap) / n;
        scene.objects.push_back(rectangle(exhibit.objects[i], 0, top, 1, bottom));
    }
    return scene;
}

Scene build_patches(const Exhibit& exhibit) {
    Scene scene = flat_scene();
    const std::size_t n = exhibit.objects.size();
    // As many columns as make the patches nearly square in the frame at hand.
    const double aspect = static_cast<double>(exhibit.display.width_px) / exhibit.display.height_px;
    const auto columns =
        static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(n) * aspect) - 1e-9));
    const std::size_t rows = (n + columns - 1) / columns;
    for (std::size_t i = 0; i < n; ++i) {
        const double column = static_cast<double>(i % columns), row = static_cast<double>(i / columns);
        const double w = static_cast<double>(columns), h = static_cast<double>(rows);
        scene.objects.push_back(
            rectangle(exhibit.objects[i], column / w, row / h, (column + 1) / w, (row + 1) / h));
    }
    return scene;
}

} // namespace metamer
