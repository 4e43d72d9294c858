#include "gles/surfaceless.h"

#include <GLES2/gl2.h>
#include <cstdio>
#include <gmock/gmock.h>
#include <optional>
#include <unistd.h>

#include "base/error.h"
#include "gles2/gl_test.h"

namespace metamer {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string gl_text(GLenum name) {
    const GLubyte* value = glGetString(name);
    return value == nullptr ? "no context" : reinterpret_cast<const char*>(value);
}

TEST(Surfaceless, GivesACurrentEs2Context) {
    const Surfaceless gl;
    EXPECT_THAT(gl_text(GL_VERSION), StartsWith("OpenGL ES "));
    EXPECT_NE(eglGetCurrentContext(), EGL_NO_CONTEXT);
}

/// The suite runs again under other drivers and versions (CMakeLists.txt): this says that they really came.
TEST(Surfaceless, IsWhatTheEnvironmentAsksFor) {
    const Surfaceless gl;
    if (const char* driver = std::getenv("GALLIUM_DRIVER")) {
        EXPECT_THAT(gl_text(GL_RENDERER), HasSubstr(driver));
    }
    if (const char* version = std::getenv("MESA_GLES_VERSION_OVERRIDE")) {
        EXPECT_THAT(gl_text(GL_VERSION), StartsWith("OpenGL ES " + std::string(version)));
    }
}

TEST(Surfaceless, UsesAPbufferWithoutExtensions) {
    const test::Environment off("METAMER_GL_EXTENSIONS", "none");
    const Surfaceless gl;
    EXPECT_NE(eglGetCurrentSurface(EGL_DRAW), EGL_NO_SURFACE);
    EXPECT_THAT(gl_text(GL_VERSION), StartsWith("OpenGL ES "));
}

TEST(Surfaceless, NeedsNoSurfaceWithExtensions) {
    const test::Environment on("METAMER_GL_EXTENSIONS", nullptr);
    const Surfaceless gl;
    EXPECT_EQ(eglGetCurrentSurface(EGL_DRAW), EGL_NO_SURFACE);
}

TEST(Surfaceless, LeavesNothingCurrent) {
    { const Surfaceless gl; }
    EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
}

TEST(Surfaceless, OneEndsAndTheOtherLives) {
    const Surfaceless first;
    std::optional<Surfaceless> second(std::in_place);
    second.reset();
    first.make_current();
    EXPECT_THAT(gl_text(GL_VERSION), StartsWith("OpenGL ES "));
}

TEST(Surfaceless, Moves) {
    Surfaceless first;
    EGLContext context = eglGetCurrentContext();
    Surfaceless second(std::move(first));
    EXPECT_EQ(eglGetCurrentContext(), context);
    Surfaceless third;
    EXPECT_NE(eglGetCurrentContext(), context);
    third = std::move(second);
    third.make_current();
    EXPECT_EQ(eglGetCurrentContext(), context);
}

TEST(Surfaceless, OpensFiftyTimes) {
    for (int i = 0; i < 50; ++i) {
        const Surfaceless gl;
        ASSERT_THAT(gl_text(GL_VERSION), StartsWith("OpenGL ES "));
    }
}

TEST(SurfacelessDeathTest, NamesEveryDisplayTriedWhereThereIsNoDriver) {
    testing::FLAGS_gtest_death_test_style =
        "threadsafe"; // a fresh process, in which EGL has not looked around yet
    const auto open = [] {
        setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere.json", 1);
        try {
            const Surfaceless gl;
        } catch (const Error& error) {
            std::fprintf(stderr, "%s\n", error.what());
            _exit(static_cast<int>(error.status()));
        }
        _exit(0);
    };
    EXPECT_EXIT(
        open(), testing::ExitedWithCode(3),
        "cannot open an OpenGL ES 2 context: surfaceless platform: .*; first device: .*; default display: ");
}

} // namespace
} // namespace metamer
