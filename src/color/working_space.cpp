#include "color/working_space.h"

#include <algorithm>
#include <string>

#include "base/error.h"
#include "base/names.h"
#include "color/colorimetry.h"

namespace metamer {

namespace {

constexpr Chromaticity kD65{0.3127, 0.3290}, kD50{0.3457, 0.3585}, kE{1.0 / 3, 1.0 / 3}, kC{0.31006, 0.31616};

// clang-format off
constexpr WorkingSpace kSpaces[] = {
    {"sRGB-D65",  "sRGB (IEC 61966-2-1)",            {0.64, 0.33},   {0.30, 0.60},   {0.15, 0.06},   kD65, "D65"},
    {"sRGB-D50",  "sRGB primaries, white D50",       {0.64, 0.33},   {0.30, 0.60},   {0.15, 0.06},   kD50, "D50"},
    {"sRGB-E",    "sRGB primaries, white E",         {0.64, 0.33},   {0.30, 0.60},   {0.15, 0.06},   kE,   "E"},
    {"CIE-RGB-E", "CIE 1931 RGB",                    {0.735, 0.265}, {0.274, 0.717}, {0.167, 0.009}, kE,   "E"},
    {"Adobe-D65", "Adobe RGB (1998)",                {0.64, 0.33},   {0.21, 0.71},   {0.15, 0.06},   kD65, "D65"},
    {"Apple-D50", "Apple RGB primaries, white D50",  {0.625, 0.34},  {0.28, 0.595},  {0.155, 0.07},  kD50, "D50"},
    {"Apple-D65", "Apple RGB",                       {0.625, 0.34},  {0.28, 0.595},  {0.155, 0.07},  kD65, "D65"},
    {"NTSC-C",    "NTSC 1953",                       {0.67, 0.33},   {0.21, 0.71},   {0.14, 0.08},   kC,   "C"},
    {"PAL-D65",   "PAL/SECAM (ITU-R BT.470)",        {0.64, 0.33},   {0.29, 0.60},   {0.15, 0.06},   kD65, "D65"},
};
// clang-format on

std::string bare(std::string_view name) {
    std::string out = lower_case(name);
    std::erase_if(out, [](char c) { return std::string_view(" -_()/").find(c) != std::string_view::npos; });
    return out;
}

} // namespace

std::span<const WorkingSpace> working_spaces() {
    return kSpaces;
}

const WorkingSpace* find_working_space(std::string_view name) {
    const auto found = std::find_if(std::begin(kSpaces), std::end(kSpaces),
                                    [&](const auto& s) { return bare(s.name) == bare(name); });
    return found == std::end(kSpaces) ? nullptr : found;
}

std::optional<Matrix3> xyz_from_rgb(const WorkingSpace& space) {
    const Xyz r = xyz_of(space.red), g = xyz_of(space.green), b = xyz_of(space.blue), w = xyz_of(space.white);
    const Matrix3 primaries{{{{r.x, g.x, b.x}, {r.y, g.y, b.y}, {r.z, g.z, b.z}}}};
    const auto back = inverse(primaries);
    if (!back)
        return std::nullopt;
    const auto scale = *back * std::array<double, 3>{w.x, w.y, w.z};
    return primaries * Matrix3::diagonal(scale[0], scale[1], scale[2]);
}

Matrix3 rgb_from_xyz(const WorkingSpace& space) {
    const auto forward = xyz_from_rgb(space);
    const auto back = forward ? inverse(*forward) : std::nullopt;
    if (!back)
        throw bad_input("use", "working space " + std::string(space.name), "its primaries lie on a line");
    return *back;
}

} // namespace metamer
