#include "color/working_space.h"

#include <cmath>
#include <gtest/gtest.h>

#include "base/error.h"

namespace metamer {
namespace {

// XYZ to RGB as they follow from primaries and white (sRGB: IEC 61966-2-1 by more digits; CIE RGB and NTSC as
// Lindbloom prints them; D65 spaces of Lindbloom take XYZ 0.95047 1 1.08883 for white, which moves
// coefficients by up to 5e-4).
struct Published {
    const char* space;
    double m[3][3];
    double tolerance;
};
constexpr Published kPublished[] = {
    {"sRGB-D65",
     {{3.2409699419, -1.5373831776, -0.4986107603},
      {-0.9692436363, 1.8759675015, 0.0415550574},
      {0.0556300797, -0.2039769589, 1.0569715142}},
     1e-9},
    {"sRGB-D50",
     {{2.75484, -1.306783, -0.4238215}, {-0.993467, 1.922852, 0.042594}, {0.077074, -0.282603, 1.464398}},
     1e-6},
    {"sRGB-E",
     {{2.6896551724, -1.2758620690, -0.4137931034},
      {-1.0221081721, 1.9782866167, 0.0438215555},
      {0.0612244898, -0.2244897959, 1.1632653061}},
     1e-9},
    {"CIE-RGB-E",
     {{2.3706743, -0.9000405, -0.4706338},
      {-0.5138850, 1.4253036, 0.0885814},
      {0.0052982, -0.0146949, 1.0093968}},
     1e-6},
    {"Adobe-D65",
     {{2.0413690, -0.5649464, -0.3446944},
      {-0.9692660, 1.8760108, 0.0415560},
      {0.0134474, -0.1183897, 1.0154096}},
     5e-4},
    {"Apple-D65",
     {{2.9515373, -1.2894116, -0.4738445},
      {-1.0851093, 1.9908566, 0.0372026},
      {0.0854934, -0.2694964, 1.0912975}},
     5e-4},
    {"Apple-D50",
     {{2.5318310436, -1.1060582702, -0.4064641714},
      {-1.1127199605, 2.0415139824, 0.0381491808},
      {0.1198428029, -0.3777743719, 1.5297581317}},
     1e-9},
    {"NTSC-C",
     {{1.9099961, -0.5324542, -0.2882091},
      {-0.9846663, 1.9991710, -0.0283082},
      {0.0583056, -0.1183781, 0.8975535}},
     1e-4},
    {"PAL-D65",
     {{3.0628971, -1.3931791, -0.4757517},
      {-0.9692660, 1.8760108, 0.0415560},
      {0.0678775, -0.2288548, 1.0693490}},
     5e-4},
};

TEST(WorkingSpace, MatricesAreThePublishedOnes) {
    for (const Published& published : kPublished) {
        const WorkingSpace* space = find_working_space(published.space);
        ASSERT_TRUE(space) << published.space;
        const Matrix3 m = rgb_from_xyz(*space);
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                EXPECT_NEAR(m.m[i][j], published.m[i][j], published.tolerance) << published.space << i << j;
    }
}

// Figure 33 prints under "Apple (D50)" the matrix of D65: one is not the other.
TEST(WorkingSpace, AppleD50IsNotTheThesisesMislabelledMatrix) {
    const Matrix3 d50 = rgb_from_xyz(*find_working_space("Apple-D50"));
    EXPECT_GT(std::abs(d50.m[0][0] - 2.951537), 0.4);
}

TEST(WorkingSpace, OnesAreWhiteAtYOfOne) {
    for (const WorkingSpace& space : working_spaces()) {
        const Xyz white = to_xyz(xyz_from_rgb(space).value(), {1, 1, 1});
        EXPECT_NEAR(white.y, 1, 1e-12) << space.name;
        EXPECT_NEAR(white.x / (white.x + white.y + white.z), space.white.x, 1e-12) << space.name;
    }
}

TEST(WorkingSpace, AllEightOfFigure33AreThere) {
    for (const char* name :
         {"sRGB-D50", "sRGB-D65", "sRGB-E", "CIE-RGB-E", "Adobe-D65", "Apple-D50", "NTSC-C", "PAL-D65"})
        EXPECT_TRUE(find_working_space(name)) << name;
}

TEST(WorkingSpace, NamesAreForgiving) {
    EXPECT_EQ(find_working_space("srgb (d65)"), &working_spaces()[0]);
    EXPECT_EQ(find_working_space("CIE RGB E"), find_working_space("CIE-RGB-E"));
    EXPECT_EQ(find_working_space("sRGB"), nullptr);
    EXPECT_EQ(find_working_space(""), nullptr);
}

TEST(WorkingSpace, PrimariesOnALineAreRefused) {
    const WorkingSpace flat{"flat", "", {0.2, 0.2}, {0.3, 0.3}, {0.4, 0.4}, {0.3, 0.3}, "E"};
    EXPECT_FALSE(xyz_from_rgb(flat));
    EXPECT_THROW(rgb_from_xyz(flat), Error);
}

} // namespace
} // namespace metamer
