// The problem that taps are fitted to, and its solutions.
#include "methods/tap_weights.h"

#include <random>

#include <gtest/gtest.h>

#include "methods/tap_problem.h"
#include "methods/tap_scenes.h"

namespace metamer::test {
namespace {

// What the header says the error is, written out.
double expected_error(const TapProblem& problem, const std::vector<std::size_t>& taps, std::size_t column,
                      const std::vector<double>& weight) {
    double sum = 0;
    for (std::size_t r = 0; r < problem.rows; ++r) {
        const double visible = problem.visible[r * problem.columns + column];
        double off = -problem.target[r * problem.columns + column];
        for (std::size_t j = 0; j < taps.size(); ++j) {
            const double term = weight[j] * problem.spectrum[r][taps[j]];
            off += term;
            sum += std::pow(kTermError * term * visible, 2);
        }
        sum += std::pow(off * visible, 2);
    }
    return std::sqrt(sum);
}

// No weight can be moved from one tap to another to gain: with the sum given, that is the least error. A move
// below zero is none.
void expect_least(const TapProblem& problem, const std::vector<std::size_t>& taps, std::size_t column,
                  const ColumnWeights& best, bool negative) {
    EXPECT_NEAR(expected_error(problem, taps, column, best.weight), best.error, 1e-9 * best.error);
    for (std::size_t from = 0; from < taps.size(); ++from)
        for (std::size_t to = 0; to < taps.size(); ++to) {
            std::vector<double> moved = best.weight;
            const double step = negative ? 1e-5 : std::min(1e-5, moved[from]);
            moved[from] -= step;
            moved[to] += step;
            EXPECT_GE(expected_error(problem, taps, column, moved), best.error * (1 - 1e-9))
                << column << ": " << from << " to " << to;
        }
}

// Wavelengths at random, so that many weights want to be negative and some come back.
TEST(TapWeights, AreTheLeastError) {
    const Lamps lamps({lamp_of("F2"), lamp_of("krypton")});
    const std::vector<Spectrum> own = wedge(spectrum_of("liquid-permanganate"), perfect(), 9);
    const TapProblem problem = tap_problem(lamps.view, own);
    std::mt19937 random(7);
    int negative = 0;
    for (int n = 0; n < 40; ++n) {
        std::vector<std::size_t> taps;
        for (std::size_t j = 0; j < 7; ++j)
            taps.push_back(40 + 40 * j + random() % 40);
        for (std::size_t column = 0; column < problem.columns; ++column) {
            const ColumnWeights any = signed_weights(problem, taps, column);
            const ColumnWeights plain = nonnegative_weights(problem, taps, column);
            expect_least(problem, taps, column, any, true);
            expect_least(problem, taps, column, plain, false);
            EXPECT_LE(any.error, plain.error * (1 + 1e-9));
            double sum = 0;
            for (const double w : plain.weight) {
                EXPECT_GE(w, 0);
                sum += w;
            }
            EXPECT_NEAR(sum, problem.white[column], 1e-12);
            negative += *std::min_element(any.weight.begin(), any.weight.end()) < 0;
        }
    }
    EXPECT_GT(negative, 40) << "else this has tested nothing";
}

// Z of light where Z is 0: nothing to weigh.
TEST(TapWeights, AreZeroForAChannelWithoutLight) {
    const Lamps lamps({lines({{700, 1}, {710, 1}, {720, 1}})});
    const TapProblem problem = tap_problem(lamps.view, {});
    ASSERT_EQ(problem.white[2], 0);
    const std::vector<std::size_t> taps{340, 350};
    for (const double w : nonnegative_weights(problem, taps, 2).weight)
        EXPECT_EQ(w, 0);
    for (const double w : signed_weights(problem, taps, 2).weight)
        EXPECT_EQ(w, 0);
}

TEST(TapProblem, WeighsAnErrorAsTheEyeDoes) {
    // A thousandth of Y more, gray: as CIEDE2000 says it.
    const Lamps lamps({lamp_of("D65")});
    const std::vector<Spectrum> own{Spectrum(kReferenceGrid.count, 0.3)};
    const TapProblem problem = tap_problem(lamps.view, own);
    const Xyz gray = reference_xyz(lamps.lamp[0], own[0]);
    EXPECT_NEAR(problem.visible[1] * 1e-3, delta_e_2000(gray, {gray.x, gray.y + 1e-3, gray.z}), 0.02);
    EXPECT_NEAR(problem.target[1], 0.3, 1e-12);
    EXPECT_NEAR(problem.white[1], 1, 1e-12);
}

} // namespace
} // namespace metamer::test
