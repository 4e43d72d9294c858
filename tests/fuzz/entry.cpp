// libFuzzer's entry to one target, METAMER_FUZZ_TARGET.
#include <cstddef>
#include <cstdint>

#include "fuzz/targets.h"

// libFuzzer's own name: https://llvm.org/docs/LibFuzzer.html
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    metamer::fuzz::METAMER_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
    return 0;
}
