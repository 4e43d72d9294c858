#include "base/files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <unistd.h>

#include "base/error.h"

namespace metamer {

namespace fs = std::filesystem;

std::string read_file(const fs::path& path, std::size_t most_bytes) {
    std::error_code ec;
    const auto status = fs::status(path, ec);
    if (!fs::exists(status))
        throw bad_input("read", path.string(), "there is no such file");
    if (fs::is_directory(status))
        throw bad_input("read", path.string(), "it is a folder");
    std::ifstream in(path, std::ios::binary);
    if (!in)
        throw bad_input("read", path.string(), std::strerror(errno));
    std::string bytes;
    char block[1 << 16];
    while (in.read(block, sizeof block) || in.gcount() > 0) {
        bytes.append(block, static_cast<std::size_t>(in.gcount()));
        if (bytes.size() > most_bytes)
            throw bad_input("read", path.string(), "it is over " + std::to_string(most_bytes) + " bytes");
    }
    if (in.bad())
        throw bad_input("read", path.string(), "reading broke off");
    return bytes;
}

void write_file(const fs::path& path, std::string_view bytes) {
    std::error_code ec;
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, ec))
        throw bad_input("write", path.string(), "there is no folder " + folder.string());
    if (fs::is_directory(path, ec))
        throw bad_input("write", path.string(), "it is a folder");
    const fs::path part = path.string() + ".part." + std::to_string(::getpid());
    std::FILE* out = std::fopen(part.c_str(), "wb");
    if (!out)
        throw failure("write", path.string(), std::strerror(errno));
    // fclose reports what the kernel refused late (a full disk); it runs whatever fwrite said.
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), out) == bytes.size();
    const bool closed = std::fclose(out) == 0;
    const int cause = errno;
    if (written && closed)
        fs::rename(part, path, ec);
    if (!written || !closed || ec) {
        const std::string why = ec ? ec.message() : std::strerror(cause);
        fs::remove(part, ec);
        throw failure("write", path.string(), why);
    }
}

} // namespace metamer
