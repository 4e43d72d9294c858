// PNG files through libpng: 8-bit RGB(A) in and out, text and color chunks kept.
//
// Sections are those of PNG 1.2 (RFC 2083 and its successor, ISO/IEC 15948).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace metamer {

inline constexpr int kMostPixels = 4096; ///< a side's greatest length, px
inline constexpr std::size_t kMostTextBytes = 1u
                                              << 20; ///< greatest length of one text, written or read, bytes

/// 8-bit RGBA pixels, row 0 at the top, four bytes a pixel, alpha not multiplied in.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

/// What a PNG says about its colors (sections 4.2.2.1, 4.2.2.2, 4.2.2.3). With `srgb` the other two are
/// implied and stay unset: the file carries the gAMA and cHRM that the standard names for sRGB.
struct ColorChunks {
    bool srgb = false; ///< sRGB chunk, perceptual intent
    double gamma = 0;  ///< gAMA: encoding exponent, 1/2.2 for most; 0: no chunk; kept to 1e-5
    std::optional<std::array<double, 8>> xy; ///< cHRM: white, red, green, blue as x, y; kept to 1e-5
};

/// An image with its text by keyword, in UTF-8, and its color chunks. Several texts of one keyword are joined
/// by line breaks when read.
struct Png {
    Image image;
    std::map<std::string, std::string> text;
    ColorChunks color;
};

/// Encodes 8-bit RGB (if `alpha` is false) or RGBA, text as uncompressed iTXt chunks in key order. The same
/// input gives the same bytes on every machine with the same libpng and zlib: level and filters are fixed,
/// there is no time chunk. Throws bad_input for what no PNG can hold: a side outside 1 .. kMostPixels, pixels
/// of another count, a keyword that is not 1 .. 79 printable ASCII characters with single blanks inside
/// (section 4.2.3), text that is not UTF-8, holds a NUL or is over kMostTextBytes, a gamma or chromaticities
/// that make no sense.
std::string encode_png(const Png& png, bool alpha);

/// How strict decoding is about the stored layout.
enum class PngLayout {
    any,        ///< palette, gray, 16 bits, without alpha: all converted to RGBA8
    rgba8_only, ///< anything but 8-bit RGBA is refused by name
};

/// Decodes PNG bytes; `place` is the file's name for errors. Throws bad_input for anything that is not a
/// whole PNG: wrong signature, truncated at any byte, bad checksum, over kMostPixels a side, text that is not
/// UTF-8 or over kMostTextBytes (or more than 64 texts), wrong layout. Bytes after the IEND chunk are
/// ignored, as viewers do; so are chunks other than text, sRGB, gAMA, cHRM and transparency (ICC profiles
/// too).
Png decode_png(const std::string& bytes, const std::string& place, PngLayout layout = PngLayout::any);

} // namespace metamer
