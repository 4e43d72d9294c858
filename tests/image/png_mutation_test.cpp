// Damage at random, under the sanitizers: decode_png returns an image of the size that it names, or refuses.
#include "image/png.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "base/error.h"
#include "image/png_bytes.h"

namespace metamer {
namespace {

constexpr int kMutations = 2000;

struct Outcome {
    int read = 0, refused = 0;
};

void try_decode(const std::string& bytes, Outcome& outcome) {
    try {
        const Png png = decode_png(bytes, "mutant.png");
        ASSERT_EQ(png.image.rgba.size(), static_cast<std::size_t>(png.image.width * png.image.height * 4));
        ++outcome.read;
    } catch (const Error& e) {
        ASSERT_EQ(e.status(), Exit::bad_input) << e.what();
        ++outcome.refused;
    }
}

Png small_png() {
    Png png;
    png.image = {17, 13, std::vector<std::uint8_t>(17 * 13 * 4)};
    for (std::size_t i = 0; i < png.image.rgba.size(); ++i)
        png.image.rgba[i] = static_cast<std::uint8_t>(i * i / 7);
    png.text = {{"Title", "a mutant"}, {"Lines", "1\ttwo\n"}};
    png.color.srgb = true;
    return png;
}

class Mutator {
public:
    std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }

    // One change to a place at random: a byte, a bit, a piece cut out, doubled or replaced by noise.
    void mutate(std::string& bytes) {
        if (bytes.empty())
            return;
        const std::size_t at = below(bytes.size()),
                          length = 1 + below(std::min<std::size_t>(16, bytes.size() - at));
        switch (below(5)) {
        case 0:
            bytes[at] = static_cast<char>(below(256));
            break;
        case 1:
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
            break;
        case 2:
            bytes.erase(at, length);
            break;
        case 3:
            bytes.insert(at, std::string(bytes, at, length));
            break;
        default:
            for (std::size_t i = at; i < at + length; ++i)
                bytes[i] = static_cast<char>(below(256));
        }
    }

private:
    std::mt19937 random_{20150923};
};

TEST(PngMutation, BytesAtRandom) {
    const std::string whole = encode_png(small_png(), true);
    Mutator mutator;
    Outcome outcome;
    for (int i = 0; i < kMutations; ++i) {
        std::string bytes = whole;
        for (std::size_t n = 1 + mutator.below(4); n > 0; --n)
            mutator.mutate(bytes);
        try_decode(bytes, outcome);
    }
    EXPECT_GT(outcome.refused, kMutations * 9 / 10);
}

// With checksums made right again the damage reaches the code behind them.
TEST(PngMutation, ChunksAtRandomWithGoodChecksums) {
    const auto chunks = png_bytes::chunks_of(encode_png(small_png(), true));
    Mutator mutator;
    Outcome outcome;
    for (int i = 0; i < kMutations; ++i) {
        auto mutants = chunks;
        mutator.mutate(mutants[mutator.below(mutants.size())].data);
        if (mutator.below(4) == 0)
            std::swap(mutants[mutator.below(mutants.size())], mutants[mutator.below(mutants.size())]);
        if (mutator.below(4) == 0)
            mutants.insert(mutants.begin(), mutants[mutator.below(mutants.size())]);
        std::string bytes = png_bytes::kSignature;
        for (const png_bytes::Chunk& c : mutants)
            bytes += png_bytes::chunk(c.type, c.data);
        try_decode(bytes, outcome);
    }
    EXPECT_GT(outcome.read, 0);
    EXPECT_GT(outcome.refused, 0);
}

} // namespace
} // namespace metamer
