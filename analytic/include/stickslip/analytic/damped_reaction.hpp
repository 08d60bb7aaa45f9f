// SPDX-License-Identifier: MIT
#pragma once

/// The stick-state reaction of a structure, damped or not, that starts as Eq. (26) assumes, in closed form.
///
/// In a beam, Kelvin-Voigt damping is η times the bending stiffness, and a damping ratio holds in the modes of the beam
/// with its tip free and P = 0. Neither is diagonal in the modes of the stick state. With the N modes of
/// a HeldStructure, y = (ω_n T_n, T_n_t) = Re(Z z) separates them (StickPropagator), and per unit amplitude
///
///     f(t)/A0 = (s + m Ω²) sin(Ω t) + r Ω cos(Ω t) + Re Σ_k z_k(t),
///     z_k_t = λ_k z_k + u_k Ω² sin(Ω t) + v_k Ω cos(Ω t),       z_k(0) = 0,
///
/// where no number but Ω depends on the excitation. The solution is, with the sum over both signs,
///
///     z_k = sum P (exp(±i Ω t) - exp(λ_k t))/(±i Ω - λ_k),  P = (v_k Ω -+ i u_k Ω²)/2:
///
/// the steady vibration and free vibrations that decay.

#include <algorithm>
#include <complex>
#include <vector>

#include "stickslip/analytic/contact_model.hpp"
#include "stickslip/analytic/force_maximum.hpp"
#include "stickslip/analytic/stick_propagator.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

/// The numbers above.
struct DampedReaction {
  double quasi_static{};  ///< s = κ (k_c + l_c) - e_c, N/m; of a beam EI S'''(L) + χ P S'(L)
  double inertia{};       ///< m, N s²/m; that of what is not in the N modes, 0 for SteadyPart::modal_sum
  double rate{};          ///< r, N s/m
  /// Of z_k, with u_k (N s/m), v_k (N/m) and z_k(0)/Ω (N s/m), which is 0 if the tip is held.
  std::vector<ModalShare> shares;
};

/// With SteadyPart::modal_sum the undamped limit is ModalReaction, Eq. (28), with as many modes. With SteadyPart::exact
/// the inertia of the other modes counts statically, so that the terms at Ω fall as P n⁻⁴ + n⁻⁶. Throws what
/// StickPropagator throws. Next to critical damping of a mode two terms of up to 1e8 times the force
/// cancel; DampedForce::rounding() includes that.
[[nodiscard]] DampedReaction damped_reaction(const HeldStructure& structure,
                                             SteadyPart steady_part = SteadyPart::modal_sum);

/// The same for a tip that a spring k_t holds to the wall (data::TangentialContact), as long as its slider rests: the
/// force in the spring, f = k_t x, x = u_L - w. With X = (T, x) and the equations of contact_model.hpp
///
///     M X_tt + C X_t + (K + k_t e eᵀ) X = F(t),       X(0) = X_t(0) = 0,
///
/// and the static part x_s = s/(k_c + l_c + k_t) of X is taken out. The rest starts with X_t(0) = -x_s Ω e. For
/// large k_t it tends to SteadyPart::exact of the held tip; the static part differs by the factor k_t/(k_c + l_c + k_t). Throws what
/// require_free_mass() throws, and
/// data::FieldError, naming contact.tangential_stiffness, if the beam on its spring buckles or flutters.
[[nodiscard]] DampedReaction compliant_reaction(const HeldStructure& structure, double tangential_stiffness);

/// The reaction to one excitation frequency over 0 ≤ t ≤ duration, per unit amplitude.
class DampedForce {
 public:
  /// angular_frequency: Ω, rad/s; duration: T, s. Throws data::FieldError, naming
  /// excitation.frequency_hz or excitation.duration, unless both are positive and finite.
  DampedForce(const DampedReaction& reaction, double angular_frequency, double duration);

