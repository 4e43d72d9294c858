// What stands on the surface: the CPU twin's colors at every place of the scene.
#include <gmock/gmock.h>
#include <set>

#include "kiosk/twin.h"

namespace metamer {
namespace {

/// The same, and that enough of all objects can be seen.
void expect_twin(const TestKiosk& at, const Exhibit& drawn, std::size_t halves = 2) {
    expect_colors(at, drawn);
    std::set<std::pair<std::size_t, std::size_t>> met;
    std::set<std::size_t> objects;
    for (const Place& place : places(at)) {
        met.insert({place.object, place.half});
        objects.insert(place.object);
    }
    EXPECT_GE(met.size(), drawn.objects.size() * halves / 2);
    EXPECT_EQ(objects.size(), drawn.objects.size());
}

TEST(Picture, BothHalvesHaveTheTwinsColorsOnEveryScreen) {
    for (const TestScreen& screen :
         {TestScreen{640, 480}, {800, 480}, {1280, 720}, {1920, 1080}, {480, 800}, {720, 1280}}) {
        SCOPED_TRACE(std::to_string(screen.width_px) + "x" + std::to_string(screen.height_px));
        TestKiosk at(patches(), screen);
        at.settle();
        expect_twin(at, lit(at.text, at.state()));
    }
}

TEST(Picture, EitherWayUp) {
    for (const int rotation : {90, 180, 270}) {
        SCOPED_TRACE(rotation);
        TestKiosk at(patches(), {640, 480, rotation});
        at.settle();
        expect_twin(at, lit(at.text, at.state()));
    }
}

TEST(Picture, HalvesAreTold) {
    // Else the tests above would see nothing.
    const Exhibit drawn = lit(patches(), start_state(kiosk_exhibit(patches())));
    const Twin twin(drawn);
    EXPECT_GT(apart(twin.color(0, 0), twin.color(0, 1)), 3 * kMostSteps);
}

TEST(Picture, AnySplit) {
    TestKiosk at;
    const PxBox handle = at.kiosk.desk().find(Part::split)->box;
    const double y = handle.top + 2;
    double x = handle.left + handle.width / 2.0;
    at.turn(PointerEvent{PointerPhase::down, 0, x, y});
    for (const double split : {0.3, 0.71, 0.0, 1.0}) {
        const PxBox scene = at.kiosk.desk().layout.scene;
        x = scene.left + split * scene.width;
        at.turn(PointerEvent{PointerPhase::move, 0, x, y});
        EXPECT_NEAR(at.state().split, split, 1e-9);
        expect_twin(at, lit(at.text, at.state()), 1);
    }
}

TEST(Picture, EachLampAndStrength) {
    TestKiosk at;
    for (int lamp = 0; lamp < 3; ++lamp) {
        at.tap(Part::lamp, lamp);
        at.settle();
        EXPECT_EQ(at.state().lamp, static_cast<std::size_t>(lamp));
        expect_twin(at, lit(at.text, at.state()));
    }
    const PxBox slider = at.kiosk.desk().find(Part::strength)->box;
    at.tap(slider.left + 0.2 * slider.width, slider.top + slider.height / 2.0);
    EXPECT_LT(at.state().strength, 0.5);
    expect_twin(at, lit(at.text, at.state()));
}

TEST(Picture, Supersampled) {
    TestKiosk at("[display]\nsupersample = 2\n" + patches());
    at.settle();
    expect_twin(at, lit(at.text, at.state()));
}

// On screens as they are: 1280x720 and below have room for it.
TEST(Picture, SupersamplingSmoothsEdges) {
    const auto picture = [](const std::string& supersample) {
        TestKiosk at("[display]\nsupersample = " + supersample +
                         "\n[atlas]\nquantization = thesis\n[scene]\n" +
                         "kind = loaf\nmaterials = cc-red\n[lamp.1]\nspectrum = E\n[compare]\n" +
                         "right.method = rgb\n[kiosk]\nlamps = E, F11\npixel_shift = 0\n",
                     {1280, 720});
        at.settle();
        return at.stage.read_rgba();
    };
    EXPECT_NE(picture("1"), picture("2"));
}

TEST(Picture, WithoutAComparison) {
    TestKiosk at("[atlas]\nquantization = thesis\n[scene]\nkind = patches\nmaterials = crayon-red, cc-cyan\n"
                 "[lamp.1]\nspectrum = F11\nstrength = 0.8\n[kiosk]\nlamps = E, F11\npixel_shift = 0\n");
    at.settle();
    expect_twin(at, lit(at.text, at.state()), 1);
}

TEST(Picture, WandersAgainstBurnIn) {
    TestKiosk at(patches("pixel_shift = 3\nidle_s = 3600\n"));
    std::set<std::pair<int, int>> places_of_picture;
    for (int minute = 0; minute < 24; ++minute) {
        const Shift walk = pixel_shift(at.stage.now_s(), 3);
        at.shift = {walk.x_px + 3, walk.y_px};
        places_of_picture.insert({at.shift.x_px, at.shift.y_px});
        if (minute % 5 == 0)
            expect_twin(at, lit(at.text, at.state()));
        const Seen8 seen(at);
        EXPECT_EQ(seen(0, 479).r, 20) << "the margin is ground";
        const long before = at.stage.frames_shown();
        at.pass(60);
        EXPECT_EQ(at.stage.frames_shown(), before + 1) << "a pixel a minute, and not a frame more";
    }
    EXPECT_EQ(places_of_picture.size(), 24u);
}

TEST(Picture, TouchesFollowTheShift) {
    TestKiosk at(patches("pixel_shift = 8\nidle_s = 3600\n"));
    at.pass(12 * 60);
    const Shift walk = pixel_shift(at.stage.now_s(), 8);
    at.shift = {walk.x_px + 8, walk.y_px};
    ASSERT_GT(at.shift.x_px, 12);
    const PxBox tile = at.kiosk.desk().find(Part::lamp, 1)->box;
    at.tap(tile.right() - 1 + at.shift.x_px, tile.bottom() - 1 + at.shift.y_px);
    EXPECT_EQ(at.state().lamp, 1u);
}

TEST(Picture, TheSplitHasALineBetweenItsHalves) {
    TestKiosk at;
    const Seen8 seen(at);
    const PxBox scene = at.kiosk.desk().layout.scene;
    const int column = scene.left + static_cast<int>(std::lround(0.5 * scene.width));
    EXPECT_EQ(text_of(seen(column, scene.top + 60)), "217 217 217");
    EXPECT_NE(text_of(seen(column + 4, scene.top + 60)), "217 217 217");
}

TEST(Picture, TheGroundIsOpaque) {
    TestKiosk at;
    const std::vector<std::uint8_t> rgba = at.stage.read_rgba();
    for (std::size_t i = 3; i < rgba.size(); i += 4)
        ASSERT_EQ(rgba[i], 255) << "at " << i / 4;
}

// What changes lies in the boxes of what changed: the panel, its button, the hint that makes room.
TEST(Picture, WordsStayInTheirBoxes) {
    TestKiosk at;
    at.settle();
    const Seen8 before(at);
    std::vector<PxBox> boxes{at.kiosk.desk().find(Part::hint)->box};
    at.tap(Part::expert);
    at.settle();
    for (const Part part : {Part::expert_panel, Part::expert, Part::hint})
        if (const Widget* widget = at.kiosk.desk().find(part))
            boxes.push_back(widget->box);
    const Seen8 after(at);
    int inside = 0;
    for (int y = 0; y < at.picture().height_px; ++y)
        for (int x = 0; x < at.picture().width_px; ++x) {
            if (before(x, y) == after(x, y))
                continue;
            ASSERT_TRUE(std::ranges::any_of(boxes, [&](const PxBox& box) { return box.contains(x, y); }))
                << x << ' ' << y;
            ++inside;
        }
    const PxBox panel = at.kiosk.desk().find(Part::expert_panel)->box;
    EXPECT_GT(inside, panel.width * panel.height / 2);
}

// Cards that match under daylight and part under a tube, whole in either half, and tapped what they are.
void expect_cards(TestKiosk& at) {
    const Play& play = at.kiosk.show().play();
    ASSERT_TRUE(play.side_by_side());
    const PxBox scene = at.kiosk.desk().layout.scene;
    const Seen8 seen(at);
    // The cards' middles: of all places that hit them.
    struct Middle {
        double x = 0, y = 0, hits = 0;
    };
    std::map<std::string, Middle> middles;
    for (double x = 0.005; x < 1; x += 0.01)
        for (double y = 0.005; y < 1; y += 0.01)
            if (const auto hit =
                    pick(play.renderer().scene(), play.exhibit(), x, y, 0.5 * scene.width / scene.height)) {
                Middle& middle = middles[play.exhibit().objects[hit->object].name];
                middle = {middle.x + x, middle.y + y, middle.hits + 1};
            }
    const auto card = [&](const std::string& name, int half) {
        const Middle& middle = middles.at(name);
        return seen(scene.left + static_cast<int>((half + middle.x / middle.hits) / 2 * scene.width),
                    scene.top + static_cast<int>(middle.y / middle.hits * scene.height));
    };
    EXPECT_LE(apart(card("card-a", 0), card("card-b", 0)), kMostSteps) << "they match under daylight";
    EXPECT_GT(apart(card("card-a", 1), card("card-b", 1)), 60) << "and part under the tube";
    EXPECT_GT(card("card-a", 0).g, 40) << "lit";
    // And tapped, each is what it is, in either half.
    for (const int half : {0, 1}) {
        const Middle& middle = middles.at("card-b");
        at.tap(scene.left + (half + middle.x / middle.hits) / 2 * scene.width,
               scene.top + middle.y / middle.hits * scene.height);
        ASSERT_TRUE(at.state().seen);
        EXPECT_EQ(play.exhibit().objects[at.state().seen->object].name, "card-b");
        EXPECT_THAT(at.kiosk.desk().find(Part::panel)->product->title,
                    testing::HasSubstr(all_words().text("en", "booth.card_b")));
        at.tap(Part::close);
    }
}

TEST(Picture, TheBoothShowsEachLampsCards) {
    TestKiosk at(patches(), {800, 480});
    at.tap(Part::mode);
    at.settle();
    expect_cards(at);
}

TEST(Picture, AnExhibitOfABoothShowsThemToo) {
    TestKiosk at(replaced(replaced(patches(), "kind = patches", "kind = booth"),
                          "left.method = tristimulus\nright.method = folded",
                          "left.method = auto\nleft.lamp = D65\nright.method = auto\nright.lamp = F11"),
                 {800, 480});
    at.settle();
    expect_cards(at);
}

TEST(Picture, TapsOpenWhatIsSeen) {
    TestKiosk at;
    const std::vector<Place> all = places(at);
    ASSERT_GT(all.size(), 100u);
    for (std::size_t i = 0; i < all.size(); i += all.size() / 12) {
        at.tap(all[i].x, all[i].y);
        ASSERT_TRUE(at.state().seen) << all[i].x << ' ' << all[i].y;
        EXPECT_EQ(at.state().seen->object, all[i].object);
        EXPECT_TRUE(at.kiosk.desk().find(Part::panel));
        at.tap(Part::close);
        ASSERT_FALSE(at.state().seen);
    }
}

} // namespace
} // namespace metamer
