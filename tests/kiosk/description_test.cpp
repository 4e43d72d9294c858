#include "kiosk/description.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

#include "kiosk/desks.h"

namespace metamer {
namespace {

nlohmann::json described(const TestDesk& at, Shift shift = {}) {
    return nlohmann::json::parse(description(at.desk, at.visit, {1280, 720}, shift));
}

TEST(Description, TellsTheState) {
    TestDesk at;
    at.visit.act(SetSplit{0.25});
    at.visit.act(SetStrength{2});
    at.visit.act(ChooseLanguage{"ja"});
    at.lay();
    const auto json = described(at);
    EXPECT_EQ(json["width_px"], 1280);
    EXPECT_EQ(json["height_px"], 720);
    EXPECT_EQ(json["phase"], "visitor");
    EXPECT_EQ(json["mode"], "methods");
    EXPECT_EQ(json["language"], "ja");
    EXPECT_EQ(json["split"], 0.25);
    EXPECT_EQ(json["strength"], 2);
}

TEST(Description, TellsEveryWidgetWhereItIsSeen) {
    TestDesk at;
    at.tap(Part::expert);
    at.key(Key::enter);
    const auto json = described(at, {3, 5});
    ASSERT_EQ(json["widgets"].size(), at.desk.widgets.size());
    EXPECT_EQ(json["scene"][0], at.desk.layout.scene.left + 3);
    EXPECT_EQ(json["scene"][1], at.desk.layout.scene.top + 5);
    for (std::size_t i = 0; i < at.desk.widgets.size(); ++i) {
        const Widget& widget = at.desk.widgets[i];
        const auto& told = json["widgets"][i];
        EXPECT_EQ(told["part"], part_name(widget.part));
        EXPECT_EQ(told["index"], widget.index);
        EXPECT_EQ(told["text"], widget.text);
        EXPECT_EQ(told["on"], widget.on);
        EXPECT_EQ(told["focused"], widget.focused);
        EXPECT_EQ(told["value"], widget.value);
        EXPECT_EQ(told["box"], (nlohmann::json{widget.box.left + 3, widget.box.top + 5, widget.box.width,
                                               widget.box.height}));
        EXPECT_EQ(told.contains("colors"), widget.part == Part::panel);
        EXPECT_EQ(told.contains("rows"), widget.part == Part::expert_panel);
    }
}

TEST(Description, TellsThePhase) {
    TestDesk at(patches("night = 20:00-08:00\n"));
    at.visit.tick(100, 12 * 60);
    EXPECT_EQ(described(at)["phase"], "tour");
    at.visit.tick(200, 22 * 60);
    EXPECT_EQ(described(at)["phase"], "night");
    TestDesk booth;
    booth.tap(Part::mode);
    EXPECT_EQ(described(booth)["mode"], "booth");
}

TEST(Description, EveryPartHasANameOfItsOwn) {
    std::set<std::string> names;
    for (int part = 0; part <= static_cast<int>(Part::notice); ++part)
        names.insert(part_name(static_cast<Part>(part)));
    EXPECT_EQ(names.size(), static_cast<std::size_t>(Part::notice) + 1);
}

} // namespace
} // namespace metamer
