#include "base/names.h"

#include <gmock/gmock.h>

namespace metamer {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::vector<std::string> kKnown{"spectrum", "strength", "position", "crayon-red"};

TEST(NearestName, ForgivesOneSlip) {
    EXPECT_EQ(nearest_name("strenght", kKnown), "strength"); // neighbors swapped
    EXPECT_EQ(nearest_name("spectum", kKnown), "spectrum");
    EXPECT_EQ(nearest_name("Crayon_Red", kKnown), "crayon-red");
}

TEST(NearestName, OffersNothingForSomethingElse) {
    EXPECT_EQ(nearest_name("zzzzzz", kKnown), "");
    EXPECT_EQ(nearest_name("", kKnown), "");
    EXPECT_EQ(nearest_name(std::string(10000, 'x'), kKnown), "");
}

TEST(NearestName, NeighborsSwappedAreOneSlip) {
    EXPECT_EQ(nearest_name("form", std::vector<std::string>{"fabm", "from"}), "from");
}

TEST(NearestName, HalfTheLettersMustBeRight) {
    const std::vector<std::string> known{"abcdef"};
    EXPECT_EQ(nearest_name("abcxxx", known), "abcdef");
    EXPECT_EQ(nearest_name("abxxxx", known), "");
}

TEST(NearestName, LooksAtNoNameBeyond64Letters) {
    const std::vector<std::string> known{std::string(64, 'a'), std::string(65, 'b')};
    EXPECT_EQ(nearest_name(std::string(64, 'a'), known), known[0]);
    EXPECT_EQ(nearest_name(std::string(65, 'b'), known), "");
}

TEST(DidYouMean, IsASentenceOrNothing) {
    EXPECT_EQ(did_you_mean("spectre", kKnown), "; did you mean \"spectrum\"?");
    EXPECT_EQ(did_you_mean("qqq", kKnown), "");
}

TEST(Split, TrimsItsPieces) {
    EXPECT_THAT(split(" a, b ,c", ','), ElementsAre("a", "b", "c"));
    EXPECT_THAT(split("a,,b", ','), ElementsAre("a", "", "b"));
    EXPECT_THAT(split("  ", ','), IsEmpty());
}

TEST(SameName, LooksPastCaseOnly) {
    EXPECT_TRUE(same_name("F11", "f11"));
    EXPECT_FALSE(same_name("F11", "F1"));
    EXPECT_EQ(lower_case("\xC3\x84X"), "\xC3\x84x") << "UTF-8 stays";
}

} // namespace
} // namespace metamer
