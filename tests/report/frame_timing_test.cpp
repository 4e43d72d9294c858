#include "report/frame_timing.h"

#include <gmock/gmock.h>

#include <set>

namespace metamer {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::SizeIs;

// A clock of a test's own: calls are told apart by the order they come in, no time passes.
TEST(TimeRounds, DrawsEachFrameOnceARoundInChangingOrder) {
    std::vector<int> drawn;
    const std::vector<std::function<void()>> frames{[&] { drawn.push_back(0); }, [&] { drawn.push_back(1); },
                                                    [&] { drawn.push_back(2); }};
    double now = 0;
    const auto ms = time_rounds(frames, 8, [&](const std::function<void()>& draw) {
        draw();
        return ++now;
    });
    ASSERT_THAT(drawn, SizeIs(27)) << "eight rounds and one to warm up";
    std::set<std::vector<int>> orders;
    for (std::size_t round = 0; round < 9; ++round) {
        const std::vector<int> order(drawn.begin() + static_cast<std::ptrdiff_t>(3 * round),
                                     drawn.begin() + static_cast<std::ptrdiff_t>(3 * round + 3));
        EXPECT_THAT(order, testing::UnorderedElementsAre(0, 1, 2));
        orders.insert(order);
    }
    EXPECT_GT(orders.size(), 2u);
    // Every frame has its own times, round by round, the warming up not among them.
    ASSERT_THAT(ms, SizeIs(3));
    EXPECT_THAT(ms, Each(SizeIs(8)));
    for (std::size_t frame = 0; frame < 3; ++frame)
        for (std::size_t round = 0; round < 8; ++round) {
            const auto call = static_cast<std::size_t>(ms[frame][round]) - 1;
            EXPECT_EQ(call / 3, round + 1);
            EXPECT_EQ(drawn[call], static_cast<int>(frame));
        }
}

TEST(TimeRounds, AreTheSameOnEveryRun) {
    const auto order = [] {
        std::vector<int> drawn;
        const std::vector<std::function<void()>> frames{[&] { drawn.push_back(0); },
                                                        [&] { drawn.push_back(1); }};
        time_rounds(frames, 20, [](const std::function<void()>& draw) {
            draw();
            return 1.0;
        });
        return drawn;
    };
    EXPECT_EQ(order(), order());
}

TEST(Ratios, AreRoundByRound) {
    EXPECT_THAT(ratios(std::vector<double>{2, 9}, std::vector<double>{4, 3}), ElementsAre(0.5, 3));
}

} // namespace
} // namespace metamer
