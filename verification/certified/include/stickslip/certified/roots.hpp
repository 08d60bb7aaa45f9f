#pragma once

#include <functional>
#include <vector>

#include "stickslip/certified/dual.hpp"
#include "stickslip/certified/real.hpp"

namespace stickslip::certified {

/// A function and its derivative over a ball: the result's value holds F(x), its slope F'(x), for every x in
/// the argument's ball.
using DifferentiableFunction = std::function<Dual<Real>(const Real& x)>;

/// Every root of F in [lower, upper], ascending, each in a ball of its own that holds no other: a proof, not
/// a search. The interval is halved until on each piece either F excludes 0, or F' excludes 0 and the signs
/// of F at the ends say whether there is one root or none. Roots are then contracted by interval Newton steps
/// as far as the precision allows. The ends must be exact (a radius of 0).
///
/// Throws std::invalid_argument if the ends are not exact and ascending, and std::runtime_error, naming the
/// piece, if F has no certain sign at an end, or if a piece is undecided when it is 2^-depth of the interval,
/// depth = a quarter of the precision: there is a multiple root, or two that are closer than that.
[[nodiscard]] std::vector<Real> isolate_roots(const DifferentiableFunction& function, const Real& lower,
                                              const Real& upper);

/// The one root in [lower, upper], where F changes sign and F' does not. Throws as isolate_roots(), and
/// std::runtime_error if the roots are not one.
[[nodiscard]] Real isolate_root(const DifferentiableFunction& function, const Real& lower, const Real& upper);

}  // namespace stickslip::certified
