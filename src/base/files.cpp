#include "base/files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <unistd.h>

#include "base/error.h"

namespace metamer {

namespace fs = std::filesystem;

namespace {

// Writes to `to`; errors are about `path`.
void write_to(const fs::path& to, std::string_view bytes, const fs::path& path) {
    std::FILE* out = std::fopen(to.c_str(), "wb");
    if (!out)
        throw failure("write", path.string(), std::strerror(errno));
    // fclose reports what the kernel refused late (a full disk); it runs whatever fwrite said.
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), out) == bytes.size();
    const int early = errno;
    const bool closed = std::fclose(out) == 0;
    if (!written || !closed)
        throw failure("write", path.string(), std::strerror(written ? errno : early));
}

} // namespace

std::string read_file(const fs::path& path, std::size_t most_bytes) {
    std::error_code ec;
    const auto status = fs::status(path, ec);
    if (!fs::exists(status))
        throw bad_input("read", path.string(), "there is no such file");
    if (fs::is_directory(status))
        throw bad_input("read", path.string(), "it is a folder");
    if (!fs::is_regular_file(status)) // reading may wait for somebody who never writes
        throw bad_input("read", path.string(), "it is a pipe or a device, no file");
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
    if (const auto status = fs::status(path, ec); fs::exists(status) && !fs::is_regular_file(status))
        return write_to(path, bytes, path);
    // A link stays a link: the file behind it is the one to replace.
    const fs::path target = fs::is_symlink(path, ec) ? fs::weakly_canonical(path, ec) : path;
    const fs::path part = target.string() + ".part." + std::to_string(::getpid());
    try {
        write_to(part, bytes, path);
        fs::rename(part, target, ec);
        if (ec)
            throw failure("write", path.string(), ec.message());
    } catch (const Error&) {
        fs::remove(part, ec);
        throw;
    }
}

} // namespace metamer
