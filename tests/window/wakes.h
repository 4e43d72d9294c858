// How often a thread slept: a count, where seconds would measure the machine.
#pragma once

#include <sys/resource.h>

namespace metamer::test {

/// The calling thread's voluntary context switches (getrusage(2)).
inline long wakes() {
    rusage usage{};
    getrusage(RUSAGE_THREAD, &usage);
    return usage.ru_nvcsw;
}

} // namespace metamer::test
