// What the tests of src/gles share: a context, shaders from strings, small drawings. A machine without a
// context fails every one of them.
#pragma once

#include <cstdlib>
#include <gtest/gtest.h>
#include <map>
#include <string>
#include <vector>

#include "gles/check.h"
#include "gles/framebuffer.h"
#include "gles/mesh_data.h"
#include "gles/program.h"
#include "gles/shader_source.h"
#include "gles/surfaceless.h"

namespace metamer::test {

using Texts = std::map<std::string, std::string, std::less<>>;

/// Shader files that exist only in a test.
inline ShaderFiles files_of(Texts texts) {
    return [texts = std::move(texts)](std::string_view name) -> std::string_view {
        const auto found = texts.find(name);
        return found == texts.end() ? std::string_view{} : std::string_view(found->second);
    };
}

/// A test with a context of its own, which must end without a GL error.
class GlTest : public testing::Test {
protected:
    void TearDown() override { EXPECT_NO_THROW(throw_on_gl_error("end", "the test")); }

    Surfaceless gl_;
};

/// An environment variable for as long as this lives; nullptr takes it away.
class Environment {
public:
    Environment(const char* name, const char* value) : name_(name) {
        if (const char* old = std::getenv(name)) {
            old_ = old;
            had_ = true;
        }
        put(value);
    }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;
    ~Environment() { put(had_ ? old_.c_str() : nullptr); }

private:
    void put(const char* value) const {
        if (value == nullptr)
            unsetenv(name_);
        else
            setenv(name_, value, 1);
    }

    const char* name_;
    std::string old_;
    bool had_ = false;
};

/// A vertex shader that hands on a_uv as v_uv.
inline constexpr const char* kPassVertex =
    "attribute vec3 a_position;\nattribute vec2 a_uv;\nvarying vec2 v_uv;\n"
    "void main() { v_uv = a_uv; gl_Position = vec4(a_position, 1.0); }\n";

/// Declarations and an expression for gl_FragColor, made a program over kPassVertex.
inline Program program_of(const std::string& declarations, const std::string& color) {
    const std::string fragment = "precision mediump float;\nvarying vec2 v_uv;\n" + declarations +
                                 "\nvoid main() { gl_FragColor = " + color + "; }\n";
    const ShaderFiles files = files_of({{"pass.vert", kPassVertex}, {"test.frag", fragment}});
    return {compose_shader("pass.vert", {}, files), compose_shader("test.frag", {}, files), kMeshAttributes};
}

/// A rectangle in clip coordinates at depth z, uv (0, 0) at (x0, y0) and (1, 1) at (x1, y1); normal (0.2,
/// 0.4, 0.6), tangent (0.8, 0.6, 0.4).
inline MeshData rectangle(float x0, float y0, float x1, float y1, float z = 0) {
    MeshData data;
    for (const auto& [x, y, u, v] : {std::array{x0, y0, 0.0F, 0.0F}, std::array{x1, y0, 1.0F, 0.0F},
                                     std::array{x1, y1, 1.0F, 1.0F}, std::array{x0, y1, 0.0F, 1.0F}})
        data.vertices.insert(data.vertices.end(), {x, y, z, 0.2F, 0.4F, 0.6F, 0.8F, 0.6F, 0.4F, u, v});
    data.indices = {0, 1, 2, 0, 2, 3};
    return data;
}

/// One pixel of what Framebuffer::read_rgba gives.
inline std::vector<int> pixel(const std::vector<std::uint8_t>& rgba, int width_px, int x, int y) {
    const auto at = rgba.begin() + (static_cast<std::ptrdiff_t>(y) * width_px + x) * 4;
    return {at, at + 4};
}

} // namespace metamer::test
