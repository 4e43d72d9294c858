#include "image/png.h"

#include <algorithm>
#include <new>
#include <utility>

#include "base/error.h"
#include "base/numbers.h"
#include "base/utf8.h"
#include "image/png_guard.h"

namespace metamer {

namespace {

// Zlib's own middle between speed and size. Named, so that no other default of some build of libpng changes
// the bytes.
constexpr int kZlibLevel = 6;

void write_bytes(png_structp png, png_bytep from, std::size_t count) {
    auto* out = static_cast<std::string*>(png_get_io_ptr(png));
    bool written = true;
    // No exception may leave through libpng's frames.
    try {
        out->append(reinterpret_cast<const char*>(from), count);
    } catch (const std::exception&) {
        written = false;
    }
    if (!written)
        png_error(png, "out of memory");
}

void flush_nothing(png_structp) {}

// Libpng's two structures with what its callbacks need: it must not move.
class Writer {
public:
    Writer() {
        png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &failure_, png_give_up, png_pass_over);
        info = png ? png_create_info_struct(png) : nullptr;
        if (!info) {
            png_destroy_write_struct(&png, nullptr);
            throw std::bad_alloc();
        }
        png_set_write_fn(png, &bytes, write_bytes, flush_nothing);
    }
    ~Writer() { png_destroy_write_struct(&png, &info); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    std::string cause() const { return failure_.message.data(); }

    png_structp png = nullptr;
    png_infop info = nullptr;
    std::string bytes;

private:
    PngFailure failure_;
};

Error refusal(const std::string& cause) {
    return bad_input("encode", "a PNG", cause);
}

void check_image(const Image& image) {
    const auto fits = [](int side) { return side >= 1 && side <= kMostPixels; };
    const std::string size = std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels";
    if (!fits(image.width) || !fits(image.height))
        throw refusal(size + " are outside 1 x 1 .. " + std::to_string(kMostPixels) + " x " +
                      std::to_string(kMostPixels));
    const std::size_t needed =
        std::size_t{4} * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (image.rgba.size() != needed)
        throw refusal(size + " take " + std::to_string(needed) + " bytes, not " +
                      std::to_string(image.rgba.size()));
}

void check_text(const std::string& key, const std::string& text) {
    const bool printable = std::all_of(key.begin(), key.end(), [](char c) { return c >= ' ' && c <= '~'; });
    if (key.empty() || key.size() > 79 || !printable || key.front() == ' ' || key.back() == ' ' ||
        key.find("  ") != std::string::npos)
        throw refusal("the keyword \"" + key +
                      "\" is not 1 .. 79 printable ASCII characters with single blanks inside");
    if (text.size() > kMostTextBytes)
        throw refusal("the text " + key + " is over " + std::to_string(kMostTextBytes) + " bytes");
    if (!is_utf8(text) || text.find('\0') != std::string::npos)
        throw refusal("the text " + key + " is not UTF-8 without NUL");
}

void check_color(const ColorChunks& color) {
    // The chunk holds gamma * 100000 as a 31-bit whole number.
    if (color.gamma != 0 && !(color.gamma >= 1e-5 && color.gamma <= 21474.0))
        throw refusal("the gamma " + to_text(color.gamma) + " is outside 0.00001 .. 21474");
    if (!color.xy)
        return;
    for (const double v : *color.xy)
        if (!(v >= 0 && v <= 1))
            throw refusal("the chromaticity coordinate " + to_text(v) + " is outside 0 .. 1");
}

void set_color(png_structp png, png_infop info, const ColorChunks& color) {
    if (color.srgb) {
        png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
        return;
    }
    if (color.gamma != 0)
        png_set_gAMA(png, info, color.gamma);
    if (color.xy) {
        const auto& xy = *color.xy;
        png_set_cHRM(png, info, xy[0], xy[1], xy[2], xy[3], xy[4], xy[5], xy[6], xy[7]);
    }
}

// The texts as libpng takes them; it copies what they point to, and changes nothing.
std::vector<png_text> text_chunks(const Png& png) {
    std::vector<png_text> out;
    static char none[] = "";
    for (const auto& [key, text] : png.text) {
        png_text one{};
        one.compression = PNG_ITXT_COMPRESSION_NONE;
        one.key = const_cast<char*>(key.c_str());
        one.text = const_cast<char*>(text.c_str());
        one.itxt_length = text.size();
        one.lang = none;
        one.lang_key = none;
        out.push_back(one);
    }
    return out;
}

} // namespace

std::string encode_png(const Png& png, bool alpha) {
    check_image(png.image);
    for (const auto& [key, text] : png.text)
        check_text(key, text);
    check_color(png.color);

    const auto width = static_cast<png_uint_32>(png.image.width);
    const auto height = static_cast<png_uint_32>(png.image.height);
    const std::vector<png_text> texts = text_chunks(png);
    Writer writer;
    const png_structp out = writer.png;
    const png_infop info = writer.info;
    const bool done = guarded(out, [&] {
        png_set_compression_level(out, kZlibLevel);
        png_set_filter(out, PNG_FILTER_TYPE_BASE, PNG_FILTER_PAETH);
        png_set_IHDR(out, info, width, height, 8, alpha ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB,
                     PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        set_color(out, info, png.color);
        png_set_text(out, info, texts.data(), static_cast<int>(texts.size()));
        png_write_info(out, info);
        if (!alpha)
            png_set_filler(out, 0, PNG_FILLER_AFTER);
        for (std::size_t y = 0; y < height; ++y)
            png_write_row(out, png.image.rgba.data() + y * 4 * width);
        png_write_end(out, nullptr);
    });
    if (!done)
        throw refusal(writer.cause());
    return std::move(writer.bytes);
}

} // namespace metamer
