// SPDX-License-Identifier: MIT
#pragma once

/// The stick state as a modal sum. Each factor may be changed, in order to compute the result of a wrong
/// model. The factors come from the continuous beam or from the matrices of a mesh.

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/data/problem.hpp"
#include "stickslip/solver/beam_model.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/contact_system.hpp"

namespace stickslip::studies {

/// The modal sum of the stick state. With h = A0 sin(Ω t),
///
///     f = f_S h + f_a h_tt + sum f_n T_n,     y(L/2) = y_S h + sum y_n T_n,
///     T_n_tt + w_n² T_n = C_n h_tt,          T_n(0) = 0,  T_n_t(0) = V_n h_t(0).
struct StickSum {
  struct Mode {
    double natural_frequency{};     ///< ω_n, rad/s
    double oscillator_frequency{};  ///< w_n in the equation of T_n, rad/s
    double participation{};         ///< C_n = -int U (1 + S) / int U²
    double rigid_participation{};   ///< -int U / int U²
    double initial_rate{};          ///< V_n
    double force{};                 ///< f_n, N
    double follower_force{};        ///< (1 - χ) P U_n'(L), N
    double displacement{};          ///< y_n
  };
  double force{};                   ///< f_S, N/m
  double force_per_acceleration{};  ///< f_a, kg
  double follower_force{};          ///< (1 - χ) P S'(L), N/m
  double displacement{};            ///< y_S
  /// Whether the parts at w_n are included; otherwise only the steady vibration.
  bool free_vibrations{true};
  /// Whether h = A0 cos(Ω t) with T_n(0) = 0 and h_t(0) = 0; the terms of sinusoids() are then cosines.
  bool cosine{};
  std::vector<Mode> modes;
};

/// The sum of Eqs. (18) to (28) in closed form. Throws what stick_modes() throws.
[[nodiscard]] StickSum stick_sum(const data::Beam& beam, int modes);

/// The sum over all modes of a mesh with the matrices of `system`, driven as in beam_contact_system(). The
/// force f is the contact row of the slip-state balance or, if `force_row` is not empty, the product of
/// `force_row` with the displacements. There is no error of time integration. follower_force and
/// rigid_participation are not set. Throws data::FieldError if the stick stiffness is not positive definite.
[[nodiscard]] StickSum stick_sum(const solver::BeamModel& mesh, const solver::ContactSystem& system,
                                 const Eigen::RowVectorXd& force_row = {});

/// The quantity that is read from a StickSum: f (N) or y(L/2) (m).
enum class StickReading { force, displacement };

/// The history of a quantity as a sum of sinusoids. A mode within the relative distance 1e-8 of resonance is
/// moved away from it by the same amount. This changes the history by the fraction 1e-8 Ω t.
[[nodiscard]] std::vector<analytic::Sinusoid> sinusoids(const StickSum& sum,
                                                        const data::HarmonicExcitation& excitation,
                                                        StickReading reading);

[[nodiscard]] double value_at(const std::vector<analytic::Sinusoid>& terms, double t);

/// The largest magnitude of the sum over 0 ... duration, from samples. Each local maximum is interpolated by
/// the parabola through three samples.
[[nodiscard]] double max_abs(const std::vector<analytic::Sinusoid>& terms, double duration,
                             double sampling_step);

/// A one-step method for T_n with the parameters of generalised-alpha. The parameters may be wrong ones.
struct ModalScheme {
  double step{};                ///< s
  double alpha_m{}, alpha_f{};  ///< weights of the old state in the inertia and in the other forces
  double beta{}, gamma{};       ///< parameters of Newmark
  double load_delay{};          ///< the load is taken at t_n + load_delay
  double damping_ratio{};       ///< relative to critical, in all modes
};

/// The history of a quantity at t = 0, step, ..., count * step, where T_n is computed by the scheme.
[[nodiscard]] std::vector<double> stepped(const StickSum& sum, const ModalScheme& scheme,
                                          const data::HarmonicExcitation& excitation, StickReading reading,
                                          long count);

// Stick-slip runs of the tip for arbitrary matrices, loads and contact laws. They also compute wrong models.

constexpr std::size_t every_event = std::numeric_limits<std::size_t>::max();

/// The history of the tip, sampled at the time step, and its events.
struct TipRun {
  double step{};                           ///< time between samples, s
  std::vector<double> tip_displacement{};  ///< y(L), m
  std::vector<double> friction_force{};    ///< f, N, sign of Eq. (28)
  std::vector<double> tip_velocity{};      ///< y_t(L), m/s
  /// y(L/2), m, and y_t(L/2), m/s, if the mesh of a beam has an even number of elements.
  std::vector<double> midspan_displacement{}, midspan_velocity{};  ///< NaN on an odd number of elements
  std::vector<double> events{};                                    ///< times of onsets and captures, s
};

/// The velocities of the start: the quasi-static shape to that of the base, u_t = 0, or y_t = 0.
enum class Start { quasi_static, with_the_base, at_rest };

/// A run by the integrator of the solver with located changes. The beam starts with the quasi-static shape to the
/// displacement of the base. The run ends at `end` (s), or at the change of contact number `events`, whichever is first.
[[nodiscard]] TipRun tip_run(const solver::ContactSystem& system, const solver::PrescribedMotion& base,
                             const data::NumericalSettings& numerics, Start start, double end,
                             std::size_t events = every_event);

/// A contact law of one's own: the coefficient of friction against a sliding velocity v, f_d = -c(v) N, odd
/// or not, and whether a tip at rest is held by up to μ_s N.
struct FrictionRule {
  std::function<double(const data::FrictionLaw&, double)> coefficient;
  bool holds{true};
};

/// A run by the implicit midpoint rule. The friction force f of a step is determined by the velocity at its
/// end (Moreau's scheme): v_s = v_free + m f with the mobility m of the contact. The tip is held if v_s = 0
/// is possible with |f| ≤ μ_s N. Otherwise v_s is the root of v + m N c(v) = v_free, by bisection. The
/// method has first order in the step, which is a tenth of the time step of the case.
[[nodiscard]] TipRun tip_run(const solver::ContactSystem& system, const solver::PrescribedMotion& base,
                             const data::NumericalSettings& numerics, const FrictionRule& law, double end,
                             std::size_t events = every_event);

}  // namespace stickslip::studies
