// SPDX-License-Identifier: MIT
#pragma once

/// The methods that compute a history, each with what it refuses: stated once, here.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stickslip/analytic/boundary_integral.hpp"
#include "stickslip/analytic/contact_model.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/data/problem.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/history/history.hpp"

namespace stickslip::studies {

/// What a method describes the beam by.
enum class Basis {
  elements,   ///< numerics.elements()
  modes,      ///< numerics.modes() of the continuous beam
  whole_beam  ///< its mobility: all modes, no mesh
};

/// One method.
struct Method {
  std::string name{};
  Basis basis{};
  /// What it cannot do. The text, with the reason, is the end of the error message "<field> is <value>, but must be".
  std::map<data::Feature, std::string> refused{};
  /// Throws data::FieldError, naming excitation.duration, for a history that would take more than minutes.
  void (*require_feasible)(const data::Case& problem){};
  /// The history of a case that require() accepts. With a sink, rows go there as they come, and History::rows is empty.
  /// Throws what the implementation throws.
  History (*run)(const data::Case& problem, const Sampling& sampling, const solver::RunOptions& options,
                 const RowSink& sink){};
  /// It goes from time step to time step, so that a row at each of them costs little.
  bool in_time_steps{};
  std::set<data::Feature> done_for_models{};  ///< what it refuses of a beam, but not of a Model

  /// Its motion goes on after the first slip.
  [[nodiscard]] bool follows_slip() const { return !refused.contains(data::Feature::slip); }
  /// Throws data::FieldError if the method cannot do the feature, which the field with that value asks for.
  void require(data::Feature feature, std::string_view field, const std::string& value) const;
  /// Throws data::FieldError for a case or an option that the method refuses or that is not feasible.
  void require(const data::Case& problem, const solver::RunOptions& options = {}) const;
};

/// All methods, by name.
[[nodiscard]] const std::vector<Method>& methods();
[[nodiscard]] std::vector<std::string> method_names();
/// Throws std::out_of_range if there is none of that name.
[[nodiscard]] const Method& method(std::string_view name);
[[nodiscard]] const Method& boundary_integral();
[[nodiscard]] const Method& closed_form();
[[nodiscard]] const Method& event_driven();
[[nodiscard]] const Method& finite_elements();

/// The contact schemes of finite elements, by name.
[[nodiscard]] const std::map<std::string, solver::ContactScheme>& contact_schemes();

/// What each method can do, as a Markdown table.
[[nodiscard]] std::string table_of_methods();

inline constexpr double most_periods_in_closed_form = 1e8, most_periods_by_events = 1e6;  // minutes of work
/// Throws data::FieldError, naming excitation.duration, if that holds more than so many periods of the excitation or of
/// the highest of numerics.modes() modes.
void require_periods(const data::Case& problem, double most_periods);

// The runs behind the methods, for studies that choose more than a case says.

/// By finite elements in time steps.
[[nodiscard]] History finite_element_history(const data::Case& problem, const Sampling& sampling = {},
                                             const solver::RunOptions& options = {},
                                             const RowSink& sink = {});

/// From event to event in the modes of the continuous beam.
[[nodiscard]] History event_driven_history(const data::Case& problem, const Sampling& sampling,
                                           const solver::RunOptions& options = {}, const RowSink& sink = {});
/// The same of any contact model with the harmonic drive of a beam, from the quasi-static start, with rows at these times;
/// without y(L/2).
[[nodiscard]] History event_driven_history(const analytic::ContactModel& model,
                                           const std::vector<double>& times, double tolerance = 1e-12);

/// By the boundary integral of the tip with boundary_integral_step(), and with twice that for History::step_effect.
[[nodiscard]] History boundary_integral_history(const data::Case& problem, const Sampling& sampling,
                                                const solver::RunOptions& options, const RowSink& sink);
/// The same with so many steps in numerics.time_step(), and without History::step_effect.
[[nodiscard]] History boundary_integral_history(const data::Case& problem, const Sampling& sampling,
                                                int steps_per_time_step);

/// The step of the boundary integral (s): numerics.time_step() divided by a power of two, so that it is at
/// most 1/20000 of the period of the first stick mode and of the excitation, and that a step, as one of twice that, has one
/// solution (analytic::require_unique_step()). Throws what stick_modes() throws.
[[nodiscard]] double boundary_integral_step(const data::Case& problem);

/// Contact before the step with that number, from steps of the boundary integral: sliding velocity, friction force and
/// state. Velocity and force are means over steps; here, the mean of the steps before and after. The force of the
/// start is extrapolated, because the tip sticks there.
[[nodiscard]] HistoryRow contact_between(const std::vector<analytic::ContactStep>& steps, std::size_t step);

/// Where the direction of sliding changes from one step to the next, with the position from 0 on.
[[nodiscard]] std::vector<data::ContactEvent> events_between(const std::vector<analytic::ContactStep>& steps,
                                                             double time_step);

/// By the free modes of the continuous beam, propagated exactly in steps (analytic::FreeModeRun), with so many steps in
/// numerics.time_step(); without damping. Velocity, force and state are those of the step before a row.
[[nodiscard]] History free_mode_history(const data::Case& problem, const Sampling& sampling,
                                        int steps_per_time_step);

/// The number of free modes for a step h: those with ω_k h ≤ 20, where ω_k grows with k², but at least 20 and at
/// most 1000. Throws what slip_modes() throws.
[[nodiscard]] int free_modes_for(const data::Beam& beam, double time_step);

/// In closed form, the tip held: Eqs. (26) to (28).
[[nodiscard]] History closed_form_history(const data::Case& problem, const Sampling& sampling,
                                          analytic::SteadyPart steady_part, const RowSink& sink = {});

}  // namespace stickslip::studies
