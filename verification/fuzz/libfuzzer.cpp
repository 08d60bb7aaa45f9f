/// One target as libFuzzer calls it. FUZZ_TARGET is its function.

#include <cstddef>
#include <cstdint>

#include "targets/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  stickslip::fuzz::FUZZ_TARGET({data, size});
  return 0;
}
