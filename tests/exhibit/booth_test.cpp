#include "exhibit/booth.h"

#include <algorithm>
#include <gmock/gmock.h>

#include "color/colorimetry.h"
#include "color/difference.h"
#include "exhibit/support.h"

namespace metamer {
namespace {

using testing::ElementsAre;

const ObjectSetting& object(const Exhibit& exhibit, const std::string& name) {
    return *std::ranges::find(exhibit.objects, name, &ObjectSetting::name);
}

// CIEDE2000 between the two cards under a lamp.
double between_cards(const Exhibit& booth, const std::string& lamp) {
    const LampSpectrum light = find_lamp(lamp).spectrum;
    return delta_e_2000(reference_xyz(light, object(booth, "card-a").material.material.spectrum),
                        reference_xyz(light, object(booth, "card-b").material.material.spectrum));
}

// What an object wears is in the atlas, and known at full resolution.
void expect_at_hand(const Exhibit& exhibit, const MaterialSetting& material) {
    EXPECT_EQ(exhibit.atlas.materials.at(static_cast<std::size_t>(material.key)).name,
              material.material.name);
    EXPECT_EQ(exhibit.materials.at(material.key).name, material.material.name);
}

TEST(Booth, HasSamplesAndTwoCards) {
    const Exhibit booth = exhibit_of("[scene]\nkind = booth\nmaterials = cc-red, cc-green\n");
    std::vector<std::string> names;
    for (const ObjectSetting& o : booth.objects)
        names.push_back(o.name);
    EXPECT_THAT(names, ElementsAre("interior", "sample-1", "sample-2", "card-a", "card-b"));
    EXPECT_EQ(object(booth, "sample-2").material.material.name, "cc-green");
    for (const ObjectSetting& o : booth.objects)
        expect_at_hand(booth, o.material);
}

TEST(Booth, TheCardsMatchOnTheLeftAndPartOnTheRight) {
    const Exhibit booth =
        exhibit_of("[scene]\nkind = booth\n[compare]\nleft.lamp = A2800\nright.lamp = F11\n");
    EXPECT_LT(between_cards(booth, "A2800"), 1e-6);
    EXPECT_GT(between_cards(booth, "F11"), 20);
    EXPECT_EQ(object(booth, "card-a").material.material.name, "metamer a of A2800, F11");
    EXPECT_EQ(object(booth, "card-b").material.material.name, "metamer b of A2800, F11");
}

TEST(Booth, AHalfWithoutALampOfItsOwnHasLampOne) {
    const std::string lamp = "[scene]\nkind = booth\n[lamp.1]\nspectrum = F11\n[compare]\n";
    EXPECT_EQ(object(exhibit_of(lamp + "right.lamp = E\n"), "card-a").material.material.name,
              "metamer a of F11, E");
    EXPECT_EQ(object(exhibit_of(lamp + "left.lamp = E\n"), "card-a").material.material.name,
              "metamer a of E, F11");
}

TEST(Booth, WithoutAComparisonTheCardsMatch) {
    EXPECT_LT(between_cards(exhibit_of("[scene]\nkind = booth\n"), "D65"), 1e-6);
    EXPECT_GT(between_cards(exhibit_of("[scene]\nkind = booth\n"), "F11"), 20);
    const Exhibit under_f11 = exhibit_of("[scene]\nkind = booth\n[lamp.1]\nspectrum = F11\n");
    EXPECT_LT(between_cards(under_f11, "F11"), 1e-6);
    EXPECT_GT(between_cards(under_f11, "D65"), 20);
}

TEST(Booth, ACardsOwnMaterialStays) {
    const Exhibit booth = exhibit_of("[scene]\nkind = booth\n[object.card-a]\nmaterial = cc-red\n");
    EXPECT_EQ(object(booth, "card-a").material.material.name, "cc-red");
    EXPECT_EQ(object(booth, "card-b").material.material.name, "metamer b of D65, F11");
}

TEST(Booth, HoldsTwelveSamples) {
    EXPECT_EQ(error_of([] { exhibit_of("[scene]\nkind = booth\nmaterials = crayons\n"); }),
              "cannot read k.ini:3: materials = crayons is 15 materials; scene booth takes 1 .. 12");
}

TEST(CardMaterials, TakeTheGrayThatPartsTheMost) {
    const Lamp d65 = find_lamp("D65"), f11 = find_lamp("F11");
    const CardMaterials cards = card_materials(d65, f11);
    const double y = reference_xyz(d65.spectrum, cards.a.spectrum).y;
    EXPECT_THAT(y, testing::AnyOf(testing::DoubleNear(0.2, 1e-9), testing::DoubleNear(0.3, 1e-9),
                                  testing::DoubleNear(0.4, 1e-9)));
    EXPECT_NEAR(reference_xyz(d65.spectrum, cards.b.spectrum).y, y, 1e-9);
    EXPECT_EQ(cards.b.description, "one of two that match under D65 and part under F11");
}

LampSetting lamp(const std::string& name) {
    LampSetting setting;
    setting.lamp = find_lamp(name);
    return setting;
}

TEST(BoothExhibit, ShowsTheBasesMaterialsUnderTwoLamps) {
    const Exhibit base =
        exhibit_of("[display]\nwidth = 640\n[accuracy]\nmethod = rgb\ntolerance = 2\n[scene]\n"
                   "kind = crayons\n[compare]\nline = 3\nleft.method = rgb\n");
    const Exhibit booth = booth_exhibit(base, lamp("D65"), lamp("krypton"));
    EXPECT_EQ(booth.scene, SceneKind::booth);
    EXPECT_EQ(booth.display.width_px, 640);
    EXPECT_EQ(booth.accuracy.tolerance, 2);
    EXPECT_EQ(booth.accuracy.method, MethodChoice());
    ASSERT_EQ(booth.objects.size(), 15u) << "a room, 12 of the 15 crayons, two cards";
    for (std::size_t i = 0; i < 12; ++i)
        EXPECT_EQ(booth.objects[i + 1].material.material.name, base.objects[i].material.material.name);
    for (const ObjectSetting& o : booth.objects)
        expect_at_hand(booth, o.material);
    EXPECT_EQ(booth.compare->left.lamp->lamp.name, "D65");
    EXPECT_EQ(booth.compare->right.lamp->lamp.name, "krypton");
    EXPECT_EQ(booth.compare->line_px, 3);
    EXPECT_FALSE(booth.compare->left.method) << "as [accuracy] says: auto";
    for (const LampSetting& l : {*booth.compare->left.lamp, *booth.compare->right.lamp, booth.lamps.at(0)})
        EXPECT_EQ(booth.atlas.lamps.at(static_cast<std::size_t>(l.key)).name, l.lamp.name);
    EXPECT_LT(between_cards(booth, "D65"), 1e-6);
    EXPECT_GT(between_cards(booth, "krypton"), 20);
}

TEST(BoothExhibit, ShowsAMaterialOnce) {
    const Exhibit base = exhibit_of("[scene]\nkind = loaf\nmaterials = cc-red, cc-blue, cc-red\n");
    EXPECT_EQ(booth_exhibit(base, lamp("D65"), lamp("E")).objects.size(), 5u);
}

// As the shipped one stands: light, strength and shadows.
TEST(BoothExhibit, IsLitAsTheShippedBooth) {
    const Exhibit shipped = load_exhibit(config_folder() / "booth.ini");
    const Exhibit booth = booth_exhibit(shipped, lamp("D65"), lamp("F11"));
    ASSERT_EQ(booth.lamps.size(), shipped.lamps.size());
    for (std::size_t i = 0; i < booth.lamps.size(); ++i) {
        EXPECT_EQ(booth.lamps[i].strength, shipped.lamps[i].strength);
        EXPECT_EQ(booth.lamps[i].shadow, shipped.lamps[i].shadow);
    }
}

} // namespace
} // namespace metamer
