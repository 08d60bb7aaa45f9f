// SPDX-License-Identifier: MIT
#include "studies/stick_slip/event_history.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "studies/convergence/convergence.hpp"

namespace stickslip::studies {

std::vector<HistoryEvent> without_micro_sticks(const std::vector<HistoryEvent>& events,
                                               double shortest_stick) {
  std::vector<HistoryEvent> kept;
  for (const HistoryEvent& event : events) {
    const bool ends_micro_stick =
        event.onset && !kept.empty() && !kept.back().onset && event.time - kept.back().time < shortest_stick;
    if (ends_micro_stick)
      kept.pop_back();
    else
      kept.push_back(event);
  }
  return kept;
}

std::optional<HistoryEvent> first_capture(const std::vector<HistoryEvent>& events) {
  const auto found = std::ranges::find(events, false, &HistoryEvent::onset);
  return found == events.end() ? std::nullopt : std::optional(*found);
}

TipHistory event_driven_history(const analytic::ContactModel& model, double duration, double sample,
                                double tolerance) {
  analytic::EventDriven run(model, {.tolerance = tolerance});
  TipHistory history;
  const long samples = std::lround(duration / sample);
  for (long n = 0; n <= samples; ++n) {
    const double t = static_cast<double>(n) * sample;
    run.advance_to(t);
    history.time.push_back(t);
    history.tip_displacement.push_back(run.contact_position());
  }
  for (const auto& event : run.events()) {
    ++history.changes;
    const bool onset = event.change == data::ContactChange::onset;
    if (onset || event.change == data::ContactChange::capture)
      history.events.push_back({onset, event.time, event.position});
  }
  return history;
}

TipHistory time_stepper_history(const data::Beam& beam, const data::FrictionLaw& friction,
                                const data::HarmonicExcitation& excitation,
                                const data::NumericalSettings& numerics, const solver::BeamRun& run,
                                double duration, int every) {
  solver::BeamSimulation simulation(beam, friction, excitation, numerics, run);
  TipHistory history;
  const long steps = solver::step_count(duration, numerics.time_step());
  for (long n = 0; n <= steps; ++n) {
    if (n > 0) simulation.step();
    if (n % every != 0) continue;
    history.time.push_back(simulation.time());
    history.tip_displacement.push_back(simulation.tip_displacement());
  }
  for (const auto& event : simulation.integrator().events()) {
    ++history.changes;
    const bool onset = event.change == data::ContactChange::onset;
    if (onset || event.change == data::ContactChange::capture)
      history.events.push_back({onset, event.time, event.position});
  }
  return history;
}

EventDifference largest_difference(const std::vector<HistoryEvent>& a, const std::vector<HistoryEvent>& b,
                                   std::size_t count) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (std::min(a.size(), b.size()) < count) return {infinity, infinity};
  EventDifference largest;
  for (std::size_t i = 0; i < count; ++i) {
    if (a[i].onset != b[i].onset) return {infinity, infinity};
    largest.time = largest_or_nan({largest.time, std::abs(a[i].time - b[i].time)});
    largest.position = largest_or_nan({largest.position, std::abs(a[i].position - b[i].position)});
  }
  return largest;
}

data::NumericalSettings refined(const data::NumericalSettings& numerics, int elements, double time_step) {
  data::NumericalChoices choices = numerics.choices();
  choices.elements = elements;
  choices.time_step = time_step;
  choices.velocity_threshold = 0.0;
  return data::NumericalSettings(choices);
}

}  // namespace stickslip::studies
