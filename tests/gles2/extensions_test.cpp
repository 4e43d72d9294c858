#include "gles/extensions.h"

#include <gmock/gmock.h>

#include "gles2/gl_test.h"

namespace metamer {
namespace {

using testing::Contains;
using testing::IsEmpty;
using testing::Not;

TEST(ListedExtension, IsAWholeName) {
    const test::Environment on("METAMER_GL_EXTENSIONS", nullptr);
    EXPECT_TRUE(use_listed_extension("EGL_a EGL_ab", "EGL_ab"));
    EXPECT_TRUE(use_listed_extension("EGL_ab EGL_a ", "EGL_a"));
    EXPECT_FALSE(use_listed_extension("EGL_ab", "EGL_a"));
    EXPECT_FALSE(use_listed_extension("", "EGL_a"));
    EXPECT_FALSE(use_listed_extension(nullptr, "EGL_a"));
}

TEST(ListedExtension, CanBeSwitchedOff) {
    const test::Environment off("METAMER_GL_EXTENSIONS", "none");
    EXPECT_FALSE(use_listed_extension("EGL_a", "EGL_a"));
}

using Extensions = test::GlTest;

TEST_F(Extensions, ArePresentOneByOne) {
    EXPECT_THAT(present_gl_extensions(), Contains("GL_OES_rgb8_rgba8")); // every Mesa since 2010
    EXPECT_THAT(present_gl_extensions(), Not(Contains("")));
}

TEST_F(Extensions, AreUsedWhereKnownAndPresent) {
    const test::Environment on("METAMER_GL_EXTENSIONS", nullptr);
    EXPECT_TRUE(use_gl_extension("GL_OES_rgb8_rgba8"));
    EXPECT_FALSE(use_gl_extension("GL_OES_rgb8"));
    EXPECT_THAT(used_gl_extensions(), Contains("GL_OES_rgb8_rgba8"));
    EXPECT_THAT(present_gl_extensions(), testing::IsSupersetOf(used_gl_extensions()));
}

TEST_F(Extensions, CanAllBeSwitchedOff) {
    const test::Environment off("METAMER_GL_EXTENSIONS", "none");
    EXPECT_FALSE(use_gl_extension("GL_OES_rgb8_rgba8"));
    EXPECT_THAT(used_gl_extensions(), IsEmpty());
    EXPECT_THAT(present_gl_extensions(), Not(IsEmpty()));
}

} // namespace
} // namespace metamer
