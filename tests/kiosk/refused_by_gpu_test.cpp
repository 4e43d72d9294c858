// A GPU that takes no more programs, by a glLinkProgram of our own: small ones refuse what is too long for
// them.
#include <GLES2/gl2.h>
#include <dlfcn.h>
#include <gmock/gmock.h>
#include <limits>

#include "kiosk/kiosks.h"
#include "kiosk/twin.h"

namespace {

constexpr long kAll = std::numeric_limits<long>::max();
long takes = kAll, linked = 0;

} // namespace

extern "C" void GL_APIENTRY glLinkProgram(GLuint program) {
    static const auto link = reinterpret_cast<void (*)(GLuint)>(dlsym(RTLD_NEXT, "glLinkProgram"));
    if (linked++ < takes)
        link(program); // else GL_LINK_STATUS stays GL_FALSE
}

namespace metamer {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

class RefusedByGpu : public testing::Test {
protected:
    ~RefusedByGpu() override { takes = kAll; }
    static void take_only(long more) {
        linked = 0;
        takes = more;
    }
};

TEST_F(RefusedByGpu, AVisitorsWishIsPutBackWithANotice) {
    TestKiosk at;
    at.settle();
    take_only(0);
    at.tap(Part::mode);
    EXPECT_EQ(at.state().mode, Mode::methods) << "the booth's programs are too long";
    EXPECT_THAT(at.kiosk.notice(), HasSubstr("cannot"));
    EXPECT_THAT(at.lines.back(), HasSubstr("event=scene_refused error="));
    at.settle();
    expect_colors(at, lit(at.text, at.state()));
    take_only(kAll);
    at.tap(Part::mode);
    EXPECT_EQ(at.state().mode, Mode::booth);
    EXPECT_EQ(at.kiosk.notice(), "");
}

TEST_F(RefusedByGpu, AWatchIsGoneWithout) {
    TestKiosk at;
    at.settle();
    take_only(kAll);
    at.turn(ReloadEvent{});
    at.settle();
    take_only(linked);
    at.text = patches("watch_s = 5\n");
    at.turn(ReloadEvent{});
    at.settle();
    EXPECT_THAT(at.lines, Contains(HasSubstr("event=watch_off error=")));
    EXPECT_THAT(at.lines, Not(Contains(HasSubstr("reload_refused")))) << "the exhibit is shown";
    EXPECT_EQ(at.kiosk.notice(), "");
    at.pass(20);
    expect_colors(at, lit(at.text, at.state()));
}

TEST_F(RefusedByGpu, AtTheStartIsAnError) {
    take_only(0);
    EXPECT_THROW(TestKiosk(), Error);
}

} // namespace
} // namespace metamer
