#include "kiosk/outlet.h"

#include <gmock/gmock.h>

#include "window/event_text.h"
#include "window/surfaceless_stage.h"

namespace metamer {
namespace {

using test::texts;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(Outlet, TellsTheStage) {
    SurfacelessStage stage(8, 8);
    Outlet outlet;
    outlet.lead_to(stage);
    EXPECT_THAT(stage.wait(0), IsEmpty());
    outlet.tell(Outside::changed);
    outlet.tell(Outside::reload);
    EXPECT_FALSE(outlet.quit());
    outlet.tell(Outside::quit);
    EXPECT_TRUE(outlet.quit());
    EXPECT_THAT(texts(stage.wait(0)), ElementsAre("files changed", "reload", "quit"));
}

TEST(Outlet, KeepsWhatComesBeforeTheStage) {
    for (const Outside what : {Outside::changed, Outside::reload}) {
        SurfacelessStage stage(8, 8);
        Outlet outlet;
        outlet.tell(what);
        outlet.tell(what);
        outlet.lead_to(stage);
        EXPECT_THAT(texts(stage.wait(0)), ElementsAre("files changed")) << "once";
        outlet.tell(Outside::reload);
        EXPECT_THAT(texts(stage.wait(0)), ElementsAre("reload"));
    }
}

TEST(Outlet, AnEndBeforeTheStageIsAskedFor) {
    SurfacelessStage stage(8, 8);
    Outlet outlet;
    outlet.tell(Outside::quit);
    EXPECT_TRUE(outlet.quit());
    outlet.lead_to(stage);
    EXPECT_THAT(stage.wait(0), IsEmpty());
}

} // namespace
} // namespace metamer
