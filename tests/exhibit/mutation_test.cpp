// Whatever an INI file holds, loading gives an exhibit or bad input: never a crash (run under ASan and
// UBSan).
#include <gmock/gmock.h>
#include <random>

#include "exhibit/support.h"

namespace metamer {
namespace {

// Thesis rows, which take no time: it is not the fit of levels that is tested here.
constexpr const char* kGood =
    "; comment\n[display]\nwidth = 640\nmatrix = 3 -1 0 -1 2 0 0 0 1\ngamut = keep-hue\ncolor_depth = 16\n"
    "dither = yes\n[accuracy]\ntolerance = 0.25\n[atlas]\nquantization = thesis\n[scene]\n"
    "kind = loaf\nmaterials = cc-red, cc-blue, gauss:530:20\n[lamp.1]\nspectrum = F11\n"
    "position = 1 2 3\nfalloff = 1 0 0.5\nshadow = yes\n[lamp.2]\nspectrum = planck:2856\n"
    "direction = 0 -1 -1\n[object.slice-2]\nmaterial = cc-green\nmethod = rgb\n"
    "[compare]\nsplit = 320px\nleft.method = tristimulus\nright.lamp = A\n";

enum class Mutation { replace, insert, erase, truncate, repeat, count };

std::string mutated(std::string text, std::mt19937& rng) {
    const auto up_to = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n)(rng); };
    const std::size_t changes = 1 + up_to(1);
    for (std::size_t i = 0; i < changes && !text.empty(); ++i) {
        const std::size_t at = up_to(text.size() - 1);
        // Half of the letters are those that the language knows.
        constexpr std::string_view special = "[]=:;#,.- \n\t\"09";
        const char letter =
            up_to(1) == 0 ? special[up_to(special.size() - 1)] : static_cast<char>(up_to(255));
        switch (static_cast<Mutation>(up_to(static_cast<std::size_t>(Mutation::count) - 1))) {
        case Mutation::replace:
            text[at] = letter;
            break;
        case Mutation::insert:
            text.insert(at, up_to(4), letter);
            break;
        case Mutation::erase:
            text.erase(at, up_to(12));
            break;
        case Mutation::truncate:
            text.resize(at);
            break;
        case Mutation::repeat:
            text.insert(at, text.substr(up_to(text.size() - 1), up_to(60)));
            break;
        case Mutation::count:
            break;
        }
    }
    return text;
}

TEST(Mutation, NeverCrashes) {
    ASSERT_EQ(error_of([] { exhibit_of(kGood); }), "no error");
    std::mt19937 rng(20150); // NOLINT: the same on every run
    int taken = 0, refused = 0;
    for (int i = 0; i < 3000; ++i) {
        const std::string text = mutated(kGood, rng);
        const std::string message = error_of([&] { exhibit_of(text); });
        EXPECT_THAT(message, testing::AnyOf("no error", testing::StartsWith("cannot read k.ini"))) << text;
        ++(message == "no error" ? taken : refused);
    }
    // Both ends are reached often: the mutations are neither all harmless nor all caught by the first check.
    EXPECT_GT(taken, 100);
    EXPECT_GT(refused, 1000);
}

TEST(Mutation, EveryTruncationOfAGoodText) {
    const std::string good = kGood;
    for (std::size_t n = 0; n < good.size(); ++n)
        EXPECT_THAT(error_of([&] { exhibit_of(good.substr(0, n)); }),
                    testing::AnyOf("no error", testing::StartsWith("cannot read k.ini:")));
}

TEST(Mutation, EveryMutationOfAnOverride) {
    std::mt19937 rng(20151); // NOLINT: the same on every run
    for (int i = 0; i < 1000; ++i) {
        const std::string set = mutated("object.slice-2.material=cc-red", rng);
        EXPECT_THAT(error_of([&] { exhibit_of(kGood, {set}); }),
                    testing::AnyOf("no error", testing::StartsWith("cannot read --set ")))
            << set;
    }
}

} // namespace
} // namespace metamer
