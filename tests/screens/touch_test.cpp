// What a visitor's hands do, on the screen and in words.
#include <csignal>

#include "overlay/words.h"
#include "screens/on_screen.h"

namespace metamer {
namespace {

using test::Json;
using test::widget;

constexpr PxSize kScreen{800, 480};

class Touch : public test::OnScreen {
protected:
    std::string text(const std::string& part, int index = 0) {
        return widget(kiosk_->told(), part, index).at("text");
    }
    Json await_panel() {
        const Json told =
            kiosk_->await("a panel", [](const Json& now) { return !widget(now, "panel").is_null(); });
        return widget(told, "panel");
    }
    void await_no_panel() {
        kiosk_->await("no panel", [](const Json& now) { return widget(now, "panel").is_null(); });
    }

    Words words_;
};

TEST_F(Touch, DragsTheSplit) {
    start(kScreen);
    const Json handle = widget(kiosk_->told(), "split").at("box");
    const double x = handle[0].get<double>() + handle[2].get<double>() / 2;
    const double y = handle[1].get<double>() + handle[3].get<double>() / 2;
    drag(x, y, x - 0.3 * kScreen.width_px, y);
    const Json told = kiosk_->await("the split further left", [](const Json& now) {
        return std::abs(now.at("split").get<double>() - 0.2) < 0.005;
    });
    // Its handle went with it.
    const Json moved = widget(told, "split").at("box");
    EXPECT_NEAR(moved[0].get<double>(), handle[0].get<double>() - 0.3 * kScreen.width_px, 2);
    EXPECT_EQ(wrong_colors(), "");
}

TEST_F(Touch, PicksEachLamp) {
    start(kScreen);
    EXPECT_TRUE(widget(kiosk_->told(), "lamp", 1).at("on")) << "F11 is the exhibit's own";
    const char* const lamps[] = {"D65", "F11", "A2800", "krypton"};
    for (const int i : {0, 1, 2, 3}) {
        tap("lamp", i);
        const Json told = kiosk_->await(lamps[i], [&](const Json& now) {
            return widget(now, "lamp", i).at("on") && !widget(now, "lamp", (i + 1) % 4).at("on");
        });
        EXPECT_EQ(text("lamp", i), words_.name_of("en", "lamp", lamps[i]));
        EXPECT_EQ(wrong_colors({std::string("lamp.1.spectrum=") + lamps[i]}), "") << lamps[i];
    }
}

TEST_F(Touch, MakesTheLampBrighter) {
    start(kScreen);
    const Json slider = widget(kiosk_->told(), "strength").at("box");
    const double y = slider[1].get<double>() + slider[3].get<double>() / 2;
    const double middle = slider[0].get<double>() + slider[2].get<double>() / 2;
    drag(middle, y, slider[0], y);
    const double strength =
        kiosk_->await("less light", [](const Json& now) { return now.at("strength") == 0.05; })
            .at("strength");
    EXPECT_EQ(text("strength"), words_.text("en", "slider.strength", {{"factor", "0.05"}}));
    EXPECT_EQ(wrong_colors({"lamp.1.strength=" + std::to_string(strength)}), "");
}

TEST_F(Touch, OpensAPanelByATapAndCloses) {
    start(kScreen);
    const Json scene = kiosk_->told().at("scene");
    // In the middle of the first patch.
    tap(scene[0].get<double>() + 0.12 * scene[2].get<double>(),
        scene[1].get<double>() + 0.35 * scene[3].get<double>());
    const Json panel = await_panel();
    const std::string material = words_.name_of("en", "material", "cc-orange");
    const std::string lamp = words_.name_of("en", "lamp", "F11");
    const std::string title = words_.text("en", "panel.title", {{"material", material}, {"lamp", lamp}});
    EXPECT_THAT(panel.at("text").get<std::string>(), testing::StartsWith(title));
    EXPECT_NE(panel.at("colors")[0], panel.at("colors")[1]);
    tap("next");
    const std::string second = words_.name_of("en", "material", "cc-blue");
    kiosk_->await("the second object", [&](const Json& now) {
        return widget(now, "panel").at("text").get<std::string>().starts_with(second);
    });
    tap("close");
    await_no_panel();
    EXPECT_EQ(wrong_colors(), "");
}

TEST_F(Touch, ReachesAllByKeys) {
    start(kScreen);
    key("Tab"); // the scene
    key("Right");
    await_panel();
    key("Right");
    const std::string second = words_.name_of("en", "material", "cc-blue");
    kiosk_->await("the second object", [&](const Json& now) {
        const Json panel = widget(now, "panel");
        return !panel.is_null() && panel.at("text").get<std::string>().starts_with(second);
    });
    key("Escape");
    await_no_panel();
    for (int i = 0; i < 60 && !widget(kiosk_->told(), "language", 2).at("focused"); ++i) {
        const Json before = kiosk_->told();
        key("Tab");
        kiosk_->await("another focus", [&](const Json& now) { return now != before; });
    }
    key("Return");
    kiosk_->await("German", [](const Json& now) { return now.at("language") == "de"; });
}

TEST_F(Touch, SpeaksEveryLanguage) {
    start(kScreen);
    const auto& all = words_.languages();
    ASSERT_GE(all.size(), 6u);
    for (std::size_t i = all.size(); i-- > 0;) {
        tap("language", static_cast<int>(i));
        const std::string code = all[i].code;
        const Json told = kiosk_->await(code, [&](const Json& now) { return now.at("language") == code; });
        for (const auto& [part, key] : {std::pair{"mode", "button.booth"},
                                        {"expert", "button.expert"},
                                        {"hint", "hint.methods"},
                                        {"left-label", "half.numbers"},
                                        {"right-label", "half.wavelengths"}})
            EXPECT_EQ(widget(told, part).at("text"), words_.text(code, key)) << code;
        EXPECT_EQ(widget(told, "lamp", 0).at("text"), words_.name_of(code, "lamp", "D65"));
    }
}

TEST_F(Touch, TellsTheExpert) {
    start(kScreen);
    tap("expert");
    const Json told =
        kiosk_->await("its panel", [](const Json& now) { return !widget(now, "expert-panel").is_null(); });
    EXPECT_TRUE(widget(told, "expert").at("on"));
    const Json rows = widget(told, "expert-panel").at("rows");
    const auto value = [&](const char* key) -> std::string {
        for (const Json& row : rows)
            if (row[0] == words_.text("en", key))
                return row[1];
        return "no such row";
    };
    EXPECT_EQ(value("expert.method"),
              words_.text("en", "method.tristimulus") + " | " + words_.text("en", "method.spectral"));
    EXPECT_EQ(value("expert.space"), "sRGB-D65");
    EXPECT_EQ(value("expert.wavelengths"), "3 | 64");
    EXPECT_EQ(wrong_colors(), "");
}

TEST_F(Touch, ComparesTwoLamps) {
    start(kScreen);
    tap("mode");
    kiosk_->await("the booth", [](const Json& now) { return now.at("mode") == "booth"; });
    EXPECT_TRUE(widget(kiosk_->told(), "split").is_null());
    tap("lamp-right", 2);
    const Json told = kiosk_->await("A2800 on the right",
                                    [](const Json& now) { return widget(now, "lamp-right", 2).at("on"); });
    EXPECT_EQ(widget(told, "right-label").at("text"),
              words_.text("en", "booth.part", {{"lamp", words_.name_of("en", "lamp", "A2800")}}));
    EXPECT_EQ(widget(told, "left-label").at("text"),
              words_.text("en", "booth.match", {{"lamp", words_.name_of("en", "lamp", "F11")}}));
    tap("mode");
    kiosk_->await("one lamp again", [](const Json& now) { return now.at("mode") == "methods"; });
    EXPECT_EQ(wrong_colors(), "");
}

} // namespace
} // namespace metamer
