// metamer atlas build and metamer atlas show.
#include "atlas/atlas_file.h"
#include "commands/command_test.h"
#include "image/png.h"

namespace metamer::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class AtlasCommand : public CommandTest {
protected:
    AtlasCommand() {
        write("lamp.csv", kFlatLamp);
        write("two.csv", kTwoMaterials);
    }

    Atlas atlas(const std::string& name) const { return decode_atlas(read(name), name); }

    static std::vector<std::string> names(const json& document, const char* kind) {
        std::vector<std::string> out;
        for (const json& row : document["rows"])
            if (!row[kind].is_null())
                out.push_back(row[kind]["name"]);
        return out;
    }
};

TEST_F(AtlasCommand, BuildingIsReproducible) {
    for (const char* name : {"a.png", "b.png"})
        EXPECT_EQ(output_of({"atlas", "build", "--lamps", "thesis", "lamp.csv", "--materials", "crayons",
                             "two.csv", "--output", name}),
                  std::string(name) + ": written\n");
    EXPECT_EQ(read("a.png"), read("b.png"));
    EXPECT_EQ(atlas("a.png").lamps[15].name, "krypton");
}

TEST_F(AtlasCommand, FilesStandForTheirColumnsAndSetsForTheirMembers) {
    output_of({"atlas", "build", "--lamps", "lamp.csv", "F11", "f11", "planck:2856", "--materials", "two.csv",
               "crayons", "two.csv#step", "-o", "a.png"});
    const json document = json_of({"atlas", "show", "a.png", "--json"});
    EXPECT_THAT(names(document, "lamp"), testing::ElementsAre("lamp.csv#flat", "F11", "planck:2856"));
    const auto materials = names(document, "material");
    ASSERT_EQ(materials.size(), 17u);
    EXPECT_EQ(materials[0], "two.csv#half");
    EXPECT_EQ(materials[1], "two.csv#step");
    EXPECT_EQ(materials[2], "crayon-white");
    // Where a flat lamp ends within the grid, the best fit on it overshoots a little.
    EXPECT_NEAR(document["rows"][0]["lamp"]["peak"].get<double>(), 1.0, 0.05);
}

TEST_F(AtlasCommand, TheValuesAreTheSpectras) {
    output_of({"atlas", "build", "--quantization", "thesis", "--materials", "two.csv", "-o", "a.png"});
    const Atlas built = atlas("a.png");
    EXPECT_EQ(built.rgba[atlas_byte(1, 0, AtlasChannel::material)], 128);
    EXPECT_EQ(built.rgba[atlas_byte(2, 0, AtlasChannel::material)], 0);
    EXPECT_EQ(built.rgba[atlas_byte(2, 63, AtlasChannel::material)], 255);
    EXPECT_TRUE(built.lamps[1].name.empty());
}

TEST_F(AtlasCommand, TheQuantizationIsChosenAndShown) {
    output_of({"atlas", "build", "--materials", "two.csv", "-o", "a.png"});
    output_of({"atlas", "build", "--quantization", "thesis", "--materials", "two.csv", "-o", "t.png"});
    EXPECT_EQ(json_of({"atlas", "show", "a.png", "--json"})["quantization"], "weighted");
    EXPECT_EQ(json_of({"atlas", "show", "t.png", "--json"})["quantization"], "thesis");
    EXPECT_THAT(output_of({"atlas", "show", "t.png"}), HasSubstr("quantization: thesis"));
    EXPECT_LT(json_of({"atlas", "show", "a.png", "--json"})["rows"][0]["material"]["scale"], 0.6);
    expect_failure_like(2,
                        {"atlas", "build", "--quantization", "fine", "--materials", "two.csv", "-o", "x.png"},
                        HasSubstr("--quantization"));
}

TEST_F(AtlasCommand, EveryLampFitsBesideEachSet) {
    for (const char* set : {"colorchecker", "single", "weighted", "empirical", "crayons", "media"}) {
        output_of({"atlas", "build", "--lamps", "all", "--materials", set, "-o", "a.png"});
        const json document = json_of({"atlas", "show", "a.png", "--json"});
        EXPECT_GE(names(document, "lamp").size(), 50u);
        EXPECT_GE(names(document, "material").size(), 6u) << set;
    }
}

TEST_F(AtlasCommand, LostEnergyIsWarnedOfWithItsShare) {
    write("wide.csv", "wavelength_nm,wide\n282.5,1\n1082.5,1\n");
    const Outcome outcome = metamer({"atlas", "build", "--lamps", "wide.csv", "-o", "a.png"});
    EXPECT_EQ(outcome.status, 0);
    // 64 samples of 5 nm are kept of 802.5: at an end a sample stands for the one whole distance there.
    EXPECT_EQ(outcome.err, "metamer: warning: wide.csv#wide: 60.1 % of its energy lies outside the grid "
                           "(385..700 nm) and is lost\n");
    EXPECT_EQ(outcome.out, "a.png: written\n");
}

