// The CPU's word on what a kiosk's scene shows: flat scenes, where every pixel of an object is one color.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "color/xyz.h"
#include "plan/twin.h"
#include "render/scene.h"

namespace metamer::test {

class SceneTwin {
public:
    /// `sets` as `--set` takes them.
    SceneTwin(const std::string& ini, const std::vector<std::string>& sets);

    /// At a place of the scene, 0 .. 1 from its upper left corner, in a half (0 left, 1 right), by the twin
    /// of the method that draws it there; none where no object is, or an edge within `around` of the width or
    /// height.
    std::optional<EncodedRgb8> color(double x, double y, std::size_t half, double around) const;

private:
    Exhibit exhibit_;
    Twin twin_;
    Scene scene_;
};

} // namespace metamer::test
