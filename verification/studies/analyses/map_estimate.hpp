// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "studies/analyses/criterion_map.hpp"

namespace stickslip::studies {

/// What evaluations of a map cost, from a sample that was timed.
struct MapEstimate {
  std::size_t evaluations{}, sample{};
  double seconds_each{};  ///< processor time on one thread, without the preparation that all share
  unsigned threads{};     ///< thread_count()
  double speedup{};       ///< of the sample on that many threads over one, by the clock on the wall

  [[nodiscard]] double core_hours() const { return static_cast<double>(evaluations) * seconds_each / 3600.0; }
  [[nodiscard]] double hours() const { return core_hours() / speedup; }
};

/// Times a sample of these evaluations, evenly distributed, on one thread and then on thread_count(). On one thread
/// the sample takes half a second of processor time or more, unless it is all of them. Throws what evaluate() throws.
[[nodiscard]] MapEstimate map_estimate(const MapTask& task, std::span<const std::size_t> numbers);

}  // namespace stickslip::studies