TEST_F(AtlasCommand, WhatCannotBeBuiltIsNotWritten) {
    write("bad.csv", "wavelength_nm,a\n400,1\n400,1\n");
    write("a.png", "old");
    expect_failure(2, {"atlas", "build", "-o", "x.png"},
                   "cannot build x.png: there are neither --lamps nor --materials");
    expect_failure(2, {"atlas", "build", "--lamps", "F11", "-o", "none/x.png"},
                   "cannot write none/x.png: there is no folder none");
    expect_failure(2, {"atlas", "build", "--materials", "single", "weighted", "-o", "a.png"},
                   "cannot add material \"weighted-390\": all 63 material rows of the atlas are taken");
    expect_failure(2, {"atlas", "build", "--materials", "crayon-rd", "-o", "a.png"},
                   "cannot find material \"crayon-rd\": the library has no such material; did you mean "
                   "\"crayon-red\"?");
    expect_failure(2, {"atlas", "build", "--lamps", "none.csv", "-o", "a.png"},
                   "cannot read none.csv: there is no such file");
    expect_failure_like(2, {"atlas", "build", "--lamps", "bad.csv", "-o", "a.png"},
                        testing::StartsWith("metamer: cannot read bad.csv:3: "));
    EXPECT_EQ(read("a.png"), "old");
}

TEST_F(AtlasCommand, ShowPrintsNamesPeaksAndRows) {
    output_of({"atlas", "build", "--lamps", "lamp.csv", "F11", "--materials", "crayon-red", "-o", "a.png"});
    const std::string text = output_of({"atlas", "show", "a.png"});
    for (const char* part : {"observer: CIE 1931", "\n  1  ", "lamp.csv#flat (peak 1.03", "F11 (peak ",
                             "crayon-red", "385 .. 700 nm", "█"})
        EXPECT_THAT(text, HasSubstr(part));
}

TEST_F(AtlasCommand, ShowsJsonHasEverythingItsTextHas) {
    output_of({"atlas", "build", "--lamps", "F11", "--materials", "crayon-red", "-o", "a.png"});
    const json document = json_of({"atlas", "show", "a.png", "--json"});
    EXPECT_EQ(document["grid"], json({{"first_nm", 385.0}, {"step_nm", 5.0}, {"count", 64}}));
    EXPECT_THAT(document["observer"].get<std::string>(), HasSubstr("CIE 1931"));
    const json& row = document["rows"][0];
    EXPECT_EQ(row["key"], 1);
    EXPECT_EQ(row["lamp"]["name"], "F11");
    EXPECT_GT(row["lamp"]["peak"].get<double>(), 0);
    EXPECT_NE(row["lamp"]["source"], "");
    EXPECT_GT(row["material"]["scale"].get<double>(), 0.5);
    EXPECT_LE(row["material"]["scale"].get<double>(), 1);
}

TEST_F(AtlasCommand, ShowDrawsAPictureOfTheRows) {
    output_of({"atlas", "build", "--lamps", "thesis", "-o", "a.png"});
    const std::string text = output_of({"atlas", "show", "a.png"});
    EXPECT_EQ(output_of({"atlas", "show", "a.png", "--picture", "rows.png"}), text);
    const Png picture = decode_png(read("rows.png"), "rows.png");
    EXPECT_EQ(picture.image.width, 928);
    EXPECT_EQ(picture.image.height, 238) << "the observer and fifteen lamps, 14 px each, in their margin";
    EXPECT_TRUE(picture.color.srgb);
    expect_failure(2, {"atlas", "show", "a.png", "--picture", "none/rows.png"},
                   "cannot write none/rows.png: there is no folder none");
}

TEST_F(AtlasCommand, WhatIsNoAtlasIsRefusedByName) {
    output_of({"atlas", "build", "--lamps", "F11", "-o", "a.png"});
    output_of({"atlas", "show", "a.png", "--picture", "picture.png"});
    write("cut.png", read("a.png").substr(0, 200));
    write("empty.png", "");
    for (const char* name : {"picture.png", "cut.png", "empty.png", "lamp.csv"})
        expect_failure_like(2, {"atlas", "show", name, "--json"},
                            testing::StartsWith("metamer: cannot read " + std::string(name) + ": "));
    expect_failure(2, {"atlas", "show", "none.png"}, "cannot read none.png: there is no such file");
    expect_failure(2, {"atlas", "show", "."}, "cannot read .: it is a folder");
}

// Exhibits take their rows from it, by name and by key.
TEST_F(AtlasCommand, WhatIsBuiltCanBeRendered) {
    output_of({"atlas", "build", "--lamps", "F11", "--materials", "crayon-red", "cc-green", "-o", "a.png"});
    write("e.ini", "[atlas]\nfile = a.png\n[scene]\nkind = patches\nmaterials = 2\n[lamp.1]\n"
                   "spectrum = F11\n[display]\nwidth = 16\nheight = 16\n[accuracy]\nmethod = spectral\n");
    output_of({"render", "e.ini", "-o", "x.png"});
    const Image image = decode_png(read("x.png"), "x.png").image;
    const json measured = json_of({"measure", "--lamp", "F11", "--material", "cc-green", "--json"});
    const auto expected = measured["methods"][2]["gpu_rgb8"].get<std::vector<int>>();
    const auto middle = image.rgba.begin() + (8 * 16 + 8) * 4;
    EXPECT_EQ(std::vector<int>(middle, middle + 3), expected);
}

} // namespace
} // namespace metamer::test
