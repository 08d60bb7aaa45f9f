// SPDX-License-Identifier: MIT
#include "comparison/event_sequence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stickslip::studies {

std::string description(std::size_t index, const TabulatedEvent& event) {
  return fmt::format("event {} ({} at {:.9g} s)", index + 1, event.change, event.time);
}

SequenceMatch match(const std::vector<TabulatedEvent>& reference, const std::vector<TabulatedEvent>& theirs,
                    double horizon, double time_tolerance) {
  const auto is_within = [horizon](const TabulatedEvent& event) { return event.time <= horizon; };
  const auto is_at_horizon = [&](const TabulatedEvent& event) {
    return std::abs(event.time - horizon) <= time_tolerance + event.time_radius;
  };
  const auto within = static_cast<std::size_t>(std::ranges::count_if(reference, is_within));
  SequenceMatch result;
  std::size_t& i = result.common;
  while (i < std::min(within, theirs.size()) && reference[i].change == theirs[i].change) ++i;

  // The last reference event within the horizon may be missing because the user's run ends before it. The
  // first reference event after the horizon may be before the horizon in the user's run.
  const bool last_is_late = i == theirs.size() && i + 1 == within && is_at_horizon(reference[i]);
  result.missing = last_is_late ? 0 : within - i;
  result.extra = static_cast<std::size_t>(
      std::count_if(theirs.begin() + static_cast<std::ptrdiff_t>(i), theirs.end(), is_within));
  const bool next_is_early = i == within && i < reference.size() && result.extra == 1 &&
                             reference[i].change == theirs[i].change && is_at_horizon(reference[i]);
  if (next_is_early) result.extra = 0;
  result.beyond = theirs.size() - i - result.extra;
  if (result.missing + result.extra == 0) return result;

  if (result.missing > 0) result.until = reference[i].time;
  if (result.extra > 0) result.until = std::min(result.until, theirs[i].time);
  if (result.missing > 0 && result.extra > 0)
    result.difference =
        fmt::format("{} is {} in the file", description(i, reference[i]), description(i, theirs[i]));
  else if (result.missing > 0)
    result.difference = fmt::format("{} is missing in the file", description(i, reference[i]));
  else
    result.difference = fmt::format("{} of the file is not in the data set", description(i, theirs[i]));
  return result;
}

}  // namespace stickslip::studies
