#include "atlas/atlas_file.h"

#include <algorithm>

#include "atlas/atlas_check.h"
#include "atlas/atlas_text.h"
#include "base/error.h"
#include "base/files.h"
#include "image/png.h"

namespace metamer {

std::string encode_atlas(const Atlas& atlas) {
    if (const auto flaw = flaw_of(atlas))
        throw bad_input("encode", "an atlas", *flaw);
    Png png;
    png.image = {kAtlasSize, kAtlasSize, {atlas.rgba.begin(), atlas.rgba.end()}};
    png.text = atlas_texts(atlas);
    return encode_png(png, true);
}

Atlas decode_atlas(const std::string& bytes, const std::string& place) {
    const Png png = decode_png(bytes, place, PngLayout::rgba8_only);
    if (png.image.width != kAtlasSize || png.image.height != kAtlasSize)
        throw bad_input("read", place,
                        "it is no atlas: it has " + std::to_string(png.image.width) + " x " +
                            std::to_string(png.image.height) + " pixels, not 64 x 64");
    Atlas atlas;
    std::copy(png.image.rgba.begin(), png.image.rgba.end(), atlas.rgba.begin());
    read_atlas_texts(atlas, png.text, place);
    if (const auto flaw = flaw_of(atlas))
        throw bad_input("read", place, *flaw);
    return atlas;
}

Atlas read_atlas(const std::filesystem::path& path) {
    constexpr std::size_t most_bytes = 4u << 20;
    return decode_atlas(read_file(path, most_bytes), path.string());
}

} // namespace metamer
