#include "stickslip/report/progress_in_tenths.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "progress.hpp"

namespace stickslip::report {

std::function<void(double)> progress_in_tenths(const std::string& command) {
  return [progress = Progress(command, false), told = 0](double share) mutable {
    const int tenths = static_cast<int>(10.0 * share + 1e-9);
    if (tenths > told) progress(fmt::format("{} %", 10 * tenths));
    told = std::max(told, tenths);
  };
}

}  // namespace stickslip::report
