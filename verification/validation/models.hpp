// SPDX-License-Identifier: MIT
#pragma once

/// What the models say of the quantities that the records are read for.

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "validation/estimators.hpp"

namespace stickslip::validation {

using Values = std::map<std::string, double>;

/// The slider with a rigid contact and constant coefficients (theory.md, Sect. 17): with D = (μ_s - μ_k) m g ω/(k V)
///
///     period = (2/ω) (π - arctan D + D),     force_range = 2 √((μ_s - μ_k)² + (k V/(ω m g))²),
///     fall_time = (arccos(-0.8) - arccos(0.8))/ω,     mean_force = μ_k,
///     rise_ratio = force_range m g/(k V (period - π/ω)).
[[nodiscard]] Values rigid_slider(const Slider& slider, double kinetic, double excess);

/// The force of the spring of that motion in parts of the weight, t in s after the start of a slip.
[[nodiscard]] double rigid_slider_force(const Slider& slider, double kinetic, double excess, double t);

/// A contact spring k_t (N/m) in series with constant friction F (N) and a play b (m) under a stroke of 2 X (m), X > F/k_t +
/// b/2: slip_force = F, energy = 4 F (X - F/k_t - b/2) a cycle.
[[nodiscard]] Values damper_loop(double amplitude, double slip_force, double contact_stiffness, double play);

/// A clamped strip without axial load, its tip free.
struct Strip {
  double modulus{200e9};   ///< E, Pa
  double density{7850.0};  ///< ρ, kg/m³
  double length{0.759};    ///< L, m
  double height{5.14e-3};  ///< h, m, in the direction of the vibration
};

/// `frequency_1` to `frequency_4`, Hz: b_n² h √(E/(12 ρ))/(2 π L²) with cosh(b_n) cos(b_n) = -1.
[[nodiscard]] Values strip_frequencies(const Strip& strip);

/// What a model says at its inputs, and the standard uncertainty by independent inputs to first order: the root of the sum of
/// squares of half the differences between the model at value + uncertainty and value - uncertainty.
[[nodiscard]] Figures propagated(const std::function<Values(const std::vector<double>&)>& model,
                                 const std::vector<Figure>& inputs);

}  // namespace stickslip::validation
