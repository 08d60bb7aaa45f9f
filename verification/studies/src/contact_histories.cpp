#include "stickslip/studies/contact_histories.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/solver/beam_simulation.hpp"

namespace stickslip::studies {

namespace {

struct TipRun {
  std::vector<double> time, displacement;
};

TipRun tip_run(const data::Beam& beam, const data::FrictionLaw& friction,
               const data::HarmonicExcitation& excitation, const data::NumericalSettings& numerics,
               double shown) {
  solver::BeamSimulation simulation(beam, friction, excitation, numerics);
  TipRun run;
  for (long n = solver::step_count(shown, numerics.time_step()); n >= 0; --n) {
    run.time.push_back(simulation.time());
    run.displacement.push_back(simulation.tip_displacement());
    if (n > 0) simulation.step();
  }
  return run;
}

data::NumericalSettings with_twice_the_elements(const data::NumericalSettings& numerics) {
  data::NumericalChoices choices = numerics.choices();
  choices.elements *= 2;
  return data::NumericalSettings(choices);
}

double agreeing_until(const TipRun& a, const TipRun& b) {
  const auto [low, high] = std::minmax_element(a.displacement.begin(), a.displacement.end());
  const double allowed = 0.01 * (*high - *low);
  for (std::size_t i = 0; i < a.time.size(); ++i)
    if (std::abs(a.displacement[i] - b.displacement[i]) > allowed) return a.time[i];
  return a.time.back();
}

}  // namespace

std::optional<double> closed_form_first_slip(const data::Beam& beam, const data::FrictionLaw& friction,
                                             const data::HarmonicExcitation& excitation, double duration) {
  const analytic::StickResponse response(beam, excitation, 60, analytic::SteadyPart::exact);
  const double limit = friction.static_coefficient() * beam.axial_force();
  const auto exceeded = [&](double t) { return std::abs(response.friction_force(t)) > limit; };
  constexpr double scan = 2e-5;
  const long samples = std::lround(duration / scan);
  for (long n = 1; n <= samples; ++n) {
    double high = static_cast<double>(n) * scan;
    if (!exceeded(high)) continue;
    double low = high - scan;
    while (high - low > 1e-9) {
      const double middle = 0.5 * (low + high);
      (exceeded(middle) ? high : low) = middle;
    }
    return high;
  }
  return std::nullopt;
}

ContactHistory contact_history(const data::Beam& beam, const data::FrictionLaw& friction,
                               const data::HarmonicExcitation& excitation,
                               const data::NumericalSettings& numerics, double shown) {
  const TipRun run = tip_run(beam, friction, excitation, numerics, shown);
  const TipRun finer = tip_run(beam, friction, excitation, with_twice_the_elements(numerics), shown);
  ContactHistory history;
  history.frequency_hz = excitation.frequency_hz();
  history.amplitude = excitation.amplitude();
  history.time = run.time;
  history.tip_displacement = run.displacement;
  history.finite_element_slip = solver::first_slip(beam, friction, excitation, numerics);
  history.criterion_slips =
      analytic::evaluate_criterion(beam, friction, excitation, numerics.duration(), numerics.modes())
          .verdict == analytic::Verdict::stick_slip;
  if (history.criterion_slips)
    history.closed_form_slip = closed_form_first_slip(beam, friction, excitation, numerics.duration());
  history.trusted_until = agreeing_until(run, finer);
  return history;
}

}  // namespace stickslip::studies
