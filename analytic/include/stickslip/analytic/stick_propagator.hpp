// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "stickslip/analytic/contact_dynamics.hpp"

namespace stickslip::analytic {

/// What the coordinate z_k of a separated structure adds to a force: the real part of an x with
/// x_t = eigenvalue x + sine sin(Ω t) + cosine cos(Ω t).
struct ModalShare {
  std::complex<double> eigenvalue;    ///< λ_k, rad/s, Re ≤ 0; one of each complex pair
  std::complex<double> sine, cosine;  ///< of the load
  std::complex<double> start{};       ///< x(0), where a phase does not begin with 0
};

/// A stick phase, exactly: with y = (ω_n T_n, T_n_t) = Re(Z z), every z_k_t = λ_k z_k + F_k(t) with
/// Re λ_k ≤ 0 and F_k sinusoidal at Ω, plus a constant where the wall has a speed, so that
///
///     z_k(t0 + τ) = exp(λ_k τ) z_k(t0) + Σ_±Ω P exp(±i Ω t0) (exp(±i Ω τ) - exp(λ_k τ))/(±i Ω - λ_k),
///
/// written without the 0/0 at resonance. On a piece of a general motion F_k is a polynomial instead, and
///
///     z_k(t0 + τ) = q(τ) + exp(λ_k τ) (z_k(t0) - q(0)),   q_τ = λ_k q + F_k,
///
/// with the polynomial q, or, where |λ_k| times the length is below 1 and q would lose digits, its Taylor series. Where damping does not couple the held modes, λ is known for each of them (i ω_n without
/// damping). Else they are the eigenvalues of the first-order matrix (GSL), one of each complex pair.
class StickPropagator {
 public:
  /// Throws std::runtime_error if the damped eigenvectors are too nearly parallel (a critically damped mode)
  /// for nine digits. `dynamics` must outlive this.
  explicit StickPropagator(const ContactDynamics& dynamics);

  /// Begins a phase at time t with the contact at rest on the wall.
  void begin(double t, const ContactKinematics& state);

  /// Goes on at time t on the piece of the drive that `dynamics` has entered since, t not before the last begin.
  void go_on(double t);

  /// The state at time t ≥ the begin.
  [[nodiscard]] ContactKinematics state(double t) const;

  /// f_d and its rate.
  [[nodiscard]] double force(double t) const;
  [[nodiscard]] double force_rate(double t) const;

  /// What each z_k adds to f_d at a time of the piece of a general motion, by |λ_k|.
  [[nodiscard]] std::vector<double> force_terms(double t) const;

  /// The least -Re λ_k, 1/s; 0 without damping or modes.
  [[nodiscard]] double slowest_decay() const;

  /// What each z_k adds to f_d.
  [[nodiscard]] std::vector<ModalShare> force_shares() const;

  /// A bound of |d² f_d/dt²| from t to t + length.
  [[nodiscard]] double curvature_bound(double t, double length) const;

  /// The first time in from ... to at which |f_d| exceeds the limit, or nothing; |f_d(from)| ≤ limit.
  [[nodiscard]] std::optional<double> first_excess(double from, double to, double limit);

 private:
  using Complex = std::complex<double>;

  void set_uncoupled();
  void set_damped();
  void set_forcing();
  void set_drive();
  void enter_piece();
  void set_series(std::size_t k, std::span<const Complex> load, double length);
  [[nodiscard]] Complex coordinate(std::size_t k, double t) const;
  /// exp(λ_k tau) of each free_ that is not 0; an instant is often asked for more than once.
  [[nodiscard]] const std::vector<Complex>& decays(double tau) const;
  [[nodiscard]] Complex forcing(std::size_t k, double t) const;

  const ContactDynamics& dynamics_;
  double omega_;                                   // Ω
  std::vector<Complex> eigenvalue_;                // λ_k
  std::vector<Complex> shape_;                     // Z, 2 m rows of eigenvalue_.size()
  std::vector<Complex> inverse_;                   // z = W y, eigenvalue_.size() rows of 2 m
  std::vector<Complex> sine_, cosine_, constant_;  // F_k = sine sin(Ω t) + cosine cos(Ω t) + constant
  std::vector<Complex> force_weight_;              // f_d = Re sum weight z + ...
  std::vector<double> bend_;                       // of |z_k| in curvature_bound()
  double least_bend_{}, bend_growth_{};            // its part without z, and what a length adds
  Harmonic force_harmonic_;

  /// Factors of h_tt, h_t, w_tt and w_t in F_k or in f_d.
  template <typename Number>
  struct DriveRow {
    Number base_acceleration{}, base_velocity{}, wall_acceleration{}, wall_velocity{};
  };
  static constexpr std::size_t most_terms = 20;
  std::vector<DriveRow<Complex>> drive_rows_;
  DriveRow<double> force_row_;
  std::vector<std::array<Complex, most_terms>> series_;  // q or the Taylor series of z_k, in t - begin_
  std::vector<std::size_t> terms_;                       // of them
  std::vector<Complex> free_;                            // z_k(t0) - q(0)
  mutable std::vector<Complex> decays_;                  // see decays(); of one instant after the begin
  mutable double decays_at_{};
  std::array<double, most_terms> force_series_{};  // what f_d has besides them

  double begin_{};
  double position_{};  // u_c - w
  std::vector<Complex> initial_;
  double next_length_{};
};

}  // namespace stickslip::analytic
