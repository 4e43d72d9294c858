#include "gles/info.h"

#include <gmock/gmock.h>

#include "gles/precision_probe.h"
#include "gles2/gl_test.h"

namespace metamer {
namespace {

using testing::StartsWith;

using Info = test::GlTest;

TEST_F(Info, NamesTheDriver) {
    const GlInfo info = gl_info();
    EXPECT_NE(info.vendor, "");
    EXPECT_NE(info.renderer, "");
    EXPECT_THAT(info.version, StartsWith("OpenGL ES "));
    EXPECT_THAT(info.shading_language, StartsWith("OpenGL ES GLSL ES "));
    EXPECT_FALSE(info.extensions.empty());
}

/// The floors of OpenGL ES 2.0.25 tables 6.18 to 6.20.
TEST_F(Info, ReportsAtLeastTheFloorsOfEs2) {
    const GlLimits limits = gl_info().limits;
    EXPECT_GE(limits.max_fragment_uniform_vectors, 16);
    EXPECT_GE(limits.max_vertex_uniform_vectors, 128);
    EXPECT_GE(limits.max_varying_vectors, 8);
    EXPECT_GE(limits.max_vertex_attribs, 8);
    EXPECT_GE(limits.max_texture_image_units, 8);
    EXPECT_GE(limits.max_vertex_texture_image_units, 0);
    EXPECT_GE(limits.max_combined_texture_image_units, 8);
    EXPECT_GE(limits.max_texture_size_px, 64);
    EXPECT_GE(limits.max_renderbuffer_size_px, 1);
    EXPECT_GE(limits.max_viewport_width_px, 64);
    EXPECT_GE(limits.max_viewport_height_px, 64);
}

/// GLSL ES 1.00.17 section 4.5.2: mediump has at least 10 bits and 2^14, lowp 8 bits and 2.
TEST_F(Info, ReportsAtLeastTheFloorsOfPrecision) {
    const GlInfo info = gl_info();
    EXPECT_GE(info.lowp.reported_bits, 8);
    EXPECT_GE(info.mediump.reported_bits, 10);
    EXPECT_GE(info.mediump.range_min_log2, 14);
    EXPECT_GE(info.mediump.range_max_log2, 14);
}

TEST_F(Info, HasWhatTheProbeMeasures) {
    const GlInfo info = gl_info();
    EXPECT_EQ(info.measured_mediump_bits, measured_fragment_bits(Precision::mediump));
    EXPECT_EQ(info.measured_highp_bits, measured_fragment_bits(Precision::highp));
}

} // namespace
} // namespace metamer
