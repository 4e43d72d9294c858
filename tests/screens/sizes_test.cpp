// The exhibit on every size of screen, standing and lying: nothing outside, the colors that belong there.
#include <csignal>

#include "screens/on_screen.h"

namespace metamer {
namespace {

using test::Json;

struct Hung {
    PxSize screen;
    int rotation_deg = 0;
    friend void PrintTo(const Hung& hung, std::ostream* out) {
        *out << hung.screen.width_px << 'x' << hung.screen.height_px << " at " << hung.rotation_deg;
    }
};

class Sizes : public test::OnScreen, public testing::WithParamInterface<Hung> {
protected:
    void tap_and_await(const std::string& part, int index, const std::function<bool(const Json&)>& is) {
        tap(part, index);
        expect_all_inside(kiosk_->await("what " + part + " is for", is));
    }
};

TEST_P(Sizes, NothingIsOutsideAndColorsAreRight) {
    start(GetParam().screen, test::kPatches, GetParam().rotation_deg);
    const PxSize picture = turned(size_, GetParam().rotation_deg);
    const Json told = kiosk_->told();
    EXPECT_EQ(told.at("width_px"), picture.width_px);
    EXPECT_EQ(told.at("height_px"), picture.height_px);
    for (const char* part : {"left-label", "right-label", "split", "strength", "mode", "expert", "hint"})
        EXPECT_FALSE(test::widget(told, part).is_null()) << part;
    EXPECT_FALSE(test::widget(told, "lamp", 3).is_null());
    EXPECT_FALSE(test::widget(told, "language", 5).is_null());
    expect_all_inside(told);
    EXPECT_EQ(wrong_colors(), "");

    // All that can lie on the scene; then the same in Arabic, which is mirrored.
    tap_and_await("expert", 0, [](const Json& now) { return !test::widget(now, "expert-panel").is_null(); });
    key("Escape");
    kiosk_->await("no expert's panel",
                  [](const Json& now) { return test::widget(now, "expert-panel").is_null(); });
    key("Return");
    expect_all_inside(kiosk_->await("an object's panel",
                                    [](const Json& now) { return !test::widget(now, "panel").is_null(); }));
    tap_and_await("language", 1, [](const Json& now) { return now.at("language") == "ar"; });
    tap_and_await("mode", 0, [](const Json& now) { return now.at("mode") == "booth"; });
    EXPECT_EQ(kiosk_->end_by(SIGTERM), 0) << kiosk_->log();
}

INSTANTIATE_TEST_SUITE_P(Of, Sizes,
                         testing::Values(Hung{{640, 480}}, Hung{{800, 480}}, Hung{{1280, 720}},
                                         Hung{{1920, 1080}}, Hung{{1280, 720}, 90}));

} // namespace
} // namespace metamer
