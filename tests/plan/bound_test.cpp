// A plan's bound against pixels that the planner has not tried: any thickness, any share of the lamps, any
// mixture of direct and bounced light.
#include <gtest/gtest.h>
#include <random>

#include "color/difference.h"
#include "plan/planned.h"

namespace metamer::test {
namespace {

constexpr int kPixels = 100;

// How far the bound, which is a maximum over samples, may be passed between them: in half, rounding alone is
// another for each pixel, up to a twentieth.
constexpr double kSlack = 1.15, kLeast = 0.01, kLeastInHalf = 0.05;

class Bound : public testing::Test {
protected:
    double uniform() { return std::uniform_real_distribution<double>(0, 1)(rng_); }

    /// As bright as one lamp, as the planner's pixels are; shares at random.
    Pixel random_pixel(const Planned& planned, const ObjectSetting& object) {
        Pixel pixel = pixel_of(planned.plan.halves[0].view);
        pixel.material = planned.spectra.material(object.material.key);
        double total = 0;
        for (PixelLamp& lamp : pixel.lamps)
            total += lamp.strength = uniform();
        for (PixelLamp& lamp : pixel.lamps)
            lamp.strength /= total;
        if (object.medium) {
            pixel.medium = planned.spectra.material(object.medium->key);
            pixel.thickness = uniform() * object.thickness;
        }
        if (const ObjectSetting* other = other_wall(planned.exhibit, object)) {
            pixel.other = planned.spectra.material(other->material.key);
            for (PixelLamp& lamp : pixel.lamps)
                lamp.light = {uniform(), 0, 0.5 * uniform()};
        }
        return pixel;
    }

    double error_of(const Planned& planned, const ObjectPlan& plan, const Pixel& pixel) {
        const Sight sight = sight_of(planned.plan.halves[0].view, planned.spectra, &plan.taps);
        const Xyz shown = shown_xyz(plan.method, pixel, sight, planned.plan.fragment_bits);
        return delta_e_2000(shown, exact_xyz(pixel, planned.spectra.exact()));
    }

    void expect_bound(const std::string& text, int fragment_bits = 23) {
        const Planned planned(text, fragment_bits);
        for (std::size_t i = 0; i < planned.exhibit.objects.size(); ++i) {
            const ObjectPlan& plan = planned.plan.halves[0].objects[i];
            double worst = 0;
            for (int k = 0; k < kPixels; ++k)
                worst = std::max(worst,
                                 error_of(planned, plan, random_pixel(planned, planned.exhibit.objects[i])));
            const double least = fragment_bits < kFloatBits ? kLeastInHalf : kLeast;
            EXPECT_LE(worst, kSlack * plan.delta_e_bound + least)
                << text << plan.object << ": " << in_english(plan.why);
            EXPECT_LE(plan.delta_e_bound, plan.asked ? 100 : planned.plan.tolerance);
        }
    }

private:
    std::mt19937 rng_{2015}; // NOLINT: the same on every run
};

const std::string kThreeLamps = "[lamp.1]\nspectrum = F11\nstrength = 2\n[lamp.2]\nspectrum = A2800\n"
                                "[lamp.3]\nspectrum = D65\nstrength = 0.5\n";

TEST_F(Bound, HoldsThroughMedia) {
    expect_bound("[scene]\nkind = media\n[lamp.1]\nspectrum = krypton\n");
    expect_bound("[scene]\nkind = media\n[accuracy]\ntolerance = 0.1\n" + kThreeLamps);
}

TEST_F(Bound, HoldsBetweenTwoWalls) {
    expect_bound("[scene]\nkind = corner\n" + kThreeLamps);
    expect_bound("[scene]\nkind = corner\n[accuracy]\nmethod = reduced\n" + kThreeLamps);
    expect_bound("[scene]\nkind = corner\n[accuracy]\nmethod = tristimulus\n" + kThreeLamps);
}

TEST_F(Bound, HoldsForProductsAndLoopsUnderSeveralLamps) {
    for (const char* method : {"rgb", "tristimulus", "prefiltered", "packed", "spectral"})
        expect_bound("[scene]\nmaterials = cc-red, cc-blue, cc-cyan\n[accuracy]\nmethod = " +
                     std::string(method) + "\n" + kThreeLamps);
}

TEST_F(Bound, HoldsInHalfPrecision) {
    expect_bound("[scene]\nkind = media\n[accuracy]\ntolerance = 2\n" + kThreeLamps, 10);
    expect_bound("[scene]\nmaterials = cc-red, cc-blue\n" + kThreeLamps, 10);
}

} // namespace
} // namespace metamer::test
