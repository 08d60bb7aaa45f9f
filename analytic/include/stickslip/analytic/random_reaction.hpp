// SPDX-License-Identifier: MIT
#pragma once

/// The force that holds the contact under stationary random motions of base and wall (data::PowerSpectrum), in closed form and by
/// realisations. The contact has always been held, so that the force is stationary as well.

#include <complex>
#include <cstdint>
#include <vector>

#include "stickslip/analytic/contact_model.hpp"
#include "stickslip/analytic/held_motion.hpp"

namespace stickslip::analytic {

/// The spectra that move a case; nullptr for what rests.
struct RandomDrive {
  const data::PowerSpectrum* base{};
  const data::PowerSpectrum* wall{};
  double base_scale{1.0}, wall_scale{1.0};
};
/// Nothing for a case that is not Case::is_random().
[[nodiscard]] RandomDrive random_drive(const data::Case& problem);

/// f_d of a held structure whose base or wall has the acceleration exp(iωt), from the equations of contact_model.hpp with u_c = w.
class HeldTransfer {
 public:
  using Complex = std::complex<double>;

  /// `model` must outlive this.
  explicit HeldTransfer(const ContactModel& model)
      : model_(model), is_uncoupled_(model.damping.empty() || model.is_uncoupled()) {}

  /// What each mode adds, and last what follows at once, N/(m/s²). ω > 0, rad/s.
  [[nodiscard]] std::vector<Complex> terms(double omega, bool of_wall) const;
  /// Their sum.
  [[nodiscard]] Complex force(double omega, bool of_wall) const;

 private:
  [[nodiscard]] std::vector<Complex> amplitudes(double omega, const std::vector<Complex>& load) const;

  const ContactModel& model_;
  bool is_uncoupled_;
};

/// The moments of the one-sided spectral density S_f = Σ |H|² S of the force over base and wall, λ_j = ∫ (2πf)^j S_f df, by Gauss and
/// Legendre's rule in intervals that are halved until they change λ_0 and λ_2 by less than 1e-12.
struct RandomReaction {
  double deviation{};       ///< σ = √λ_0, N
  double rate_deviation{};  ///< √λ_2, N/s
  double bandwidth{};       ///< √(1 - λ_1²/(λ_0 λ_2))
  std::vector<double>
      mode_shares;  ///< E[f_n f]/σ² of each mode; what is left of 1 follows base and wall at once
  std::vector<BandShare>
      bands;  ///< the part of σ² in each octave between powers of 2 Hz, as a share in place of a force

  /// How often |f| grows beyond the limit, 1/s (Rice, 1944): √λ_2/(π σ) exp(-limit²/(2 σ²)).
  [[nodiscard]] double crossings(double limit) const;
  /// The probability that |f| does so in a time: by Poisson's law, as if crossings were independent, 1 - exp(-ν T), ...
  [[nodiscard]] double poisson(double limit, double time) const;
  /// ... and of those that come in clumps (Vanmarcke, J. Appl. Mech. 42, 215-220, 1975), r = limit/σ,
  ///
  ///     1 - (1 - exp(-r²/2)) exp(-ν T (1 - exp(-√(π/2) δ^1.2 r))/(1 - exp(-r²/2))).
  [[nodiscard]] double vanmarcke(double limit, double time) const;
  /// The limit, N, that |f| exceeds in the time with this probability, by vanmarcke().
  [[nodiscard]] double exceeded_with(double probability, double time) const;
  /// σ (c + 0.5772/c), c² = 2 ln(ν_0 T): the expected largest |f| (Davenport, 1964), N.
  [[nodiscard]] double expected_largest(double time) const;
};

/// With so many held modes and the inertia of all others. Throws data::FieldError, naming damping.ratio, for a structure without damping,
/// which vibrates more and more, and naming excitation.spectrum for a case that is not random.
[[nodiscard]] RandomReaction random_reaction(const data::Case& problem, int modes);
/// Of a model with damping.
[[nodiscard]] RandomReaction random_reaction(const ContactModel& model, const RandomDrive& drive);

/// The largest |f| of realisations of a case over its duration, by a Fourier transform of the lines with 32 instants in a period of the
/// highest one and parabolas between them: to 1e-5 of it. Realisation i has the seeds of the case and i more.
class RandomRealisations {
 public:
  /// Throws as random_reaction().
  RandomRealisations(const data::Case& problem, int modes);
  /// Over `duration`, s; what `drive` points to must outlive this.
  RandomRealisations(const ContactModel& model, const RandomDrive& drive, double duration);

  [[nodiscard]] double largest(std::uint64_t realisation) const;  ///< N; of many threads at once
  /// f at those instants, N.
  [[nodiscard]] std::vector<double> force(std::uint64_t realisation) const;
  [[nodiscard]] std::size_t instants() const noexcept { return instants_; }

 private:
  RandomDrive drive_;
  double duration_;
  std::size_t instants_{};
  std::vector<HeldTransfer::Complex> of_base_, of_wall_;  // by line
};

}  // namespace stickslip::analytic
