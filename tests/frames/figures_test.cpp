// Every shipped exhibit draws, and shows something.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <gtest/gtest.h>
#include <set>

#include "frames/frames.h"

namespace metamer {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> shipped() {
    std::vector<std::string> names;
    for (const char* folder : {"/config", "/config/figures"})
        for (const auto& entry : fs::directory_iterator(std::string(METAMER_SOURCE_DIR) + folder))
            if (entry.path().extension() == ".ini")
                names.push_back(entry.path().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
    std::string name = fs::path(info.param).stem().string();
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return name;
}

class Shipped : public testing::TestWithParam<std::string> {};

TEST_P(Shipped, DrawsAPictureOfManyColors) {
    const Exhibit exhibit =
        load_exhibit(GetParam(), {"display.width=160", "display.height=90", "display.supersample=1"});
    const Image image = frame_of(exhibit);
    ASSERT_EQ(image.width, 160);
    std::set<int> colors;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
        colors.insert(image.rgba[i] << 16 | image.rgba[i + 1] << 8 | image.rgba[i + 2]);
    EXPECT_GE(colors.size(), exhibit.objects.size()) << "most objects are to be seen";
}

INSTANTIATE_TEST_SUITE_P(Exhibits, Shipped, testing::ValuesIn(shipped()), test_name);

TEST(ShippedFigures, AreAllThere) {
    EXPECT_GE(shipped().size(), 30u);
}

} // namespace
} // namespace metamer
