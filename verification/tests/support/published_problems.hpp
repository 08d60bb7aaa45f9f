// SPDX-License-Identifier: MIT
#pragma once

/// Friction problems of others, one or two masses with one contact, by both implementations against the
/// closed forms of the data sets `published-problems`, `stops-per-period` and `non-stop-limits`, which the
/// README of data/reference states.

#include <array>
#include <string>
#include <vector>

#include "stickslip/data/reference.hpp"

namespace stickslip::testing {

/// Largest errors over the rows of a problem.
struct ProblemErrors {
  bool same_changes{};  ///< as many changes of the contact as the data set has, of the same kinds
  double time{};        ///< s
  double position{};    ///< m
};

/// One problem by both implementations. Predicted: the time stepper is of second order in h, so that each
/// error is a quarter of that on twice the step; the event-driven run keeps 1e-12 of each coordinate in a step.
struct PublishedProblem {
  std::string name;
  double duration{};   ///< the last time of the problem, s
  double amplitude{};  ///< the largest |position|, m
  ProblemErrors event_driven;
  double event_driven_prediction{};   ///< of either error over duration or amplitude
  std::array<double, 3> time_step{};  ///< h, h/2, h/4, s
  std::array<ProblemErrors, 3> stepped;
  /// By analytic::ModalContactRun, which does not locate a change: its time is off by up to a step, its position by
  /// a share of h^2. Not for a mass without a spring and for the pair, whose modes cannot be separated.
  bool has_spring{};
  std::array<ProblemErrors, 3> fixed_steps;
};

/// All problems of `published-problems`, with the spectral radius 0.9. Throws what the implementations throw.
[[nodiscard]] std::vector<PublishedProblem> published_problems(const data::ReferencePackage& package);

/// Captures of a mass with k = 100 N/m, m = 1 kg, mu N = 5 N, from rest at 0, in a period of the force.
struct StopCount {
  double frequency_ratio{}, force_ratio{};
  int reference{}, event_driven{}, stepped{};
};

/// The counts of `stops-per-period`; the time step is 1/500 of the shorter of the periods of force and mass.
[[nodiscard]] std::vector<StopCount> stops_per_period(const data::ReferencePackage& package);

/// For each limit of `non-stop-limits` the captures in the 40th period, from rest, with `share` of the force
/// of the limit; `reference` is -1.
[[nodiscard]] std::vector<StopCount> stops_beside_the_limit(const data::ReferencePackage& package,
                                                            double share);

}  // namespace stickslip::testing
