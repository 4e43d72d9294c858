#include "gles/check.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "gles2/gl_test.h"

namespace metamer {
namespace {

using Check = test::GlTest;

TEST_F(Check, SaysNothingWithoutAnError) {
    EXPECT_NO_THROW(throw_on_gl_error("draw", "the loaf"));
}

TEST_F(Check, NamesTheErrorAndClearsIt) {
    glEnable(0xffff);
    try {
        throw_on_gl_error("draw", "the loaf");
        FAIL() << "not thrown";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "cannot draw the loaf: GL_INVALID_ENUM");
        EXPECT_EQ(error.status(), Exit::failure);
    }
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(CheckNames, KnowsTheErrorsOfEs2) {
    EXPECT_EQ(gl_error_name(GL_INVALID_FRAMEBUFFER_OPERATION), "GL_INVALID_FRAMEBUFFER_OPERATION");
    EXPECT_EQ(gl_error_name(GL_OUT_OF_MEMORY), "GL_OUT_OF_MEMORY");
    EXPECT_EQ(gl_error_name(0x0503), "GL error 0x0503");
}

TEST(CheckNames, KnowsTheStatusesOfEs2) {
    EXPECT_EQ(framebuffer_status_name(GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT),
              "GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT");
    EXPECT_EQ(framebuffer_status_name(GL_FRAMEBUFFER_UNSUPPORTED), "GL_FRAMEBUFFER_UNSUPPORTED");
    EXPECT_EQ(framebuffer_status_name(0x8cdb), "framebuffer status 0x8cdb");
}

} // namespace
} // namespace metamer
