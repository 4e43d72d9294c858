#include "image/png.h"

#include <algorithm>
#include <cstring>
#include <new>

#include "base/error.h"
#include "base/utf8.h"
#include "image/png_guard.h"

namespace metamer {

namespace {

constexpr std::size_t kSignatureBytes = 8;
constexpr png_uint_32 kMostTexts = 64;

// What libpng reads from.
struct Source {
    const char* at;
    std::size_t left;
    bool ran_out = false;
};

void read_bytes(png_structp png, png_bytep to, std::size_t count) {
    auto* source = static_cast<Source*>(png_get_io_ptr(png));
    if (count > source->left) {
        source->ran_out = true;
        png_error(png, "cut short");
    }
    std::memcpy(to, source->at, count);
    source->at += count;
    source->left -= count;
}

// Libpng's two structures with what its callbacks need: it must not move.
class Reader {
public:
    explicit Reader(const std::string& bytes) : source_{bytes.data(), bytes.size()} {
        png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &failure_, png_give_up, png_pass_over);
        info = png ? png_create_info_struct(png) : nullptr;
        if (!info) {
            png_destroy_read_struct(&png, nullptr, nullptr);
            throw std::bad_alloc();
        }
        png_set_read_fn(png, &source_, read_bytes);
    }
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    std::string cause() const {
        return source_.ran_out ? "it is cut short"
                               : "it is damaged (" + std::string(failure_.message.data()) + ")";
    }

    png_structp png = nullptr;
    png_infop info = nullptr;

private:
    Source source_;
    PngFailure failure_;
};

struct Header {
    png_uint_32 width = 0, height = 0;
    int bits = 0, color_type = 0;
};

void check_signature(const std::string& bytes, const std::string& place) {
    if (bytes.empty())
        throw bad_input("read", place, "it is empty");
    const std::size_t there = std::min(bytes.size(), kSignatureBytes);
    if (png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, there) != 0)
        throw bad_input("read", place, "it is not a PNG file");
}

// Every doubt is an error: a checksum, a broken text chunk, compressed data that goes on too long.
void be_strict(png_structp png) {
    png_set_crc_action(png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
    png_set_benign_errors(png, 0);
    // Sides are checked after the header with a message of our own; no pixel buffer exists before that.
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    // A text's keyword and language stand in the chunk beside the text.
    png_set_chunk_malloc_max(png, kMostTextBytes + 1024);
    // Libpng counts down to 1, not to 0.
    png_set_chunk_cache_max(png, kMostTexts + 2);
    // Known to libpng, of no use here, and strict reading would refuse files for their flaws.
    static constexpr png_byte ignored[] = "bKGD\0eXIf\0hIST\0iCCP\0oFFs\0pCAL\0pHYs\0sBIT\0sCAL\0sPLT\0tIME";
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, ignored, sizeof ignored / 5);
}

std::string layout_name(const Header& header) {
    if (header.color_type == PNG_COLOR_TYPE_PALETTE)
        return "a palette";
    const std::string channels = header.color_type == PNG_COLOR_TYPE_GRAY         ? "gray"
                                 : header.color_type == PNG_COLOR_TYPE_GRAY_ALPHA ? "gray with alpha"
                                 : header.color_type == PNG_COLOR_TYPE_RGB        ? "RGB without alpha"
                                                                                  : "RGBA";
    return std::to_string(header.bits) + "-bit " + channels;
}

void check_header(const Header& header, PngLayout layout, const std::string& place) {
    constexpr auto most = static_cast<png_uint_32>(kMostPixels);
    if (header.width > most || header.height > most)
        throw bad_input("read", place,
                        "it has " + std::to_string(header.width) + " x " + std::to_string(header.height) +
                            " pixels; at most " + std::to_string(most) + " x " + std::to_string(most) +
                            " are read");
    if (layout == PngLayout::rgba8_only &&
        (header.bits != 8 || header.color_type != PNG_COLOR_TYPE_RGB_ALPHA))
        throw bad_input("read", place, "it has " + layout_name(header) + "; 8-bit RGBA is needed");
}

void convert_to_rgba8(png_structp png, png_infop info, const Header& header) {
    const bool has_alpha =
        (header.color_type & PNG_COLOR_MASK_ALPHA) != 0 || png_get_valid(png, info, PNG_INFO_tRNS) != 0;
    png_set_expand(png);
    png_set_scale_16(png);
    png_set_gray_to_rgb(png);
    if (!has_alpha)
        png_set_add_alpha(png, 0xFF, PNG_FILLER_AFTER);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
}

std::map<std::string, std::string> texts(const Reader& reader, const std::string& place) {
    std::map<std::string, std::string> out;
    png_textp all = nullptr;
    const int count = png_get_text(reader.png, reader.info, &all, nullptr);
    for (int i = 0; i < count; ++i) {
        const png_text& one = all[i];
        const bool international = one.compression >= PNG_ITXT_COMPRESSION_NONE;
        const std::string key = utf8_from_latin1(one.key);
        const std::string_view stored(one.text ? one.text : "",
                                      international ? one.itxt_length : one.text_length);
        if (international && !is_utf8(stored))
            throw bad_input("read", place, "its text " + key + " is not UTF-8");
        const std::string value = international ? std::string(stored) : utf8_from_latin1(stored);
        const auto [at, is_new] = out.emplace(key, value);
        if (!is_new)
            at->second += "\n" + value;
    }
    return out;
}

ColorChunks color_chunks(png_const_structp png, png_infop info) {
    ColorChunks color;
    color.srgb = png_get_valid(png, info, PNG_INFO_sRGB) != 0;
    if (color.srgb)
        return color;
    png_get_gAMA(png, info, &color.gamma);
    std::array<double, 8> xy{};
    if (png_get_cHRM(png, info, &xy[0], &xy[1], &xy[2], &xy[3], &xy[4], &xy[5], &xy[6], &xy[7]) != 0)
        color.xy = xy;
    return color;
}

} // namespace

Png decode_png(const std::string& bytes, const std::string& place, PngLayout layout) {
    check_signature(bytes, place);
    Reader reader(bytes);
    const auto demand = [&](bool done) {
        if (!done)
            throw bad_input("read", place, reader.cause());
    };
    Header header;
    demand(guarded(reader.png, [&] {
        be_strict(reader.png);
        png_read_info(reader.png, reader.info);
        png_get_IHDR(reader.png, reader.info, &header.width, &header.height, &header.bits, &header.color_type,
                     nullptr, nullptr, nullptr);
    }));
    check_header(header, layout, place);

    Png out;
    out.image.width = static_cast<int>(header.width);
    out.image.height = static_cast<int>(header.height);
    const std::size_t pitch = std::size_t{4} * header.width;
    out.image.rgba.resize(pitch * header.height);
    std::vector<png_bytep> rows(header.height);
    for (std::size_t y = 0; y < rows.size(); ++y)
        rows[y] = out.image.rgba.data() + y * pitch;
    png_bytepp row_pointers = rows.data();
    demand(guarded(reader.png, [&] {
        convert_to_rgba8(reader.png, reader.info, header);
        if (png_get_rowbytes(reader.png, reader.info) != pitch)
            png_error(reader.png, "unexpected row length");
        png_read_image(reader.png, row_pointers);
        png_read_end(reader.png, reader.info);
    }));
    out.text = texts(reader, place);
    out.color = color_chunks(reader.png, reader.info);
    return out;
}

} // namespace metamer
