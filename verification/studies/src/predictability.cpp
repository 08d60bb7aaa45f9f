#include "stickslip/studies/predictability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "stickslip/analytic/beam_contact_model.hpp"
#include "stickslip/studies/convergence.hpp"
#include "stickslip/studies/finite_element_contact_model.hpp"

namespace stickslip::studies {

namespace {

constexpr double sample = 1e-4;

double range_of(const TipHistory& history) {
  const auto [low, high] = std::ranges::minmax(history.tip_displacement);
  return high - low;
}

double slip_share_of(const TipHistory& history) {
  double slipping = 0.0, since = -1.0;
  for (const HistoryEvent& event : history.events) {
    if (event.onset) since = event.time;
    if (!event.onset && since >= 0.0) slipping += event.time - since;
    if (!event.onset) since = -1.0;
  }
  if (since >= 0.0) slipping += history.time.back() - since;
  return slipping / history.time.back();
}

// The largest difference within each period, from the first slip on.
void set_series(const TipHistory& a, const TipHistory& b, double period, Separation& result) {
  if (a.events.empty()) return;
  const double start = a.events.front().time;
  for (std::size_t i = 0; i < a.time.size(); ++i) {
    if (a.time[i] < start) continue;
    const auto index = static_cast<std::size_t>((a.time[i] - start) / period);
    if (index >= result.time.size()) {
      result.time.push_back(start + (static_cast<double>(index) + 0.5) * period);
      result.separation.push_back(0.0);
    }
    double& largest = result.separation.back();
    largest = std::max(largest, std::abs(a.tip_displacement[i] - b.tip_displacement[i]));
  }
}

// Least-squares slope of the logarithm of the series while it is below `limit`.
double growth_rate_of(const Separation& series, double limit) {
  std::vector<double> times, logarithms;
  for (std::size_t i = 0; i < series.time.size() && series.separation[i] <= limit; ++i) {
    if (series.separation[i] <= 0.0) continue;
    times.push_back(series.time[i]);
    logarithms.push_back(std::log(series.separation[i]));
  }
  return times.size() < 3 ? 0.0 : linear_slope(times, logarithms);
}

}  // namespace

double agreeing_until(const TipHistory& a, const TipHistory& b, double allowed) {
  for (std::size_t i = 0; i < a.time.size(); ++i)
    if (std::abs(a.tip_displacement[i] - b.tip_displacement[i]) > allowed) return a.time[i];
  return a.time.back();
}

PredictabilityStudy predictability_study(const data::Beam& beam, const data::FrictionLaw& friction,
                                         const data::HarmonicExcitation& excitation,
                                         const data::NumericalSettings& numerics, double duration,
                                         int modes) {
  const auto continuous = [&](int count, double change, analytic::SlipBasis basis) {
    const data::HarmonicExcitation perturbed(
        {excitation.frequency_hz(), excitation.amplitude() * (1.0 + change)});
    return event_driven_history(
        analytic::BeamContactModel(beam, friction, perturbed, data::Damping(), count, basis).model(),
        duration, sample);
  };
  const auto event_driven = [&](int elements) {
    return event_driven_history(finite_element_contact_model(solver::BeamModel(beam, elements), friction,
                                                             excitation, data::Damping()),
                                duration, sample);
  };
  const auto stepped = [&](int elements, double time_step, double spectral_radius) {
    data::NumericalChoices choices = refined(numerics, elements, time_step).choices();
    choices.spectral_radius = spectral_radius;
    return time_stepper_history(beam, friction, excitation, data::NumericalSettings(choices), {}, duration,
                                static_cast<int>(std::lround(sample / time_step)));
  };
  using analytic::SlipBasis;
  const int elements = numerics.elements();
  const double h = sample, radius = numerics.spectral_radius();
  const TipHistory reference = continuous(modes, 0.0, SlipBasis::held_modes);
  const TipHistory mesh = event_driven(elements);
  const TipHistory step = stepped(elements, h, radius);

  PredictabilityStudy study;
  study.frequency_hz = excitation.frequency_hz();
  study.amplitude = excitation.amplitude();
  study.duration = duration;
  study.range = range_of(reference);
  study.slip_share = slip_share_of(reference);
  study.predicted_rate = 2.0 * (friction.static_coefficient() - friction.kinetic_coefficient()) *
                         friction.decay() * beam.axial_force() /
                         (beam.density() * beam.area() * beam.length());
  const auto separate = [&](const std::string& what, const TipHistory& a, const TipHistory& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.time.size(); ++i)
      largest = std::max(largest, std::abs(a.tip_displacement[i] - b.tip_displacement[i]));
    Separation result;
    result.what = what;
    result.one_percent_until = agreeing_until(a, b, fine_agreement * study.range);
    result.ten_percent_until = agreeing_until(a, b, coarse_agreement * study.range);
    result.largest = largest / study.range;
    result.changes = a.changes;
    result.other_changes = b.changes;
    set_series(a, b, 1.0 / excitation.frequency_hz(), result);
    result.growth_rate = growth_rate_of(result, coarse_agreement * study.range);
    study.separations.push_back(std::move(result));
  };
  separate(fmt::format("amplitude changed by {:.0e}", perturbation), reference,
           continuous(modes, perturbation, SlipBasis::held_modes));
  separate(fmt::format("{} against {} modes", modes, 2 * modes), reference,
           continuous(2 * modes, 0.0, SlipBasis::held_modes));
  separate("held against free modes", reference, continuous(modes, 0.0, SlipBasis::free_modes));
  separate(fmt::format("event-driven: {} against {} elements", elements / 2, elements),
           event_driven(elements / 2), mesh);
  separate(fmt::format("{} elements against {} modes", elements, modes), mesh, reference);
  separate(fmt::format("time steps: {} against {} elements", elements, 2 * elements), step,
           stepped(2 * elements, h, radius));
  separate(fmt::format("time steps: {:.0e} against {:.0e} s", h, 0.1 * h), step,
           stepped(elements, 0.1 * h, radius));
  separate(fmt::format("time steps: spectral radius {:g} against 1", radius), step,
           stepped(elements, h, 1.0));
  separate(fmt::format("{} elements: {:.0e} s against event-driven", elements, h), step, mesh);
  separate(fmt::format("{} elements: {:.0e} s against event-driven", elements, 0.01 * h),
           stepped(elements, 0.01 * h, radius), mesh);
  return study;
}

}  // namespace stickslip::studies
