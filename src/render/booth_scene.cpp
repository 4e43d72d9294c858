// The light booth of showrooms: a gray room, samples on its steps, and two cards in front that touch each
// other.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/meshes.h"
#include "render/scene_kinds.h"

namespace metamer {

namespace {

// The steps lie before the back; floor and walls go on beyond any frame.
constexpr float kBack = -1.5f, kFront = 24, kTop = 12, kHalfWidth = 1.8f, kFlare = 20;
constexpr float kStepHeight = 0.64f, kStepDepth = 0.55f;
constexpr std::size_t kMostInARow = 6;

/// How the samples stand: up to six on one step, more on two.
struct Rack {
    std::size_t samples, steps, columns;
    float pitch; ///< from one to the next
};

Rack rack_of(const Exhibit& exhibit) {
    const auto samples = static_cast<std::size_t>(
        std::ranges::count_if(exhibit.objects, [](const auto& o) { return o.name.starts_with("sample-"); }));
    const std::size_t steps = samples > kMostInARow ? 2 : 1, columns = (samples + steps - 1) / steps;
    return {samples, steps, columns, std::min(3.1f / static_cast<float>(columns), 0.8f)};
}

float step_front(std::size_t steps, std::size_t step) {
    return kBack + kStepDepth * static_cast<float>(steps - step);
}

void add_room(MeshData& mesh, std::size_t steps) {
    const float w = kHalfWidth, f = kHalfWidth + kFlare;
    add_quad(mesh, {-f, 0, kFront}, {f, 0, kFront}, {f, 0, kBack}, {-f, 0, kBack});
    add_quad(mesh, {-w, 0, kBack}, {w, 0, kBack}, {w, kTop, kBack}, {-w, kTop, kBack});
    // The sides open to the visitor, so that a lamp above and before them lights both.
    add_quad(mesh, {-f, 0, kFront}, {-w, 0, kBack}, {-w, kTop, kBack}, {-f, kTop, kFront});
    add_quad(mesh, {w, 0, kBack}, {f, 0, kFront}, {f, kTop, kFront}, {w, kTop, kBack});
    for (std::size_t i = 0; i < steps; ++i) {
        const float z = step_front(steps, i), y = kStepHeight * static_cast<float>(i + 1);
        const float low = y - kStepHeight, behind = z - kStepDepth;
        add_quad(mesh, {-w, low, z}, {w, low, z}, {w, y, z}, {-w, y, z});
        add_quad(mesh, {-w, y, z}, {w, y, z}, {w, y, behind}, {-w, y, behind});
    }
}

// A card that leans back, its lower edge from `left` over `width`; seen from both sides, as lamps see its
// back.
void add_card(MeshData& mesh, const glm::vec3& left, float width, float height, float lean) {
    const glm::vec3 across(width, 0, 0), up(0, height * std::cos(lean), -height * std::sin(lean));
    add_quad(mesh, left, left + across, left + across + up, left + up);
    add_quad(mesh, left + across, left, left + up, left + across + up);
}

void add_sample(MeshData& mesh, const Rack& rack, std::size_t sample) {
    // Read from the upper left, as lists are.
    const std::size_t row = sample / rack.columns, step = rack.steps - 1 - row;
    const std::size_t in_row = std::min(rack.columns, rack.samples - row * rack.columns);
    const float width = 0.88f * rack.pitch, height = std::min(1.25f * width, 0.6f);
    const float column = static_cast<float>(sample % rack.columns) - static_cast<float>(in_row) / 2 + 0.5f;
    const glm::vec3 foot(column * rack.pitch - width / 2, kStepHeight * static_cast<float>(step + 1),
                         step_front(rack.steps, step) - 0.15f);
    add_card(mesh, foot, width, height, 0.25f);
}

// Those in front touch at x = 0.
void add_front_card(MeshData& mesh, bool left) {
    constexpr float kWidth = 1.05f, kHeight = 1, kLean = 0.55f;
    add_card(mesh, {left ? -kWidth : 0, 0, 1}, kWidth, kHeight, kLean);
}

} // namespace

Scene build_booth(const Exhibit& exhibit) {
    Scene scene;
    const Rack rack = rack_of(exhibit);
    std::size_t sample = 0;
    for (const ObjectSetting& setting : exhibit.objects) {
        SceneObject object{&setting, {}};
        if (setting.name == "interior")
            add_room(object.mesh, rack.steps);
        else if (setting.name == "card-a" || setting.name == "card-b")
            add_front_card(object.mesh, setting.name == "card-a");
        else
            add_sample(object.mesh, rack, sample++);
        scene.objects.push_back(std::move(object));
    }
    const float more = 0.25f * static_cast<float>(rack.steps - 1);
    scene.camera = {.eye = {0, 2.1f + more, 6},
                    .target = {0, 0.7f + more, 0},
                    .field_of_view_deg = 26,
                    .half_size = {1.6f, 1.2f + more}};
    scene.center = {0, 0.6f, -0.2f};
    scene.radius = 2.2f;
    // From above and before, as the tubes of a booth; the second fills the shadows of the first.
    for (const glm::vec3& direction :
         {glm::vec3(0, 1, 0.7f), glm::vec3(0, 0.4f, 1), glm::vec3(-0.6f, 1, 0.8f), glm::vec3(0.6f, 1, 0.8f),
          glm::vec3(-0.8f, 0.6f, 1), glm::vec3(0.8f, 0.6f, 1), glm::vec3(0, 1, 0.4f), glm::vec3(0, 0.2f, 1)})
        scene.lamp_directions.push_back(glm::normalize(direction));
    return scene;
}

} // namespace metamer
