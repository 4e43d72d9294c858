// What a process holds on to.
#pragma once

#include <cstddef>
#include <string>

namespace metamer::test {

struct Vitals {
    std::size_t allocated = 0, resident = 0; ///< bytes: of malloc, of memory
    int descriptors = 0, threads = 0;
    int gl_objects = 0; ///< of the current context
};

Vitals vitals();

/// `12.3 MB allocated, 80.1 MB resident, 9 descriptors, 4 threads, 57 GL objects`.
std::string text_of(const Vitals& vitals);

} // namespace metamer::test
