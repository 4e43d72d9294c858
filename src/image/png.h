// PNG files through libpng: 8-bit RGB(A) in and out, text and color chunks kept.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace metamer {

/// 8-bit RGBA pixels, row 0 at the top, four bytes a pixel.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

/// What a PNG says about its colors: an sRGB chunk, or gAMA and cHRM (PNG 1.2 sections 11.3.3).
struct ColorChunks {
    bool srgb = false;                             ///< sRGB chunk (with the gAMA and cHRM that the standard asks for)
    double gamma = 0;                              ///< gAMA: encoding exponent, 1/2.2 for most; 0: no chunk
    std::optional<std::array<double, 8>> xy;       ///< cHRM: white, red, green, blue as x, y
};

/// An image with the text chunks (tEXt/iTXt by keyword) and layout it was stored with.
struct Png {
    Image image;
    std::map<std::string, std::string> text;
    ColorChunks color;
};

/// Encodes 8-bit RGB (if `alpha` is false) or RGBA, text as iTXt chunks in key order. The same input gives the same
/// bytes on every machine with the same zlib; no time chunk.
std::string encode_png(const Png& png, bool alpha);

/// How strict decoding is about the stored layout.
enum class PngLayout {
    any,        ///< palette, gray, 16 bits: all converted to RGBA8
    rgba8_only, ///< anything but 8-bit RGBA is refused by name
};

/// Decodes PNG bytes; `place` is the file's name for errors. Throws bad_input for anything that is not a whole PNG:
/// wrong signature, truncated at any byte, bad checksum, over 4096 x 4096 pixels, wrong layout.
Png decode_png(const std::string& bytes, const std::string& place, PngLayout layout = PngLayout::any);

} // namespace metamer
