#include "methods/color_program.h"

#include <cmath>
#include <gmock/gmock.h>

#include "methods/lamp_colors.h"
#include "spectra/library.h"

namespace metamer {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

double sum_of(std::span<const double> weight, const std::vector<double>& r) {
    double sum = 0;
    for (std::size_t i = 0; i < r.size(); ++i)
        sum += weight[i] * r[i];
    return sum;
}

// What the reflectance misses of the target.
double missed(const ColorProgram& program, const std::vector<double>& r) {
    Triple rest = program.target;
    for (std::size_t i = 0; i < r.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            rest[k] -= r[i] * program.color[i][k];
    return std::max({std::abs(rest[0]), std::abs(rest[1]), std::abs(rest[2])});
}

// Three pure colors and their mixture: one unknown is left, how much of the mixture.
ColorProgram four(double target) {
    return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}, {target, target, target}};
}

std::vector<double> extreme_of_four(double target, double weight_of_mixture) {
    const ColorProgram program = four(target);
    ColorExtremes extremes(program);
    return extremes.greatest(std::vector<double>{1, 1, 1, weight_of_mixture})->reflectance;
}

TEST(ColorProgram, AClosedForm) {
    const auto are = [](double pure, double mixture) {
        return ElementsAre(DoubleNear(pure, 1e-12), DoubleNear(pure, 1e-12), DoubleNear(pure, 1e-12),
                           DoubleNear(mixture, 1e-12));
    };
    EXPECT_THAT(extreme_of_four(0.4, 2.9), are(0.4, 0)) << "dearer than its parts";
    EXPECT_THAT(extreme_of_four(0.4, 3.1), are(0, 0.4)) << "worth more than its parts";
    EXPECT_THAT(extreme_of_four(1.4, 2.9), are(1, 0.4)) << "as little of it as will do";
    EXPECT_THAT(extreme_of_four(1.4, 3.1), are(0.4, 1)) << "as much of it as there is";
    EXPECT_THAT(extreme_of_four(2, -5), are(1, 1)) << "white has one reflectance";
    EXPECT_THAT(extreme_of_four(0, 5), are(0, 0)) << "black has one reflectance";
}

TEST(ColorProgram, NothingBeyondTheSolid) {
    const std::vector<double> weight{1, 2, 3, 4};
    for (const Triple& target :
         {Triple{2.1, 2, 2}, Triple{-0.1, 0.5, 0.5}, Triple{1.5, 0.4, 0.4}, Triple{NAN, 0, 0}}) {
        ColorProgram program = four(0);
        program.target = target;
        ColorExtremes extremes(program);
        EXPECT_FALSE(extremes.greatest(weight)) << target[0];
    }
}

// A program as pairs have it: the color of a gray under one lamp, weights by directions under another.
struct LampProgram {
    ColorProgram program;
    std::vector<double> weight;
};

std::vector<Triple> colors(const std::string& lamp_name) {
    return lamp_colors(reference_lamp(find_lamp(lamp_name).spectrum));
}

LampProgram lamps(const std::string& matching, const std::string& parting, double gray,
                  const Triple& direction) {
    LampProgram out{{colors(matching), {}}, {}};
    for (const Triple& c : out.program.color)
        for (std::size_t k = 0; k < 3; ++k)
            out.program.target[k] += gray * c[k];
    for (const Triple& c : colors(parting))
        out.weight.push_back(dot(direction, c));
    return out;
}

const Triple kDirections[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 2, -0.5}, {0.3, -1, 0.2}};

// Weak duality: no reflectance of that color has a greater sum than this, at any price.
double dual_bound(const ColorProgram& program, std::span<const double> weight, const Triple& price) {
    double bound = dot(price, program.target);
    for (std::size_t i = 0; i < program.color.size(); ++i)
        bound += std::max(0.0, weight[i] - dot(price, program.color[i]));
    return bound;
}

// Where both meet, both are at their end.
TEST(ColorProgram, TheDualProvesTheGreatest) {
    for (const char* matching : {"D65", "A2800", "F11", "krypton", "line:589"})
        for (const char* parting : {"E", "F11", "krypton", "line:589"})
            for (const Triple& direction : kDirections) {
                const LampProgram p = lamps(matching, parting, 0.3, direction);
                ColorExtremes extremes(p.program);
                const auto found = extremes.greatest(p.weight);
                ASSERT_TRUE(found) << matching << parting;
                const double greatest = sum_of(p.weight, found->reflectance);
                EXPECT_NEAR(dual_bound(p.program, p.weight, found->price), greatest, 1e-8)
                    << matching << parting;
                EXPECT_LT(missed(p.program, found->reflectance), 1e-11) << matching << parting;
                EXPECT_GT(dual_bound(p.program, p.weight, {1, 1, 1}), greatest + 1e-3)
                    << "another price proves less";
                int between = 0;
                for (const double r : found->reflectance) {
                    ASSERT_GE(r, 0);
                    ASSERT_LE(r, 1);
                    between += r > 0 && r < 1;
                }
                EXPECT_LE(between, 3) << matching << parting;
            }
}

TEST(ColorProgram, WhereItStartsFromDoesNotMatter) {
    const LampProgram first = lamps("D65", "F11", 0.4, kDirections[0]);
    ColorExtremes kept(first.program);
    for (const Triple& direction : kDirections) {
        const LampProgram p = lamps("D65", "F11", 0.4, direction);
        ColorExtremes fresh(p.program);
        EXPECT_NEAR(sum_of(p.weight, kept.greatest(p.weight)->reflectance),
                    sum_of(p.weight, fresh.greatest(p.weight)->reflectance), 1e-8);
    }
}

} // namespace
} // namespace metamer
