// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "chebyshev_table.hpp"
#include "stickslip/analytic/damped_reaction.hpp"

namespace stickslip::analytic {

/// What a DampedReaction of a beam depends on, made dimensionless with L, EI and ρA, whose frequency is ν = √(EI/(ρA L⁴)).
struct DampedNumbers {
  double load_factor{};  ///< z = P L²/EI
  /// q: ζ if there is one damping ratio alone, η ν if there is Kelvin-Voigt damping alone, δ/ν if mass-proportional damping alone. Of any
  /// other damping, which is then the same in all beams, ν.
  double damping{};
};
[[nodiscard]] DampedNumbers damped_numbers(const data::Case& problem);
/// Whether two cases differ in these numbers and in their units alone: beams rigid in shear with one χ, one wall and one kind of damping.
[[nodiscard]] bool are_alike(const data::Case& one, const data::Case& other);

/// The damped reactions of beams that are alike, without integrals and eigenvalues. With m = ρ A L
///
///     s = m ν² ŝ,   inertia = m m̂,   r = m ν r̂,   λ = ν λ̂,   u = m ν û,   v = m ν² v̂,
///
/// and of the two eigenvalues λ, λ' of a mode, with the transfer u/(s - λ) + u'/(s - λ') = (a s + b)/(s² + p s + q), the numbers p, q, a
/// and b, which are smooth through critical damping. The dimensionless ones are interpolated in z and q (ChebyshevTable), until their last
/// coefficients are at most what eigenvalues and eigenvectors are rounded by: 16 eps |λ̂|_max for λ̂, and |λ̂|_max/|λ̂|_min as much,
/// relative, for û.
class DampedReactionTable {
 public:
  /// Nothing if that takes more than `most_points` reactions.
  [[nodiscard]] static std::optional<DampedReactionTable> of(const data::Case& first,
                                                             const Bounds& load_factor, const Bounds& damping,
                                                             int modes, SteadyPart part,
                                                             std::size_t most_points);

  /// Whether the case is like the first one, and its numbers are in the range.
  [[nodiscard]] bool holds(const data::Case& problem) const;
  /// damped_reaction() of its structure; holds(problem) must be true.
  [[nodiscard]] DampedReaction at(const data::Case& problem) const;

 private:
  DampedReactionTable(const data::Case& first, ChebyshevTable table);

  data::Case first_;
  ChebyshevTable table_;
};

}  // namespace stickslip::analytic
