// Scenes without shading: ramps and patches, drawn in clip space.
#include <array>
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

// Upright strips from left to right, each `thickness` thick (texture coordinate u, 0 .. 1) where it stands,
// between a bottom and a top in shares of the frame.
template <class Shape>
SceneObject strips(const ObjectSetting& setting, double left, double right, int count, const Shape& shape) {
    SceneObject object{&setting, {}};
    const auto point = [&](double u, double v) {
        const auto [top, bottom, thickness] = shape(u);
        const double x = left + (right - left) * u, y = bottom + (top - bottom) * v;
        return glm::vec3(2 * x - 1, 1 - 2 * y, 0);
    };
    add_surface(object.mesh, point, count, 1);
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column <= count; ++column)
            object.mesh
                .vertices[static_cast<std::size_t>((row * (count + 1) + column) * kVertexFloats + kUvAt)] =
                static_cast<float>(shape(static_cast<double>(column) / count)[2]);
    return object;
}

} // namespace

Scene build_media(const Exhibit& exhibit) {
    Scene scene = flat_scene();
    for (const ObjectSetting& setting : exhibit.objects) {
        if (setting.name == "wedge") // seen from the side of its growing thickness
            scene.objects.push_back(strips(setting, 0.08, 0.92, 64, [](double u) {
                return std::array{0.12, 0.44, u};
            }));
        else if (setting.name == "vessel") // the chord of a circle, seen from the front
            scene.objects.push_back(strips(setting, 0.34, 0.66, 96, [](double u) {
                const double across = 2 * u - 1, chord = std::sqrt(std::max(0.0, 1 - across * across));
                return std::array{0.56 - 0.012 * chord, 0.92 + 0.012 * chord, chord};
            }));
        else
            scene.objects.push_back(rectangle(setting, 0, 0, 1, 1));
    }
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
