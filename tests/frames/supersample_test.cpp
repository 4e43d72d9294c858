#include "render/supersample.h"

#include <gtest/gtest.h>

namespace metamer {
namespace {

Image checker(std::uint8_t a, std::uint8_t b) {
    return {2, 2, {a, a, a, 255, b, b, b, 255, b, b, b, 255, a, a, a, 255}};
}

TEST(Averaged, IsTheMeanOfLightNotOfCodes) {
    // Half the light of white is code 188 (IEC 61966-2-1), not 128.
    EXPECT_EQ(averaged(checker(0, 255), 2, Transfer::srgb).rgba,
              (std::vector<std::uint8_t>{188, 188, 188, 255}));
    EXPECT_EQ(averaged(checker(0, 255), 2, Transfer::none).rgba,
              (std::vector<std::uint8_t>{128, 128, 128, 255}));
}

TEST(Averaged, KeepsEveryFlatColor) {
    for (int code = 0; code < 256; ++code) {
        const auto c = static_cast<std::uint8_t>(code);
        EXPECT_EQ(averaged(checker(c, c), 2, Transfer::srgb).rgba, (std::vector<std::uint8_t>{c, c, c, 255}));
    }
}

TEST(Averaged, ByOneIsTheSame) {
    EXPECT_EQ(averaged(checker(3, 250), 1, Transfer::srgb).rgba, checker(3, 250).rgba);
}

} // namespace
} // namespace metamer
