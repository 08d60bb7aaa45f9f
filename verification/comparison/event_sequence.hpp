// SPDX-License-Identifier: MIT
#pragma once

/// The comparison of two sequences of contact changes.

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace stickslip::studies {

/// A change of contact in a table.
struct TabulatedEvent {
  std::string change;  ///< onset, capture or reversal
  double time{}, time_radius{};
  std::size_t row{};
};

/// A description such as "event 3 (onset at 0.0729 s)" of the event with this index, which counts from 0.
[[nodiscard]] std::string description(std::size_t index, const TabulatedEvent& event);

/// How far the user's sequence agrees with that of the reference up to the horizon.
struct SequenceMatch {
  /// Number of pairs of the same kind, from the beginning.
  std::size_t common{};
  /// Reference events missing, and additional user events, within the horizon.
  std::size_t missing{}, extra{};
  std::size_t beyond{};                                   ///< number of user events after the horizon
  double until{std::numeric_limits<double>::infinity()};  ///< the earlier time of the first pair that differs
  std::string difference;                                 ///< a description, empty if there is no difference
};

/// Compares two sequences up to the horizon (s). An event of the reference within `time_tolerance` (s) of the
/// horizon may be on either side of it in the user's sequence.
[[nodiscard]] SequenceMatch match(const std::vector<TabulatedEvent>& reference,
                                  const std::vector<TabulatedEvent>& theirs, double horizon,
                                  double time_tolerance);

}  // namespace stickslip::studies
