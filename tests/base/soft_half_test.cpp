#include "base/soft_half.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace metamer {
namespace {

SoftHalf half_of(int bits) {
    return std::bit_cast<SoftHalf>(static_cast<std::uint16_t>(bits));
}

int bits_of(SoftHalf value) {
    return std::bit_cast<std::uint16_t>(value);
}

// IEEE 754-2019 section 3.4: sign, exponent biased by 15, ten digits behind the point.
double by_definition(int bits) {
    const int exponent = bits >> 10 & 31, digits = bits & 1023;
    const double size = exponent == 0 ? std::ldexp(digits, -24) : std::ldexp(1024 + digits, exponent - 25);
    return bits >= 0x8000 ? -size : size;
}

constexpr int kInfinity = 0x7c00, kGreatest = 0x7bff;

TEST(SoftHalf, EveryNumberIsWhatItsBitsSay) {
    for (int bits = 0; bits < kInfinity; ++bits) {
        EXPECT_EQ(static_cast<double>(half_of(bits)), by_definition(bits)) << bits;
        EXPECT_EQ(static_cast<double>(half_of(bits | 0x8000)), by_definition(bits | 0x8000)) << bits;
        EXPECT_EQ(bits_of(SoftHalf(by_definition(bits))), bits);
        EXPECT_EQ(bits_of(SoftHalf(by_definition(bits | 0x8000))), bits | 0x8000);
    }
}

// Between two neighbors: the nearer, and of a tie the even one, however little is missing or over.
TEST(SoftHalf, RoundsToNearestTiesToEven) {
    for (int bits = 0; bits < kGreatest; ++bits) {
        const double middle = (by_definition(bits) + by_definition(bits + 1)) / 2;
        EXPECT_EQ(bits_of(SoftHalf(middle)), bits % 2 == 0 ? bits : bits + 1) << bits;
        EXPECT_EQ(bits_of(SoftHalf(std::nextafter(middle, 0))), bits);
        EXPECT_EQ(bits_of(SoftHalf(std::nextafter(middle, 1e9))), bits + 1);
    }
}

TEST(SoftHalf, EndsInInfinity) {
    EXPECT_EQ(bits_of(SoftHalf(65519.999)), kGreatest);
    EXPECT_EQ(bits_of(SoftHalf(65520)), kInfinity);
    EXPECT_EQ(bits_of(SoftHalf(-1e300)), kInfinity | 0x8000);
    EXPECT_EQ(static_cast<float>(half_of(kInfinity)), std::numeric_limits<float>::infinity());
    EXPECT_TRUE(std::isnan(static_cast<float>(SoftHalf(std::nan("")))));
    EXPECT_EQ(bits_of(SoftHalf(1e-300)), 0);
    const SoftHalf undefined(std::nan(""));
    EXPECT_FALSE(undefined == undefined);
    EXPECT_FALSE(undefined < undefined || undefined >= undefined);
}

// Sums, differences and products of two halves are exact in double; a quotient is never near a middle there.
TEST(SoftHalf, OperationsAreRoundedOnce) {
    std::mt19937 rng(1931); // NOLINT: the same on every run
    std::uniform_int_distribution<int> any(0, 0xffff);
    for (int i = 0; i < 200000; ++i) {
        const SoftHalf a = half_of(any(rng)), b = half_of(any(rng));
        const auto x = static_cast<double>(a), y = static_cast<double>(b);
        if (!std::isfinite(x) || !std::isfinite(y) || y == 0)
            continue;
        EXPECT_EQ(bits_of(a + b), bits_of(SoftHalf(x + y))) << x << ' ' << y;
        EXPECT_EQ(bits_of(a - b), bits_of(SoftHalf(x - y))) << x << ' ' << y;
        EXPECT_EQ(bits_of(a * b), bits_of(SoftHalf(x * y))) << x << ' ' << y;
        EXPECT_EQ(bits_of(a / b), bits_of(SoftHalf(x / y))) << x << ' ' << y;
        EXPECT_EQ(bits_of(-a), bits_of(a) ^ 0x8000);
        EXPECT_EQ(a < b, x < y);
        EXPECT_EQ(a == b, x == y);
    }
}

#ifdef __x86_64__
// The compiler's own, where it has one.
TEST(SoftHalf, IsTheCompilers) {
    __extension__ typedef _Float16 Theirs;
    std::mt19937_64 rng(1931); // NOLINT: the same on every run
    for (int i = 0; i < 200000; ++i) {
        const auto value = std::bit_cast<double>((rng() & 0x803fffffffffffff) + (std::uint64_t{0x3e0} << 52));
        EXPECT_EQ(bits_of(SoftHalf(value)), std::bit_cast<std::uint16_t>(static_cast<Theirs>(value)))
            << value;
    }
}
#endif

} // namespace
} // namespace metamer
