#include "gles/precision_probe.h"

#include <cmath>
#include <gmock/gmock.h>

#include "gles/mesh.h"
#include "gles2/gl_test.h"

namespace metamer {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::Ge;
using testing::Le;

using PrecisionProbe = test::GlTest;

/// Whether the fragment shader tells 2^bits + 1 from its even neighbors: it takes `bits` bits behind the
/// leading one.
bool tells_odd_from_even(const std::string& precision, int bits) {
    const Framebuffer target(1, 1);
    const std::string fragment = "precision " + precision +
                                 " float;\nvarying vec2 v_uv;\nuniform float u_power;\n" +
                                 "void main() {\n    float odd = u_power + floor(v_uv.x) + 1.0;\n" +
                                 "    gl_FragColor = vec4(fract(odd * 0.5) == 0.5 ? 1.0 : 0.0);\n}\n";
    const ShaderFiles files = test::files_of({{"pass.vert", test::kPassVertex}, {"odd.frag", fragment}});
    const Program program(compose_shader("pass.vert", {}, files), compose_shader("odd.frag", {}, files),
                          kMeshAttributes);
    program.set("u_power", std::ldexp(1.0F, bits));
    Mesh(test::rectangle(-1, -1, 1, 1)).draw();
    return test::pixel(target.read_rgba(), 1, 0, 0)[0] == 255;
}

/// IEEE single: 1 + 2^-23 > 1, and 1 + 2^-24 only where that tie is rounded up.
TEST_F(PrecisionProbe, FindsSinglePrecisionInHighp) {
    EXPECT_THAT(measured_fragment_bits(Precision::highp), AllOf(Ge(23), Le(24)));
}

/// Mesa's llvmpipe computes mediump in half precision where the processor converts it (F16C), softpipe in
/// single.
TEST_F(PrecisionProbe, FindsHalfOrSinglePrecisionInMediump) {
    EXPECT_THAT(measured_fragment_bits(Precision::mediump), AnyOf(10, 11, 23, 24));
}

/// A second opinion, by counting instead of by fractions.
TEST_F(PrecisionProbe, AgreesWithTheGreatestOddNumber) {
    const int mediump = measured_fragment_bits(Precision::mediump),
              highp = measured_fragment_bits(Precision::highp);
    EXPECT_TRUE(tells_odd_from_even("mediump", mediump)) << mediump;
    EXPECT_FALSE(tells_odd_from_even("mediump", mediump + 1)) << mediump;
    EXPECT_TRUE(tells_odd_from_even("highp", highp)) << highp;
    EXPECT_FALSE(tells_odd_from_even("highp", highp + 1)) << highp;
}

TEST_F(PrecisionProbe, DoesNotDependOnWhatWasDrawnBefore) {
    const int bits = measured_fragment_bits(Precision::mediump);
    const Framebuffer other(3, 3);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(measured_fragment_bits(Precision::mediump), bits);
}

} // namespace
} // namespace metamer
