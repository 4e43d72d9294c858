#include "exhibit/keys.h"

#include <gmock/gmock.h>
#include <set>

#include "base/files.h"
#include "exhibit/support.h"

namespace metamer {
namespace {

using testing::HasSubstr;

TEST(Keys, SectionsFitTheirPatterns) {
    EXPECT_EQ(section_pattern("display"), "display");
    EXPECT_EQ(section_pattern("lamp.1"), "lamp.N");
    EXPECT_EQ(section_pattern("lamp.8"), "lamp.N");
    EXPECT_EQ(section_pattern("tour.64"), "tour.N");
    EXPECT_EQ(section_pattern("object.crayon-red"), "object.NAME");
    EXPECT_EQ(section_pattern("object.a.b"), "object.NAME");
    for (const char* unknown : {"", "lamp", "lamp.", "lamp.0", "lamp.9", "lamp.01", "lamp.+1", "lamp.N.x",
                                "object.", "object", "Display", "shop", "lamp.1 ", "tour.0", "tour.65"})
        EXPECT_EQ(section_pattern(unknown), "") << unknown;
}

TEST(Keys, ThePatternsThemselvesAreSections) {
    EXPECT_EQ(section_pattern("lamp.N"), "");
    EXPECT_EQ(section_pattern("object.NAME"), "object.NAME");
}

TEST(Keys, AreFoundWithTheirSectionOnly) {
    ASSERT_NE(find_key("lamp.3", "strength"), nullptr);
    EXPECT_EQ(find_key("lamp.3", "strength")->most, 1e6);
    EXPECT_EQ(find_key("display", "strength"), nullptr);
    EXPECT_EQ(find_key("lamp.9", "strength"), nullptr);
}

TEST(Keys, NameTheNearestSection) {
    EXPECT_EQ(unknown_section("lmap.1"), "unknown section [lmap.1]; did you mean [lamp.1]?");
    EXPECT_EQ(unknown_section("Display"), "unknown section [Display]; did you mean [display]?");
    EXPECT_EQ(unknown_section("objct.ball"), "unknown section [objct.ball]; did you mean [object.ball]?");
    EXPECT_EQ(unknown_section("lamps"), "unknown section [lamps]; did you mean [lamp.1]?");
    EXPECT_EQ(unknown_section("lamp.9"), "unknown section [lamp.9]; lamps are [lamp.1] .. [lamp.8]");
    EXPECT_EQ(unknown_section("object."), "unknown section [object.]; objects are [object.NAME]");
    EXPECT_EQ(unknown_section("qqqqqqq"), "unknown section [qqqqqqq]");
}

TEST(Keys, NameTheNearestKeyOfTheSection) {
    EXPECT_EQ(unknown_key("lamp.1", "strenght"),
              "unknown key \"strenght\" in [lamp.1]; did you mean \"strength\"?");
    EXPECT_EQ(unknown_key("compare", "left.metod"),
              "unknown key \"left.metod\" in [compare]; did you mean \"left.method\"?");
    EXPECT_EQ(unknown_key("atlas", "qqqqqq"), "unknown key \"qqqqqq\" in [atlas]");
}

TEST(Keys, NoneIsThereTwiceAndEachSaysWhatItIs) {
    std::set<std::pair<std::string_view, std::string_view>> seen;
    for (const KeyInfo& info : keys()) {
        EXPECT_TRUE(seen.emplace(info.section, info.key).second) << info.section << " " << info.key;
        EXPECT_FALSE(info.doc.empty() || info.fallback.empty()) << info.section << " " << info.key;
        EXPECT_EQ(info.kind == ValueKind::choice, info.choices != nullptr) << info.section << " " << info.key;
    }
}

TEST(Keys, RangesAreTold) {
    EXPECT_EQ(range_text(*find_key("display", "width")), "16 .. 4096 px");
    EXPECT_EQ(range_text(*find_key("lamp.1", "strength")), "0 .. 1000000");
    EXPECT_EQ(range_text(*find_key("lamp.1", "falloff")), "3 numbers, 0 .. 1000000");
    EXPECT_EQ(range_text(*find_key("accuracy", "method")),
              "auto, rgb, tristimulus, spectral, prefiltered, packed, reduced, folded");
    EXPECT_EQ(range_text(*find_key("accuracy", "tolerance")), "0.01 .. 100 CIEDE2000");
    EXPECT_EQ(range_text(*find_key("object.NAME", "thickness")), "0 .. 1000");
    EXPECT_EQ(plain_number(0.25), "0.25");
}

TEST(Keys, TheShippedTableIsThisTable) {
    EXPECT_EQ(read_file(config_folder() / "KEYS.md"), keys_table());
}

// Each key with what it is, its range and unit, its default; then the key itself, switched off or not.
TEST(Keys, TheReferenceExhibitCommentsEveryKey) {
    const std::string text = read_file(config_folder() / "reference.ini");
    std::size_t at = 0;
    for (const KeyInfo& info : keys()) {
        const std::string comment = "; " + std::string(info.doc) + "\n; " + range_text(info) +
                                    "; default: " + std::string(info.fallback) + "\n";
        const std::size_t found = text.find(comment, at);
        ASSERT_NE(found, std::string::npos) << "in order of the table: " << comment;
        const std::string line = text.substr(found + comment.size(), text.find('\n', found + comment.size()));
        EXPECT_THAT(line.substr(0, info.key.size() + 4),
                    testing::AnyOf(HasSubstr(std::string(info.key) + " = ")))
            << info.key;
        at = found + comment.size();
    }
}

} // namespace
} // namespace metamer
