// Each guard against what is no number is needed: without it extremes_test.cpp would fail.
#include <gtest/gtest.h>

#include "frames/extremes.h"
#include "frames/stage.h"
#include "gles/precision_probe.h"

namespace metamer {
namespace {

struct Guard {
    const char* name;
    Edit away; ///< what the shader says without it
    Method method;
    Surface surface;
    const char* lamps;
    std::optional<Place> place;
    bool mediump;
};

const Guard kGuards[] = {
    {"the bound of light before a matrix",
     {"return clamp(light, -MOST_LIGHT, MOST_LIGHT);", "return light;"},
     Method::tristimulus,
     Surface::plain,
     kOneLamp,
     {},
     true},
    {"the bound of a lamp's part",
     {"return bounded(light);", "return light;"},
     Method::rgb,
     Surface::plain,
     kTwoLamps,
     kPlaces[6],
     true},
    {"the least k'", {", LEAST_K)", ", 0.0)"}, Method::spectral, Surface::plain, kVioletLamp, {}, false},
    {"the least falloff",
     {", LEAST_FALLOFF)", ", 0.0)"},
     Method::folded,
     Surface::plain,
     kOneLamp,
     kPlaces[4],
     true},
    {"the least distance",
     {"max(dot(ray, ray), LEAST_LENGTH_SQUARED)", "dot(ray, ray)"},
     Method::folded,
     Surface::plain,
     kOneLamp,
     kPlaces[3],
     false},
    {"the share of infinite fading",
     {"share > 0.0 ? share * fading : 0.0", "share * fading"},
     Method::folded,
     Surface::plain,
     kOneLamp,
     kPlaces[5],
     true},
    {"the least transmittance of one wavelength",
     {"max(second, LEAST_TRANSMITTANCE)", "second"},
     Method::spectral,
     Surface::medium,
     kOneLamp,
     {},
     false},
    {"the least transmittance of four",
     {"max(second, LEAST_TRANSMITTANCE)", "second"},
     Method::packed,
     Surface::medium,
     kOneLamp,
     {},
     false},
};

// The tests above would miss nothing: without a guard there is something that is no number.
TEST(ExtremeGuards, AreNeeded) {
    Stage stage;
    for (const Guard& guard : kGuards) {
        if (guard.mediump && measured_fragment_bits(Precision::mediump) > 10)
            continue; // this driver computes in more than half precision whatever is asked for
        Subject subject(guard.surface, guard.method, guard.lamps);
        subject.object().thickness = 0;
        subject.object().specular = 1;
        if (guard.place)
            put(subject.exhibit, *guard.place);
        set_strengths(subject.exhibit, kBright);
        const FragmentEdits edits{.mediump = guard.mediump, .watched = true, .others = {guard.away}};
        EXPECT_GT(not_numbers(stage.draw(subject.exhibit, subject.draws(), edits)), 0) << guard.name;
    }
}

// Uniforms beyond half precision would be infinite there, and no light of an infinite lamp no number.
TEST(ExtremeGuards, UniformsAreFiniteInHalf) {
    Stage stage;
    if (measured_fragment_bits(Precision::mediump) > 10)
        GTEST_SKIP() << "this driver computes in more than half precision";
    Subject subject(Surface::plain, Method::rgb, kOneLamp);
    subject.object().material = subject.exhibit.objects[1].material;
    set_strengths(subject.exhibit, kBright);
    const FragmentEdits edits{.mediump = true, .watched = true, .others = {}};
    HalfDraws draws = subject.draws();
    EXPECT_EQ(not_numbers(stage.draw(subject.exhibit, draws, edits)), 0);
    for (Uniform& uniform : draws.lamps.at(Method::rgb))
        if (uniform.name == std::string("u_lamp_color"))
            uniform.value = std::vector{glm::vec3(1e6F)};
    EXPECT_GT(not_numbers(stage.draw(subject.exhibit, draws, edits)), 0);
}

} // namespace
} // namespace metamer
