#include "kiosk/reason_words.h"

#include <gmock/gmock.h>
#include <set>

#include "kiosk/exhibits.h"

namespace metamer {
namespace {

using testing::HasSubstr;
using testing::Not;

Reason reason(Ground ground) {
    Reason made{.ground = ground, .error = 0.123, .taps = 6, .worst = {}, .rejected = {}};
    made.worst = {"F11", "cc-red", "glass-cobalt", 2.5};
    made.rejected = {Method::tristimulus, 0, 3.4};
    return made;
}

const std::vector<Ground> kGrounds{Ground::asked, Ground::constant,  Ground::table, Ground::product,
                                   Ground::taps,  Ground::thickness, Ground::all};

// No two grounds say the same, and nothing of one language is left in another.
TEST(ReasonWords, AreEveryLanguagesOwn) {
    std::set<std::string> all;
    for (const Language& language : all_words().languages())
        for (const Ground ground : kGrounds) {
            const std::string said = reason_words(reason(ground), all_words(), language.code);
            EXPECT_TRUE(all.insert(said).second) << said;
            EXPECT_THAT(said, Not(HasSubstr("{"))) << said;
            EXPECT_THAT(said, HasSubstr(language.decimal == "," ? "0,12" : "0.12")) << said;
            EXPECT_THAT(said, HasSubstr(all_words().text(language.code, "method.tristimulus")));
            if (language.code != "en") {
                EXPECT_THAT(said, Not(HasSubstr(" at most "))) << said;
            }
        }
}

TEST(ReasonWords, TellAllThatThePlannerTells) {
    const Words& words = all_words();
    const std::string error = words.text("de", "difference.number", {{"number", "0,12"}});
    const std::string few = words.text("de", "reason.taps", {{"count", "6"}, {"error", error}});
    Reason taps = reason(Ground::taps);
    taps.rejected = {Method::reduced, 4, 1.5};
    EXPECT_EQ(reason_words(taps, words, "de"),
              words.text("de", "reason.cheaper",
                         {{"reason", few},
                          {"error", words.text("de", "difference.number", {{"number", "1,50"}})},
                          {"method", words.text("de", "reason.few", {{"count", "4"}})}}));
    taps.rejected.reset();
    EXPECT_EQ(reason_words(taps, words, "de"), few);
    taps.error = 0.0044;
    EXPECT_THAT(reason_words(taps, words, "de"), HasSubstr("0,004"));
}

TEST(ReasonWords, NameTheWorstPixelAsTheShelfDoes) {
    const Words& words = all_words();
    Reason asked = reason(Ground::asked);
    const auto german = [&](const char* kind, const char* name) { return words.name_of("de", kind, name); };
    const auto title = [&](const std::string& material, const std::string& lamp) {
        return words.text("de", "panel.title", {{"material", material}, {"lamp", lamp}});
    };
    EXPECT_THAT(reason_words(asked, words, "de"),
                HasSubstr(title(words.text("de", "reason.behind",
                                           {{"material", german("material", "cc-red")},
                                            {"medium", german("material", "glass-cobalt")},
                                            {"thickness", "2,5"}}),
                                german("lamp", "F11"))));
    asked.worst = {"", "cc-red", "", 0};
    EXPECT_THAT(reason_words(asked, words, "de"),
                HasSubstr(title(german("material", "cc-red"), words.text("de", "panel.all_lamps"))));
}

} // namespace
} // namespace metamer
