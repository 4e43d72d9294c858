// Every lamp x every material x every method: what the GPU draws is what the CPU twin says, to one step of 8
// bits.
#include <cmath>
#include <gtest/gtest.h>

#include "frames/frames.h"
#include "gles/framebuffer.h"
#include "plan/twin.h"
#include "render/frame_renderer.h"

namespace metamer {
namespace {

/// Patches of `set` in a square frame, side by side as build_patches lays them.
Exhibit patches_of(const std::string& set) {
    return exhibit_of("[display]\nwidth = 64\nheight = 64\n[scene]\nkind = patches\nmaterials = " + set +
                      "\n");
}

void compare_with_twin(const Exhibit& exhibit, const Image& image) {
    const Twin twins(exhibit);
    const auto columns =
        static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(exhibit.objects.size())) - 1e-9));
    const std::size_t rows = (exhibit.objects.size() + columns - 1) / columns;
    for (std::size_t i = 0; i < exhibit.objects.size(); ++i) {
        const double x = (static_cast<double>(i % columns) + 0.5) / static_cast<double>(columns);
        const double y = (static_cast<double>(i / columns) + 0.5) / static_cast<double>(rows);
        const EncodedRgb8 drawn = pixel(image, static_cast<int>(x * 64), static_cast<int>(y * 64)),
                          twin = twins.rgb8(exhibit.objects[i]);
        EXPECT_LE(steps(drawn, twin), 1)
            << method_name(twins.plan_of(exhibit.objects[i]).method) << ", " << exhibit.lamps[0].lamp.name
            << " on " << exhibit.objects[i].material.material.name << ": drawn " << int(drawn.r) << ' '
            << int(drawn.g) << ' ' << int(drawn.b) << ", twin " << int(twin.r) << ' ' << int(twin.g) << ' '
            << int(twin.b);
    }
}

class Pairs : public testing::TestWithParam<MaterialSet> {};

TEST_P(Pairs, GpuIsWithinAStepOfTheTwin) {
    const Surfaceless context;
    const Framebuffer target(64, 64, DepthBuffer::depth16);
    Exhibit exhibit = patches_of(GetParam().name);
    const Atlas materials_only = exhibit.atlas;
    for (const MethodInfo& info : kMethods) {
        exhibit.accuracy.method = info.method;
        FrameRenderer renderer(exhibit);
        for (const Lamp& lamp : library_lamps()) {
            exhibit.atlas = materials_only;
            exhibit.lamps[0].lamp = lamp;
            exhibit.lamps[0].key = add_lamp(exhibit.atlas, lamp);
            renderer.update();
            target.bind();
            renderer.draw(64, 64);
            compare_with_twin(exhibit, {64, 64, target.read_rgba()});
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Materials, Pairs, testing::ValuesIn(material_sets().begin(), material_sets().end()),
                         [](const auto& set) { return set.param.name; });

// Nearly all light at one end of the grid: a loop that begins late or ends early misses it.
TEST(PairsAtTheEnds, GpuIsWithinAStepOfTheTwin) {
    const Surfaceless context;
    for (const double end_nm : {kThesisGrid.first_nm, kThesisGrid.last_nm()}) {
        Exhibit exhibit = patches_of("colorchecker");
        Lamp lamp = find_lamp("line:555");
        lamp.spectrum.lines = {{555, 1}, {end_nm, 100}};
        exhibit.lamps[0].lamp = lamp;
        exhibit.lamps[0].key = add_lamp(exhibit.atlas, lamp);
        compare_with_twin(exhibit, render_frame(exhibit));
    }
}

// The same in other spaces, curves and adaptations, on a few pairs.
TEST(PairsInSpaces, GpuIsWithinAStepOfTheTwin) {
    const Surfaceless context;
    for (const WorkingSpace& space : working_spaces())
        for (const char* transfer : {"srgb", "none"})
            for (const char* adaptation : {"none", "bradford"})
                for (const MethodInfo& info : kMethods) {
                    const Exhibit exhibit = exhibit_of(
                        "[display]\nwidth = 64\nheight = 64\nworking_space = " + std::string(space.name) +
                        "\ntransfer = " + transfer + "\nadaptation = " + adaptation +
                        "\n[accuracy]\nmethod = " + std::string(info.name) +
                        "\n[scene]\nkind = patches\nmaterials = cc-red, cc-cyan, cc-neutral-5, cc-blue\n" +
                        "[lamp.1]\nspectrum = F2\nstrength = 1.3\n");
                    compare_with_twin(exhibit, render_frame(exhibit));
                }
}

} // namespace
} // namespace metamer
