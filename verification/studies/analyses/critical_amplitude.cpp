// SPDX-License-Identifier: MIT
#include "studies/analyses/critical_amplitude.hpp"

#include <cmath>
#include <cstddef>

#include "stickslip/solver/beam_simulation.hpp"
#include "studies/common/parallel.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::studies {

namespace {

CriticalAmplitudeSearch search(const data::Beam& beam, const data::FrictionLaw& friction,
                               const data::NumericalSettings& numerics, double hz, double increment,
                               double cap) {
  const int steps = static_cast<int>(std::lround(cap / increment));
  const auto at = [&](double amplitude) {
    return data::HarmonicExcitation({.frequency_hz = hz, .amplitude = amplitude});
  };
  CriticalAmplitudeSearch result;
  result.frequency_hz = hz;
  result.increment = increment;
  result.cap = cap;
  const double limit = friction_limit(friction, beam);
  result.linear =
      increment * limit /
      solver::max_abs_friction_force(beam, at(increment), numerics, {}, solver::Coordinates::fastest);
  const double multiple = std::floor(result.linear / increment) + 1.0;
  if (multiple <= steps) result.stepped_linear = multiple * increment;
  while (!result.searched && result.runs < steps) {
    ++result.runs;
    const double amplitude = result.runs * increment;
    if (solver::first_slip(beam, friction, at(amplitude), numerics, {}, solver::Coordinates::fastest))
      result.searched = amplitude;
  }
  return result;
}

}  // namespace

std::vector<CriticalAmplitudeSearch> critical_amplitude_searches(const data::Beam& beam,
                                                                 const data::FrictionLaw& friction,
                                                                 const data::NumericalSettings& numerics,
                                                                 const std::vector<double>& frequencies_hz,
                                                                 double increment, double cap) {
  std::vector<CriticalAmplitudeSearch> searches(frequencies_hz.size());
  in_parallel(searches.size(), [&](std::size_t i) {
    searches[i] = search(beam, friction, numerics, frequencies_hz[i], increment, cap);
  });
  return searches;
}

std::vector<double> figure6_frequencies() {
  std::vector<double> frequencies;
  for (int i = 1; i <= 20; ++i) frequencies.push_back(5.0 * i);
  return frequencies;
}

}  // namespace stickslip::studies
