// libFuzzer's changes to a PNG, checksums made right again: else none would come further than the first
// chunk.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "atlas/atlas.h"
#include "base/error.h"
#include "image/png.h"
#include "image/png_bytes.h"

// libFuzzer's own names: https://llvm.org/docs/LibFuzzer.html, FuzzerInterface.h.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed);

namespace metamer::fuzz {

namespace {

using png_bytes::Chunk;

class Mutator {
public:
    explicit Mutator(unsigned seed) : random_(seed) {}

    /// Another PNG, as libFuzzer changes one; empty where the bytes are none that this can change.
    std::string changed(const std::string& bytes) {
        return below(3) == 0 ? with_another_row(bytes) : with_other_chunks(bytes);
    }

private:
    std::size_t below(std::size_t n) { return random_() % n; }

    void mutate(std::string& bytes, std::size_t room) {
        const std::size_t size = bytes.size();
        bytes.resize(size + room);
        bytes.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(bytes.data()), size, bytes.size()));
    }

    static std::vector<Chunk> whole_chunks(const std::string& bytes) {
        std::vector<Chunk> chunks;
        for (std::size_t at = png_bytes::kSignature.size(); at + 12 <= bytes.size();) {
            const std::size_t length = png_bytes::read_be32(std::string_view(bytes).substr(at, 4));
            if (length > bytes.size() - at - 12)
                break;
            chunks.push_back({bytes.substr(at + 4, 4), bytes.substr(at + 8, length)});
            at += 12 + length;
        }
        return chunks;
    }

    std::string with_other_chunks(const std::string& bytes) {
        std::vector<Chunk> chunks = whole_chunks(bytes);
        if (chunks.empty())
            return {};
        const std::size_t at = below(chunks.size()), other = below(chunks.size());
        switch (below(12)) {
        case 0:
            std::swap(chunks[at], chunks[other]);
            break;
        case 1:
            chunks.insert(chunks.begin() + static_cast<std::ptrdiff_t>(at), Chunk(chunks[other]));
            break;
        case 2:
            chunks.erase(chunks.begin() + static_cast<std::ptrdiff_t>(at));
            break;
        case 3:
            mutate(chunks[at].type, 0);
            chunks[at].type.resize(4, 'x');
            break;
        default:
            mutate(chunks[at].data, 64);
        }
        std::string out = png_bytes::kSignature;
        for (const Chunk& chunk : chunks)
            out += png_bytes::chunk(chunk.type, chunk.data);
        return out;
    }

    /// One row's lamp or material, with a name and a number where it had none.
    std::string with_another_row(const std::string& bytes) {
        try {
            Png png = decode_png(bytes, "seed.png");
            if (png.image.width != kAtlasSize || png.image.height != kAtlasSize)
                return {};
            const bool lamp = below(2) == 0;
            const int row = 1 + static_cast<int>(below(kAtlasRows));
            std::string levels;
            for (std::size_t i = 0; i < kIntervals; ++i)
                levels += static_cast<char>(png.image.rgba[byte(row, i, lamp)]);
            mutate(levels, 0);
            levels.resize(kIntervals);
            levels[below(kIntervals)] = '\xff'; // a lamp's greatest
            for (std::size_t i = 0; i < kIntervals; ++i)
                png.image.rgba[byte(row, i, lamp)] = static_cast<std::uint8_t>(levels[i]);
            name(png.text[lamp ? "metamer:lamps" : "metamer:materials"], row);
            return encode_png(png, true);
        } catch (const Error&) {
            return {};
        }
    }

    static std::size_t byte(int row, std::size_t interval, bool lamp) {
        return atlas_byte(row, interval, lamp ? AtlasChannel::lamp : AtlasChannel::material);
    }

    static void name(std::string& lines, int row) {
        const std::string key = std::to_string(row);
        if (!lines.starts_with(key + "\t") && lines.find("\n" + key + "\t") == std::string::npos)
            lines += key + "\trow " + key + "\t1\t\n";
    }

    std::mt19937 random_;
};

} // namespace

} // namespace metamer::fuzz

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                    unsigned seed) {
    metamer::fuzz::Mutator mutator(seed);
    const std::string changed = mutator.changed({reinterpret_cast<const char*>(data), size});
    if (changed.empty() || changed.size() > max_size || seed % 16 == 0)
        return LLVMFuzzerMutate(data, size, max_size);
    std::ranges::copy(changed, reinterpret_cast<char*>(data));
    return changed.size();
}
