// SPDX-License-Identifier: MIT
#include "studies/verification/stick_history.hpp"

#include <cmath>

#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/common/convergence.hpp"
#include "studies/common/discretisation.hpp"

namespace stickslip::studies {

namespace {

struct SampledHistory {
  std::vector<double> displacement, force;
};

// A run with a bonded tip, of which every `stride`-th step is kept.
SampledHistory finite_element_history(const data::Beam& beam, const data::HarmonicExcitation& excitation,
                                      const data::NumericalSettings& numerics, long stride) {
  const data::FrictionLaw unused({});
  solver::BeamSimulation simulation(beam, unused, excitation, numerics,
                                    {.contact = solver::TipContact::bonded});
  const long steps = solver::step_count(numerics.duration(), numerics.time_step());
  SampledHistory history;
  for (long n = 0; n <= steps; ++n) {
    if (n > 0) simulation.step();
    if (n % stride != 0) continue;
    history.displacement.push_back(simulation.midspan_displacement());
    history.force.push_back(simulation.friction_force());
  }
  return history;
}

data::NumericalSettings refined(const data::NumericalSettings& numerics, int level) {
  data::NumericalChoices choices = numerics.choices();
  choices.elements <<= level;
  choices.time_step /= std::pow(4.0, level);
  return data::NumericalSettings(choices);
}

}  // namespace

StickHistoryStudy stick_history_study(const data::Beam& beam, const data::HarmonicExcitation& excitation,
                                      const data::NumericalSettings& numerics, int levels) {
  StickHistoryStudy study;
  const double midspan = 0.5 * beam.length();
  const analytic::StickResponse exact(beam, excitation, 200, analytic::SteadyPart::exact);
  const long samples = solver::step_count(numerics.duration(), numerics.time_step());
  for (long n = 0; n <= samples; ++n) {
    const double t = static_cast<double>(n) * numerics.time_step();
    study.time.push_back(t);
    study.displacement.push_back(exact.absolute_displacement(midspan, t));
    study.force.push_back(exact.friction_force(t));
  }
  const std::vector<double> zero(study.time.size());
  study.displacement_peak = largest_difference(study.displacement, zero);
  study.force_peak = largest_difference(study.force, zero);

  const auto free_displacement = exact.transient_displacement(midspan);
  const auto free_force = exact.transient_force();
  for (int k = 0; k < levels; ++k) {
    const data::NumericalSettings level = refined(numerics, k);
    SampledHistory computed = finite_element_history(beam, excitation, level, 1L << (2 * k));
    const double displacement_error = largest_difference(computed.displacement, study.displacement);
    const double force_error = largest_difference(computed.force, study.force);
    study.levels.push_back({level.elements(), level.time_step(), displacement_error, force_error,
                            drift_bound(beam, exact.modes(), free_displacement, level, numerics.duration()),
                            drift_bound(beam, exact.modes(), free_force, level, numerics.duration()),
                            displacement_error / study.displacement_peak, force_error / study.force_peak});
    if (k == 0) {
      study.first_displacement = std::move(computed.displacement);
      study.first_force = std::move(computed.force);
    }
  }
  if (levels < 2) return study;
  const auto column = [&study](double StickHistoryLevel::*entry) {
    std::vector<double> values;
    for (const StickHistoryLevel& level : study.levels) values.push_back(level.*entry);
    return values;
  };
  const std::vector<double> steps = column(&StickHistoryLevel::time_step);
  study.displacement_order = order_estimate(steps, column(&StickHistoryLevel::displacement_error));
  study.force_order = order_estimate(steps, column(&StickHistoryLevel::force_error));
  study.predicted_displacement_order =
      observed_order(steps, column(&StickHistoryLevel::predicted_displacement_error));
  study.predicted_force_order = observed_order(steps, column(&StickHistoryLevel::predicted_force_error));
  return study;
}

}  // namespace stickslip::studies
