// SPDX-License-Identifier: MIT
#pragma once

/// Warnings for cases that leave the range of validity of the model or of the numerical method, and errors
/// for cases whose computation is not feasible. A case with a warning is computed as asked for, but its
/// result is less accurate than it seems.

#include <optional>
#include <string>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/history/method.hpp"
#include "studies/history/natural_frequencies.hpp"

namespace stickslip::studies {

enum class Concern {
  flutter,
  buckling,
  resonance,
  near_resonance,
  few_modes,
  thick_beam,
  coarse_mesh,
  long_step,
  growth,
  structure_mass,
  base_alone
};

struct Warning {
  Concern concern{};
  double
      value{};  ///< what was found: P (N), Ω/2π (Hz), |f_max| (N), a relative frequency error, h (s), σ* (1/s), mass (kg), a share
  /// Flutter or buckling load, ω_n/2π, |f_max| with all modes, allowed error, suggested step, allowed σ*.
  double limit{};
  std::string sentence;
};

/// The largest relative frequency error, from rotary inertia and shear, at which Euler-Bernoulli theory is
/// accepted.
constexpr double allowed_model_error = 0.05;
/// The least distance √(d² + ζ²) of the excitation from a natural frequency, d = (ω_n - Ω)/Ω and ζ the damping ratio of the mode. The
/// mode vibrates in proportion to its inverse, so that 1 % of error in ω_n changes the force by up to 10 % at this distance, by up
/// to 20 % at half of it.
constexpr double least_resonance_distance = 0.1;
/// A mode is relevant if its free vibration has more than this fraction of max |f|.
constexpr double share_that_matters = 0.01;

/// The error of a free vibration of angular frequency ω (rad/s) by generalised-alpha with time_step (s):
/// the larger of the relative frequency error and the relative loss of amplitude per period. For small ω
/// h it is about (ω h)² (k_1 + k_2)/2, with k_1 and k_2 of discretisation.hpp.
[[nodiscard]] double step_error(double spectral_radius, double omega, double time_step);

/// The number of the highest mode, up to numerics.modes(), whose free vibration has more than
/// share_that_matters of max |f|; 1 if there is none. max |f| is estimated from 2048 instants, which
/// are not commensurate with the periods. They cover the duration, or one period of the excitation and of the
/// first mode if that is longer. The result does not depend on the amplitude.
[[nodiscard]] int highest_mode_that_matters(const data::Case& problem);

/// How much of max |f| rows with this spacing H (s) may miss: between two rows a vibration rises above them by 1 - cos(ω H/2),
/// and by all of its size from half a period on,
///
///     1 - cos(Ω H/2) + Σ share_n (1 - cos(ω_n H/2)).
[[nodiscard]] double row_effect(const data::Case& problem, double spacing);

/// The warnings for a case, each at most once, in the order of Concern. All of them have
/// - thick beam: stick_model_error() of the highest relevant mode is above allowed_model_error, and the beam has no shear
///   stiffness.
///
/// Of a history by a method:
/// - flutter or buckling, if it follows the slip: instability_warning();
/// - resonance and few modes, if it does not: resonance_warning(), too_few_modes();
/// - coarse mesh, by elements: coarse_mesh_warning();
/// - long step, by elements: step_error() of the highest relevant mode, or of a vibration at Ω, is above 1 %. The limit is the
///   largest allowed step, rounded down to two digits.
///
/// Throws what stick_modes() throws.
[[nodiscard]] std::vector<Warning> history_warnings(const data::Case& problem, const Method& method);
/// Of the criterion: resonance, or else near resonance where least_resonance_distance is not kept; few modes; a thick beam without
/// damping with its shear_effect(). First structure_warnings().
[[nodiscard]] std::vector<Warning> criterion_warnings(const data::Case& problem);
/// Of matrices, what they cannot tell by themselves: less than 1 g or more than 10 t follow base and contact, as with files in other
/// units, or the structure, moved with its base, pulls at the contact by more than 1e-6 of its stiffness there.
[[nodiscard]] std::vector<Warning> structure_warnings(const data::Case& problem);
/// Of |f_max| over a band up to the excitation frequency of the case: few modes.
[[nodiscard]] std::vector<Warning> design_warnings(const data::Case& problem);
/// Of so many natural frequencies: thick beam, by the highest of them; with the tip free by slip_model_error().
[[nodiscard]] std::vector<Warning> frequency_warnings(const data::Case& problem, analytic::TipSupport tip,
                                                      int count);

/// The warning that slip of the case grows at its axial force (slip_instability()), with the load from which on it does. The
/// criterion and a design need it where the tip slips.
[[nodiscard]] std::optional<Warning> instability_warning(const data::Case& problem);

/// The warning, for an undamped |f| in closed form, that a natural frequency of the stick state is so close to Ω that |f| grows over
/// the whole duration T, |Ω - ω_n| T ≤ π (half a beat), and reaches at least ten times the quasi-static response, Ω T/2 ≥ 10.
[[nodiscard]] std::optional<Warning> resonance_warning(const data::Case& problem);

/// The warning that too_few_modes() of the case, if there are.
[[nodiscard]] std::optional<Warning> few_modes_warning(const data::Case& problem);

/// The warning that the mesh may change more of max |f| than allowed_model_error, unless the held beam is buckled: each free vibration
/// changes by its share times the phase that the relative error e of its frequency (mesh_frequency_error()) makes until it has decayed,
/// at the rate d,
///
///     e(Ω) + e_s + Σ share_n min(2, e_n (1 + ω_n min(T, 1/d_n))),    T = numerics.duration(),
///
/// at most 1 in the first two terms; e_s, hermite_eigenvalue_error() of the first mode, is that of the stiffness next to buckling. An
/// upper estimate: over many beats max |f| does not depend on the phases.
[[nodiscard]] std::optional<Warning> coarse_mesh_warning(const data::Case& problem);

/// What shear and rotary inertia change in |f_max| and in the verdict, by the undamped criterion of all modes with
/// with_shear(), as the end of a sentence. Throws what analytic::criterion_with_all_modes() throws.
[[nodiscard]] std::string shear_effect(const data::Case& problem);

/// The warning for a history, by time steps or event-driven, in which the contact changed: σ* T > 36, with
/// σ* of the discretisation (contact_growth.hpp) and T = numerics.duration(). By the bound exp(σ* t) a
/// rounding error may then grow to the size of the motion, because exp(36) is about 1/eps of double precision;
/// the observed growth is slower. `value` is σ*, and `limit` is 36/T. No warning for more than 200 elements
/// or modes, 50 with damping, where σ* would take seconds.
///
/// The sentence also gives
/// - σ* of the beam, with Kelvin-Voigt damping but without other damping and without shear;
/// - if σ* of the run is above 1.1 times that of the beam: settings with about the σ* of the beam,
///   which are the spectral radius 0 and ω_max h = filtering_angle (history_convergence.hpp);
/// - if σ* T of the beam is also above 36 and there is no other damping: the time up to which the bound is useful
///   for any discretisation.
///
/// Throws what the run itself throws.
[[nodiscard]] std::optional<Warning> growth_warning(const data::Case& problem, const Method& method);

/// Throws data::FieldError, naming excitation.duration, for a history T by the boundary integral in which slip_instability() grows by
/// more than exp(σ T), σ T = 7.4. Its contour lies at eps^(-1/3) a block of weights (beam_boundary_integral.hpp), so that a motion that
/// grows comes back with the relative error exp(2 (σ T - 12)), 1e-4 there; the weights are the same in stick and slip.
void require_held_growth(const data::Case& problem, const Method& method);

/// The history_warnings() of a history that was computed, then
/// what the changes of contact leave open (an alternating force with Kelvin-Voigt damping and a spectral radius above 0,
/// growth_warning() or else changes that twice the step or, event-driven, half as many modes more do not
/// find, and changes within a step of the boundary integral), that rows do not obey the law of friction, and that the closed form does not hold beyond its first slip.
[[nodiscard]] std::vector<std::string> warnings_after(const data::Case& problem, const Method& method,
                                                      const History& history,
                                                      const solver::RunOptions& options = {});

/// The time steps from look to look at a history whose method takes any times: the longest divisor of the row step, in steps of
/// 1, 2 and 5, with a row_effect() of at most 1 %; or 1.
[[nodiscard]] long look_step(const data::Case& problem, long row_step);

/// The warning that rows are too far apart: longer than half a period of the base, so that they show another motion; or, for a
/// method that does not go from step to step, a row_effect() of the looks, `look_step` time steps apart, above allowed_model_error.
[[nodiscard]] std::optional<std::string> row_warning(const data::Case& problem, const Method& method,
                                                     long look_step, long row_step);

/// The warning that fixed steps h (analytic::ModalContactRun) are too long: (ω h)²/24, the relative error of the impulse of a
/// constant force on the highest mode that matters, is above 1 %.
[[nodiscard]] std::optional<std::string> fixed_step_warning(const data::Case& problem, double step);

/// The relative error of the linear curvature for a tip that is deflected by w (m) relative to the base. A beam has the
/// curvature y''/(1 + y'²)^(3/2), which y'' exceeds by 3/2 y'² to leading order; a cantilever with a force at its tip has the largest slope
/// there, 3 w/(2 L), so that
///
///     error = 27/8 (w/L)².
[[nodiscard]] double curvature_error(const data::Beam& beam, double deflection);

/// The warning that a deflection of the tip leaves the theory of small slopes: curvature_error() above allowed_model_error,
/// which is 12 % of the length.
[[nodiscard]] std::optional<std::string> deflection_warning(const data::Case& problem, double deflection);

/// The stiffness (N/m) of the spring that keeps P to 10 % as the tip draws back by that way (m): P/10 over the way.
[[nodiscard]] double spring_that_keeps(const data::Beam& beam, double draw_back);

/// The warning that the axial force hardly stays constant: a way above allowed_draw_back, for which P must compress that spring by
/// more than 1 mm.
constexpr double allowed_draw_back = 1e-4;  // m
[[nodiscard]] std::optional<std::string> draw_back_warning(const data::Case& problem, double draw_back);

/// The warnings for the criterion that hold for all values of the varied parameters: none of few modes, no resonance warning if
/// one of them changes a frequency, no thick-beam warning if the length or the section is varied, and no warning if P is not
/// below the buckling load.
[[nodiscard]] std::vector<Warning> warnings_common_to(const data::Case& problem,
                                                      const std::vector<std::string_view>& varied);

/// Throws data::FieldError for a criterion or a design that would take more than minutes, with more than 1e8 periods of the highest
/// natural frequency or of the excitation, naming excitation.duration; and for a wall that moves.
void require_feasible(const data::Case& problem);

}  // namespace stickslip::studies
