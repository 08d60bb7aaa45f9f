// SPDX-License-Identifier: MIT
#pragma once

/// Stick-slip histories without mesh and without modes: the boundary integral equation of the contact.
///
/// Let f_h(t) be the friction force that holding the contact for ever would take: with it the contact never
/// moves. By linearity, with the mobility Y (velocity of the free contact per force on it, tip_mobility.hpp),
///
///     v_s = Y(d/dt) (f_d - f_h),       f_d in -N μ(|v_s|) Sgn(v_s),       Sgn(0) = [-1, 1].
///
/// This set-valued Volterra equation for one function of time is the whole problem; stick and slip are one
/// law. (For a bowed string: McIntyre, Schumacher & Woodhouse, J. Acoust. Soc. Am. 74, 1325-1345, 1983.)
///
/// Discretisation. The friction force is constant over each step of length h, and v is its mean over the
/// step, so that h v f_d is the exact work of friction. Then
///
///     v_n = sum_(j ≤ n) W_(n-j) (f_j - f_h,j),        f_n in -N μ(|v_n|) Sgn(v_n),
///
/// f_h,j being the mean over the step. The generating function of the weights is, with the stability function
/// R of an implicit Runge-Kutta method (Lubich & Ostermann, Math. Comp. 60, 105-131, 1993) and x_i the
/// solutions of R(x) = 1/ζ,
///
///     Σ_j W_j ζ^j = ((1 - ζ)/ζ)² Σ_i Y(x_i/h)/(x_i² R'(x_i)).
///
/// With R = exp it would be the exact response to a force constant in steps. Here R is the Pade approximant
/// (k, k) of exp, the method of Gauss with k stages: A-stable, so that a passive Y stays passive; of order
/// 2k, so that waves keep their phase (k = 1 is the trapezoidal rule).
///
/// Each step is a scalar equation v = p + W_0 f. It has exactly one solution if κ W_0 < 1 with
/// κ = (μ_s - μ_m) α N, since μ falls with |v| no faster than that.

#include <complex>
#include <cstddef>
#include <functional>
#include <vector>

#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

/// Velocity of a contact per unit force on it, m/(N s), as a function of s in 1/s; real for real s.
using Mobility = std::function<std::complex<double>(std::complex<double>)>;

/// The largest number of stages of the method of Gauss.
constexpr int most_stages = 4;
constexpr int usual_stages = 3;

/// The generating function above at 0 < |ζ| < 1: the mobility of the discrete contact, m/(N s).
[[nodiscard]] std::complex<double> discrete_mobility(const Mobility& mobility, double time_step, int stages,
                                                     std::complex<double> zeta);

/// W_0 ... W_(count-1), m/(N s), by a Fourier transform over a circle in ζ; absolute error about 1e-11 max
/// |W|. Throws std::invalid_argument unless time_step > 0, count ≥ 1 and 1 ≤ stages ≤ most_stages.
[[nodiscard]] std::vector<double> mobility_weights(const Mobility& mobility, double time_step,
                                                   std::size_t count, int stages);

/// What presses the contact, and what it holds.
struct ContactLaw {
  double normal_force{};  ///< N, newton, ≥ 0
  data::FrictionLaw friction{{}};
  data::TangentialContact tangential{};
  double time_step{};  ///< h, s, > 0; only a spring needs it
};

/// Throws data::InputError, naming time_step, unless κ first_weight < 1: only then does every step
/// have one solution; naming friction.decay, if that is infinite.
void require_unique_step(const ContactLaw& law, double first_weight);

/// One step of the contact.
struct ContactStep {
  double sliding_velocity{};  ///< v, mean over the step, m/s; exactly zero in stick
  double friction_force{};    ///< f_d, N
  bool slides{};              ///< else it sticks: rigid, at rest; with a spring, the slider is at rest
};

/// The solution of v = free_velocity + weight f with f in -N μ(|v|) Sgn(v), to round-off; the only one if
/// κ weight < 1. weight > 0 in m/(N s).
[[nodiscard]] ContactStep solve_contact(const ContactLaw& law, double free_velocity, double weight);

/// The contact of data::TangentialContact, step by step, with the memory of its spring.
///
/// A smooth law takes f(v) in place of the set-valued law. The spring is taken in the middle of the step, x + h v/2,
/// that is f = k_t (z - x - h v/2), cut to the bound at v; z then follows. With a passive mobility this is the
/// midpoint rule: stable for any k_t h, and of second order in h.
class ContactElement {
 public:
  explicit ContactElement(const ContactLaw& law) : law_(law) {}

  /// The next step, where v = free_velocity + weight f: as solve_contact().
  ContactStep step(double free_velocity, double weight);

 private:
  [[nodiscard]] ContactStep smooth_step(double free_velocity, double weight) const;
  ContactStep spring_step(double free_velocity, double weight);

  ContactLaw law_;
  double spring_force_{};  // k_t (z - x) at the beginning of the step, N
};

/// sum_(j ≤ n) W_(n-j) x_j for every n < x.size(), by one Fourier transform. `weights` has at least that
/// size.
[[nodiscard]] std::vector<double> convolution(const std::vector<double>& weights,
                                              const std::vector<double>& x);

/// The steps of a contact with mobility weights W, started at rest, under the holding forces f_h (means over the steps,
/// N): one for each, in O(N log² N) operations (Hairer, Lubich & Schlichte, SIAM J. Sci. Stat. Comput. 6, 532-541,
/// 1985). Throws std::invalid_argument if there are more steps than weights, and what require_unique_step() throws.
[[nodiscard]] std::vector<ContactStep> contact_steps(const std::vector<double>& weights,
                                                     const ContactLaw& law,
                                                     const std::vector<double>& holding_force);

/// Where the contact is on the wall at the beginning and after every so many steps, m.
[[nodiscard]] std::vector<double> contact_positions(const std::vector<ContactStep>& steps, double time_step,
                                                    std::size_t every);

}  // namespace stickslip::analytic
