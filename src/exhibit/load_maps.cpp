// Pictures that objects carry: key map, luminance map, bump map.
#include <bit>

#include "base/files.h"
#include "exhibit/load_parts.h"
#include "exhibit/values.h"
#include "image/png.h"

namespace metamer {

namespace {

constexpr int kMostMapSide = 2048; // VideoCore IV takes no more (DESIGN.md section 5)

bool fits(int side) {
    return side >= 1 && side <= kMostMapSide && std::has_single_bit(static_cast<unsigned>(side));
}

} // namespace

Image load_map(const Setting& setting) {
    const std::filesystem::path path = setting.folder / setting.value;
    Image image;
    try {
        image = decode_png(read_file(path), path.string()).image;
    } catch (const Error& inner) {
        throw refused_by(setting, setting.value, inner);
    }
    if (!fits(image.width) || !fits(image.height))
        throw refused(setting, "is " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                                   " pixels; the sides of a map are powers of two up to " +
                                   std::to_string(kMostMapSide));
    return image;
}

void check_key_map(const Setting& setting, const Image& map, const Atlas& atlas) {
    for (std::size_t i = 0; i < map.rgba.size(); i += 4) {
        const std::size_t key = map.rgba[i];
        if (key < atlas.materials.size() && !atlas.materials[key].name.empty())
            continue;
        const std::size_t x = i / 4 % static_cast<std::size_t>(map.width),
                          y = i / 4 / static_cast<std::size_t>(map.width);
        throw refused(setting, "has key " + std::to_string(key) + " at pixel " + std::to_string(x) + ", " +
                                   std::to_string(y) + "; no material has that key");
    }
}

} // namespace metamer
