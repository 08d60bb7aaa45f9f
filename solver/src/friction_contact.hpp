// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "stickslip/solver/contact_system.hpp"

namespace stickslip::solver {

/// What the contact of a ContactSystem holds, and how it resists sliding.
class FrictionContact {
 public:
  explicit FrictionContact(const ContactSystem& system);

  [[nodiscard]] bool is_bonded() const noexcept { return std::isinf(limit_); }

  /// |force| - mu_s N, N: above zero the contact cannot be held. Minus infinity if it is bonded.
  [[nodiscard]] double excess(double force) const noexcept {
    return is_bonded() ? -limit_ : std::abs(force) - limit_;
  }

  /// f_d, N, in slip in `direction` = +1 or -1.
  [[nodiscard]] double force(double direction, double sliding_velocity) const;

  /// f_d at the alpha level of a slip step, N, where the sliding velocity is free_velocity + mobility f_d.
  /// The only solution if require_unique_force() does not throw.
  [[nodiscard]] double alpha_level_force(double direction, double free_velocity, double mobility) const;

  /// Throws std::runtime_error, naming the time and the longest possible step, unless mobility N (mu_s -
  /// mu_m) alpha < 1: the friction law would fall faster than a step can follow.
  void require_unique_force(double mobility, double time, double time_step) const;

 private:
  [[nodiscard]] double weakening() const noexcept;

  data::FrictionLaw law_;        // in slip
  double normal_force_, limit_;  // N, mu_s N
};

}  // namespace stickslip::solver
