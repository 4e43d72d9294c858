#include "screens/scene_twin.h"

#include "exhibit/load.h"
#include "render/pick.h"

namespace metamer::test {

SceneTwin::SceneTwin(const std::string& ini, const std::vector<std::string>& sets)
    : exhibit_(parse_exhibit(ini, "twin", ".", sets, nullptr, Use::kiosk)),
      twin_(exhibit_),
      scene_(build_scene(exhibit_)) {}

std::optional<EncodedRgb8> SceneTwin::color(double x, double y, std::size_t half, double around) const {
    const auto object = [&](double at_x, double at_y) {
        const auto hit = pick(scene_, exhibit_, at_x, at_y, 1);
        return hit ? std::optional(hit->object) : std::nullopt;
    };
    const auto here = object(x, y);
    for (const double dx : {-around, around})
        for (const double dy : {-around, around})
            if (!here || object(x + dx, y + dy) != here)
                return std::nullopt;
    return twin_.color(*here, half);
}

} // namespace metamer::test
