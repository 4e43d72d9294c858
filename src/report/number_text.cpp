#include "report/number_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string_view>

namespace metamer {

namespace {

constexpr std::array<std::string_view, 10> kSuperscripts{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};

std::string superscript(int exponent) {
    std::string out = exponent < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(exponent)))
        out += kSuperscripts[static_cast<std::size_t>(digit - '0')];
    return out;
}

std::string rounded(double value, std::chars_format format, int precision) {
    char text[400]; // fixed notation of the greatest double has 309 digits
    const auto end = std::to_chars(text, text + sizeof text, value, format, precision).ptr;
    return {text, end};
}

std::string without_zeros(std::string digits) {
    if (digits.find('.') != std::string::npos) {
        digits.erase(digits.find_last_not_of('0') + 1);
        if (digits.back() == '.')
            digits.pop_back();
    }
    return digits;
}

} // namespace

std::string short_number(double value, int digits) {
    if (value == 0)
        return "0";
    const std::string sign = value < 0 ? "\u2212" : "";
    // Rounding may carry into the next decade: the exponent is read off the rounded text.
    const std::string text = rounded(std::abs(value), std::chars_format::scientific, digits - 1);
    const std::size_t e = text.find('e');
    const int exponent = std::atoi(text.c_str() + e + 1);
    if (exponent >= -4 && exponent < 6) {
        const std::string plain = rounded(std::strtod(text.c_str(), nullptr), std::chars_format::fixed,
                                          std::max(0, digits - 1 - exponent));
        return sign + without_zeros(plain);
    }
    const std::string mantissa = without_zeros(text.substr(0, e));
    return sign + (mantissa == "1" ? "" : mantissa + "·") + "10" + superscript(exponent);
}

} // namespace metamer
