#pragma once

/// The stick state as a modal sum with every factor open to change, from the continuous beam or from the
/// matrices of a mesh.

#include <Eigen/Core>
#include <vector>

#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/data/problem.hpp"
#include "stickslip/solver/beam_model.hpp"
#include "stickslip/solver/contact_system.hpp"

namespace stickslip::studies {

/// With h = A0 sin(Omega t),
///
///     f = f_S h + f_a h_tt + sum f_n T_n,     y(L/2) = y_S h + sum y_n T_n,
///     T_n_tt + w_n^2 T_n = C_n h_tt,          T_n(0) = 0,  T_n_t(0) = V_n h_t(0).
struct StickSum {
  struct Mode {
    double natural_frequency{};     ///< omega_n, rad/s
    double oscillator_frequency{};  ///< w_n of the equation of T_n, rad/s
    double participation{};         ///< C_n = -int U (1 + S) / int U^2
    double rigid_participation{};   ///< -int U / int U^2
    double initial_rate{};          ///< V_n
    double force{};                 ///< f_n, N
    double follower_force{};        ///< P U_n'(L), N
    double displacement{};          ///< y_n
  };
  double force{};                   ///< f_S, N/m
  double force_per_acceleration{};  ///< f_a, kg
  double follower_force{};          ///< P S'(L), N/m
  double displacement{};            ///< y_S
  bool free_vibrations{true};       ///< the parts at w_n; without them only the steady vibration is left
  std::vector<Mode> modes;
};

/// Eqs. (18) to (28) in closed form. Throws what stick_modes() throws.
[[nodiscard]] StickSum stick_sum(const data::Beam& beam, int modes);

/// All modes of a mesh whose matrices are those of `system`, driven as beam_contact_system does; f is the row
/// of the contact in the slip-state balance or, if `force_row` is not empty, its product with the
/// displacements. Exact in time. follower_force and rigid_participation are not filled in.
[[nodiscard]] StickSum stick_sum(const solver::BeamModel& mesh, const solver::ContactSystem& system,
                                 const Eigen::RowVectorXd& force_row = {});

enum class StickReading { force, displacement };

/// A history of the sum as sinusoids. A mode within 1e-8 of resonance is moved off it by as much, which
/// changes the history by 1e-8 Omega t of it.
[[nodiscard]] std::vector<analytic::Sinusoid> sinusoids(const StickSum& sum,
                                                        const data::HarmonicExcitation& excitation,
                                                        StickReading reading);

[[nodiscard]] double value_at(const std::vector<analytic::Sinusoid>& terms, double t);

/// max |.| over 0 ... duration from samples, each local maximum by the parabola through three of them.
[[nodiscard]] double max_abs(const std::vector<analytic::Sinusoid>& terms, double duration,
                             double sampling_step);

/// A step of a one-step method for T_n, in the weights of generalised-alpha, which need not be the right
/// ones.
struct ModalScheme {
  double step{};                ///< s
  double alpha_m{}, alpha_f{};  ///< weights of the old state in inertia and in the other forces
  double beta{}, gamma{};       ///< Newmark's
  double load_delay{};          ///< the load is taken at t_n + load_delay
  double damping_ratio{};       ///< of critical, in every mode
};

/// A history of the sum with T_n by the scheme, at t = 0, step, ..., count * step.
[[nodiscard]] std::vector<double> stepped(const StickSum& sum, const ModalScheme& scheme,
                                          const data::HarmonicExcitation& excitation, StickReading reading,
                                          long count);

}  // namespace stickslip::studies
