#include "gles/texture.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "gles/mesh.h"
#include "gles2/gl_test.h"

namespace metamer {
namespace {

using testing::ElementsAre;

class TextureTest : public test::GlTest {
protected:
    /// The texture drawn over a target, texture coordinates as the expression says.
    std::vector<std::uint8_t> drawn(const Texture& texture, int width_px, int height_px,
                                    const std::string& coordinates = "v_uv", int unit = 0) {
        const Framebuffer target(width_px, height_px);
        const Program program =
            test::program_of("uniform sampler2D u_picture;", "texture2D(u_picture, " + coordinates + ")");
        program.set("u_picture", unit);
        texture.bind(unit);
        Mesh(test::rectangle(-1, -1, 1, 1)).draw();
        return target.read_rgba();
    }
};

/// width x height, every byte another.
std::vector<std::uint8_t> distinct(int width_px, int height_px) {
    std::vector<std::uint8_t> rgba;
    for (int i = 0; i < width_px * height_px * 4; ++i)
        rgba.push_back(static_cast<std::uint8_t>(i * 7 + 3));
    return rgba;
}

/// Gray texels in a row, alpha 255.
std::vector<std::uint8_t> grays(const std::vector<int>& values) {
    std::vector<std::uint8_t> rgba;
    for (const int value : values)
        rgba.insert(rgba.end(), {static_cast<std::uint8_t>(value), static_cast<std::uint8_t>(value),
                                 static_cast<std::uint8_t>(value), 255});
    return rgba;
}

std::string refusal(int width_px, int height_px, std::size_t bytes) {
    try {
        const Texture texture(width_px, height_px, std::vector<std::uint8_t>(bytes));
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Exit::failure);
        return error.what();
    }
    return "not refused";
}

TEST_F(TextureTest, ComesBackExactlyWithItsFirstRowAtTheBottom) {
    const std::vector<std::uint8_t> rgba = distinct(4, 2);
    const Texture texture(4, 2, rgba, {.filter = Filter::nearest});
    std::vector<std::uint8_t> top_first(rgba.begin() + 16, rgba.end());
    top_first.insert(top_first.end(), rgba.begin(), rgba.begin() + 16);
    EXPECT_EQ(drawn(texture, 4, 2), top_first);
    EXPECT_EQ(texture.width_px(), 4);
    EXPECT_EQ(texture.height_px(), 2);
}

TEST_F(TextureTest, BindsToTheUnitAskedFor) {
    const Texture first(1, 1, grays({10})), second(1, 1, grays({20}));
    first.bind(0);
    second.bind(3);
    EXPECT_EQ(drawn(second, 1, 1, "v_uv", 3), grays({20}));
    EXPECT_EQ(drawn(first, 1, 1, "v_uv", 0), grays({10}));
}

TEST_F(TextureTest, FiltersAsAsked) {
    const Texture nearest(2, 1, grays({0, 200}), {.filter = Filter::nearest});
    const Texture linear(2, 1, grays({0, 200}), {.filter = Filter::linear});
    EXPECT_EQ(drawn(nearest, 1, 1, "vec2(0.6, 0.5)"), grays({200}));
    EXPECT_EQ(drawn(linear, 1, 1, "vec2(0.5, 0.5)"), grays({100}));
}

TEST_F(TextureTest, WrapsAsAsked) {
    const Texture clamped(2, 1, grays({0, 200}), {.filter = Filter::nearest, .wrap = Wrap::clamp});
    const Texture repeated(2, 1, grays({0, 200}), {.filter = Filter::nearest, .wrap = Wrap::repeat});
    EXPECT_EQ(drawn(clamped, 1, 1, "vec2(1.25, 0.5)"), grays({200}));
    EXPECT_EQ(drawn(repeated, 1, 1, "vec2(1.25, 0.5)"), grays({0}));
}

TEST_F(TextureTest, AveragesMinifiedTexelsOnlyWithMipmaps) {
    std::vector<int> stripes;
    for (int i = 0; i < 64; ++i)
        stripes.push_back(i % 2 == 0 ? 0 : 200);
    const Texture plain(8, 8, grays(stripes), {.filter = Filter::nearest});
    const Texture averaged(8, 8, grays(stripes), {.filter = Filter::nearest, .mipmaps = true});
    EXPECT_THAT(test::pixel(drawn(plain, 1, 1), 1, 0, 0)[0], testing::AnyOf(0, 200));
    EXPECT_EQ(drawn(averaged, 1, 1), grays({100}));
}

TEST_F(TextureTest, RefusesSidesThatAreNoPowersOfTwo) {
    EXPECT_EQ(refusal(3, 4, 48), "cannot make texture 3x4: sides must be powers of two");
    EXPECT_EQ(refusal(4, 6, 96), "cannot make texture 4x6: sides must be powers of two");
    EXPECT_EQ(refusal(0, 4, 0), "cannot make texture 0x4: sides must be powers of two");
    EXPECT_EQ(refusal(-4, 4, 0), "cannot make texture -4x4: sides must be powers of two");
}

TEST_F(TextureTest, RefusesWhatOldGpusCannotHold) {
    EXPECT_EQ(refusal(4096, 1, 4096 * 4), "cannot make texture 4096x1: sides must be at most 2048");
    EXPECT_EQ(refusal(2048, 1, 2048 * 4), "not refused");
}

TEST_F(TextureTest, RefusesAnotherNumberOfBytes) {
    EXPECT_EQ(refusal(4, 2, 31), "cannot make texture 4x2: 31 bytes given, 32 needed");
    EXPECT_EQ(refusal(4, 2, 33), "cannot make texture 4x2: 33 bytes given, 32 needed");
}

} // namespace
} // namespace metamer
