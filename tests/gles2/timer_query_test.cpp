#include "gles/timer_query.h"

#include "gles/extensions.h"
#include "gles2/gl_test.h"

namespace metamer {
namespace {

using TimerQueries = test::GlTest;

TEST_F(TimerQueries, AreThereWhereTheDriverHasThem) {
    EXPECT_LE(TimerQuery::create().has_value(), use_gl_extension("GL_EXT_disjoint_timer_query"));
}

TEST_F(TimerQueries, CanBeSwitchedOff) {
    const test::Environment off("METAMER_GL_EXTENSIONS", "none");
    EXPECT_FALSE(TimerQuery::create());
}

TEST_F(TimerQueries, TellATimeThatIsNotNegativeAgainAndAgain) {
    auto query = TimerQuery::create();
    if (!query)
        GTEST_SKIP() << "this driver has no timer";
    const Framebuffer target(64, 64);
    TimerQuery moved = std::move(*query);
    for (int i = 0; i < 3; ++i) {
        moved.begin();
        glClear(GL_COLOR_BUFFER_BIT);
        moved.end();
        if (const auto ms = moved.elapsed_ms()) {
            EXPECT_GE(*ms, 0);
        }
    }
}

} // namespace
} // namespace metamer
