#pragma once

/// Where a case leaves the ground of its model or of its numerics without being wrong: what is computed then
/// is what was asked for, but it means less than it seems to. And where a case asks for more than can be
/// done.

#include <optional>
#include <string>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::studies {

/// What is asked of a case.
enum class Inquiry {
  stick_frequencies,
  slip_frequencies,
  criterion,            ///< |f_max|, in closed form
  closed_form_history,  ///< Eqs. (26) to (28)
  event_driven_history,
  boundary_integral_history,
  stepped_history,  ///< finite elements and generalised-alpha
  design            ///< |f_max| over a band up to the excitation frequency of the case
};

enum class Concern { flutter, resonance, thick_beam, long_step, growth };

struct Warning {
  Concern concern{};
  double value{};  ///< what was found: P (N), Omega/2pi (Hz), a relative error of a frequency, h (s), sigma*
  double limit{};  ///< where the concern begins: flutter load, omega_n/2pi, allowed error, suggested step
  std::string sentence;
};

/// The largest relative error of a frequency, by rotary inertia and shear, for which Euler-Bernoulli passes.
constexpr double allowed_model_error = 0.05;
/// The largest relative error of frequency, and of amplitude in one period, that a time step may make.
constexpr double allowed_step_error = 0.01;
/// A mode matters if its free vibration has more than this share of max |f|.
constexpr double share_that_matters = 0.01;
/// The response to a resonance counts as grown when it is this many times the quasi-static one.
constexpr double grown_response = 10.0;

/// E/(kappa G) of a rectangular section, kappa = 5/6 and a Poisson ratio of 1/4. A case has neither.
constexpr double shear_flexibility = 3.0;

/// By how much Euler-Bernoulli overestimates a natural frequency of the stick or the slip state, relative to
/// the true one, at P small against kappa G A: rotary inertia adds rho I int U'^2 to the mass rho A int U^2,
/// and shear adds (EI)^2 int U'''^2/(kappa G A) to the flexibility, so that with r^2 = I/A
///
///     omega_EB/omega - 1 = sqrt(1 + r^2 [int U'^2/int U^2 + E/(kappa G) int U'''^2/int U''^2]) - 1,
///
/// which is sqrt(1 + (k r)^2 (1 + E/(kappa G))) - 1 for half waves of wave number k. Throws what
/// stick_modes() and slip_modes() throw.
[[nodiscard]] double stick_model_error(const data::Beam& beam, int mode);
[[nodiscard]] double slip_model_error(const data::Beam& beam, int mode);

/// What a step of generalised-alpha does to a free vibration of angular frequency omega (rad/s): the larger
/// of the relative error of its frequency and of the loss of amplitude in one period. About (omega h)^2 (k_1
/// + k_2)/2 of discretisation.hpp where omega h is small.
[[nodiscard]] double step_error(double spectral_radius, double omega, double time_step);

/// The number of the highest mode, of at most numerics.modes(), whose free vibration has more than
/// share_that_matters of max |f| over the duration, at least a period of the excitation and of the first mode
/// (estimated from 2048 instants that no period is commensurate with); 1 if none has. Both are proportional
/// to the amplitude, which does not enter.
[[nodiscard]] int highest_mode_that_matters(const data::Case& problem);

/// The warnings that a case deserves, each once, in the order of Concern:
/// - flutter, for histories that can slip: P at the flutter load of the slip state or over it;
/// - resonance, for an undamped |f| in closed form: a natural frequency of stick so near to Omega that |f|
/// grows
///   all the time, |Omega - omega_n| T <= pi (half a beat), to grown_response times the quasi-static response
///   or more, Omega T/2 >= grown_response;
/// - thick beam: stick_model_error of the highest mode that matters (of the highest one asked for) above
///   allowed_model_error;
/// - long step, for time stepping: step_error of the highest mode that matters, or of a vibration at Omega,
///   above allowed_step_error. The limit is the step, rounded down to two digits, at which it is that.
/// `frequencies` is how many were asked for. Throws what stick_modes() throws.
[[nodiscard]] std::vector<Warning> problem_warnings(const data::Case& problem, Inquiry inquiry,
                                                    int frequencies = 0);

/// exp(sigma* T) above 1/eps of double precision: sigma* T above this number.
constexpr double allowed_growth = 36.0;
/// growth_warning() is silent about larger systems, whose sigma* would take seconds: elements of a mesh or
/// modes, without and with damping.
constexpr int most_undamped_for_growth = 200, most_damped_for_growth = 50;

/// The warning of a stepped or event-driven history in which the contact changed: sigma* T > allowed_growth,
/// with sigma* of its own discretisation (contact_growth.hpp) and T = numerics.duration(). By the bound
/// exp(sigma* T) a rounding error may then grow to the size of the motion; observed growth is slower. value
/// is sigma*, limit allowed_growth/T. The sentence also gives sigma* of the beam, with Kelvin-Voigt damping
/// but without damping.ratio; the settings that have about that of the beam, if the run's is more than 1.1
/// times it (spectral radius 0 and omega_max h = filtering_angle, history_convergence.hpp); and, if sigma* T
/// of the beam is above allowed_growth too and damping.ratio is 0, the time up to which the bound is of use
/// for any discretisation. Throws what the run itself throws.
[[nodiscard]] std::optional<Warning> growth_warning(const data::Case& problem, Inquiry inquiry);

/// Those of the criterion that hold wherever these parameters of the case are varied: no resonance if one of
/// them moves a frequency, no thick beam if the length is among them, and none at all of a case whose P is at
/// the buckling load or over it.
[[nodiscard]] std::vector<Warning> warnings_common_to(const data::Case& problem,
                                                      const std::vector<Parameter>& varied);

/// The step of the boundary integral, s: numerics.time_step() divided by a power of two, at most 1/20000 of
/// the period of the first stick mode and of the excitation. Throws what stick_modes() throws.
[[nodiscard]] double boundary_integral_step(const data::Case& problem);

/// Throws data::FieldError, naming numerics.duration, if a closed form would have to follow more than 1e8
/// periods of the highest natural frequency kept, or of the excitation, an event-driven history more than
/// 1e6, or a boundary integral more than 2^24 steps: minutes of work. Naming damping.ratio for a boundary
/// integral: the mobility is known in closed form with Kelvin-Voigt damping alone.
void require_feasible(const data::Case& problem, Inquiry inquiry);

}  // namespace stickslip::studies
