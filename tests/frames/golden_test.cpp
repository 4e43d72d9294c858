// Five small pictures for composition only: that the camera looks where it looked, that nothing is missing.
// Colors are tested elsewhere, against numbers. METAMER_UPDATE_GOLDEN=1 writes them anew; look at them before
// committing.
#include <cstdlib>
#include <gtest/gtest.h>

#include "base/files.h"
#include "frames/frames.h"
#include "image/png.h"

namespace metamer {
namespace {

struct Golden {
    const char* name;
    const char* exhibit;
};
constexpr Golden kGolden[] = {{"crayons", "crayons.ini"},
                              {"still-life", "still-life.ini"},
                              {"loaf", "figures/fig34.ini"},
                              {"single", "figures/fig35-spectral.ini"},
                              {"ramp", "figures/ch83-ramp.ini"}};

class Composition : public testing::TestWithParam<Golden> {};

// Rasterizers differ by coverage along edges: a pixel there may be off by all, so the mean is what counts. A
// moved object changes some percent of the pixels by tens of steps, which is more than one step in the mean.
TEST_P(Composition, IsAsItWas) {
    const std::string folder = METAMER_SOURCE_DIR;
    const Exhibit exhibit = load_exhibit(folder + "/config/" + GetParam().exhibit,
                                         {"display.width=160", "display.height=90", "display.supersample=2"});
    const Image drawn = frame_of(exhibit);
    const std::string path = folder + "/tests/frames/golden/" + GetParam().name + ".png";
    if (std::getenv("METAMER_UPDATE_GOLDEN"))
        write_file(path, encode_frame(drawn, exhibit));
    const Image golden = decode_png(read_file(path), path).image;
    ASSERT_EQ(golden.rgba.size(), drawn.rgba.size());
    double sum = 0;
    for (std::size_t i = 0; i < golden.rgba.size(); ++i)
        sum += std::abs(golden.rgba[i] - drawn.rgba[i]);
    EXPECT_LT(sum / static_cast<double>(golden.rgba.size()), 0.5) << path;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Composition, testing::ValuesIn(kGolden), [](const auto& scene) {
    std::string name = scene.param.name;
    std::erase(name, '-');
    return name;
});

} // namespace
} // namespace metamer
