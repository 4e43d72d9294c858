#include "spectra/srgb_reflectance.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include "color/colorimetry.h"
#include "color/resample.h"
#include "color/transfer.h"
#include "color/working_space.h"
#include "spectra/lhtss.h"
#include "spectra/tables.h"

namespace metamer {

namespace {

const WorkingSpace& srgb() {
    static const WorkingSpace& space = *find_working_space("sRGB-D65");
    return space;
}

const Matrix3& xyz_from_srgb() {
    static const Matrix3 matrix = *xyz_from_rgb(srgb());
    return matrix;
}

using Offset = std::array<int, 3>;

// All of {-1, 0, 1}^3: none first, then those that lead most toward gray, down where the code is high.
std::vector<Offset> offsets_for(const EncodedRgb8& code) {
    std::vector<Offset> offsets;
    for (int r = -1; r <= 1; ++r)
        for (int g = -1; g <= 1; ++g)
            for (int b = -1; b <= 1; ++b)
                offsets.push_back({r, g, b});
    const auto rank = [&](const Offset& o) {
        const bool some = o != Offset{};
        return std::pair{some, o[0] * (code.r - 128) + o[1] * (code.g - 128) + o[2] * (code.b - 128)};
    };
    std::stable_sort(offsets.begin(), offsets.end(),
                     [&](const Offset& a, const Offset& b) { return rank(a) < rank(b); });
    return offsets;
}

Xyz color_beside(const EncodedRgb8& code, const Offset& offset) {
    constexpr double kInside = 0.4; // of the half step that still rounds to the code
    const auto light = [&](int channel, int off) {
        return decode(Transfer::srgb, (channel + kInside * off) / 255);
    };
    return to_xyz(xyz_from_srgb(),
                  {light(code.r, offset[0]), light(code.g, offset[1]), light(code.b, offset[2])});
}

} // namespace

std::optional<EncodedRgb8> parse_srgb_code(std::string_view text) {
    unsigned value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
    if (text.size() != 6 || error != std::errc() || end != text.data() + text.size())
        return std::nullopt;
    const auto byte = [&](unsigned shift) { return static_cast<std::uint8_t>(value >> shift & 0xFFu); };
    return EncodedRgb8{byte(16), byte(8), byte(0)};
}

std::string srgb_code_text(const EncodedRgb8& code) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string text;
    for (const std::uint8_t byte : {code.r, code.g, code.b}) {
        text += digits[byte >> 4];
        text += digits[byte & 15];
    }
    return text;
}

EncodedRgb8 srgb_code_under_d65(const MaterialSpectrum& material) {
    static const ReferenceLamp d65 = reference_lamp({column(cie_illuminants(), "D65"), {}});
    static const Matrix3 srgb_from_xyz = rgb_from_xyz(srgb());
    const Xyz c = reference_xyz(d65, resample(material, kReferenceGrid));
    return encode_rgb8(Transfer::srgb, to_linear_rgb(srgb_from_xyz, c));
}

std::optional<MaterialSpectrum> srgb_reflectance(const EncodedRgb8& code) {
    for (const Offset& offset : offsets_for(code)) {
        auto material = lhtss(color_beside(code, offset));
        if (material && srgb_code_under_d65(*material) == code)
            return material;
    }
    return std::nullopt;
}

} // namespace metamer
