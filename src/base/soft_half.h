// Half precision in software, for compilers without _Float16: gcc 12 has it in C++ on x86 alone.
#pragma once

#include <bit>
#include <compare>
#include <concepts>
#include <cstdint>

namespace metamer {

/// IEEE 754 binary16, its bits in memory. Each operation is computed in float and rounded to nearest, ties to
/// even; float has more than twice half's digits plus two, so that comes out as if rounded once.
class SoftHalf {
public:
    SoftHalf() = default;
    template <class T>
    requires std::integral<T> || std::floating_point<T>
    explicit SoftHalf(T value) : bits_(rounded(static_cast<double>(value))) {}

    template <class T>
    requires std::integral<T> || std::floating_point<T>
    explicit operator T() const { return static_cast<T>(wide()); }

    friend SoftHalf operator+(SoftHalf a, SoftHalf b) { return SoftHalf(a.wide() + b.wide()); }
    friend SoftHalf operator-(SoftHalf a, SoftHalf b) { return SoftHalf(a.wide() - b.wide()); }
    friend SoftHalf operator*(SoftHalf a, SoftHalf b) { return SoftHalf(a.wide() * b.wide()); }
    friend SoftHalf operator/(SoftHalf a, SoftHalf b) { return SoftHalf(a.wide() / b.wide()); }
    SoftHalf operator-() const { return SoftHalf(-wide()); }
    SoftHalf& operator+=(SoftHalf other) { return *this = *this + other; }
    SoftHalf& operator-=(SoftHalf other) { return *this = *this - other; }
    SoftHalf& operator*=(SoftHalf other) { return *this = *this * other; }
    SoftHalf& operator/=(SoftHalf other) { return *this = *this / other; }
    friend bool operator==(SoftHalf a, SoftHalf b) { return a.wide() == b.wide(); }
    friend std::partial_ordering operator<=>(SoftHalf a, SoftHalf b) { return a.wide() <=> b.wide(); }

private:
    static constexpr std::uint16_t kInfinity = 0x7c00, kNan = 0x7e00;

    static double power_of_two(int exponent) {
        return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
    }

    static std::uint16_t rounded(double value) {
        const auto wide = std::bit_cast<std::uint64_t>(value);
        const auto sign = static_cast<unsigned>(wide >> 63) << 15;
        const double size = std::bit_cast<double>(wide & ~(std::uint64_t{1} << 63));
        if (!(size < 65520)) // half a step above the greatest half
            return static_cast<std::uint16_t>(sign | (value != value ? kNan : kInfinity));
        const int own = static_cast<int>(wide >> 52 & 0x7ff) - 1023;
        const int exponent = own < -14 ? -14 : own; // below, steps stay those of the least normal half
        // In steps of the result's last place; adding 2^52 leaves no digits behind the point.
        constexpr double kWhole = 4503599627370496.0;
        const double steps = size * power_of_two(10 - exponent) + kWhole - kWhole;
        return static_cast<std::uint16_t>(
            sign | static_cast<unsigned>((exponent + 14) * 1024 + static_cast<int>(steps)));
    }

    float wide() const {
        const std::uint32_t sign = static_cast<std::uint32_t>(bits_ & 0x8000) << 16, size = bits_ & 0x7fff;
        if (size >= kInfinity)
            return std::bit_cast<float>(sign | 0x7f800000 | (size & 0x3ff) << 13);
        // The exponents' biases part by 112; multiplying makes numbers below the least normal half right too.
        const float shifted = std::bit_cast<float>(size << 13) * 0x1p112F;
        return std::bit_cast<float>(sign | std::bit_cast<std::uint32_t>(shifted));
    }

    std::uint16_t bits_ = 0;
};

} // namespace metamer
