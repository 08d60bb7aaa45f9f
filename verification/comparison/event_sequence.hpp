#pragma once

/// Changes of contact of two runs, one after the other.

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

/// "event 3 (onset at 0.0729 s)", of the event with this index, counted from 0.
[[nodiscard]] std::string description(std::size_t index, const TabulatedEvent& event);

/// How far two sequences are alike up to the horizon.
struct SequenceMatch {
  std::size_t common{};                                   ///< pairs of the same kind, from the beginning
  std::size_t missing{}, extra{};                         ///< of theirs, behind these and within the horizon
  std::size_t beyond{};                                   ///< of theirs, behind the horizon
  double until{std::numeric_limits<double>::infinity()};  ///< the earlier time of the first pair that differs
  std::string difference;                                 ///< in words, empty if there is none
};

/// An event of the reference that is within `time_tolerance` of the horizon may lie on either side of it in
/// theirs.
[[nodiscard]] SequenceMatch match(const std::vector<TabulatedEvent>& reference,
                                  const std::vector<TabulatedEvent>& theirs, double horizon,
                                  double time_tolerance);

}  // namespace stickslip::studies
