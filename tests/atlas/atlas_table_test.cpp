#include "atlas/atlas_table.h"

#include <gmock/gmock.h>

#include "atlas/samples.h"

namespace metamer {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::StartsWith;

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        lines.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return lines;
}

std::string times(std::size_t count, const std::string& piece) {
    std::string out;
    for (std::size_t i = 0; i < count; ++i)
        out += piece;
    return out;
}

TEST(AtlasTable, ShowsTheObserverAndEveryRowInUse) {
    const auto lines = lines_of(describe(sample_atlas()));
    ASSERT_THAT(lines, SizeIs(8));
    EXPECT_EQ(lines[0], "observer: CIE 1931 2 degree; quantization: thesis");
    EXPECT_THAT(lines[1], StartsWith("  x  "));
    EXPECT_THAT(lines[2], StartsWith("  y  "));
    EXPECT_THAT(lines[3], StartsWith("  z  "));
    EXPECT_EQ(lines[4], "row  385 .. 700 nm" + times(19, " ") + "  lamp" + times(19, " ") +
                            "  385 .. 700 nm" + times(19, " ") + "  material");
    // Pairs of intervals, the greater of each, in eighths rounded up: 4/255 is one eighth, 255 all eight.
    EXPECT_EQ(lines[5], "  1  " + times(4, "▁") + times(4, "▂") + times(4, "▃") + times(4, "▄") +
                            times(4, "▅") + times(4, "▆") + times(4, "▇") + times(4, "█") +
                            "  ramp (peak 12.3)       " + "  " + times(32, "▅") + "  gray");
    EXPECT_EQ(lines[6], "  2  " + times(20, " ") + "█" + times(11, " ") + "  line:589.3 (peak 0.172)  " +
                            times(32, " ") + "  black");
    EXPECT_THAT(lines[7], EndsWith("  Gl\xC3\xBChlampe (peak 0.1)"));
}

TEST(AtlasTable, ShowsAScaleThatIsNotOne) {
    Atlas atlas = sample_atlas(Quantization::weighted);
    atlas.materials[2].scale = 0.05;
    EXPECT_THAT(describe(atlas), HasSubstr("  black (scale 0.05)\n"));
}

TEST(AtlasTable, ShowsAnEmptyAtlas) {
    EXPECT_THAT(lines_of(describe(empty_atlas())), SizeIs(5));
}

TEST(AtlasTable, GivesJson) {
    const Atlas atlas = sample_atlas();
    auto expected = nlohmann::json::parse(R"({
        "rows": [
            {"key": 1, "lamp": {"name": "ramp", "peak": 12.3, "source": "a test"},
             "material": {"name": "gray", "scale": 1, "source": "a test"}},
            {"key": 2, "lamp": {"name": "line:589.3", "peak": 0, "source": "a formula"},
             "material": {"name": "black", "scale": 1, "source": "a test"}},
            {"key": 3, "lamp": {"name": "Glühlampe", "peak": 0.1, "source": "光, 2015"}, "material": null}],
        "observer": "CIE 1931 2 degree", "quantization": "thesis",
        "grid": {"first_nm": 385, "step_nm": 5, "count": 64}})");
    expected["rows"][1]["lamp"]["peak"] = atlas.lamps[2].peak;
    EXPECT_EQ(describe_json(atlas), expected);
    EXPECT_EQ(describe_json(empty_atlas())["rows"], nlohmann::json::array());
}

} // namespace
} // namespace metamer
