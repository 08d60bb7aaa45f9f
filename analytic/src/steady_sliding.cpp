// SPDX-License-Identifier: MIT
#include "stickslip/analytic/steady_sliding.hpp"

#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_linalg.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "arguments.hpp"
#include "beam_constants.hpp"
#include "friction_in_slip.hpp"
#include "gsl_handles.hpp"
#include "separated_system.hpp"
#include "special_functions.hpp"
#include "stickslip/analytic/contact_dynamics.hpp"
#include "stickslip/analytic/periodic_motion.hpp"
#include "stickslip/analytic/tip_mobility.hpp"

namespace stickslip::analytic {
namespace {

using Complex = std::complex<double>;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

// d/ds of an analytic function, by Cauchy's formula with four nodes: what is left is (1e-3)⁴.
template <class Function>
Complex derivative(const Function& function, Complex s) {
  const double radius = 1e-3 * std::abs(s);
  const Complex i(0.0, 1.0);
  return (function(s + radius) - function(s - radius) -
          i * (function(s + i * radius) - function(s - i * radius))) /
         (4.0 * radius);
}

// A root of Z(s) = κ in the upper half plane, by Newton's method from a guess.
std::optional<Complex> root_near(const Mobility& mobility, double kappa, Complex guess) {
  const auto excess = [&](Complex s) { return 1.0 / mobility(s) - kappa; };
  Complex s = guess;
  for (int i = 0; i < 40; ++i) {
    const Complex change = excess(s) / derivative(excess, s);
    s -= change;
    if (!std::isfinite(std::abs(s)) || s.imag() <= 0.0) return std::nullopt;
    if (std::abs(change) <= 16.0 * kEpsilon * std::abs(s)) return s;
    // What rounding leaves of Z where its terms cancel.
    if (i > 20 && std::abs(change) <= 1e-10 * std::abs(s)) return s;
  }
  return std::nullopt;
}

// Im Z(i ω) = 0 by Newton's method.
std::optional<HopfPoint> hopf_near(const Mobility& mobility, double guess) {
  const auto impedance = [&](Complex s) { return 1.0 / mobility(s); };
  double omega = guess;
  for (int i = 0; i < 60; ++i) {
    const Complex s(0.0, omega);
    const double change = impedance(s).imag() / derivative(impedance, s).real();
    omega -= change;
    if (!std::isfinite(omega) || omega <= 0.0) return std::nullopt;
    if (std::abs(change) <= 16.0 * kEpsilon * omega || (i > 30 && std::abs(change) <= 1e-10 * omega))
      return HopfPoint{impedance({0.0, omega}).real(), omega};
  }
  return std::nullopt;
}

// Followed from κ = 0 in equal steps.
std::optional<Complex> root_at(const Mobility& mobility, double kappa, Complex free_root) {
  constexpr int steps = 16;
  Complex root = free_root, before = free_root;
  for (int i = 1; i <= steps; ++i) {
    const auto next = root_near(mobility, kappa * i / steps, root + (root - before));
    if (!next) return std::nullopt;
    before = root;
    root = *next;
  }
  return root;
}

gsl_complex to_gsl(Complex value) { return gsl_complex_rect(value.real(), value.imag()); }

}  // namespace

double falling_slope(const data::FrictionLaw& friction, double normal_force, double speed) {
  return -slip_resistance(friction.in_slip(), normal_force, std::abs(speed)).slope;
}

double speed_of_slope(const data::FrictionLaw& friction, double normal_force, double slope) {
  return speed_of_fall(friction.in_slip(), normal_force, slope);
}

SteadySliding steady_sliding(const data::Beam& beam, const data::FrictionLaw& friction,
                             const data::Wall& wall) {
  const double length = beam.length(), z = axial_load_factor(beam);
  const double force = std::copysign(
      slip_resistance(friction.in_slip(), beam.axial_force(), std::abs(wall.speed())).force, wall.speed());
  return {force, force * std::pow(length, 3) / bending_stiffness(beam) * (stumpff(2, z) - stumpff(3, z)) /
                     (1.0 - beam.axial_direction() * z * stumpff(2, z))};
}

SteadySliding steady_sliding(const data::Case& problem) {
  const data::Wall& wall = problem.contact.wall;
  if (problem.model() == nullptr) return steady_sliding(problem.beam(), problem.contact.friction, wall);
  const double stiffness = held_structure(problem, 1).contact_stiffness;
  if (!(stiffness > 0.0))
    throw data::FieldError("model.stiffness", stiffness, "above 0 (N/m) for steady sliding");
  const double force = std::copysign(
      slip_resistance(problem.contact.friction.in_slip(), problem.normal_force(), std::abs(wall.speed()))
          .force,
      wall.speed());
  return {force, force / stiffness};
}

// M x = μ (K + s M) x, μ = 1/(ω² + s): rounding is relative to the lowest. The shift s is for a contact that nothing holds.
std::vector<double> free_angular_frequencies(const HeldStructure& structure) {
  const StatusInsteadOfAbort guard;
  const std::size_t m = structure.modes(), size = m + 1;
  Matrix mass(size, size), stiffness(size, size);
  for (std::size_t n = 0; n < m; ++n) {
    if (structure.follower[n] != 0.0) throw wrong_argument("follower", structure.follower[n], "0");
    mass(n, n) = 1.0;
    mass(n, m) = mass(m, n) = structure.mass_coupling[n];
    stiffness(n, n) = std::pow(structure.angular_frequency[n], 2);
  }
  mass(m, m) = structure.contact_mass;
  stiffness(m, m) = structure.contact_stiffness;
  const double shift = structure.contact_stiffness > 0.0 ? 0.0 : m > 0 ? 1e-3 * stiffness(0, 0) : 1.0;
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j) stiffness(i, j) += shift * mass(i, j);
  const auto left = gsl_copy_of(mass), right = gsl_copy_of(stiffness);
  const auto vectors = owned(gsl_matrix_alloc(size, size));
  const auto values = owned(gsl_vector_alloc(size));
  const auto workspace = owned(gsl_eigen_gensymmv_alloc(size));
  require_success(gsl_eigen_gensymmv(left.get(), right.get(), values.get(), vectors.get(), workspace.get()),
                  "modes of the free contact");
  gsl_eigen_gensymmv_sort(values.get(), vectors.get(), GSL_EIGEN_SORT_VAL_DESC);
  constexpr double massless = 1e-12;
  std::vector<double> frequencies;
  for (std::size_t n = 0; n < size; ++n) {
    const double value = gsl_vector_get(values.get(), n);
    if (!(value > massless * gsl_vector_get(values.get(), 0))) break;
    frequencies.push_back(std::sqrt(std::max(0.0, 1.0 / value - shift)));
  }
  return frequencies;
}

