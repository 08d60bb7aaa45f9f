// SPDX-License-Identifier: MIT
#pragma once

/// The comparison of two sequences of contact changes.

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace stickslip::comparison {

struct TabulatedEvent {
  std::string change;  ///< onset, capture or reversal
  double time{}, time_radius{};
  std::size_t row{};
  std::size_t number{};  ///< in its sequence, from 1
};

/// A description such as "event 3 (onset at 0.0729 s)".
[[nodiscard]] std::string description(const TabulatedEvent& event);

/// The events without the stick and slip phases that are shorter than `shortest` (s), and without the
/// reversals inside them. Of several short phases in a row, which change the contact, one event is left. Its
/// time is the middle of them, and its radius reaches to their ends.
[[nodiscard]] std::vector<TabulatedEvent> without_short_phases(const std::vector<TabulatedEvent>& events,
                                                               double shortest);

/// The contact just after the time t: 0 in stick, +1 or -1 in slip. The sign changes at each reversal and is +1
/// after an onset. Before the first event it is the one that this event changes.
[[nodiscard]] int contact_at(const std::vector<TabulatedEvent>& events, double t);

/// How far two sequences are to be compared, s.
struct SequenceLimits {
  double horizon = std::numeric_limits<double>::infinity();  ///< of the comparison
  double end = std::numeric_limits<double>::infinity();      ///< of the user's run
  /// An event of the reference nearer than this and its radius to one of these times may be on either side.
  double time_tolerance = 0.0;
};

/// The alignment of two sequences. All numbers are indices of events.
struct SequenceMatch {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;  ///< of the reference and of the user
  /// Events of the reference without a partner, and events of the user without one, within the limits.
  std::vector<std::size_t> missing, extra;
  std::size_t unreached{};  ///< events of the reference after the end of the user's run
  std::size_t beyond{};     ///< events of the user after the horizon
};

/// Aligns two sequences of events in time. Of all alignments that keep the order and pair events of the same
/// kind only, it takes the one of least cost. A pair costs the difference of its times, an event without a
/// partner costs half the mean distance between the events of the reference. Two events that are farther apart
/// than this mean distance are therefore never a pair. Events outside the limits cost nothing.
[[nodiscard]] SequenceMatch match(const std::vector<TabulatedEvent>& reference,
                                  const std::vector<TabulatedEvent>& theirs, const SequenceLimits& limits);

}  // namespace stickslip::comparison
