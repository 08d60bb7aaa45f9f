// SPDX-License-Identifier: MIT
#include "stickslip/analytic/event_driven.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "stickslip/analytic/damped_reaction.hpp"
#include "stickslip/analytic/held_beam.hpp"
#include "stickslip/analytic/held_motion.hpp"
#include "stickslip/analytic/stick_reaction.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/method.hpp"

namespace stickslip::studies {

namespace {

HistoryRow row_of(const analytic::EventDriven& run) {
  return {.time = run.time(),
          .base_displacement = run.base_displacement(),
          .tip_displacement = run.contact_displacement() + run.base_displacement(),
          .sliding_velocity = run.sliding_velocity(),
          .friction_force = -run.friction_force(),
          .state = run.state()};
}

// Positions on the wall become positions in the frame at rest, in which the wall may move with the base.
std::vector<data::ContactEvent> events_of(const analytic::EventDriven& run,
                                          const analytic::ContactModel& model) {
  const analytic::ContactDynamics dynamics(model);
  auto events = run.events();
  for (auto& event : events) {
    dynamics.enter(event.time);
    event.position += dynamics.base_displacement(event.time) + dynamics.wall_displacement(event.time);
  }
  return events;
}

// u_t = σ w_t + sum U_n T_n_t: zero rates are the quasi-static start, and -a_n w_t a beam that moves with the base.
analytic::ContactKinematics start_of(const analytic::ContactModel& model, bool starts_with_the_base) {
  analytic::ContactKinematics start = analytic::held_start(model);
  if (!starts_with_the_base) return start;
  for (std::size_t n = 0; n < model.modes(); ++n) {
    start.amplitudes[n] = 0.0;
    start.rates[n] = -model.mass_coupling[n] * start.velocity;
  }
  return start;
}

// At rest on the wall, or, one mass, where [initial] says.
void start(analytic::EventDriven& run, const data::Case& problem, const analytic::ContactModel& model,
           bool starts_with_the_base) {
  const auto& [position, velocity] = problem.initial;
  const analytic::ContactDynamics dynamics(model);
  const double wall = dynamics.base_velocity(0.0) + dynamics.wall_velocity(0.0);
  const analytic::ContactKinematics begin = start_of(model, starts_with_the_base);
  if (problem.initial == data::InitialState() || velocity == wall)
    run.start_stuck(begin.amplitudes, begin.rates, position);
  else
    run.start_slipping({}, {}, position, velocity - wall);
}

}  // namespace

History event_driven_history(const data::Case& problem, const Sampling& sampling,
                             const solver::RunOptions& options, const RowSink& sink) {
  const int modes = problem.numerics.modes();
  std::optional<analytic::HeldBeam> beam;
  if (problem.model() == nullptr) beam.emplace(problem.beam(), problem.damping, modes);
  std::vector<double> midspan;
  if (beam) midspan = beam->shapes(0.5 * problem.beam().length());
  std::vector<std::vector<double>> shapes;
  for (const double x : sampling.positions) shapes.push_back(beam.value().shapes(x));
  const analytic::ContactModel model =
      beam ? analytic::contact_model(beam->structure(), problem) : analytic::contact_model(problem, modes);
  analytic::EventDriven run(model);
  start(run, problem, model, options.starts_with_the_base);
  History history;
  for_each_row(problem, sampling, [&](long, double time) {
    run.advance_to(time);
    HistoryRow row = row_of(run);
    if (sampling.with_reactions) {
      const auto [acceleration, base] = run.reactions();
      row.tip_acceleration = acceleration;
      row.base_reaction = base.front();
      if (beam) row.clamp_moment = base.back();
    }
    if (beam) row.midspan_displacement = analytic::absolute_displacement(midspan, run);
    for (const auto& shape : shapes) row.displacement.push_back(analytic::absolute_displacement(shape, run));
    hold_to_law(problem, history, row);
    add_row(problem, history, sink, std::move(row));
  });
  set_events(history, events_of(run, model));
  return history;
}

History event_driven_history(const analytic::ContactModel& model, const std::vector<double>& times,
                             double tolerance) {
  analytic::EventDriven run(model, {.tolerance = tolerance});
  History history;
  for (const double time : times) {
    run.advance_to(time);
    history.rows.push_back(row_of(run));
  }
  set_events(history, events_of(run, model));
  return history;
}

HistoryRow steady_crest(const data::Case& problem, const std::vector<double>& positions) {
  const analytic::StickResponse response(problem.beam(), problem.excitation(),
                                         analytic::modes_of_all(problem).first, analytic::SteadyPart::exact);
  HistoryRow crest;
  for (const double x : positions) crest.displacement.push_back(response.steady_displacement_amplitude(x));
  return crest;
}

namespace {

// The same of a model, with the residual mass of the modes that are left out.
History held_history(const data::Case& problem, const Sampling& sampling, const RowSink& sink) {
  const analytic::HeldStructure structure = analytic::held_structure(problem, problem.numerics.modes());
  const double omega = angular_frequency(problem.excitation()), limit = friction_limit(problem);
  const analytic::DampedForce force(
      analytic::damped_reaction(structure, analytic::SteadyPart::exact), omega,
      std::max(problem.numerics.duration(), sampling.times.empty() ? 0.0 : sampling.times.back()));
  const double base = analytic::contact_model(structure, problem).base_amplitude;
  History history;
  for_each_row(problem, sampling, [&](long, double time) {
    HistoryRow row{
        .time = time,
        .base_displacement = base * std::sin(omega * time),
        .tip_displacement = (1.0 - structure.wall_share) * base * std::sin(omega * time),
        .friction_force = problem.excitation().amplitude() * force.value(time) + problem.constant_force};
    if (!history.first_slip && std::abs(row.friction_force) > limit) history.first_slip = time;
    add_row(problem, history, sink, std::move(row));
  });
  return history;
}

// Under a general motion.
History held_general_history(const data::Case& problem, const Sampling& sampling, const RowSink& sink) {
  analytic::HeldMotion motion(analytic::contact_model(problem, problem.numerics.modes()));
  const double limit = friction_limit(problem), wall_at_start = motion.dynamics().wall_displacement(0.0);
  History history;
  for_each_row(problem, sampling, [&](long, double time) {
    HistoryRow row{.time = time, .friction_force = -motion.force(time)};
    row.base_displacement = motion.dynamics().base_displacement(time);
    row.tip_displacement = row.base_displacement + motion.dynamics().wall_displacement(time) - wall_at_start;
    if (!history.first_slip && std::abs(row.friction_force) > limit) history.first_slip = time;
    add_row(problem, history, sink, std::move(row));
  });
  return history;
}

}  // namespace

History closed_form_history(const data::Case& problem, const Sampling& sampling,
                            analytic::SteadyPart steady_part, const RowSink& sink) {
  if (problem.has(data::Feature::general_motion)) return held_general_history(problem, sampling, sink);
  if (problem.model() != nullptr) return held_history(problem, sampling, sink);
  const analytic::StickResponse response(problem.beam(), problem.excitation(), problem.numerics.modes(),
                                         steady_part);
  const double length = problem.beam().length(), limit = friction_limit(problem);
  History history;
  for_each_row(problem, sampling, [&](long, double time) {
    HistoryRow row{.time = time,
                   .base_displacement = response.base_displacement(time),
                   .tip_displacement = response.absolute_displacement(length, time),
                   .midspan_displacement = response.absolute_displacement(0.5 * length, time),
                   .friction_force = response.friction_force(time)};
    for (const double x : sampling.positions)
      row.displacement.push_back(response.absolute_displacement(x, time));
    if (!history.first_slip && std::abs(row.friction_force) > limit) history.first_slip = time;
    add_row(problem, history, sink, std::move(row));
  });
  return history;
}

}  // namespace stickslip::studies
