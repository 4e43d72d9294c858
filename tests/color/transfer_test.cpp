#include "color/transfer.h"

#include <bit>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>

#include "base/float16.h"

namespace metamer {
namespace {

// IEC 61966-2-1: the published pairs of the curve.
TEST(Transfer, SrgbKnowsItsFixedPoints) {
    EXPECT_EQ(encode(Transfer::srgb, 0.0), 0);
    EXPECT_NEAR(encode(Transfer::srgb, 1.0), 1, 1e-15);
    EXPECT_NEAR(encode(Transfer::srgb, 0.0031308), 0.04045, 1e-5);
    EXPECT_NEAR(encode(Transfer::srgb, 0.21404114), 0.5, 1e-7);
}

TEST(Transfer, BranchesMeet) {
    const double below = std::nextafter(0.0031308, 0), above = std::nextafter(0.0031308, 1);
    EXPECT_NEAR(encode(Transfer::srgb, below), encode(Transfer::srgb, above), 1e-7);
}

TEST(Transfer, DecodesEveryCodeBackToItself) {
    for (Transfer transfer : {Transfer::srgb, Transfer::none})
        for (int code = 0; code < 256; ++code) {
            const auto c = static_cast<std::uint8_t>(code);
            EXPECT_EQ(encode_rgb8(transfer, decode_rgb8(transfer, {c, c, c})), (EncodedRgb8{c, c, c}));
        }
}

TEST(Transfer, ClampsFirst) {
    EXPECT_EQ(encode_rgb8(Transfer::srgb, LinearRgb{-0.2, 1.7, 0.5}), (EncodedRgb8{0, 255, 188}));
    EXPECT_EQ(encode_rgb8(Transfer::none, LinearRgb{-1, 2, 0.5}), (EncodedRgb8{0, 255, 128}));
    const double inf = std::numeric_limits<double>::infinity();
    EXPECT_EQ(encode_rgb8(Transfer::srgb, LinearRgb{inf, -inf, 0}), (EncodedRgb8{255, 0, 0}));
}

TEST(Transfer, FloatTwinIsTheSameStep) {
    for (int i = 0; i <= 4096; ++i) {
        const double v = i / 4096.0;
        const auto f = static_cast<float>(v);
        const auto a = encode_rgb8(Transfer::srgb, LinearRgb{v, v, v});
        const auto b = encode_rgb8(Transfer::srgb, BasicLinearRgb<float>{f, f, f});
        EXPECT_LE(std::abs(a.r - b.r), 1) << v;
    }
}

// Every half between 0 and 1 is tried, by its bits; the exact curve is taken at the very same light.
template <class T>
double worst_steps_of_polynomial() {
    double worst = 0;
    for (int bits = 0; bits <= 0x3c00; ++bits) {
        const auto half = std::bit_cast<Float16>(static_cast<std::uint16_t>(bits));
        const double v = static_cast<double>(half);
        const auto code = static_cast<double>(encode_by_polynomial(static_cast<T>(half)));
        worst = std::max(worst, 255 * std::abs(code - encode(Transfer::srgb, v)));
    }
    return worst;
}

TEST(Transfer, PolynomialIsWithinHalfAStepOfTheCurve) {
    EXPECT_LE(worst_steps_of_polynomial<double>(), 0.24);
    EXPECT_LE(worst_steps_of_polynomial<float>(), 0.24);
    EXPECT_LE(worst_steps_of_polynomial<Float16>(), 0.5);
}

TEST(Transfer, PolynomialKeepsBlackWhiteAndOrder) {
    EXPECT_EQ(encode_by_polynomial(0.0), 0);
    EXPECT_NEAR(encode_by_polynomial(1.0), 1, 0.2 / 255);
    EXPECT_EQ(encode_by_polynomial(-1.0), 0);
    EXPECT_EQ(encode_by_polynomial(7.0), encode_by_polynomial(1.0));
    for (int i = 1; i <= 65536; ++i)
        EXPECT_GE(encode_by_polynomial(i / 65536.0), encode_by_polynomial((i - 1) / 65536.0)) << i;
}

} // namespace
} // namespace metamer
