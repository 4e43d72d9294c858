#include "color/transfer.h"

#include <gtest/gtest.h>
#include <limits>

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

} // namespace
} // namespace metamer
