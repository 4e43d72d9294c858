// Every shader variant that a frame may ask for is OpenGL ES 2 as the oldest GPUs have it (DESIGN.md section
// 5), not only as the driver at hand takes it.
#include <algorithm>
#include <cctype>
#include <gmock/gmock.h>

#include "base/error.h"
#include "gles/info.h"
#include "gles/precision_probe.h"
#include "gles/shader_files.h"
#include "gles2/gl_test.h"
#include "gles2/glslang.h"
#include "gles2/source_facts.h"
#include "render/variants.h"

namespace metamer {
namespace {

using test::Declaration;
using test::Stage;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Le;

constexpr int kVertexUniformVectors = 128; ///< ES 2's floor
constexpr int kVaryingVectors = 8;         ///< ES 2's floor
constexpr int kTextureUnits = 8;           ///< ES 2's floor
constexpr int kAttributes = 8;             ///< ES 2's floor

/// ES 2's floor up to two lamps, above what all old GPUs that were seen offer.
int fragment_uniform_budget(int lamps) {
    return lamps <= 2 ? 16 : 64;
}

struct Stages {
    std::string name;
    int lamps;
    ComposedShader vertex, fragment;
    std::vector<std::string> vertex_tokens, fragment_tokens; ///< preprocessed
};

int lamps_of(const ShaderVariant& variant) {
    for (const auto& [name, value] : variant.defines)
        if (name == "LAMPS")
            return std::stoi(value);
    return 0;
}

std::vector<test::GlslangInput> inputs_of(const std::vector<Stages>& all) {
    std::vector<test::GlslangInput> inputs;
    for (const Stages& stages : all) {
        inputs.push_back({stages.name, Stage::vertex, stages.vertex.text});
        inputs.push_back({stages.name, Stage::fragment, stages.fragment.text});
    }
    return inputs;
}

/// A method's variants, or, of no method, the shadow pass, laid pictures and the precision probe.
std::vector<ShaderVariant> variants_of(MethodChoice method) {
    if (!method)
        return {shadow_variant(), picture_variant(false), picture_variant(true),
                precision_probe_variant(Precision::mediump), precision_probe_variant(Precision::highp)};
    std::vector<ShaderVariant> variants;
    for (const Variant& variant : all_variants())
        if (variant.method == *method)
            variants.push_back(shader_variant(variant));
    return variants;
}

/// Them composed; with `mediump`, as a GPU without fragment highp sees them.
std::vector<Stages> composed(MethodChoice method, bool mediump = false) {
    std::vector<Stages> all;
    for (const ShaderVariant& variant : variants_of(method)) {
        Stages stages{variant.name,
                      lamps_of(variant),
                      compose_shader(variant.vertex, variant.defines, shader_files()),
                      compose_shader(variant.fragment, variant.defines, shader_files()),
                      {},
                      {}};
        const std::string highp = "GL_FRAGMENT_PRECISION_HIGH";
        std::string& text = stages.fragment.text;
        for (std::size_t at = 0; mediump && (at = text.find(highp, at)) != std::string::npos;)
            text.replace(at, highp.size(), "METAMER_NO_SUCH_PRECISION_");
        all.push_back(std::move(stages));
    }
    return all;
}

std::vector<Stages> preprocessed(MethodChoice method) {
    std::vector<Stages> stages = composed(method);
    const std::vector<std::string> texts = test::glslang_preprocessed(inputs_of(stages));
    for (std::size_t i = 0; i < stages.size(); ++i) {
        stages[i].vertex_tokens = test::tokens(texts[2 * i]);
        stages[i].fragment_tokens = test::tokens(texts[2 * i + 1]);
    }
    return stages;
}

TEST(Variants, HaveNamesOfTheirOwnForFiles) {
    std::vector<std::string> names;
    for (const ShaderVariant& variant : shader_variants()) {
        names.push_back(variant.name);
        for (const char c : variant.name)
            EXPECT_TRUE(std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_')
                << variant.name;
    }
    EXPECT_FALSE(names.empty());
    std::sort(names.begin(), names.end());
    EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

// Method by method: so that ctest may run them beside each other.
std::vector<MethodChoice> parts() {
    std::vector<MethodChoice> all{MethodChoice()};
    for (const MethodInfo& info : kMethods)
        all.emplace_back(info.method);
    return all;
}

std::string part_name(const testing::TestParamInfo<MethodChoice>& info) {
    return info.param ? std::string(method_name(*info.param)) : "passes";
}

class VariantsInContext : public test::GlTest, public testing::WithParamInterface<MethodChoice> {};

TEST(Variants, AreEachOfOneOfTheParts) {
    std::size_t count = 0;
    for (const MethodChoice& part : parts())
        count += variants_of(part).size();
    EXPECT_EQ(count, shader_variants().size());
}

void expect_within_the_context(const Stages& stages, const GlLimits& limits) {
    const auto vertex = test::declarations(stages.vertex_tokens);
    const auto fragment = test::declarations(stages.fragment_tokens);
    EXPECT_THAT(vectors(fragment, "uniform"), Le(limits.max_fragment_uniform_vectors));
    EXPECT_THAT(vectors(vertex, "uniform"), Le(limits.max_vertex_uniform_vectors));
    EXPECT_THAT(vectors(vertex, "varying"), Le(limits.max_varying_vectors));
    EXPECT_THAT(samplers(fragment), Le(limits.max_texture_image_units));
}

/// Compiles and links, and the counting below has seen everything that the driver sees.
TEST_P(VariantsInContext, CompileAndLinkWithinItsLimits) {
    const GlLimits limits = gl_info().limits;
    for (const Stages& stages : preprocessed(GetParam())) {
        SCOPED_TRACE(stages.name);
        std::vector<Declaration> declared = test::declarations(stages.vertex_tokens);
        const std::vector<Declaration> fragment = test::declarations(stages.fragment_tokens);
        declared.insert(declared.end(), fragment.begin(), fragment.end());
        expect_within_the_context(stages, limits);
        try {
            const Program program(stages.vertex, stages.fragment, kMeshAttributes);
            for (const ActiveUniform& active : program.active_uniforms()) {
                const auto same = [&](const Declaration& d) {
                    return d.qualifier == "uniform" && d.name == active.name && d.size >= active.size;
                };
                EXPECT_TRUE(std::any_of(declared.begin(), declared.end(), same)) << active.name;
            }
        } catch (const Error& error) {
            ADD_FAILURE() << error.what();
        }
    }
}

TEST_P(VariantsInContext, CompileAndLinkWithoutHighp) {
    for (const Stages& stages : composed(GetParam(), true)) {
        SCOPED_TRACE(stages.name);
        EXPECT_NO_THROW(Program(stages.vertex, stages.fragment, kMeshAttributes));
    }
}

INSTANTIATE_TEST_SUITE_P(Of, VariantsInContext, testing::ValuesIn(parts()), part_name);

class VariantsAsText : public testing::TestWithParam<MethodChoice> {};

void expect_within_the_budgets(const Stages& stages) {
    const auto vertex = test::declarations(stages.vertex_tokens);
    const auto fragment = test::declarations(stages.fragment_tokens);
    EXPECT_THAT(vectors(fragment, "uniform"), Le(fragment_uniform_budget(stages.lamps)));
    EXPECT_THAT(vectors(vertex, "uniform"), Le(kVertexUniformVectors));
    EXPECT_THAT(vectors(vertex, "varying"), Le(kVaryingVectors));
    EXPECT_THAT(vectors(fragment, "varying"), Le(kVaryingVectors));
    EXPECT_THAT(vectors(vertex, "attribute"), Le(kAttributes));
    EXPECT_THAT(samplers(fragment), Le(kTextureUnits));
    EXPECT_EQ(samplers(vertex), 0);
}

TEST_P(VariantsAsText, StayWithinTheBudgetsOfEs2AndKeepTheRulesOfTheHouse) {
    for (const Stages& stages : preprocessed(GetParam())) {
        SCOPED_TRACE(stages.name);
        expect_within_the_budgets(stages);
        EXPECT_THAT(test::broken_rules(Stage::vertex, stages.vertex_tokens), IsEmpty());
        EXPECT_THAT(test::broken_rules(Stage::fragment, stages.fragment_tokens), IsEmpty());
        if (!stages.name.starts_with("precision_probe")) { // it asks for the one that it measures
            EXPECT_THAT(stages.fragment.text,
                        HasSubstr("#ifdef GL_FRAGMENT_PRECISION_HIGH\nprecision highp float;\n"
                                  "precision highp sampler2D;\n#else\nprecision mediump float;\n"
                                  "precision mediump sampler2D;\n#endif\n"));
        }
        EXPECT_EQ(stages.vertex.text.find("#extension"), std::string::npos);
        EXPECT_EQ(stages.fragment.text.find("#extension"), std::string::npos);
    }
}

TEST_P(VariantsAsText, AreEssl100ToGlslang) {
    EXPECT_EQ(test::glslang_complaints(inputs_of(composed(GetParam()))), "");
    EXPECT_EQ(test::glslang_complaints(inputs_of(composed(GetParam(), true))), "");
}

INSTANTIATE_TEST_SUITE_P(Of, VariantsAsText, testing::ValuesIn(parts()), part_name);

} // namespace
} // namespace metamer
