// SPDX-License-Identifier: MIT
#include "studies/verification/event_order.hpp"

#include "studies/history/method.hpp"
#include "studies/verification/finite_element_contact_model.hpp"

namespace stickslip::studies {

EventOrderStudy event_order_study(const data::Case& problem, double duration, int elements,
                                  double spectral_radius, const std::vector<int>& divisors) {
  constexpr double longest_step = 1e-4;
  const History exact = event_driven_history(finite_element_contact_model(problem, elements),
                                             sample_times(duration, longest_step));
  const auto events = onsets_and_captures(exact.events);
  EventOrderStudy study{.spectral_radius = spectral_radius,
                        .elements = elements,
                        .events = static_cast<int>(events.size()),
                        .duration = duration,
                        .time_step = {},
                        .located = {},
                        .at_end_of_step = {}};
  const auto add = [&](EventOrder& order, solver::ContactScheme scheme, int divisor) {
    const History history =
        finite_element_history(refined(problem, elements, longest_step / divisor, duration, spectral_radius),
                               {.every = divisor}, {.scheme = scheme});
    const EventDifference difference =
        largest_difference(onsets_and_captures(history.events), events, events.size());
    order.event_time_error.push_back(difference.time);
    order.event_position_error.push_back(difference.position);
    order.tip_error.push_back(largest_difference(tip_displacements(history), tip_displacements(exact)));
  };
  for (const int divisor : divisors) {
    study.time_step.push_back(longest_step / divisor);
    add(study.located, solver::ContactScheme::located, divisor);
    add(study.at_end_of_step, solver::ContactScheme::end_of_step, divisor);
  }
  for (EventOrder* order : {&study.located, &study.at_end_of_step}) {
    order->event_time_order = order_estimate(study.time_step, order->event_time_error);
    order->event_position_order = order_estimate(study.time_step, order->event_position_error);
    order->tip_order = order_estimate(study.time_step, order->tip_error);
  }
  return study;
}

}  // namespace stickslip::studies