std::vector<Complex> sliding_eigenvalues(const ContactModel& model, double kappa) {
  require_free_mass(model);
  const ContactDynamics dynamics(model);
  const double unit = dynamics.fastest();
  const std::vector<double> scale(model.modes() + 1, unit);
  std::vector<Complex> roots = eigenvalues(first_order_matrix(dynamics, scale, unit, 0.0, kappa));
  std::erase_if(roots, [](Complex s) { return s.imag() < 0.0; });
  for (Complex& s : roots) s *= unit;
  std::ranges::sort(roots, std::greater(), [](Complex s) { return s.real(); });
  return roots;
}

Mobility contact_mobility(const data::Case& problem, const ContactModel& model) {
  if (problem.model() == nullptr && problem.damping.is_kelvin_voigt())
    return TipMobility(problem.beam(), problem.damping);
  return contact_mobility(model);
}

namespace {

// With the modes eliminated, each for itself: s² (m_c - a . a) and what each of them adds.
Complex uncoupled_mobility(const ContactModel& model, Complex s) {
  const std::size_t m = model.modes();
  const auto damping = [&](std::size_t i, std::size_t j) {
    return model.damping.empty() ? 0.0 : s * model.damping(i, j);
  };
  Complex impedance =
      s * s * model.free_mass() + damping(m, m) + model.contact_stiffness + model.contact_follower;
  for (std::size_t n = 0; n < m; ++n) {
    const double coupling = model.mass_coupling[n];
    const Complex held = damping(n, n) + std::pow(model.angular_frequency[n], 2),
                  row = damping(m, n) + model.follower[n], column = damping(n, m), mode = s * s + held;
    if (mode == 0.0) return 0.0;
    impedance += (s * s * coupling * (coupling * held - row - column) - row * column) / mode;
  }
  return impedance == 0.0 ? std::numeric_limits<double>::infinity() : s / impedance;
}

}  // namespace

