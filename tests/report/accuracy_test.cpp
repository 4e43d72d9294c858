#include "report/accuracy.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "exhibit/load.h"
#include "report/chart_exhibits.h"

namespace metamer {
namespace {

using testing::Each;
using testing::Lt;
using testing::SizeIs;

constexpr const char* kLoaf = "[scene]\nkind = loaf\nmaterials = crayon-red, crayon-blue, crayon-red\n"
                              "[lamp.1]\nspectrum = F11\nstrength = 7\n[lamp.2]\nspectrum = A2800\n"
                              "[compare]\nleft.method = spectral\nright.method = rgb\n";

Exhibit parsed(const std::string& text) {
    return parse_exhibit(text, "the test", ".");
}

std::vector<double> values(const std::vector<PairDifference>& pairs) {
    std::vector<double> out;
    for (const PairDifference& pair : pairs)
        out.push_back(pair.delta_e);
    return out;
}

double mean(const std::vector<PairDifference>& pairs) {
    const auto all = values(pairs);
    return std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
}

double worst(const std::vector<PairDifference>& pairs) {
    const auto all = values(pairs);
    return *std::max_element(all.begin(), all.end());
}

TEST(AccuracyProbe, HasEveryLampWithEveryMaterialOnce) {
    const auto pairs = AccuracyProbe(parsed(kLoaf)).differences({Method::rgb});
    std::set<std::pair<std::string, std::string>> names;
    for (const PairDifference& pair : pairs)
        names.insert({pair.lamp, pair.material});
    EXPECT_THAT(pairs, SizeIs(4));
    EXPECT_EQ(names, (std::set<std::pair<std::string, std::string>>{{"F11", "crayon-red"},
                                                                    {"F11", "crayon-blue"},
                                                                    {"A2800", "crayon-red"},
                                                                    {"A2800", "crayon-blue"}}));
}

// Sums in double on the CPU are the reference; what is left is float's rounding.
TEST(AccuracyProbe, FoldedFromFullSpectraIsExact) {
    EXPECT_THAT(values(AccuracyProbe(parsed(kLoaf)).differences({Method::folded})), Each(Lt(1e-3)));
}

// DESIGN.md section 1: under equal energy three numbers and spectra agree.
TEST(AccuracyProbe, TristimulusIsExactUnderEqualEnergyAndNotUnderLines) {
    const Exhibit exhibit = parsed("[scene]\nkind = loaf\nmaterials = crayon-red, crayon-blue\n"
                                   "[lamp.1]\nspectrum = E\n[lamp.2]\nspectrum = F11\n");
    for (const PairDifference& pair : AccuracyProbe(exhibit).differences({Method::tristimulus}))
        if (pair.lamp == "E") {
            EXPECT_LT(pair.delta_e, 0.1) << pair.material;
        } else {
            EXPECT_GT(pair.delta_e, 1) << pair.material;
        }
}

TEST(AccuracyProbe, RoundingAndHalfPrecisionCostAccuracy) {
    const AccuracyProbe probe(parsed(kLoaf));
    for (const Method method : {Method::spectral, Method::packed, Method::folded}) {
        const Way best{method, 0, Precision::fp32, Levels::unquantized};
        Way rounded = best, half = best;
        rounded.levels = Levels::eight_bit;
        half.precision = Precision::fp16;
        EXPECT_GT(mean(probe.differences(rounded)), mean(probe.differences(best))) << method_name(method);
        EXPECT_GT(mean(probe.differences(half)), mean(probe.differences(best))) << method_name(method);
    }
}

TEST(AccuracyProbe, MoreTapsAreCloser) {
    const AccuracyProbe probe(parsed("[scene]\nkind = media\n[lamp.1]\nspectrum = D65\n"));
    EXPECT_GT(worst(probe.differences({Method::reduced, 4})),
              2 * worst(probe.differences({Method::reduced, 16})));
}

TEST(AccuracyProbe, NamesThicknessesAndRefusesWhatCannotBeDrawn) {
    const AccuracyProbe probe(parsed("[scene]\nkind = media\n[lamp.1]\nspectrum = D65\n"));
    EXPECT_THAT(probe.differences({Method::spectral}).back().material, testing::HasSubstr(" through "));
    EXPECT_THAT([&] { probe.differences({Method::folded}); },
                testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr("is a constant")));
}

TEST(AccuracyProbe, PlansForThePrecisionAsked) {
    const AccuracyProbe probe(parsed(kLoaf));
    EXPECT_EQ(probe.plan({}, AccuracyProbe::bits_of(Precision::fp16)).fragment_bits, 10);
    EXPECT_EQ(probe.plan({}, AccuracyProbe::bits_of(Precision::fp32)).fragment_bits, 23);
    EXPECT_THAT(probe.plan({}, 23).halves, SizeIs(1)) << "halves are dropped";
}

TEST(PairExhibits, HoldMorePairsThanAnAtlasDoes) {
    const auto lamps = library_lamps().subspan(0, 2);
    const auto materials = library_materials().subspan(0, 65);
    const auto exhibits = pair_exhibits(lamps, materials, Display{});
    ASSERT_THAT(exhibits, SizeIs(4));
    std::set<std::pair<std::string, std::string>> names;
    std::size_t count = 0;
    for (const Exhibit& exhibit : exhibits)
        for (const PairDifference& pair : AccuracyProbe(exhibit).differences({Method::tristimulus})) {
            names.insert({pair.lamp, pair.material});
            ++count;
        }
    EXPECT_EQ(count, 130u);
    EXPECT_THAT(names, SizeIs(130));
}

TEST(DrawnBy, ForgetsHalvesAndChoices) {
    Exhibit exhibit = parsed(kLoaf);
    exhibit.objects[0].method = Method::packed;
    const Exhibit all = drawn_by(exhibit, Method::reduced, 12);
    EXPECT_FALSE(all.compare);
    EXPECT_EQ(all.accuracy.method, Method::reduced);
    EXPECT_EQ(all.accuracy.taps, 12);
    EXPECT_FALSE(all.objects[0].method);
}

TEST(FromAtlasAlone, KnowsRowsOnly) {
    const Exhibit rows = from_atlas_alone(parsed(kLoaf));
    EXPECT_TRUE(rows.materials.empty());
    EXPECT_FALSE(rows.lamps[0].full_resolution);
    EXPECT_EQ(ExhibitSpectra(rows).material(1).full, nullptr);
}

} // namespace
} // namespace metamer
