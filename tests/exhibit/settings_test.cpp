#include "exhibit/settings.h"

#include <gmock/gmock.h>

#include "exhibit/support.h"

namespace metamer {
namespace {

Settings settings_of(const std::string& text, const std::vector<std::string>& sets = {}) {
    Settings settings(parse_ini(text, "k.ini"), "k.ini", "some/folder");
    for (const std::string& set : sets)
        settings.set(set);
    return settings;
}

TEST(Settings, KnowTheirPlaceAndFolder) {
    const Settings settings = settings_of("\n[lamp.1]\nspectrum = F11\n");
    const Setting* spectrum = settings.find("lamp.1", "spectrum");
    ASSERT_NE(spectrum, nullptr);
    EXPECT_EQ(spectrum->place, "k.ini:3");
    EXPECT_EQ(spectrum->folder, "some/folder");
    EXPECT_EQ(settings.find("lamp.2", "spectrum"), nullptr);
}

TEST(Settings, SetReplacesAddsAndTakesOut) {
    const Settings settings = settings_of(
        "[lamp.1]\nspectrum = F11\nstrength = 2\n",
        {"lamp.1.spectrum=A", " lamp.1.spectrum = F2 ", "compare.left.method=rgb", "lamp.1.strength="});
    EXPECT_EQ(settings.find("lamp.1", "spectrum")->value, "F2");
    EXPECT_EQ(settings.find("lamp.1", "spectrum")->place, "--set  lamp.1.spectrum = F2 ");
    EXPECT_EQ(settings.find("lamp.1", "spectrum")->folder, ".");
    EXPECT_EQ(settings.find("compare", "left.method")->value, "rgb");
    EXPECT_EQ(settings.sections("compare").size(), 1u);
    EXPECT_EQ(settings.find("lamp.1", "strength"), nullptr);
}

TEST(Settings, SetSplitsAtTheRightDot) {
    const Settings settings =
        settings_of("", {"object.a.b.specular=1", "lamp.2.strength=1", "scene.materials=a=b"});
    EXPECT_NE(settings.find("object.a.b", "specular"), nullptr);
    EXPECT_NE(settings.find("lamp.2", "strength"), nullptr);
    EXPECT_EQ(settings.find("scene", "materials")->value, "a=b");
}

TEST(Settings, SetThatCannotBe) {
    const std::pair<std::string, std::string> cases[] = {
        {"lamp.1.spectrum", "it must be section.key=value, as in lamp.1.spectrum=F11"},
        {"width=3", "it must be section.key=value, as in lamp.1.spectrum=F11"},
        {"display.=3", "it must be section.key=value, as in lamp.1.spectrum=F11"},
        {"", "it must be section.key=value, as in lamp.1.spectrum=F11"},
        {"lamp.strength=3", "unknown section [lamp]; lamps are [lamp.1] .. [lamp.8]"},
        {"lamp.1.strenght=3", "unknown key \"strenght\" in [lamp.1]; did you mean \"strength\"?"},
        {"dispay.width=3", "unknown section [dispay]; did you mean [display]?"},
        {"display.brightness=1", "unknown key \"brightness\" in [display]"},
        {"object.ball=1", "unknown section [object]; objects are [object.NAME]"},
        {"object.=1", "it must be section.key=value, as in lamp.1.spectrum=F11"},
    };
    for (const auto& [text, cause] : cases)
        EXPECT_EQ(error_of([&] { settings_of("", {text}); }), "cannot read --set " + text + ": " + cause);
}

TEST(Settings, UnknownNamesInTheFile) {
    EXPECT_EQ(error_of([] { settings_of("[lmap.1]\n"); }),
              "cannot read k.ini:1: unknown section [lmap.1]; did you mean [lamp.1]?");
    EXPECT_EQ(error_of([] { settings_of("[lamp.1]\n\nstrenght = 1\n"); }),
              "cannot read k.ini:3: unknown key \"strenght\" in [lamp.1]; did you mean \"strength\"?");
}

} // namespace
} // namespace metamer
