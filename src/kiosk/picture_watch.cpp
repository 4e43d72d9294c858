#include "kiosk/picture_watch.h"

#include <array>
#include <cstdlib>

#include "base/error.h"
#include "base/printed.h"
#include "exhibit/load.h"
#include "methods/shade.h"
#include "plan/object_pixels.h"

namespace metamer {

namespace {

constexpr int kSidePx = 16, kMostSteps = 2;
constexpr std::array<double, 2> kStrengths{0.8, 0.5};

// Rows as the thesis has them: they take no time.
constexpr const char* kExhibit = "[atlas]\nquantization = thesis\n[scene]\nkind = patches\n"
                                 "materials = cc-orange, cc-blue\n[lamp.1]\nspectrum = F11\nstrength = 0.8\n"
                                 "[object.cc-orange]\nmethod = spectral\n[object.cc-blue]\nmethod = folded\n";

} // namespace

PictureWatch::PictureWatch()
    : exhibit_(parse_exhibit(kExhibit, "the picture watchdog", ".")),
      renderer_(exhibit_),
      target_(2 * kSidePx, kSidePx, DepthBuffer::depth16) {}

std::string PictureWatch::look() {
    std::vector<std::uint8_t> drawn;
    try {
        // Another picture each time: one that is stuck is wrong.
        exhibit_.lamps[0].strength = kStrengths[looks_++ % kStrengths.size()];
        renderer_.update();
        target_.bind();
        renderer_.draw(2 * kSidePx, kSidePx);
        drawn = target_.read_rgba();
    } catch (const Error& error) {
        return error.what();
    }
    const HalfPlan& plan = renderer_.plan().halves.front();
    const ExhibitSpectra& spectra = renderer_.spectra();
    for (std::size_t i = 0; i < exhibit_.objects.size(); ++i) {
        const Pixel pixel =
            pixel_of(exhibit_, plan.view, spectra, exhibit_.objects[i], exhibit_.objects[i].material);
        const EncodedRgb8 rgb =
            shade_rgb8<double>(plan.objects[i].method, pixel, sight_of(plan.view, spectra));
        const std::size_t at = (kSidePx / 2 * 2 * kSidePx + i * kSidePx + kSidePx / 2) * 4;
        const int expected[] = {rgb.r, rgb.g, rgb.b};
        for (std::size_t c = 0; c < 3; ++c)
            if (std::abs(drawn[at + c] - expected[c]) > kMostSteps)
                return printed("%s shows %d %d %d where %d %d %d belongs",
                               std::string(method_name(plan.objects[i].method)).c_str(), drawn[at],
                               drawn[at + 1], drawn[at + 2], expected[0], expected[1], expected[2]);
    }
    return {};
}

} // namespace metamer
