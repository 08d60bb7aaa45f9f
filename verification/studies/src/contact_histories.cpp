#include "stickslip/studies/contact_histories.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "stickslip/analytic/beam_contact_model.hpp"
#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/studies/event_history.hpp"
#include "stickslip/studies/predictability.hpp"

namespace stickslip::studies {

namespace {

constexpr int history_modes = 20;

double trusted_time(const data::Beam& beam, const data::FrictionLaw& friction,
                    const data::HarmonicExcitation& excitation, const data::NumericalSettings& numerics,
                    const TipHistory& history, double shown) {
  const int elements = numerics.elements();
  const double step = numerics.time_step();
  const TipHistory others[] = {
      time_stepper_history(beam, friction, excitation, refined(numerics, 2 * elements, step), {}, shown),
      time_stepper_history(beam, friction, excitation, refined(numerics, elements, 0.1 * step), {}, shown,
                           10),
      event_driven_history(
          analytic::BeamContactModel(beam, friction, excitation, data::Damping(), history_modes).model(),
          shown, step)};
  const auto [low, high] = std::ranges::minmax(history.tip_displacement);
  double until = shown;
  for (const TipHistory& other : others)
    until = std::min(until, agreeing_until(history, other, fine_agreement * (high - low)));
  return until;
}

}  // namespace

std::optional<double> closed_form_first_slip(const data::Beam& beam, const data::FrictionLaw& friction,
                                             const data::HarmonicExcitation& excitation, double duration) {
  const analytic::StickResponse response(beam, excitation, 60, analytic::SteadyPart::exact);
  const double limit = friction.static_coefficient() * beam.axial_force();
  const auto exceeded = [&](double t) { return std::abs(response.friction_force(t)) > limit; };
  const double scan =
      std::min(1.0 / excitation.frequency_hz(), 1.0 / response.modes().front().frequency_hz()) / 2000.0;
  const long samples = std::lround(duration / scan);
  for (long n = 1; n <= samples; ++n) {
    double high = static_cast<double>(n) * scan;
    if (!exceeded(high)) continue;
    double low = high - scan;
    while (high - low > 5e-5 * scan) {
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
  const TipHistory run = time_stepper_history(beam, friction, excitation, numerics, {}, shown);
  ContactHistory history;
  history.frequency_hz = excitation.frequency_hz();
  history.amplitude = excitation.amplitude();
  history.time = run.time;
  history.tip_displacement = run.tip_displacement;
  history.finite_element_slip = solver::first_slip(beam, friction, excitation, numerics);
  history.criterion_slips =
      analytic::evaluate_criterion(beam, friction, excitation, numerics.duration(), numerics.modes())
          .verdict == analytic::Verdict::stick_slip;
  if (history.criterion_slips)
    history.closed_form_slip = closed_form_first_slip(beam, friction, excitation, numerics.duration());
  history.trusted_until = trusted_time(beam, friction, excitation, numerics, run, shown);
  return history;
}

}  // namespace stickslip::studies
