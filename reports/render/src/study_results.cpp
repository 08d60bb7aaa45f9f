#include "study_results.hpp"

#include <algorithm>

#include "stickslip/data/paper.hpp"

namespace stickslip::report {

namespace {

const std::vector<int> meshes{4, 6, 8, 12, 16, 24, 32};
const std::vector<int> flutter_meshes{4, 8, 16, 32};
const std::vector<int> steps_per_period{50, 100, 200, 400, 800, 1600};
constexpr double spectral_radii[] = {0.0, 0.5, 0.9, 1.0};
constexpr int shown_modes = 3;
constexpr double stick_history_duration = 1.0;  // s
constexpr int stick_history_levels = 4;
constexpr double highest_frequency = 120.0;  // of Figs. 11 and 12, Hz

data::NumericalSettings with_duration(const data::NumericalSettings& numerics, double duration) {
  data::NumericalChoices choices = numerics.choices();
  choices.duration = duration;
  return data::NumericalSettings(choices);
}

data::HarmonicExcitation printed_excitation(const std::string& frequency_id,
                                            const std::string& amplitude_id) {
  return data::HarmonicExcitation({.frequency_hz = data::printed_number(frequency_id).value,
                                   .amplitude = data::printed_number(amplitude_id).value});
}

// Every quarter of a hertz, and every hundredth within half a hertz of a resonance, where the curve has a
// spike.
std::vector<double> criterion_frequencies(const studies::FrequencyStudy& natural) {
  std::vector<double> frequencies;
  for (int i = 4; i <= static_cast<int>(4.0 * highest_frequency); ++i) frequencies.push_back(0.25 * i);
  for (const auto& mode : natural.modes)
    for (int i = -50; i <= 50; ++i)
      if (const double hz = mode.closed_form_hz + 0.01 * i; hz < highest_frequency) frequencies.push_back(hz);
  std::ranges::sort(frequencies);
  return frequencies;
}

}  // namespace

StudyResults::StudyResults(std::function<void(const std::string&)> announce)
    : announce_(std::move(announce)),
      paper_(data::load_case("paper")),
      stick_excitation_(printed_excitation("figure9.frequency", "figure9.amplitude")) {}

const studies::FrequencyStudy& StudyResults::stick_frequencies() {
  return once(stick_frequencies_, "natural frequencies of the stick state",
              [&] { return studies::stick_frequency_study(paper_.beam, shown_modes, meshes); });
}

const studies::FrequencyStudy& StudyResults::slip_frequencies() {
  return once(slip_frequencies_, "natural frequencies of the slip state",
              [&] { return studies::slip_frequency_study(paper_.beam, shown_modes, meshes); });
}

const studies::FlutterStudy& StudyResults::flutter() {
  return once(flutter_, "flutter load", [&] { return studies::flutter_study(paper_.beam, flutter_meshes); });
}

const studies::ModeShapeStudy& StudyResults::mode_shapes() {
  return once(mode_shapes_, "mode shapes (Fig. 7)", [&] {
    const int elements = paper_.numerics.elements();
    return studies::mode_shape_study(paper_.beam, shown_modes, elements, points_per_element * elements + 1);
  });
}

const std::vector<studies::TimeOrderStudy>& StudyResults::time_orders() {
  return once(time_orders_, "orders of the time integration", [] {
    std::vector<studies::TimeOrderStudy> orders;
    for (const double radius : spectral_radii)
      orders.push_back(studies::time_order_study(radius, steps_per_period));
    return orders;
  });
}

const studies::StickHistoryStudy& StudyResults::stick_history() {
  return once(stick_history_, "stick-state histories under refinement (Fig. 9)", [&] {
    return studies::stick_history_study(paper_.beam, stick_excitation_,
                                        with_duration(paper_.numerics, stick_history_duration),
                                        stick_history_levels);
  });
}

const std::vector<studies::ForceMaximum>& StudyResults::force_maxima() {
  return once(force_maxima_, "largest static friction forces", [&] {
    std::vector<studies::ForceMaximum> maxima;
    for (const int hz : {15, 25, 35, 70})
      maxima.push_back(studies::force_maximum_study(
          paper_.beam,
          printed_excitation("excitation.frequency." + std::to_string(hz), "force_max.amplitude"),
          paper_.numerics));
    return maxima;
  });
}

const std::vector<studies::CriticalAmplitudePoint>& StudyResults::criterion() {
  const std::vector<double> frequencies = criterion_frequencies(stick_frequencies());
  return once(criterion_, "critical amplitudes (Fig. 11)", [&] {
    return studies::critical_amplitude_curve(paper_.beam, paper_.friction, paper_.numerics, frequencies);
  });
}

const studies::ClassificationStudy& StudyResults::classification() {
  return once(classification_, "classification of excitations (Fig. 12), the longest of all", [&] {
    return studies::classification_study(paper_.beam, paper_.friction, paper_.numerics,
                                         studies::figure12_frequencies(), studies::figure12_amplitudes());
  });
}

const std::vector<studies::ContactHistory>& StudyResults::contact_histories() {
  return once(contact_histories_, "stick-slip histories (Figs. 4 and 5)", [&] {
    std::vector<studies::ContactHistory> histories;
    for (const auto& verdict : data::printed_verdicts())
      histories.push_back(studies::contact_history(
          paper_.beam, paper_.friction,
          data::HarmonicExcitation({.frequency_hz = verdict.frequency_hz, .amplitude = verdict.amplitude}),
          paper_.numerics, shown_duration));
    return histories;
  });
}

const std::vector<studies::PrintedCheck>& StudyResults::printed_checks() {
  return once(printed_checks_, "printed numbers", [&] { return studies::printed_checks(paper_); });
}

const std::vector<studies::ErratumEvidence>& StudyResults::errata_evidence() {
  return once(errata_evidence_, "errata", [&] { return studies::errata_evidence(paper_); });
}

}  // namespace stickslip::report
