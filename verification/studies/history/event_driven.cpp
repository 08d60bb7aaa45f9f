// SPDX-License-Identifier: MIT
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/stick_reaction.hpp"

#include <cmath>
#include <utility>

#include "stickslip/analytic/held_beam.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/method.hpp"

namespace stickslip::studies {

namespace {

HistoryRow row_of(const analytic::EventDriven& run) {
  return {.time = run.time(),
          .base_displacement = -run.drive_displacement(),
          .tip_displacement = run.contact_displacement() - run.drive_displacement(),
          .sliding_velocity = run.sliding_velocity(),
          .friction_force = -run.friction_force(),
          .state = run.state()};
}

// Positions on the wall become positions in the frame at rest.
std::vector<data::ContactEvent> events_of(const analytic::EventDriven& run, double wall_speed) {
  auto events = run.events();
  for (auto& event : events) event.position += wall_speed * event.time;
  return events;
}

// u_t = σ w_t + sum U_n T_n_t: zero rates are the quasi-static start, and -a_n w_t a beam that moves with the base.
std::vector<double> rates_of(const analytic::ContactModel& model, bool starts_with_the_base) {
  std::vector<double> rates;
  if (starts_with_the_base)
    for (const double coupling : model.mass_coupling)
      rates.push_back(-coupling * (model.wall_amplitude * model.load_angular_frequency + model.wall_speed));
  return rates;
}

}  // namespace

History event_driven_history(const data::Case& problem, const Sampling& sampling,
                             const solver::RunOptions& options, const RowSink& sink) {
  const analytic::HeldBeam beam(problem.beam(), problem.damping, problem.numerics.modes());
  const std::vector<double> midspan = beam.shapes(0.5 * problem.beam().length());
  std::vector<std::vector<double>> shapes;
  for (const double x : sampling.positions) shapes.push_back(beam.shapes(x));
  const analytic::ContactModel model = analytic::contact_model(beam.structure(), problem);
  analytic::EventDriven run(model);
  run.start_stuck({}, rates_of(model, options.starts_with_the_base));
  History history;
  for_each_row(problem, sampling, [&](long, double time) {
    run.advance_to(time);
    HistoryRow row = row_of(run);
    row.midspan_displacement = analytic::absolute_displacement(midspan, run);
    for (const auto& shape : shapes) row.displacement.push_back(analytic::absolute_displacement(shape, run));
    hold_to_law(problem, history, row);
    add_row(problem, history, sink, std::move(row));
  });
  set_events(history, events_of(run, model.wall_speed));
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
  set_events(history, events_of(run, model.wall_speed));
  return history;
}

HistoryRow steady_crest(const data::Case& problem, const std::vector<double>& positions) {
  const analytic::StickResponse response(problem.beam(), problem.excitation(),
                                         analytic::modes_of_all(problem).first, analytic::SteadyPart::exact);
  HistoryRow crest;
  for (const double x : positions) crest.displacement.push_back(response.steady_displacement_amplitude(x));
  return crest;
}

History closed_form_history(const data::Case& problem, const Sampling& sampling,
                            analytic::SteadyPart steady_part, const RowSink& sink) {
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
