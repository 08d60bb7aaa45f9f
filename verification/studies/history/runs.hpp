// SPDX-License-Identifier: MIT
#pragma once

/// The runs behind the methods, for studies that choose more than a case says.

#include <vector>

#include "stickslip/analytic/boundary_integral.hpp"
#include "stickslip/analytic/contact_model.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "studies/history/method.hpp"

namespace stickslip::studies {

/// By finite elements in time steps.
[[nodiscard]] History finite_element_history(const data::Case& problem, const Sampling& sampling = {},
                                             const RunChoices& choices = {}, const RowSink& sink = {});

/// From event to event in the modes of the continuous beam.
[[nodiscard]] History event_driven_history(const data::Case& problem, const Sampling& sampling,
                                           const RunChoices& choices = {}, const RowSink& sink = {});
/// The same of any contact model with the harmonic drive of a beam, from the quasi-static start, with rows at these times;
/// without y(L/2).
[[nodiscard]] History event_driven_history(const analytic::ContactModel& model,
                                           const std::vector<double>& times, double tolerance = 1e-12);

/// By the boundary integral of the tip with boundary_integral_step(), and with twice that for History::step_effect.
[[nodiscard]] History boundary_integral_history(const data::Case& problem, const Sampling& sampling,
                                                const RunChoices& choices, const RowSink& sink);
/// The same with so many steps in numerics.time_step(), and without History::step_effect.
[[nodiscard]] History boundary_integral_history(const data::Case& problem, const Sampling& sampling,
                                                int steps_per_time_step);

/// The step of the boundary integral (s): numerics.time_step() divided by a power of two, so that it is at
/// most 1/20000 of the period of the first stick mode and of the excitation. Throws what stick_modes()
/// throws.
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
