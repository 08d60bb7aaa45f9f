#pragma once

#include <array>
#include <csignal>
#include <functional>

namespace stickslip::cli {

/// While it lives, Ctrl-C (SIGINT) and SIGTERM do not end the program at once but at the next progress(), so
/// that nothing half-written is left behind; a second one does. A signal that is ignored stays so.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// `report`, which then throws CLI::RuntimeError with the exit status 128 + n if signal n has come.
  [[nodiscard]] std::function<void(double)> progress(std::function<void(double)> report) const;

 private:
  static constexpr std::array signals_{SIGINT, SIGTERM};
  std::array<struct sigaction, signals_.size()> previous_{};
};

}  // namespace stickslip::cli
