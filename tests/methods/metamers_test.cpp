#include "methods/metamers.h"

#include <cmath>
#include <gmock/gmock.h>
#include <random>

#include "base/error.h"
#include "color/difference.h"
#include "color/observer.h"
#include "color/resample.h"
#include "methods/lamp_colors.h"
#include "spectra/library.h"

namespace metamer {
namespace {

ReferenceLamp lamp(const std::string& name) {
    return reference_lamp(find_lamp(name).spectrum);
}

Xyz gray(const ReferenceLamp& lamp, double share) {
    return share * reference_white(lamp);
}

double apart(const Xyz& a, const Xyz& b) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

Xyz under(const ReferenceLamp& lamp, const MaterialSpectrum& material) {
    return reference_xyz(lamp, resample(material, kReferenceGrid));
}

// What a pair promises, seen with the reference's eyes.
void expect_pair(const MetamericPair& pair, const ReferenceLamp& matching, const ReferenceLamp& parting,
                 const Xyz& xyz, const std::string& what) {
    EXPECT_LT(apart(under(matching, pair.a), xyz), 1e-9) << what;
    EXPECT_LT(apart(under(matching, pair.b), xyz), 1e-9) << what;
    EXPECT_LT(apart(pair.under_matching, xyz), 1e-9) << what;
    EXPECT_LT(apart(under(parting, pair.a), pair.a_under_parting), 1e-12) << what;
    EXPECT_LT(apart(under(parting, pair.b), pair.b_under_parting), 1e-12) << what;
    EXPECT_EQ(delta_e_2000(pair.a_under_parting, pair.b_under_parting), pair.delta_e_2000) << what;
    for (const MaterialSpectrum& m : {pair.a, pair.b}) {
        ASSERT_EQ(m.curve.value.size(), kReferenceGrid.count);
        for (const double r : m.curve.value) {
            ASSERT_GE(r, 0) << what;
            ASSERT_LE(r, 1) << what;
        }
    }
}

TEST(MetamericPairs, MatchUnderOneLampAndPartUnderTheOther) {
    for (const char* matching : {"A2800", "F11", "krypton", "line:589"})
        for (const char* parting : {"D65", "krypton"}) {
            const ReferenceLamp m = lamp(matching), p = lamp(parting);
            const MetamericPair pair = metameric_pair(m, p, gray(m, 0.3));
            expect_pair(pair, m, p, gray(m, 0.3), std::string(matching) + ' ' + parting);
            if (m.power != p.power) {
                EXPECT_GT(pair.delta_e_2000, 1) << matching << ' ' << parting;
            }
        }
}

TEST(MetamericPairs, ColorsToo) {
    const ReferenceLamp d65 = lamp("D65"), a = lamp("A2800");
    for (const char* name : {"cc-red", "cc-blue", "cc-yellow", "cc-dark-skin", "crayon-violet"}) {
        const Xyz xyz = under(d65, find_material(name).spectrum);
        const MetamericPair pair = metameric_pair(d65, a, xyz);
        expect_pair(pair, d65, a, xyz, name);
        EXPECT_GT(pair.delta_e_2000, 10) << name;
    }
}

TEST(MetamericPairs, EqualLampsPartNothing) {
    for (const char* name : {"E", "D65", "F11", "line:589"}) {
        const ReferenceLamp l = lamp(name);
        const MetamericPair pair = metameric_pair(l, l, gray(l, 0.5));
        expect_pair(pair, l, l, gray(l, 0.5), name);
        EXPECT_LT(pair.delta_e_2000, 1e-6) << name;
    }
}

TEST(MetamericPairs, WhiteAndBlackHaveOneReflectanceEach) {
    const ReferenceLamp d65 = lamp("D65"), f11 = lamp("F11");
    EXPECT_THAT(metameric_pair(d65, f11, gray(d65, 1)).b.curve.value,
                testing::Each(testing::DoubleNear(1, 1e-3)));
    EXPECT_LT(metameric_pair(d65, f11, gray(d65, 1)).delta_e_2000, 1e-6);
    EXPECT_THAT(metameric_pair(d65, f11, {}).a.curve.value, testing::Each(testing::DoubleNear(0, 1e-3)));
}

// XYZ under `parting` of what goes furthest there in many directions at random, of a gray under `matching`.
std::vector<Xyz> ends(const ReferenceLamp& matching, const ReferenceLamp& parting, double share) {
    const Xyz target = gray(matching, share);
    const ColorProgram program{lamp_colors(matching), {target.x, target.y, target.z}};
    ColorExtremes extremes(program);
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    std::vector<Xyz> out;
    for (int i = 0; i < 400; ++i) {
        const Triple direction{normal(random), normal(random), normal(random)};
        std::vector<double> weight;
        for (const Triple& c : lamp_colors(parting))
            weight.push_back(dot(direction, c));
        out.push_back(reference_xyz(parting, extremes.greatest(weight)->reflectance));
    }
    return out;
}

// The search's own shortcoming: it looks in so many directions and climbs from the best.
TEST(MetamericPairs, NoTwoOfManyEndsPartMore) {
    for (const auto& [matching, parting] : {std::pair("D65", "A2800"), std::pair("F11", "D65")}) {
        const ReferenceLamp m = lamp(matching), p = lamp(parting);
        const std::vector<Xyz> all = ends(m, p, 0.3);
        double most = 0;
        for (const Xyz& a : all)
            for (const Xyz& b : all)
                most = std::max(most, delta_e_2000(a, b));
        const double found = metameric_pair(m, p, gray(m, 0.3)).delta_e_2000;
        EXPECT_GE(found, 0.98 * most) << matching << ' ' << parting;
        EXPECT_LE(found, 1.1 * most) << matching << ' ' << parting;
    }
}

// A closed form: one wavelength of a gray under daylight may be all or nothing, its neighbors make up for it.
TEST(MetamericPairs, ALampOfOneLineSeesAllOrNothing) {
    const ReferenceLamp d65 = lamp("D65"), line = lamp("line:589");
    const MetamericPair pair = metameric_pair(d65, line, gray(d65, 0.3));
    const auto [dark, bright] = std::minmax(pair.a_under_parting.y, pair.b_under_parting.y);
    EXPECT_NEAR(dark, 0, 1e-9);
    EXPECT_NEAR(bright, 1, 1e-9);
    EXPECT_NEAR(pair.delta_e_2000, delta_e_2000(Xyz{}, reference_white(line)), 1e-6);
}

TEST(MetamericPairs, AreTheSameEveryTime) {
    const ReferenceLamp d65 = lamp("D65"), f11 = lamp("F11");
    const MetamericPair one = metameric_pair(d65, f11, gray(d65, 0.3)),
                        two = metameric_pair(d65, f11, gray(d65, 0.3));
    EXPECT_EQ(one.a.curve.value, two.a.curve.value);
    EXPECT_EQ(one.b.curve.value, two.b.curve.value);
}

// Between the lines nobody sees what a reflectance does: no wild steps there.
TEST(MetamericPairs, HoldTheirValuesInTheDark) {
    const ReferenceLamp red = lamp("line:620"), green = lamp("line:530");
    const auto& r = metameric_pair(red, green, gray(red, 0.4)).a.curve.value;
    const auto at = [&](double nm) { return r[static_cast<std::size_t>(nm - kReferenceGrid.first_nm)]; };
    EXPECT_EQ(at(360), at(530));
    EXPECT_EQ(at(580), at(530));
    EXPECT_EQ(at(830), at(620));
    EXPECT_NEAR(at(620), 0.4, 1e-9);
}

std::string refusal(const Xyz& xyz) {
    try {
        metameric_pair(lamp("D65"), lamp("A2800"), xyz);
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Exit::bad_input);
        return error.what();
    }
    return "no error";
}

TEST(MetamericPairs, RefuseWhatNoReflectanceHas) {
    EXPECT_EQ(
        refusal({0.5, 0.25, 0.125}),
        "cannot find a metameric pair: no reflectance of 0 .. 1 has X Y Z = 0.5 0.25 0.125 under the lamp "
        "where they are to match");
    EXPECT_NE(refusal({1, 1.5, 1}), "no error") << "brighter than white";
    EXPECT_NE(refusal({0.3, -0.1, 0.3}), "no error");
    EXPECT_NE(refusal({NAN, 0.3, 0.3}), "no error");
}

} // namespace
} // namespace metamer
