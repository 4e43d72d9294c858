#include "soak/vitals.h"

#include <GLES2/gl2.h>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <malloc.h>

#include "base/printed.h"

#if defined(__SANITIZE_ADDRESS__)
// Of the sanitizers' run time; gcc 12 ships no header for it.
extern "C" std::size_t __sanitizer_get_current_allocated_bytes();
#endif

namespace metamer::test {

namespace {

/// Far above any name that a run here reaches without losing objects; drivers hand out the lowest free one.
constexpr GLuint kMostNames = 4096;

std::size_t allocated_bytes() {
#if defined(__SANITIZE_ADDRESS__)
    return __sanitizer_get_current_allocated_bytes();
#else
    const auto info = mallinfo2();
    return info.uordblks + info.hblkhd;
#endif
}

std::size_t resident_bytes() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (std::size_t kilobytes = 0; word == "VmRSS:" && status >> kilobytes)
            return kilobytes * 1024;
    return 0;
}

int entries(const char* folder) {
    return static_cast<int>(
        std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()));
}

int gl_objects() {
    int count = 0;
    for (GLuint name = 1; name < kMostNames; ++name)
        for (const auto is :
             {glIsTexture, glIsBuffer, glIsFramebuffer, glIsRenderbuffer, glIsProgram, glIsShader})
            count += is(name) == GL_TRUE ? 1 : 0;
    return count;
}

} // namespace

Vitals vitals() {
    return {allocated_bytes(), resident_bytes(), entries("/proc/self/fd"), entries("/proc/self/task"),
            gl_objects()};
}

std::string text_of(const Vitals& vitals) {
    return printed("%.2f MB allocated, %.1f MB resident, %d descriptors, %d threads, %d GL objects",
                   static_cast<double>(vitals.allocated) / 1e6, static_cast<double>(vitals.resident) / 1e6,
                   vitals.descriptors, vitals.threads, vitals.gl_objects);
}

} // namespace metamer::test
