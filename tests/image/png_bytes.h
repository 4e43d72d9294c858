// PNG files put together by hand, so that libpng is not its own judge: PNG 1.2 (RFC 2083) and zlib (RFC 1950,
// 1951).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace metamer::png_bytes {

inline const std::string kSignature("\x89PNG\r\n\x1A\n");

inline std::string be32(std::uint32_t v) {
    return {static_cast<char>(v >> 24), static_cast<char>(v >> 16), static_cast<char>(v >> 8),
            static_cast<char>(v)};
}

inline std::uint32_t read_be32(std::string_view at) {
    std::uint32_t v = 0;
    for (std::size_t i = 0; i < 4; ++i)
        v = v << 8 | static_cast<unsigned char>(at[i]);
    return v;
}

// RFC 2083 section 15, bit by bit.
inline std::uint32_t crc32(std::string_view bytes) {
    std::uint32_t crc = 0xFFFFFFFFu;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit)
            crc = crc & 1 ? 0xEDB88320u ^ (crc >> 1) : crc >> 1;
    }
    return crc ^ 0xFFFFFFFFu;
}

// RFC 1950 section 8.
inline std::uint32_t adler32(std::string_view bytes) {
    std::uint32_t a = 1, b = 0;
    for (const char c : bytes) {
        a = (a + static_cast<unsigned char>(c)) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16 | a;
}

inline std::string chunk(const std::string& type, const std::string& data) {
    return be32(static_cast<std::uint32_t>(data.size())) + type + data + be32(crc32(type + data));
}

// One stored (uncompressed) block: up to 65535 bytes.
inline std::string zlib_stored(const std::string& raw) {
    const auto n = static_cast<std::uint16_t>(raw.size());
    const auto le16 = [](unsigned v) {
        return std::string{static_cast<char>(v & 0xFF), static_cast<char>(v >> 8 & 0xFF)};
    };
    return std::string("\x78\x01\x01", 3) + le16(n) + le16(static_cast<std::uint16_t>(~n)) + raw +
           be32(adler32(raw));
}

enum ColorType { gray = 0, rgb = 2, palette = 3, gray_alpha = 4, rgba = 6 };

inline std::string ihdr(std::uint32_t width, std::uint32_t height, int bits, ColorType type) {
    return chunk("IHDR", be32(width) + be32(height) + static_cast<char>(bits) + static_cast<char>(type) +
                             std::string(3, '\0'));
}

// `rows`: the scanlines, each with its filter byte in front. `before`: whole chunks between IHDR and IDAT.
inline std::string file(const std::string& header, const std::string& rows, const std::string& before = {}) {
    return kSignature + header + before + chunk("IDAT", zlib_stored(rows)) + chunk("IEND", {});
}

struct Chunk {
    std::string type, data;
};

// The chunks of a well-formed file, in order.
inline std::vector<Chunk> chunks_of(const std::string& bytes) {
    std::vector<Chunk> out;
    for (std::size_t at = kSignature.size(); at < bytes.size();) {
        const std::size_t length = read_be32(std::string_view(bytes).substr(at, 4));
        out.push_back({bytes.substr(at + 4, 4), bytes.substr(at + 8, length)});
        at += 12 + length;
    }
    return out;
}

inline std::string types_of(const std::string& bytes) {
    std::string types;
    for (const Chunk& c : chunks_of(bytes))
        types += (types.empty() ? "" : " ") + c.type;
    return types;
}

} // namespace metamer::png_bytes
