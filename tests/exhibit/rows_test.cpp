#include "exhibit/rows.h"

#include <gmock/gmock.h>

#include "atlas/atlas_check.h"
#include "atlas/atlas_file.h"
#include "base/files.h"
#include "exhibit/support.h"

namespace metamer {
namespace {

using testing::ElementsAre;

std::vector<std::string> material_rows(const Exhibit& exhibit) {
    std::vector<std::string> names;
    for (const AtlasMaterial& row : exhibit.atlas.materials)
        if (!row.name.empty())
            names.push_back(row.name);
    return names;
}

std::vector<std::string> lamp_rows(const Exhibit& exhibit) {
    std::vector<std::string> names;
    for (const AtlasLamp& row : exhibit.atlas.lamps)
        if (!row.name.empty())
            names.push_back(row.name);
    return names;
}

TEST(Rows, KeyIIsTheIthMaterialOfTheList) {
    for (const char* kind : {"loaf", "crayons", "patches", "still-life"}) {
        const Exhibit exhibit = exhibit_of("[scene]\nmaterials = cc-red, cc-blue, cc-green\n",
                                           {"scene.kind=" + std::string(kind)});
        EXPECT_EQ(exhibit.atlas.materials[1].name, "cc-red") << kind;
        EXPECT_EQ(exhibit.atlas.materials[2].name, "cc-blue") << kind;
        EXPECT_EQ(exhibit.atlas.materials[3].name, "cc-green") << kind;
    }
}

TEST(Rows, AnAtlasThatIsBuiltHasTheQuantizationAskedFor) {
    EXPECT_EQ(parse_exhibit("", "k.ini", ".").atlas.quantization, Quantization::weighted);
    const Exhibit exhibit = exhibit_of("[scene]\nmaterials = cc-black\n[atlas]\nquantization = thesis\n");
    EXPECT_EQ(exhibit.atlas.quantization, Quantization::thesis);
    EXPECT_EQ(exhibit.atlas.materials[1].scale, 1);
    EXPECT_EQ(flaw_of(exhibit.atlas), std::nullopt);
}

TEST(Rows, ASetInTheListStandsForItsMaterials) {
    const Exhibit exhibit = exhibit_of("[scene]\nmaterials = cc-red, crayons, cc-blue\n");
    EXPECT_EQ(exhibit.objects.size(), 17u);
    EXPECT_EQ(exhibit.atlas.materials[1].name, "cc-red");
    EXPECT_EQ(exhibit.atlas.materials[2].name, "crayon-white");
    EXPECT_EQ(exhibit.atlas.materials[17].name, "cc-blue");
}

TEST(Rows, ObjectsOwnMaterialsComeAfterTheList) {
    const Exhibit exhibit =
        exhibit_of("[object.crayon-1]\nmaterial = gauss:550:40\n[scene]\nmaterials = cc-red, cc-blue\n");
    EXPECT_THAT(material_rows(exhibit), ElementsAre("cc-red", "cc-blue", "gauss:550:40"));
    EXPECT_EQ(exhibit.objects.at(0).material.key, 3);
    EXPECT_EQ(exhibit.objects.at(1).material.key, 2);
}

TEST(Rows, TheSameNameTwiceSharesARow) {
    const Exhibit exhibit =
        exhibit_of("[scene]\nmaterials = cc-red, CC-Red, cc-blue\n[lamp.1]\nspectrum = F11\n"
                   "[lamp.2]\nspectrum = f11\n[compare]\nleft.lamp = A\nright.lamp = F11\n");
    EXPECT_THAT(material_rows(exhibit), ElementsAre("cc-red", "cc-blue"));
    EXPECT_THAT(lamp_rows(exhibit), ElementsAre("F11", "A"));
    EXPECT_EQ(exhibit.objects.at(1).material.key, 1);
    EXPECT_EQ(exhibit.compare->right.lamp->key, 1);
}

TEST(Rows, TwoFilesWithColumnsOfOneNameHaveTheirOwnRows) {
    const TestFolder folder;
    write_file(folder / "a.csv", "wavelength_nm,paint\n400,0.25\n700,0.25\n");
    std::filesystem::create_directories(folder / "b");
    write_file(folder / "b/a.csv", "wavelength_nm,paint\n400,0.5\n700,0.5\n");
    write_file(folder / "k.ini", "[scene]\nmaterials = a.csv, b/a.csv, a.csv\n");
    const Exhibit exhibit = load_exhibit(folder / "k.ini", with_quick_rows());
    EXPECT_EQ(exhibit.objects.at(0).material.key, 1);
    EXPECT_EQ(exhibit.objects.at(1).material.key, 2);
    EXPECT_EQ(exhibit.objects.at(2).material.key, 1);
    EXPECT_NEAR(reflectance(exhibit.atlas, 2).value[10], 0.5, 0.002);
}

/// An atlas in which `cc-red` is white and a lamp is called F11 but is flat.
class RowsOfAFile : public testing::Test {
protected:
    RowsOfAFile() {
        Atlas atlas = empty_atlas(Quantization::thesis);
        add_material(atlas, {"own", "", "test", {{{380, 780}, {0.5, 0.5}}}});
        add_material(atlas, {"cc-red", "", "test", {{{380, 780}, {1, 1}}}});
        add_lamp(atlas, {"F11", "", "test", {{{380, 780}, {3, 3}}, {}}});
        write_file(folder_ / "own.png", encode_atlas(atlas));
    }
    Exhibit load(const std::string& rest) {
        write_file(folder_ / "k.ini", "[atlas]\nfile = own.png\n" + rest);
        return load_exhibit(folder_ / "k.ini");
    }
    std::string message(const std::string& rest) {
        return error_of([&] { load(rest); });
    }
    std::string place(int line) {
        return "cannot read " + (folder_ / "k.ini").string() + ":" + std::to_string(line) + ": ";
    }
    TestFolder folder_;
};

TEST_F(RowsOfAFile, NamesAndKeysAreLookedUpThereFirst) {
    const Exhibit exhibit =
        load("[scene]\nmaterials = cc-red, 1, cc-blue\n[lamp.1]\nspectrum = F11\n[lamp.2]\nspectrum = 1\n"
             "[lamp.3]\nspectrum = A\n");
    EXPECT_THAT(material_rows(exhibit), ElementsAre("own", "cc-red", "cc-blue"));
    EXPECT_EQ(exhibit.objects.at(0).material.key, 2);
    EXPECT_EQ(exhibit.objects.at(1).material.key, 1);
    EXPECT_EQ(exhibit.objects.at(1).material.material.name, "own");
    EXPECT_NEAR(value_at_held(exhibit.objects.at(1).material.material.spectrum.curve, 550), 0.5, 0.002);
    EXPECT_EQ(value_at_held(exhibit.objects.at(0).material.material.spectrum.curve, 400), 1);
    EXPECT_EQ(exhibit.objects.at(2).material.key, 3);
    EXPECT_EQ(exhibit.lamps.at(0).key, 1);
    EXPECT_EQ(exhibit.lamps.at(1).key, 1);
    EXPECT_NEAR(value_at_held(exhibit.lamps.at(0).lamp.spectrum.continuum, 600), 3, 0.02);
    EXPECT_EQ(exhibit.lamps.at(2).key, 2);
}

// What the file holds is known by its rows only; what it does not hold, in full.
TEST_F(RowsOfAFile, MaterialsAtFullResolutionAreKeptByKey) {
    const Exhibit exhibit =
        load("[scene]\nmaterials = cc-red, cc-blue\n[lamp.1]\nspectrum = F11\n[lamp.2]\nspectrum = A\n");
    EXPECT_FALSE(exhibit.objects.at(0).material.full_resolution);
    EXPECT_TRUE(exhibit.objects.at(1).material.full_resolution);
    ASSERT_EQ(exhibit.materials.size(), 1u);
    EXPECT_EQ(exhibit.materials.begin()->first, exhibit.objects.at(1).material.key);
    EXPECT_EQ(exhibit.materials.begin()->second.name, "cc-blue");
    EXPECT_FALSE(exhibit.lamps.at(0).full_resolution);
    EXPECT_TRUE(exhibit.lamps.at(1).full_resolution);
}

TEST(Rows, WithoutAFileEveryMaterialIsKeptAtFullResolution) {
    const Exhibit exhibit = exhibit_of("[scene]\nkind = media\n");
    std::vector<std::string> names;
    for (const auto& [key, material] : exhibit.materials) {
        EXPECT_EQ(exhibit.atlas.materials.at(static_cast<std::size_t>(key)).name, material.name);
        names.push_back(material.name);
    }
    EXPECT_THAT(names, testing::UnorderedElementsAre("rgb:FFFFFF", "glass-cobalt", "liquid-allura-red"));
}

TEST_F(RowsOfAFile, ItsOwnMaterialsAreShownByDefault) {
    const Exhibit exhibit = load("[scene]\nkind = loaf\n");
    ASSERT_EQ(exhibit.objects.size(), 2u);
    EXPECT_EQ(exhibit.objects.at(0).material.material.name, "own");
}

TEST_F(RowsOfAFile, AKeyWithoutARow) {
    const std::string own = (folder_ / "own.png").string();
    EXPECT_EQ(message("[lamp.1]\nspectrum = 2\n"),
              place(4) + "spectrum = 2: " + own + " has no lamp in row 2");
    EXPECT_EQ(message("[scene]\nmaterials = 1, 64\n"),
              place(4) + "materials: 64: " + own + " has no material in row 64");
}

TEST_F(RowsOfAFile, NoAtlas) {
    write_file(folder_ / "own.png", "no picture");
    EXPECT_THAT(message(""), testing::StartsWith(place(2) + "file = own.png: "));
}

TEST(Rows, MoreThanAnAtlasHolds) {
    EXPECT_EQ(
        error_of([] { exhibit_of("[scene]\nmaterials = single\n[object.crayon-1]\nmaterial = cc-red\n"); }),
        "cannot read k.ini:4: material = cc-red: all 63 material rows of the atlas are taken");
}

} // namespace
} // namespace metamer
