// SPDX-License-Identifier: MIT
#include "comparison/event_sequence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace stickslip::comparison {

namespace {

enum class Step : std::uint8_t { pair, leave_reference, leave_theirs };

// The cost to leave each event without a partner.
struct LeavingCosts {
  std::vector<double> reference, theirs;
};

// How far an event of the reference may be on the other side of a limit.
double slack_of(const TabulatedEvent& event, const SequenceLimits& limits) {
  return limits.time_tolerance + event.time_radius;
}

LeavingCosts leaving_costs(const std::vector<TabulatedEvent>& reference,
                           const std::vector<TabulatedEvent>& theirs, const SequenceLimits& limits) {
  const double end = std::min(limits.horizon, limits.end);
  const double usual =
      reference.empty() ? 1.0 : 0.5 * reference.back().time / static_cast<double>(reference.size());
  LeavingCosts costs;
  for (const TabulatedEvent& event : reference) {
    const double slack = slack_of(event, limits);
    if (event.time < end - slack)
      costs.reference.push_back(usual);
    else
      costs.reference.push_back(event.time <= end + slack ? std::min(usual, slack) : 0.0);
  }
  for (const TabulatedEvent& event : theirs)
    costs.theirs.push_back(event.time <= limits.horizon ? usual : 0.0);
  return costs;
}

// The last step of the best alignment of the first i and j events, at i (theirs + 1) + j.
std::vector<Step> best_steps(const std::vector<TabulatedEvent>& reference,
                             const std::vector<TabulatedEvent>& theirs, const LeavingCosts& leaving) {
  const std::size_t width = theirs.size() + 1;
  std::vector<Step> steps((reference.size() + 1) * width, Step::leave_theirs);
  std::vector<double> cost(width, 0.0);
  for (std::size_t j = 1; j < width; ++j) cost[j] = cost[j - 1] + leaving.theirs[j - 1];
  for (std::size_t i = 1; i <= reference.size(); ++i) {
    double diagonal = cost[0];
    cost[0] += leaving.reference[i - 1];
    steps[i * width] = Step::leave_reference;
    for (std::size_t j = 1; j < width; ++j) {
      const TabulatedEvent &a = reference[i - 1], &b = theirs[j - 1];
      const double pair = a.change == b.change ? diagonal + std::abs(a.time - b.time)
                                               : std::numeric_limits<double>::infinity();
      diagonal = cost[j];
      const double without_a = cost[j] + leaving.reference[i - 1],
                   without_b = cost[j - 1] + leaving.theirs[j - 1];
      cost[j] = std::min({pair, without_a, without_b});
      steps[i * width + j] = pair <= cost[j]        ? Step::pair
                             : without_a <= cost[j] ? Step::leave_reference
                                                    : Step::leave_theirs;
    }
  }
  return steps;
}

}  // namespace

std::string description(const TabulatedEvent& event) {
  return fmt::format("event {} ({} at {:.9g} s)", event.number, event.change, event.time);
}

std::vector<TabulatedEvent> without_short_phases(const std::vector<TabulatedEvent>& events, double shortest) {
  std::vector<TabulatedEvent> left;
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (events[i].change == "reversal") {
      left.push_back(events[i]);
      continue;
    }
    std::size_t last = i;
    for (std::size_t j = i + 1; j < events.size() && events[j].time - events[last].time < shortest; ++j)
      if (events[j].change != "reversal") last = j;
    if (last == i || events[last].change == events[i].change) {
      const double half = 0.5 * (events[last].time - events[i].time);
      left.push_back(events[i]);
      left.back().time += half;
      left.back().time_radius += half;
    }
    i = last;
  }
  return left;
}

int contact_at(const std::vector<TabulatedEvent>& events, double t) {
  if (events.empty()) return 0;
  auto event = std::ranges::upper_bound(events, t, {}, &TabulatedEvent::time);
  int sign = 1;
  for (; event != events.begin() && (event - 1)->change == "reversal"; --event) sign = -sign;
  const bool slips = event == events.begin() ? event->change != "onset" : (event - 1)->change == "onset";
  return slips ? sign : 0;
}

SequenceMatch match(const std::vector<TabulatedEvent>& reference, const std::vector<TabulatedEvent>& theirs,
                    const SequenceLimits& limits) {
  std::vector<TabulatedEvent> within;
  for (const TabulatedEvent& event : reference)
    if (event.time <= limits.horizon + slack_of(event, limits)) within.push_back(event);
  const auto steps = best_steps(within, theirs, leaving_costs(within, theirs, limits));

  SequenceMatch result;
  std::size_t i = within.size(), j = theirs.size();
  while (i > 0 || j > 0) {
    const Step step = steps[i * (theirs.size() + 1) + j];
    i -= step == Step::leave_theirs ? 0 : 1;
    j -= step == Step::leave_reference ? 0 : 1;
    if (step == Step::leave_reference) {
      const double time = within[i].time, slack = slack_of(within[i], limits);
      if (time < limits.horizon - slack && time > limits.end)
        ++result.unreached;
      else if (time < std::min(limits.horizon, limits.end) - slack)
        result.missing.push_back(i);
    } else if ((step == Step::pair ? within[i] : theirs[j]).time > limits.horizon) {
      ++result.beyond;
    } else if (step == Step::pair) {
      result.pairs.emplace_back(i, j);
    } else {
      result.extra.push_back(j);
    }
  }
  std::ranges::reverse(result.pairs);
  std::ranges::reverse(result.missing);
  std::ranges::reverse(result.extra);
  return result;
}

}  // namespace stickslip::comparison
