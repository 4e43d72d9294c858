// Nothing that an exhibit may ask for makes anything but a number, in half precision either.
#include <cmath>
#include <gtest/gtest.h>

#include "methods/stock.h"

namespace metamer::test {
namespace {

constexpr double kStrengths[] = {0, 1e-4, 1, 1e6};
const Light<double> kLights[] = {{0, 0, 0}, {1000, 0, 0}, {0, 1000, 0}, {1000, 1000, 0.5}, {1, 0, 0.5}};

Layer constant(double value) {
    static std::map<double, std::pair<Reflectance, std::vector<double>>> made;
    auto& [row, full] = made[value];
    row.value.fill(value);
    full.assign(kReferenceGrid.count, value);
    return {&row, &full};
}

void expect_numbers(const Pixel& pixel, const Sight& sight, const std::string& what) {
    for (const MethodInfo& info : kMethods) {
        const auto c = shade<Float16>(info.method, pixel, sight);
        for (const Float16 v : {c.r, c.g, c.b}) {
            const auto code = static_cast<double>(encode(sight.output.transfer, v));
            EXPECT_TRUE(code >= 0 && code <= 1) << info.name << ' ' << what << ": " << static_cast<double>(v);
        }
    }
}

void expect_numbers_at_any_light(Pixel pixel, const std::string& what) {
    Sight sight = stock().sight();
    Pixel one = pixel;
    one.thickness = std::min(pixel.thickness, 4.0);
    const Taps taps = taps_for(one, sight.tap_count);
    sight.taps = &taps;
    for (const double strength : kStrengths)
        for (const Light<double>& light : kLights) {
            for (PixelLamp& lamp : pixel.lamps) {
                lamp.strength = strength;
                lamp.light = light;
            }
            expect_numbers(pixel, sight, what + " at " + std::to_string(strength));
        }
}

TEST(Extremes, BlackAndWhiteUnderAnyLampAreNumbers) {
    for (const char* lamp : {"E", "krypton", "NIST-LPS", "line:450", "line:660", "A2800"})
        for (const double reflectance : {0.0, 1.0}) {
            Pixel pixel = stock().pair(lamp, "cc-red");
            pixel.material = constant(reflectance);
            expect_numbers_at_any_light(pixel, lamp);
        }
}

TEST(Extremes, MediaOfAnyDensityAreNumbers) {
    for (const double transmittance : {0.0, 0.5, 1.0})
        for (const double thickness : {0.0, 1.0, 1000.0}) {
            Pixel pixel = stock().pair("F11", "cc-white");
            pixel.medium = constant(transmittance);
            pixel.thickness = thickness;
            expect_numbers_at_any_light(pixel, "thickness " + std::to_string(thickness));
        }
    Pixel pixel = stock().pair("krypton", "cc-white");
    pixel.medium = stock().layer("glass-cobalt");
    pixel.thickness = 1000;
    expect_numbers_at_any_light(pixel, "cobalt");
}

TEST(Extremes, WallsUnderEightLampsAreNumbers) {
    Pixel pixel = stock().pair("NIST-LPS", "cc-blue");
    while (pixel.lamps.size() < 8)
        pixel.lamps.push_back(stock().lamp("A2800"));
    pixel.other = constant(1);
    expect_numbers_at_any_light(pixel, "walls");
}

// The guard of k': a lamp whose light the observer's y does not see is dark or bounded, never a division by
// nothing.
TEST(Extremes, ALampWithoutYIsANumber) {
    GridObserver blind;
    blind.x[60] = blind.z[3] = 1;
    Emission lamp;
    lamp.value.fill(1);
    Reflectance white;
    white.value.fill(1);
    const LitEmission<Float16> lit[]{{&lamp, Float16(1), {}}};
    const SpectralLayers<Float16> layers{&white};
    const auto floored = spectral<Float16>(lit, layers, blind);
    EXPECT_EQ(static_cast<double>(floored.x), kMostLight);
    EXPECT_EQ(static_cast<double>(floored.y), 0);
    EXPECT_EQ(static_cast<double>(packed<Float16>(lit, layers, blind).x), 0);
    blind.y[30] = 2 * kLeastK; // above the floor nothing of it is left
    blind.x[60] = kLeastK;
    EXPECT_EQ(static_cast<double>(spectral<Float16>(lit, layers, blind).x), 0.5);
    blind.y[30] = 0.5 * kLeastK;
    EXPECT_EQ(static_cast<double>(spectral<Float16>(lit, layers, blind).x), 1);
}

} // namespace
} // namespace metamer::test
