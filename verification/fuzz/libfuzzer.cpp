// SPDX-License-Identifier: MIT
/// The entry point of libFuzzer for one target. FUZZ_TARGET is the function of the target.

#include <cstddef>
#include <cstdint>

#include "targets/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  stickslip::fuzz::FUZZ_TARGET({data, size});
  return 0;
}
