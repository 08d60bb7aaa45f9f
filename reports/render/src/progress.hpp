#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <string>
#include <utility>

namespace stickslip::report {

/// One line per stage on standard error, for a person at a terminal.
class Progress {
 public:
  Progress(std::string command, bool quiet)
      : command_(std::move(command)), speaks_(!quiet && ::isatty(STDERR_FILENO) == 1) {}

  void operator()(const std::string& stage) const {
    if (speaks_) fmt::print(stderr, "stickslip {}: {}\n", command_, stage);
  }

 private:
  std::string command_;
  bool speaks_;
};

}  // namespace stickslip::report