  /// The same of all modes, between bounds: `reaction` has N of them and `half` N/2, 40 or more and 20, both with
  /// SteadyPart::exact, and Ω is below ω_(N/2). The free vibrations of the start alternate or not, and fall as n⁻⁴, or
  /// as n⁻² where damping is their load: Kelvin-Voigt damping of the bent beam that the base sets in motion, or the
  /// coupling of the free modes by a damping ratio. Where n² |B_n| does not rise beyond N/2, and where what the other
  /// modes change of the N/2 first ones falls as 1/N or faster,
  ///
  ///     sum over n > N of |B_n|  ≤  1.04 (sum over N/2 < n ≤ N of |B_n|),
  ///
  /// as with Σ (n + 1/4)⁻² over both. So |f - f_N| ≤ E(t), 1.04 times what N/2 more modes have changed: the amplitude at
  /// Ω; each new free vibration, |B_n| exp(Re λ_n t); and of each other one, matched by its eigenvalue,
  ///
  ///     |B_k - B_k'| exp(-d t) + |B_k'| |λ_k - λ_k'| t exp(-d t),      d = min(-Re λ_k, -Re λ_k').
  ///
  /// E falls with t, so that the overshoot of the start does not widen what comes later. It has the rounding of the
  /// eigenvalues, four eps of the largest.
  DampedForce(const DampedReaction& reaction, double angular_frequency, double duration,
              const DampedReaction& half);

  /// f(t)/A0, N/m.
  [[nodiscard]] double value(double t) const { return jet(t).value; }
  /// Amplitude of the steady part, N/m.
  [[nodiscard]] double steady_amplitude() const noexcept { return steady_amplitude_; }
  /// The same between bounds: E of what is at Ω alone.
  [[nodiscard]] Bounds steady_bounds() const noexcept {
    return {std::max(0.0, steady_amplitude_ - steady_omitted_), steady_amplitude_ + steady_omitted_};
  }

  /// E(t), N/m; 0 for the modes of one reaction alone.
  [[nodiscard]] double omitted(double t) const;

  /// Bounds of max |f|/A0 over 0 ≤ t ≤ T, N/m, with upper - lower ≤ relative_width * lower + 3 rounding(), and up to
  /// 4 omitted(t) more, with t where the upper one is; rigorous for the eigenvalues and weights given, rounding included.
  ///
  /// On a piece of time of half-width r about t_c that begins at a, each term is either evaluated, and leaves
  /// |A_k λ_k³| exp(Re λ_k a) r³/6 beyond its parabola, or counts with its amplitude |A_k| exp(Re
  /// λ_k a), whichever is less. Pieces whose bound does not exceed the best value are dropped, the others
  /// halved. A term with |±i Ω - λ_k| T < 2 stays one, (exp(i Ω t) - exp(λ t))/(i Ω -
  /// λ), whose modulus is at most t. Where the free vibrations have fallen below relative_width/4 of the
  /// steady amplitude and half a period is left, that amplitude bounds the rest.
  ///
  /// Throws std::invalid_argument unless 1e-13 ≤ relative_width < 1, and data::FieldError, naming
  /// excitation.duration, if that needs more than 1e8 pieces.
  [[nodiscard]] Bounds refined_to(double relative_width = 1e-10) const;

  /// The same with less work where more is not asked, as ForceMaximum does it: an upper bound that does not exceed `enough` (N/m) may be
  /// wide, and a lower bound above `too_much` ends the search, after which the upper one says nothing.
  [[nodiscard]] Bounds refined_to(double relative_width, double enough, double too_much) const;

  /// The sum of the amplitudes with omitted(0), N/m, without a search.
  [[nodiscard]] double upper_bound() const;

  /// Bound of the rounding error of an evaluation of f/A0, N/m.
  [[nodiscard]] double rounding() const noexcept { return rounding_; }

 private:
  class Search;
  using Complex = std::complex<double>;

  // Re[amplitude exp(exponent t)], with |amplitude| and |amplitude exponent³|; that at Ω comes first.
  struct Term {
    Complex amplitude, exponent;
    double size{}, third{};
  };
  // Re[amplitude (exp(pole t) - exp(exponent t))/(pole - exponent)]
  struct NearResonantTerm {
    Complex amplitude, pole, exponent;
  };

  // amplitude exp(-rate t)
  struct Decay {
    double amplitude{}, rate{};
  };

  void bound_omitted(const DampedReaction& reaction, const DampedReaction& half);
  [[nodiscard]] TaylorCoefficients jet(double t) const;
  void add(TaylorCoefficients& sum, const Term& term, double t) const;
  void add(TaylorCoefficients& sum, const NearResonantTerm& beat, double t) const;
  [[nodiscard]] double transient_bound(double t) const;  // of the terms but the first, from t on

  double omega_, duration_;
  std::vector<Term> terms_;
  std::vector<NearResonantTerm> near_resonant_terms_;
  std::vector<Decay> omitted_;
  double steady_amplitude_{}, steady_omitted_{};
  double rounding_{};
};

}  // namespace stickslip::analytic
