// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "stickslip/solver/contact_system.hpp"

namespace stickslip::solver {

/// The motion h(t) of the base with its derivatives. Harmonic: h = A0 sin(Ω t), Ω = 2 π frequency_hz.
[[nodiscard]] PrescribedMotion base_motion(const data::Motion& motion);

/// The wall of a case in coordinates that move with the base: V t - h, or V t where it belongs to the base or where the excitation is
/// a force.
[[nodiscard]] PrescribedMotion wall_motion(const data::Case& problem, const PrescribedMotion& base);

/// max |h|, m; of a general motion at the begins of its pieces.
[[nodiscard]] double largest_displacement(const data::Motion& motion);

/// A term of h(t + τ) = Σ_k w_k(t) h_k(τ), the motion from any time t on.
struct ShiftedMotion {
  std::function<double(double)> weight;  ///< w_k, of t in s
  PrescribedMotion motion;               ///< h_k, of τ in s
};

/// Its terms. Throws FieldError for a general motion. Harmonic: sin(Ω t) A0 cos(Ω τ) + cos(Ω t) A0 sin(Ω τ).
[[nodiscard]] std::vector<ShiftedMotion> shifted_motion(const data::Motion& motion);

}  // namespace stickslip::solver
