// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "stickslip/solver/contact_system.hpp"

namespace stickslip::solver {

/// -1 or +1, the latter at zero.
[[nodiscard]] inline double sign(double value) noexcept { return value < 0.0 ? -1.0 : 1.0; }

/// What the contact of a ContactSystem holds, and how it resists sliding.
class FrictionContact {
 public:
  explicit FrictionContact(const ContactSystem& system);

  [[nodiscard]] bool is_bonded() const noexcept { return std::isinf(limit_); }

  /// |force| - μ_s N, N: above zero the contact cannot be held. Minus infinity if it is bonded.
  [[nodiscard]] double excess(double force) const noexcept {
    return is_bonded() ? -limit_ : std::abs(force) - limit_;
  }

  /// f_d, N, in slip in `direction` = +1 or -1.
  [[nodiscard]] double force(double direction, double sliding_velocity) const;

  /// f_d at the α level of a slip step, N, where the sliding velocity is free_velocity + mobility f_d.
  /// The only solution if require_unique_force() does not throw.
  [[nodiscard]] double alpha_level_force(double direction, double free_velocity, double mobility) const;

  /// Whether a spring or a smooth law holds the contact: it then moves in stick too, by the equations of slip.
  [[nodiscard]] bool yields() const noexcept { return !tangential_.is_rigid(); }

  /// f_d, N, of a contact that yields, at a position on the wall and a sliding velocity; the slider is where the
  /// spring has no force.
  [[nodiscard]] double yielding_force(double slider, double position, double sliding_velocity) const;

  /// The force, N, cut to the bound of a contact that yields.
  [[nodiscard]] double bounded(double force, double sliding_velocity) const;

  /// Sliding velocity and position on the wall at the α level of a step without f_d, and what a unit f_d adds.
  struct Response {
    double velocity{}, position{};
    double mobility{}, flexibility{};
  };
  /// The f_d, N, at the α level that is yielding_force() of the motion it causes. The only solution if
  /// require_unique_force() does not throw.
  [[nodiscard]] double solve_yielding_force(double slider, const Response& response) const;

  /// Where the slider is after a step to the position and velocity given, and whether it has moved, in the direction
  /// +1 or -1; else 0. A smooth law has no slider and always slides.
  struct Slider {
    double position{}, direction{};
  };
  [[nodiscard]] Slider advance_slider(double slider, double position, double sliding_velocity) const;

  /// Throws std::runtime_error, naming the time and the longest possible step, unless mobility N (μ_s -
  /// μ_m) α < 1: the friction law would fall faster than a step can follow.
  void require_unique_force(double mobility, double time, double time_step) const;

 private:
  data::FrictionLaw law_;  // in slip
  data::TangentialContact tangential_;
  double normal_force_, limit_;  // N, μ_s N
};

}  // namespace stickslip::solver
