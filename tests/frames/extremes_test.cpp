// Whatever an exhibit may ask for, no value on the way to a pixel is ever anything but a number, in half
// precision either.
#include <gtest/gtest.h>

#include "frames/extremes.h"
#include "frames/stage.h"

namespace metamer {
namespace {

/// A matrix of a display's own, of numbers of this size: light of one color minus light of another.
Matrix3 own_matrix(double m) {
    return {{{{m, -m, 1}, {-m, m, m}, {m, m, -m}}}};
}

struct Case {
    Method method;
    bool mediump;
};

class Extremes : public testing::TestWithParam<Case> {
protected:
    void expect_numbers(const Subject& subject, const std::string& what) {
        const FragmentEdits edits{.mediump = GetParam().mediump, .watched = true, .others = {}};
        const int bad = not_numbers(stage_.draw(subject.exhibit, subject.draws(), edits));
        EXPECT_EQ(bad, 0) << what << ", strength " << subject.exhibit.lamps[0].strength;
    }

    void expect_numbers_at_any_strength(Subject& subject, const std::string& what) {
        for (const Strengths& strengths : kStrengths) {
            set_strengths(subject.exhibit, strengths);
            expect_numbers(subject, what);
        }
    }

    Stage stage_;
};

TEST_P(Extremes, ThingsUnderLampsAnywhere) {
    for (const char* lamps : {kOneLamp, kVioletLamp, kTwoLamps}) {
        Subject subject(Surface::plain, GetParam().method, lamps);
        subject.object().specular = 1;
        subject.object().shininess = 1000;
        for (const MaterialSetting& material :
             {subject.exhibit.objects[0].material, subject.exhibit.objects[1].material})
            for (const Place& place : kPlaces) {
                subject.object().material = material;
                put(subject.exhibit, place);
                set_strengths(subject.exhibit, kBright);
                expect_numbers(subject, lamps + material.material.name + ' ' + place.name);
            }
        expect_numbers_at_any_strength(subject, lamps);
    }
}

TEST_P(Extremes, SurfacesThatMixMaterials) {
    if (!GetParam().mediump)
        return; // what is a number in half precision is one in full
    for (const Surface surface : {Surface::maps, Surface::bounce}) {
        Subject subject(surface, GetParam().method, kTwoLamps);
        for (const Strengths& strengths : {kBright, kMixed}) {
            set_strengths(subject.exhibit, strengths);
            expect_numbers(subject, "surface " + std::to_string(static_cast<int>(surface)));
        }
    }
}

TEST_P(Extremes, RampsKeptInHue) {
    Subject subject(Surface::ramp, GetParam().method, kTwoLamps);
    subject.exhibit.display.gamut = Gamut::keep_hue;
    expect_numbers_at_any_strength(subject, "sRGB");
    // Times the brightest light, 15 is still a number in half precision.
    subject.exhibit.display.matrix = own_matrix(GetParam().mediump ? 15 : 100);
    expect_numbers_at_any_strength(subject, "own matrix");
}

TEST_P(Extremes, MediaOfAnyThickness) {
    if (!can_draw(GetParam().method, true))
        return;
    Subject subject(Surface::medium, GetParam().method, kTwoLamps);
    for (const double thickness : {0.0, 1.0, 1000.0})
        for (const Strengths& strengths : {kBright, kMixed}) {
            subject.object().thickness = thickness;
            set_strengths(subject.exhibit, strengths);
            expect_numbers(subject, "thickness " + std::to_string(thickness));
        }
}

// The program as it ships, on white, parallel light: overflow is white, no light is black.
TEST_P(Extremes, LightWithoutBoundsIsWhiteAndNoneIsBlack) {
    Subject subject(Surface::plain, GetParam().method, "[lamp.1]\nspectrum = E\ndirection = 0 0 -1\n");
    const FragmentEdits edits{.mediump = GetParam().mediump, .watched = false, .others = {}};
    for (const double strength : {0.0, 1e4, 1e6}) {
        if (GetParam().method == Method::reduced && strength > 1e4)
            break; // its taps are bounded one by one and keep no ratio
        set_strengths(subject.exhibit, {strength});
        const auto level = static_cast<std::uint8_t>(strength > 0 ? 255 : 0);
        const auto pixels = stage_.draw(subject.exhibit, subject.draws(), edits);
        EXPECT_EQ(std::count(pixels.begin(), pixels.end(), EncodedRgb8{level, level, level}),
                  kSidePx * kSidePx)
            << "strength " << strength;
    }
}

std::vector<Case> cases() {
    std::vector<Case> all;
    for (const MethodInfo& info : kMethods)
        for (const bool mediump : {false, true})
            all.push_back({info.method, mediump});
    return all;
}

std::string case_name(const testing::TestParamInfo<Case>& info) {
    return std::string(method_name(info.param.method)) + (info.param.mediump ? "_mediump" : "_highp");
}

INSTANTIATE_TEST_SUITE_P(By, Extremes, testing::ValuesIn(cases()), case_name);

} // namespace
} // namespace metamer
