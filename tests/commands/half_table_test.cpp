// metamer render --table: how far the two halves part, lamp by lamp.
#include <sstream>

#include "commands/command_test.h"

namespace metamer::test {
namespace {

struct Row {
    std::string lamp;
    double mean = -1, greatest = -1;
    std::string material;
};

class HalfTable : public CommandTest {
protected:
    /// The table's rows under its three lines of head.
    std::vector<Row> rows(std::vector<std::string> sets) const {
        std::vector<std::string> arguments = {"render", "--table", "--output", "x.png",
                                              "--size", "32x18",   "--set",    "display.adaptation=none"};
        for (const std::string& set : sets)
            arguments.insert(arguments.end(), {"--set", set});
        std::istringstream lines(output_of(arguments));
        std::string line;
        for (int i = 0; i < 3; ++i)
            std::getline(lines, line);
        EXPECT_EQ(line, "lamp          mean   greatest  material");
        std::vector<Row> out;
        while (std::getline(lines, line)) {
            Row& row = out.emplace_back();
            std::istringstream(line) >> row.lamp >> row.mean >> row.greatest >> row.material;
        }
        return out;
    }
};

TEST_F(HalfTable, HasARowForEachOfTheThesissLamps) {
    const std::vector<std::string> lamps = {"E",   "B",      "C",         "D4000",     "D55",
                                            "D65", "D25000", "moonlight", "A2800",     "A3200",
                                            "F2",  "F7",     "F11",       "white-LED", "krypton"};
    const auto table = rows({});
    ASSERT_EQ(table.size(), lamps.size());
    for (std::size_t i = 0; i < lamps.size(); ++i) {
        EXPECT_EQ(table[i].lamp, lamps[i]);
        EXPECT_GE(table[i].mean, 0);
        EXPECT_GE(table[i].greatest, table[i].mean);
        EXPECT_TRUE(table[i].material.starts_with("crayon-")) << table[i].material;
    }
    // Under equal energy both color models agree but for the grid's rounding; the lines of krypton part them
    // most.
    EXPECT_LT(table.front().greatest, 0.2);
    EXPECT_GT(table.back().greatest, 20);
    EXPECT_GT(table.back().mean, 10);
}

TEST_F(HalfTable, EqualHalvesAreEqual) {
    for (const Row& row : rows({"compare.left.method=spectral"})) {
        EXPECT_EQ(row.mean, 0) << row.lamp;
        EXPECT_EQ(row.greatest, 0) << row.lamp;
    }
}

// A half's own lamp stays: under its own lamp, D65, the other half differs from it by nothing, else by much.
TEST_F(HalfTable, AHalfsOwnLampStays) {
    const auto table = rows({"compare.left.method=spectral", "compare.left.lamp=D65"});
    for (const Row& row : table)
        if (row.lamp == "D65")
            EXPECT_EQ(row.greatest, 0);
        else
            EXPECT_GT(row.greatest, 1) << row.lamp;
}

TEST_F(HalfTable, OfOneMaterialMeanAndGreatestAreOne) {
    for (const Row& row : rows({"scene.materials=crayon-blue"})) {
        EXPECT_EQ(row.mean, row.greatest) << row.lamp;
        EXPECT_EQ(row.material, "crayon-blue");
    }
}

TEST_F(HalfTable, NeedsHalvesBeforeAnythingIsWritten) {
    write("whole.ini", "[scene]\nkind = patches\n");
    expect_failure(2, {"render", "whole.ini", "--table", "--output", "x.png"},
                   "cannot compare the halves of whole.ini: it has no section [compare]");
}

} // namespace
} // namespace metamer::test
