// SPDX-License-Identifier: MIT
#include "stickslip/certified/roots.hpp"

#include <stdexcept>
#include <string>

namespace stickslip::certified {
namespace {

struct Piece {
  Real lower, upper;
  int sign_at_lower{}, sign_at_upper{};
  long depth{};
};

std::string text(const Real& lower, const Real& upper) {
  return enclosure(lower, 17).value + " and " + enclosure(upper, 17).value;
}

/// A point inside the interval and the value of F there, whose sign is certain.
struct Cut {
  Real point, value;
};

/// The midpoint or, if F has no certain sign there, a point near it.
Cut cut(const DifferentiableFunction& function, const Piece& piece) {
  for (const int share : {32, 27, 37, 22, 42}) {
    const Real point = (piece.lower + (piece.upper - piece.lower) * share / 64).midpoint();
    const Real value = function(point).value;
    if (value.certain_sign() != 0) return {point, value};
  }
  throw std::runtime_error("The function has no certain sign between " + text(piece.lower, piece.upper) +
                           "; the precision is too low, or a root is not simple.");
}

/// Reduces a ball that contains exactly one root and on which F' does not contain 0. Each interval Newton
/// step removes at least one side of the midpoint. The iteration ends when F has no certain sign there.
Real contracted(const DifferentiableFunction& function, Real root) {
  for (;;) {
    const Real middle = root.midpoint();
    const Real newton = intersection(root, middle - function(middle).value / function(root).slope);
    if (!(newton.radius() * 4 < root.radius() * 3)) return newton;
    root = newton;
  }
}

}  // namespace

std::vector<Real> isolate_roots(const DifferentiableFunction& function, const Real& lower,
                                const Real& upper) {
  if (!(lower.radius() <= 0 && upper.radius() <= 0 && lower < upper))
    throw std::invalid_argument("The ends of an interval of roots are " + text(lower, upper) +
                                "; they must be exact and ascending.");
  const long deepest = precision() / 4;
  std::vector<Piece> open{
      {lower, upper, function(lower).value.certain_sign(), function(upper).value.certain_sign(), 0}};
  if (open.front().sign_at_lower == 0 || open.front().sign_at_upper == 0)
    throw std::runtime_error("The function has no certain sign at the ends of the interval between " +
                             text(lower, upper) + ".");

  std::vector<Real> roots;
  while (!open.empty()) {
    const Piece piece = open.back();
    open.pop_back();
    const Real whole = hull(piece.lower, piece.upper);
    const Dual<Real> range = function(whole);
    if (range.value.certain_sign() != 0) continue;
    if (range.slope.certain_sign() != 0) {
      if (piece.sign_at_lower != piece.sign_at_upper) roots.push_back(contracted(function, whole));
      continue;
    }
    const Cut middle = cut(function, piece);
    // The mean value form is narrower than the range on a short interval.
    if ((middle.value + range.slope * (whole - middle.point)).certain_sign() != 0) continue;
    if (piece.depth == deepest)
      throw std::runtime_error("Roots between " + text(piece.lower, piece.upper) +
                               " cannot be separated at this precision.");
    const int sign = middle.value.certain_sign();
    open.push_back({middle.point, piece.upper, sign, piece.sign_at_upper, piece.depth + 1});
    open.push_back({piece.lower, middle.point, piece.sign_at_lower, sign, piece.depth + 1});
  }
  return roots;
}

Real isolate_root(const DifferentiableFunction& function, const Real& lower, const Real& upper) {
  const std::vector<Real> roots = isolate_roots(function, lower, upper);
  if (roots.size() != 1)
    throw std::runtime_error(std::to_string(roots.size()) + " roots lie between " + text(lower, upper) +
                             "; there must be one.");
  return roots.front();
}

}  // namespace stickslip::certified
