#include <cmath>
#include <gmock/gmock.h>
#include <map>
#include <set>

#include "report/picture.h"
#include "report/stability.h"
#include "report/stability_groups.h"
#include "spectra/library.h"

namespace metamer {
namespace {

using ::testing::ContainsRegex;
using ::testing::ElementsAreArray;
using ::testing::Ge;
using ::testing::HasSubstr;
using ::testing::Le;

const std::vector<Experiment>& all() {
    static const std::vector<Experiment> experiments = stability_experiments();
    return experiments;
}

// One experiment by itself: each test is a process, and all of them take long under sanitizers.
const Experiment& once(Experiment (*run)()) {
    static std::map<Experiment (*)(), Experiment> done;
    const auto found = done.find(run);
    return found != done.end() ? found->second : done.emplace(run, run()).first->second;
}

Experiment green_line() {
    return line_position("green", 540, 550);
}
Experiment yellow_line() {
    return line_position("yellow", 580, 595);
}

// The difference of a method at the point nearest to x.
double at(const Experiment& e, double x, const std::string& method) {
    const auto nearest =
        std::min_element(e.points.begin(), e.points.end(),
                         [&](const auto& a, const auto& b) { return std::abs(a.x - x) < std::abs(b.x - x); });
    return nearest->delta_e.at(method);
}

double greatest(const Experiment& e, const std::string& method) {
    double most = 0;
    for (const ExperimentPoint& point : e.points)
        most = std::max(most, point.delta_e.at(method));
    return most;
}

void expect_every_experiment_of_the_issue() {
    std::vector<std::string> names;
    for (const Experiment& e : all())
        names.push_back(e.name);
    EXPECT_THAT(names, ElementsAreArray({"Width of a lamp's band",
                                         "Position of a line, green",
                                         "Position of a line, yellow",
                                         "Wavelengths under line lamps",
                                         "Bands of a reflectance",
                                         "Spacing of two bands",
                                         "Dark materials",
                                         "Dim rows of the atlas",
                                         "Bits of a level",
                                         "Filtering between rows",
                                         "Order of a sum in half precision",
                                         "Keys in half precision",
                                         "Coordinates in half precision",
                                         "Strength of the light",
                                         "Violet lamps with next to no Y",
                                         "Red lamps with next to no Y",
                                         "Two bounces under sodium",
                                         "Thickness of a medium",
                                         "Near-singular matrices",
                                         "The white of CIELAB",
                                         "Colors outside the working space"}));
}

void expect_curves_that_ascend_and_are_numbers() {
    for (const Experiment& e : all()) {
        SCOPED_TRACE(e.name);
        ASSERT_THAT(e.points.size(), Ge(5u));
        for (std::size_t i = 0; i < e.points.size(); ++i) {
            EXPECT_TRUE(std::isfinite(e.points[i].x));
            if (i > 0) {
                EXPECT_LT(e.points[i - 1].x, e.points[i].x);
            }
            EXPECT_EQ(e.points[i].delta_e.size(), e.points[0].delta_e.size());
            for (const auto& [method, difference] : e.points[i].delta_e) {
                EXPECT_TRUE(std::isfinite(difference)) << method << " at " << e.points[i].x;
                EXPECT_GE(difference, 0) << method;
            }
        }
        for (const std::string& text : {e.group, e.finding, e.swept, e.guard})
            EXPECT_FALSE(text.empty());
    }
}

TEST(Stability, SweepsReachWhatTheIssueAsksFor) {
    const auto range = [](Experiment (*run)()) {
        const Experiment& e = once(run);
        return std::pair(e.points.front().x, e.points.back().x);
    };
    const auto near = [](double low, double high) {
        return ::testing::Pair(::testing::DoubleNear(low, 1e-9 * high),
                               ::testing::DoubleNear(high, 1e-9 * high));
    };
    EXPECT_THAT(range(line_width), near(0.1, 100));
    EXPECT_THAT(range(strength), near(1e-4, 1e4));
    EXPECT_THAT(range(dark_materials), near(0.001, 1));
    EXPECT_THAT(range(dim_rows), near(1, 50));
    EXPECT_THAT(range(level_bits), near(4, 8));
    EXPECT_THAT(range(key_precision), near(1, 255));
    EXPECT_THAT(range(thickness), near(0, 6));
    const Experiment& line = once(yellow_line);
    EXPECT_NEAR(line.points[1].x - line.points[0].x, 0.1, 1e-9);
}

// A method is among the failures exactly if its curve leaves the limit, and fails where it does so.
void expect_failures_that_agree_with_the_curves() {
    for (const Experiment& e : all()) {
        std::map<std::string, double> fails;
        for (const Failure& fail : e.fails) {
            EXPECT_TRUE(fails.emplace(fail.method, fail.at).second)
                << e.name << ": " << fail.method << " twice";
            EXPECT_FALSE(fail.why.empty()) << e.name;
        }
        for (const auto& [method, unused] : e.points.front().delta_e) {
            SCOPED_TRACE(e.name + ": " + method);
            ASSERT_EQ(greatest(e, method) > kFailsAbove, fails.contains(method));
            if (!fails.contains(method))
                continue;
            const double place = fails.at(method);
            double beside = 0; // the greater of the points around the failure
            for (std::size_t i = 0; i < e.points.size(); ++i) {
                const bool above_before = i + 1 == e.points.size() || place <= e.points[i + 1].x;
                const bool below_next = i == 0 || place >= e.points[i - 1].x;
                if (above_before && below_next)
                    beside = std::max(beside, e.points[i].delta_e.at(method));
            }
            EXPECT_GT(beside, kFailsAbove) << "at " << place;
        }
        EXPECT_THAT(fails.size(), Le(e.points.front().delta_e.size()));
    }
}

// What the guards are for, each against what it replaces.
TEST(Guards, EnergyOfALineIsSharedByTwoIntervals) {
    for (Experiment (*const line)() : {&green_line, &yellow_line})
        EXPECT_LT(greatest(once(line), "spectral"), 0.5 * greatest(once(line), "spectral, nearest interval"));
    const Experiment& width = once(line_width);
    EXPECT_LT(at(width, 0.1, "spectral"), 0.5 * at(width, 0.1, "spectral, point samples"));
}

void expect_folded_to_hold_whatever_the_spectra() {
    for (const Experiment& e : all())
        if (e.points.front().delta_e.contains("folded") && e.name != "Strength of the light") {
            EXPECT_LT(greatest(e, "folded"), 0.001) << e.name;
        }
}

TEST(Guards, RowsAtFullScaleDoNotDim) {
    const Experiment& dim = once(dim_rows);
    EXPECT_GT(at(dim, 50, "spectral, lamp's row dim"), 5);
    EXPECT_GT(at(dim, 50, "spectral, material's row dim"), 5);
    EXPECT_LT(at(dim, 50, "spectral"), 0.5);
    const Experiment& dark = once(dark_materials);
    EXPECT_GT(at(dark, 0.01, "spectral, rows not scaled"), 2);
    EXPECT_LT(greatest(dark, "spectral"), 0.5);
}

TEST(Guards, LevelsChosenTogetherBeatThoseRoundedOneByOne) {
    for (const ExperimentPoint& point : once(level_bits).points)
        EXPECT_LE(point.delta_e.at("spectral"), point.delta_e.at("spectral, rounded one by one")) << point.x;
}

TEST(Guards, PartialSumsBearAGpuThatCuts) {
    const Experiment& order = once(summation_order);
    const std::string cuts = "spectral in fp16 that cuts";
    EXPECT_LT(at(order, 4, cuts), 0.5 * at(order, 64, cuts));
    EXPECT_DOUBLE_EQ(at(order, 1, cuts), at(order, 64, cuts)) << "both are one sum of 64";
}

TEST(Guards, KeysAreRoundedAndTablesSmall) {
    const Experiment& keys = once(key_precision);
    EXPECT_GT(greatest(keys, "key cut, GPU that cuts"), 10);
    EXPECT_EQ(greatest(keys, "key rounded, GPU that cuts"), 0);
    const Experiment& texels = once(texel_precision);
    EXPECT_EQ(at(texels, 256, "coordinate in fp16"), 0);
    EXPECT_GT(at(texels, 2048, "coordinate in fp16"), 10);
}

TEST(Guards, TheNearestRowIsReadWithinHalfARow) {
    const Experiment& rows = once(row_filtering);
    EXPECT_LT(at(rows, 0.49, "spectral"), 0.1);
    EXPECT_GT(at(rows, 0.02, "spectral, linear filter"), 1);
}

TEST(Guards, KeepHueKeepsTooMuchLightFromTurning) {
    const Experiment& strength_of_light = once(strength);
    EXPECT_GT(at(strength_of_light, 10, "folded, gamut = clip"), 10);
    EXPECT_LT(greatest(strength_of_light, "folded"), 1) << "what is left are steps of 8 bits";
    const Experiment& outside = once(outside_gamut);
    double clip = 0, keep = 0;
    for (const ExperimentPoint& point : outside.points) {
        clip += point.also.at("hue_turn_deg_clip");
        keep += point.also.at("hue_turn_deg_keep_hue");
    }
    EXPECT_LT(keep, clip);
}

TEST(Guards, TheDisplaysWhiteBearsLineLamps) {
    const Experiment& white = once(lightness_white);
    EXPECT_GT(at(white, 0.1, "the lamp's white"), 30);
    EXPECT_LT(greatest(white, "the display's white"), 1);
}

TEST(Outside, CountsPatchesPerLampOfTheLibrary) {
    const Experiment& outside = once(outside_gamut);
    std::set<std::string> names;
    for (std::size_t i = 0; i < outside.points.size(); ++i) {
        const ExperimentPoint& point = outside.points[i];
        EXPECT_EQ(point.x, static_cast<double>(i + 1));
        if (i > 0) {
            EXPECT_LE(outside.points[i - 1].also.at("outside"), point.also.at("outside"));
        }
        EXPECT_LE(point.also.at("outside"), point.also.at("materials"));
        names.insert(point.name);
    }
    EXPECT_EQ(names.size(), library_lamps().size());
    EXPECT_EQ(outside.points.back().name, "NIST-LPS") << "light of one wavelength puts all colors outside";
    EXPECT_EQ(outside.points.back().also.at("outside"), 24);
}

void expect_text_that_fits_a_terminal() {
    const std::string text = stability_text(all());
    std::size_t begin = 0;
    for (std::size_t end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
        EXPECT_LE(end - begin, 100u) << text.substr(begin, end - begin);
    EXPECT_EQ(begin, text.size()) << "ends in a line break";
}

TEST(StabilityText, HoldsEveryFailureAndTheGuard) {
    const Experiment one{.name = "N",
                         .finding = "found",
                         .swept = "s",
                         .unit = "nm",
                         .points = {{1, {{"m", 2}, {"n", 0}}}, {2, {{"m", 3}, {"n", 0}}}},
                         .fails = {{"m", 1, "because"}},
                         .guard = "guarded"};
    EXPECT_EQ(stability_text({{one}}),
              "Where each method fails: its CIEDE2000 against the reference exceeds 1.\n"
              "\nN: found\n  swept: s, 1 .. 2 nm\n  m fails at 1 nm: because\n  holds throughout: n\n"
              "  guard: guarded\n");
}

TEST(StabilityCsv, HasALinePerPointAndMethod) {
    const Experiment one{
        .name = "a, \"b\"", .swept = "s", .unit = "nm", .points = {{0.1, {{"m", 2}, {"n, o", 1e-7}}, "p"}}};
    EXPECT_EQ(stability_csv({{one}}), "experiment,swept,unit,x,point,method,delta_e_2000\n"
                                      "\"a, \"\"b\"\"\",s,nm,0.1,p,m,2\n"
                                      "\"a, \"\"b\"\"\",s,nm,0.1,p,\"n, o\",1e-07\n");
}

void expect_a_line_per_point_and_method() {
    std::size_t lines = 1;
    for (const Experiment& e : all())
        for (const ExperimentPoint& point : e.points)
            lines += point.delta_e.size();
    const std::string text = stability_csv(all());
    EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')), lines);
}

void expect_a_page_per_group_with_every_label_placed() {
    std::set<std::string> groups;
    for (const Experiment& e : all())
        groups.insert(e.group);
    const auto pages = stability_pages(all());
    EXPECT_EQ(pages.size(), groups.size());
    std::size_t plots = 0;
    for (const StabilityPage& page : pages) {
        EXPECT_THAT(page.file, ContainsRegex("^stability-[a-z-]+$"));
        EXPECT_EQ(unplaced_labels(page.picture), 0) << page.file;
        plots += page.picture.plots.size();
    }
    EXPECT_EQ(plots, all().size());
    EXPECT_THAT(pages.front().picture.plots.front().title, HasSubstr(all().front().finding));
    EXPECT_TRUE(stability_pages({}).empty());
}

TEST(Stability, IsWhole) {
    expect_every_experiment_of_the_issue();
    expect_curves_that_ascend_and_are_numbers();
    expect_failures_that_agree_with_the_curves();
    expect_folded_to_hold_whatever_the_spectra();
    expect_text_that_fits_a_terminal();
    expect_a_line_per_point_and_method();
    expect_a_page_per_group_with_every_label_placed();
}

TEST(Stability, IsTheSameEveryTime) {
    for (Experiment (*const run)() : {&level_bits, &matrix_condition, &tap_counts}) {
        const Experiment again = run();
        const Experiment& before = once(run);
        EXPECT_EQ(stability_csv({{again}}), stability_csv({{before}}));
        EXPECT_EQ(again.finding, before.finding);
    }
}

} // namespace
} // namespace metamer
