// SPDX-License-Identifier: MIT
#include "render/study_results.hpp"

#include <algorithm>
#include <limits>

#include "render/study_json.hpp"
#include "stickslip/data/atomic_file.hpp"
#include "stickslip/data/paper.hpp"

namespace stickslip::report {

namespace fs = std::filesystem;

namespace {

const std::vector<int> meshes{4, 6, 8, 12, 16, 24, 32};
const std::vector<int> flutter_meshes{4, 8, 16, 32};
const std::vector<int> steps_per_period{50, 100, 200, 400, 800, 1600};
constexpr double spectral_radii[] = {0.0, 0.5, 0.9, 1.0};
constexpr int shown_modes = 3;
constexpr double stick_history_duration = 1.0;  // s
constexpr int stick_history_levels = 4;
constexpr int motion_snapshots = 9, motion_positions = 61;
constexpr double highest_frequency = 120.0;  // of Figs. 10 to 13, Hz
constexpr int slipping_frequencies_hz[] = {25, 70};
constexpr double resolved_angle = 0.3, radiating_angle = 1.2;  // omega_max h
constexpr double radiating_share = 0.01;                       // of the mass of an element
constexpr double filtering_radii[] = {0.0, 0.5};
// Resolved in time, 80 elements would take half a minute and 160 minutes.
const std::vector<int> resolved_meshes{5, 10, 20, 40}, fixed_step_meshes{5, 10, 20, 40, 80, 160},
    filtered_meshes{5, 10, 20, 40, 80}, finest_filtered_meshes{10, 20, 40, 80, 160},
    coarser_filtered_meshes{10, 20, 40, 80};
constexpr double event_order_duration = 0.12;  // s: seven events
constexpr int event_order_elements = 10;
const std::vector<int> event_order_divisors{1, 2, 4, 8, 16, 32, 64};
constexpr double energy_audit_duration = 0.12;  // s
const std::vector<double> energy_audit_steps{2e-5, 1e-5, 5e-6, 2.5e-6, 1.25e-6, 6.25e-7};
const std::vector<int> damped_audit_elements{10};
const std::vector<int> undamped_audit_elements{5, 10, 20};
constexpr int continuous_modes = 20;
constexpr double wrong_model_stick_duration = 1.0, wrong_model_contact_duration = 0.12;  // s

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

data::Case at_frequency(data::Case problem, double hz) {
  problem.excitation = data::HarmonicExcitation({hz, problem.excitation.amplitude()});
  return problem;
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

StudyResults::StudyResults(std::function<void(const std::string&)> announce, std::filesystem::path folder)
    : announce_(std::move(announce)),
      folder_(std::move(folder)),
      paper_(data::load_case("paper")),
      damped_(data::load_case("damped")),
      half_stiffness_(data::load_case("paper-half-stiffness")),
      flat_section_(data::load_case("paper-figure14")),
      stick_excitation_(printed_excitation("figure9.frequency", "figure9.amplitude")) {}

template <typename Study>
const std::invoke_result_t<Study>& StudyResults::once(const std::string& name, const std::string& what,
                                                      const Study& study) {
  using Result = std::invoke_result_t<Study>;
  std::any& result = results_[name];
  if (!result.has_value()) {
    announce_(what);
    result = study();
    fs::create_directories(folder_);
    data::write_text(folder_ / (name + ".json"), json_text(*std::any_cast<Result>(&result)));
  }
  return *std::any_cast<Result>(&result);
}

void StudyResults::run_all() {
  // The figures ask for the others.
  flutter();
  manufactured();
  schemes();
  wrong_models();
  force_sensitivity();
  design_example();
  scope();
  model_form();
  model_variants();
  errata_evidence();
  history_refinements();
}

const studies::FrequencyStudy& StudyResults::stick_frequencies() {
  return once("stick_frequencies", "natural frequencies of the stick state",
              [&] { return studies::stick_frequency_study(paper_.beam, shown_modes, meshes); });
}

const studies::FrequencyStudy& StudyResults::slip_frequencies() {
  return once("slip_frequencies", "natural frequencies of the slip state",
              [&] { return studies::slip_frequency_study(paper_.beam, shown_modes, meshes); });
}

const studies::FlutterStudy& StudyResults::flutter() {
  return once("flutter", "flutter load", [&] { return studies::flutter_study(paper_.beam, flutter_meshes); });
}

const studies::ModeShapeStudy& StudyResults::mode_shapes() {
  return once("mode_shapes", "mode shapes (Fig. 7)", [&] {
    const int elements = paper_.numerics.elements();
    return studies::mode_shape_study(paper_.beam, shown_modes, elements, points_per_element * elements + 1);
  });
}

const std::vector<studies::TimeOrderStudy>& StudyResults::time_orders() {
  return once("time_orders", "orders of the time integration", [] {
    std::vector<studies::TimeOrderStudy> orders;
    for (const double radius : spectral_radii)
      orders.push_back(studies::time_order_study(radius, steps_per_period));
    return orders;
  });
}

const studies::ManufacturedSolutionStudy& StudyResults::manufactured() {
  return once("manufactured_solution", "manufactured solutions",
              [&] { return studies::manufactured_solution_study(paper_.beam); });
}

const studies::StickHistoryStudy& StudyResults::stick_history() {
  return once("stick_history", "stick-state histories under refinement (Fig. 9)", [&] {
    return studies::stick_history_study(paper_.beam, stick_excitation_,
                                        with_duration(paper_.numerics, stick_history_duration),
                                        stick_history_levels);
  });
}

const std::vector<studies::ForceMaximumStudy>& StudyResults::force_maxima() {
  return once("force_maxima", "largest static friction forces", [&] {
    std::vector<studies::ForceMaximumStudy> maxima;
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
  return once("criterion", "critical amplitudes (Fig. 11)", [&] {
    return studies::critical_amplitude_curve(paper_.beam, paper_.friction, paper_.numerics, frequencies);
  });
}

const std::vector<studies::CriticalAmplitudeSearch>& StudyResults::searches() {
  return once("searches", "critical amplitudes by the paper's procedure (Fig. 6)", [&] {
    return studies::critical_amplitude_searches(paper_.beam, paper_.friction, paper_.numerics,
                                                studies::figure6_frequencies(), search_increment, search_cap);
  });
}

const studies::FrequencyStudy& StudyResults::half_stiffness_frequencies() {
  return once("half_stiffness_frequencies", "natural frequencies at half the stiffness",
              [&] { return studies::stick_frequency_study(half_stiffness_.beam, shown_modes, meshes); });
}

const std::vector<studies::CriticalAmplitudePoint>& StudyResults::half_stiffness_criterion() {
  const double ratio = half_stiffness_frequencies().modes.front().closed_form_hz /
                       stick_frequencies().modes.front().closed_form_hz;
  return once("half_stiffness_criterion", "critical amplitudes at half the stiffness (Fig. 13)", [&] {
    std::vector<double> frequencies = criterion_frequencies(stick_frequencies());
    for (double& hz : frequencies) hz *= ratio;
    return studies::critical_amplitude_curve(half_stiffness_.beam, half_stiffness_.friction,
                                             half_stiffness_.numerics, frequencies);
  });
}

const studies::LengthForceMap& StudyResults::length_force_map() {
  return once("length_force_map", "criterion over length and axial force (Fig. 14)", [&] {
    return studies::length_force_map(flat_section_, 0.4, 2.0, studies::figure14_axial_forces());
  });
}

const studies::ClassificationStudy& StudyResults::classification() {
  return once("classification", "classification of excitations (Fig. 12), the longest of all", [&] {
    return studies::classification_study(paper_.beam, paper_.friction, paper_.numerics,
                                         studies::figure12_frequencies(), studies::figure12_amplitudes());
  });
}

const std::vector<studies::ContactHistory>& StudyResults::contact_histories() {
  return once("contact_histories", "stick-slip histories (Figs. 4 and 5)", [&] {
    std::vector<studies::ContactHistory> histories;
    for (const auto& verdict : data::printed_verdicts()) {
      data::Case problem = paper_;
      problem.excitation =
          data::HarmonicExcitation({.frequency_hz = verdict.frequency_hz, .amplitude = verdict.amplitude});
      histories.push_back(studies::contact_history(problem, shown_duration));
    }
    return histories;
  });
}

const std::vector<studies::EventOrderStudy>& StudyResults::event_orders() {
  return once("event_orders", "orders through the events of a damped history", [&] {
    std::vector<studies::EventOrderStudy> orders;
    for (const double radius : {paper_.numerics.spectral_radius(), 1.0})
      orders.push_back(studies::event_order_study(damped_, event_order_duration, event_order_elements, radius,
                                                  event_order_divisors));
    return orders;
  });
}

const std::vector<studies::DampedBenchmark>& StudyResults::damped_benchmarks() {
  return once("damped_benchmarks", "the damped benchmark by every method", [&] {
    std::vector<studies::DampedBenchmark> benchmarks;
    for (const int hz : slipping_frequencies_hz)
      benchmarks.push_back(studies::damped_benchmark(at_frequency(damped_, hz)));
    return benchmarks;
  });
}

data::Case StudyResults::undamped_at(double hz) const {
  data::Case problem = at_frequency(damped_, hz);
  problem.damping = data::Damping();
  return problem;
}

const std::vector<studies::ConvergedHistory>& StudyResults::converged_histories() {
  return once("converged_histories", "converged histories", [&] {
    std::vector<studies::ConvergedHistory> converged;
    for (const auto& history : contact_histories())
      if (history.converged && history.amplitude == damped_.excitation.amplitude())
        converged.push_back(*history.converged);
    return converged;
  });
}

const std::vector<std::vector<studies::PracticeRun>>& StudyResults::usual_practice() {
  return once("usual_practice", "undamped histories as they are usually computed", [&] {
    std::vector<std::vector<studies::PracticeRun>> runs;
    for (const auto& history : converged_histories())
      runs.push_back(studies::usual_practice(paper_, history));
    return runs;
  });
}

const std::vector<studies::HistoryRefinement>& StudyResults::history_growth() {
  return once("history_growth", "growth of a disturbance on meshes", [&] {
    const data::Case problem = undamped_at(converged_histories().front().frequency_hz);
    const auto refined = [&](const studies::StepRule& rule, const std::vector<int>& elements) {
      return studies::history_refinement(problem, converged_histories().front(), rule, elements,
                                         elements.back());
    };
    const double radius = paper_.numerics.spectral_radius(), step = paper_.numerics.time_step();
    return std::vector{
        refined({"resolved in time", resolved_angle, 0.0, radius}, resolved_meshes),
        refined({"fixed step", 0.0, step, radius}, fixed_step_meshes),
        refined({"filtering step", studies::filtering_angle, 0.0, 0.0}, filtered_meshes),
        refined({"radiating tip", radiating_angle, 0.0, 1.0, radiating_share}, resolved_meshes)};
  });
}

const std::vector<studies::HistoryRefinement>& StudyResults::history_refinements() {
  return once("history_refinements", "refinement of undamped histories on meshes", [&] {
    std::vector<studies::HistoryRefinement> refinements;
    for (const auto& reference : converged_histories())
      for (const double radius : filtering_radii)
        refinements.push_back(
            studies::history_refinement(undamped_at(reference.frequency_hz), reference,
                                        {"filtering step", studies::filtering_angle, 0.0, radius},
                                        radius == 0.0 ? finest_filtered_meshes : coarser_filtered_meshes, 0));
    return refinements;
  });
}

const std::vector<studies::EnergyAudit>& StudyResults::energy_audits() {
  return once("energy_audits", "energy balance", [&] {
    const auto audit = [](const data::Case& problem, const std::vector<int>& elements) {
      return studies::energy_audit(problem, energy_audit_duration, elements, continuous_modes,
                                   energy_audit_steps);
    };
    return std::vector{audit(damped_, damped_audit_elements),
                       audit(undamped_at(damped_.excitation.frequency_hz()), undamped_audit_elements)};
  });
}

const std::vector<studies::SchemeRun>& StudyResults::schemes() {
  return once("schemes", "contact schemes", [&] {
    return studies::compare_schemes(paper_.beam, paper_.friction, damped_.excitation,
                                    with_duration(paper_.numerics, shown_duration), data::Damping());
  });
}

const std::vector<studies::BeamMotionStudy>& StudyResults::beam_motions() {
  return once("beam_motions", "motions of the whole beam (Fig. 3)", [&] {
    std::vector<studies::BeamMotionStudy> motions;
    for (const int hz : {15, 25, 35, 70}) {
      data::Case problem = paper_;
      problem.excitation =
          printed_excitation("excitation.frequency." + std::to_string(hz), "force_max.amplitude");
      motions.push_back(studies::beam_motion_study(problem, motion_snapshots, motion_positions));
    }
    return motions;
  });
}

const std::vector<studies::WrongModelEffect>& StudyResults::wrong_models() {
  return once("wrong_models", "what the known mistakes change", [&] {
    return studies::wrong_model_effects(damped_, wrong_model_stick_duration, wrong_model_contact_duration);
  });
}

const studies::ForceSensitivity& StudyResults::force_sensitivity() {
  return once("force_sensitivity", "what moves the printed forces",
              [&] { return studies::force_sensitivity(paper_); });
}

const studies::SolutionVerification& StudyResults::solution_verification() {
  return once("solution_verification", "grid convergence of each result",
              [&] { return studies::solution_verification(paper_); });
}

const studies::CriterionMap& StudyResults::stiffness_map() {
  return once("stiffness_map", "criterion over frequency and stiffness", [&] {
    data::Case problem = paper_;
    problem.excitation = stick_excitation_;
    const double modulus = paper_.beam.youngs_modulus();
    return studies::criterion_map(
        {.problem = problem,
         .x = studies::map_axis("excitation.frequency_hz", 1.0, highest_frequency, 239, false),
         .y = studies::map_axis("beam.youngs_modulus", 0.25 * modulus, 4.0 * modulus, 61, true)});
  });
}

const studies::Design& StudyResults::design_example() {
  return once("design_example", "lengths and forces that avoid slipping", [&] {
    const double hz = flat_section_.excitation.frequency_hz();
    const analytic::FrequencyBand band{hz - 1.0, hz + 1.0};
    const auto scan = [&](std::string_view parameter, double from, double to) {
      return studies::design_scan(flat_section_, parameter,
                                  studies::range_below_buckling(flat_section_, parameter, from, to), band);
    };
    return studies::Design{.band = band,
                           .margin = studies::band_margin(flat_section_, band),
                           .lengths = scan("beam.length", 0.4, 2.0),
                           .forces = scan("beam.axial_force", 50.0, 5000.0)};
  });
}

const studies::Scope& StudyResults::scope() {
  return once("scope", "scope of the criterion", [&] {
    const auto& histories = converged_histories();
    const auto slow = std::ranges::find(histories, 35.0, &studies::ConvergedHistory::frequency_hz);
    return studies::scope(paper_, damped_, *slow);
  });
}

const studies::ModelForm& StudyResults::model_form() {
  return once("model_form", "criterion with an axial force of fixed direction", [&] {
    constexpr int lengths = 81;  // every 2 cm
    return studies::model_form(paper_, half_stiffness_, flat_section_, lengths);
  });
}

const std::vector<std::vector<studies::VariantPlane>>& StudyResults::model_variants() {
  return once("model_variants", "criterion with contact compliance and with damping", [&] {
    constexpr int lengths = 17;        // every 10 cm
    constexpr std::size_t stride = 5;  // of the axial forces
    constexpr double rigid = std::numeric_limits<double>::infinity();
    std::vector<std::vector<studies::VariantPlane>> rows;
    for (const studies::ModelVariant& variant :
         {studies::ModelVariant{10.0, 0.0}, {100.0, 0.0}, {1000.0, 0.0}, {rigid, 0.005}, {rigid, 0.02}})
      rows.push_back(
          studies::variant_planes(variant, paper_, half_stiffness_, flat_section_, lengths, stride));
    return rows;
  });
}

const std::vector<studies::PrintedCheck>& StudyResults::printed_checks() {
  return once("printed_checks", "printed numbers", [&] { return studies::printed_checks(paper_); });
}

const std::vector<studies::ErratumEvidence>& StudyResults::errata_evidence() {
  return once("errata_evidence", "errata", [&] { return studies::errata_evidence(paper_); });
}

}  // namespace stickslip::report