Mobility contact_mobility(const ContactModel& model) {
  require_consistent(model);
  if (model.is_uncoupled()) return [model](Complex s) { return uncoupled_mobility(model, s); };
  return [model](Complex s) {
    const StatusInsteadOfAbort guard;
    const std::size_t m = model.modes(), size = m + 1;
    const auto matrix = owned(gsl_matrix_complex_alloc(size, size));
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; j < size; ++j) {
        Complex entry = model.damping.empty() ? 0.0 : s * model.damping(i, j);
        if (i == j)
          entry += i < m ? s * s + std::pow(model.angular_frequency[i], 2)
                         : s * s * model.contact_mass + model.contact_stiffness + model.contact_follower;
        if (i < m && j == m) entry += s * s * model.mass_coupling[i];
        if (i == m && j < m) entry += s * s * model.mass_coupling[j] + model.follower[j];
        gsl_matrix_complex_set(matrix.get(), i, j, to_gsl(entry));
      }
    }
    const auto permutation = owned(gsl_permutation_alloc(size));
    const auto unit = owned(gsl_vector_complex_calloc(size));
    gsl_vector_complex_set(unit.get(), m, gsl_complex_rect(1.0, 0.0));
    int sign = 0;
    require_success(gsl_linalg_complex_LU_decomp(matrix.get(), permutation.get(), &sign), "contact mobility");
    const int status = gsl_linalg_complex_LU_svx(matrix.get(), permutation.get(), unit.get());
    if (status == GSL_EDOM) return Complex(std::numeric_limits<double>::infinity());  // s is an eigenvalue
    require_success(status, "contact mobility");
    const gsl_complex flexibility = gsl_vector_complex_get(unit.get(), m);
    return s * Complex(GSL_REAL(flexibility), GSL_IMAG(flexibility));
  };
}

std::vector<SlidingMode> sliding_modes(const Mobility& mobility,
                                       const std::vector<double>& angular_frequencies, double kappa) {
  const auto impedance = [&](Complex s) { return 1.0 / mobility(s); };
  std::vector<SlidingMode> modes;
  for (const double omega : angular_frequencies) {
    // Off the axis, on which Y may be infinite.
    const auto free_root = root_near(mobility, 0.0, Complex(-1e-6, 1.0) * omega);
    const auto is = [](Complex root, Complex other) {
      return std::abs(root - other) < 1e-6 * std::abs(other);
    };
    if (!free_root || (!modes.empty() && is(*free_root, modes.back().free_root))) break;
    auto hopf = hopf_near(mobility, free_root->imag());
    if (hopf) {  // of this mode, or of another one
      const auto root = root_at(mobility, hopf->slope, *free_root);
      if (!root || !is(*root, Complex(0.0, hopf->angular_frequency))) hopf.reset();
    }
    const Complex residue = 1.0 / derivative(impedance, *free_root);
    modes.push_back({.free_root = *free_root,
                     .one_mode_slope = -free_root->real() / residue.real(),
                     .hopf = hopf,
                     .root = root_at(mobility, kappa, *free_root)});
  }
  return modes;
}

}  // namespace stickslip::analytic
