// Every exhibit that the project ships loads without a doubt.
#include <algorithm>
#include <gmock/gmock.h>
#include <set>

#include "base/files.h"
#include "base/names.h"
#include "exhibit/support.h"
#include "spectra/library.h"

namespace metamer {
namespace {

std::vector<std::filesystem::path> shipped() {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(config_folder()))
        if (entry.path().extension() == ".ini" && entry.path().parent_path().filename() != "strings")
            paths.push_back(entry.path());
    std::ranges::sort(paths);
    return paths;
}

/// Where it names no atlas of its own, with_quick_rows().
Exhibit loaded(const std::filesystem::path& path, std::vector<std::string>* warnings = nullptr) {
    const bool quick = read_file(path).find("\n[atlas]") == std::string::npos;
    return load_exhibit(path, quick ? with_quick_rows() : std::vector<std::string>(), warnings);
}

TEST(Shipped, EveryExhibitLoadsWithoutADoubtAndSaysWhatItShows) {
    EXPECT_GT(shipped().size(), 40u);
    for (const auto& path : shipped()) {
        std::vector<std::string> warnings;
        EXPECT_EQ(error_of([&] { loaded(path, &warnings); }), "no error");
        EXPECT_THAT(warnings, testing::IsEmpty()) << path;
        EXPECT_TRUE(read_file(path).starts_with("; ")) << path;
    }
}

TEST(Shipped, EveryFigureSaysWhatToSee) {
    for (const auto& path : shipped())
        if (path.parent_path().filename() == "figures") {
            EXPECT_THAT(read_file(path), testing::HasSubstr("; What to see: ")) << path;
        }
}

TEST(Shipped, EachOfTheThesissLampsHasItsFigure) {
    std::set<std::string> shown;
    for (const auto& path : shipped())
        if (path.filename().string().starts_with("fig45-"))
            shown.insert(loaded(path).lamps.at(0).lamp.name);
    EXPECT_EQ(shown, std::set<std::string>(thesis_lamps().begin(), thesis_lamps().end()));
}

TEST(Shipped, TheBuiltInExhibitIsTheShippedOne) {
    const Exhibit built_in = default_exhibit(), file = load_exhibit(config_folder() / "crayons.ini");
    EXPECT_EQ(built_in.place, "the built-in crayons.ini");
    EXPECT_EQ(built_in.atlas.rgba, file.atlas.rgba);
    EXPECT_EQ(built_in.objects.size(), 15u);
    EXPECT_EQ(built_in.compare->left.method, MethodChoice(Method::tristimulus));
    EXPECT_EQ(built_in.compare->right.method, MethodChoice(Method::spectral));
    EXPECT_EQ(built_in.display.supersample, 2);
    EXPECT_EQ(default_exhibit(with_quick_rows({"lamp.1.spectrum=A"})).lamps.at(0).lamp.name, "A");
}

TEST(Shipped, TheMuseumsExhibitHasAShelfAndATourInEveryLanguage) {
    const KioskSetting kiosk = loaded(config_folder() / "kiosk.ini").kiosk;
    EXPECT_GE(kiosk.lamps.size(), 6u);
    EXPECT_GE(kiosk.tour.size(), 6u);
    EXPECT_FALSE(kiosk.night) << "a remark until a curator wants it";
    for (const auto& entry : std::filesystem::directory_iterator(config_folder() / "strings")) {
        const std::string language = entry.path().stem().string();
        for (std::size_t i = 0; i < kiosk.tour.size(); ++i) {
            const TourStep& step = kiosk.tour[i];
            const bool own = step.captions.contains(language);
            EXPECT_TRUE(own || (language == "en" && step.captions.contains("")))
                << language << " has no caption in [tour." << i + 1 << "]";
        }
    }
}

TEST(Shipped, TheBeachBallHasItsEightMaterials) {
    const Exhibit exhibit = loaded(config_folder() / "figures/ch84-keymap.ini");
    const auto ball = std::ranges::find(exhibit.objects, "ball", &ObjectSetting::name);
    std::set<int> used;
    for (std::size_t i = 0; i < ball->key_map->rgba.size(); i += 4)
        used.insert(ball->key_map->rgba[i]);
    EXPECT_EQ(used, (std::set<int>{1, 2, 3, 4, 5, 6, 7, 8}));
    EXPECT_EQ(exhibit.atlas.materials[2].name, "crayon-red");
}

} // namespace
} // namespace metamer
