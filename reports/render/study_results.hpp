// SPDX-License-Identifier: MIT
#pragma once

/// What the report draws and quotes: each study, run on the paper's case with the settings chosen here, once
/// and only if somebody asks.

#include <any>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

#include "comparison/diagnosis/wrong_models.hpp"
#include "stickslip/data/case_file.hpp"
#include "studies/convergence/manufactured_solution.hpp"
#include "studies/convergence/scheme_comparison.hpp"
#include "studies/convergence/time_order.hpp"
#include "studies/criterion/classification.hpp"
#include "studies/criterion/criterion_map.hpp"
#include "studies/criterion/critical_amplitude.hpp"
#include "studies/criterion/design_guide.hpp"
#include "studies/criterion/length_force_map.hpp"
#include "studies/criterion/model_form.hpp"
#include "studies/criterion/scope.hpp"
#include "studies/paper/force_sensitivity.hpp"
#include "studies/paper/paper_checks.hpp"
#include "studies/paper/solution_verification.hpp"
#include "studies/stick/force_maximum.hpp"
#include "studies/stick/frequencies.hpp"
#include "studies/stick/stick_history.hpp"
#include "studies/stick_slip/beam_motion.hpp"
#include "studies/stick_slip/contact_histories.hpp"
#include "studies/stick_slip/damped_benchmark.hpp"
#include "studies/stick_slip/energy_audit.hpp"
#include "studies/stick_slip/event_order.hpp"
#include "studies/stick_slip/history_convergence.hpp"

namespace stickslip::report {

class StudyResults {
 public:
  /// `announce` is told what starts, before each study; `folder` receives each result as <name>.json.
  StudyResults(std::function<void(const std::string&)> announce, std::filesystem::path folder);

  /// Runs every study that has not run.
  void run_all();

  [[nodiscard]] const data::Case& paper() const noexcept { return paper_; }
  [[nodiscard]] const data::Case& damped() const noexcept { return damped_; }
  [[nodiscard]] const data::Case& half_stiffness() const noexcept { return half_stiffness_; }
  [[nodiscard]] const data::Case& flat_section() const noexcept { return flat_section_; }  ///< of Fig. 14
  [[nodiscard]] const data::HarmonicExcitation& stick_excitation() const noexcept {
    return stick_excitation_;
  }

  const studies::FrequencyStudy& stick_frequencies();
  const studies::FrequencyStudy& slip_frequencies();
  const studies::FlutterStudy& flutter();
  const studies::ModeShapeStudy& mode_shapes();               ///< points_per_element per element
  const std::vector<studies::TimeOrderStudy>& time_orders();  ///< one per spectral radius
  const studies::ManufacturedSolutionStudy& manufactured();
  const studies::StickHistoryStudy& stick_history();                ///< Fig. 9
  const std::vector<studies::ForceMaximumStudy>& force_maxima();    ///< at the four frequencies of Sect. 5
  const std::vector<studies::CriticalAmplitudePoint>& criterion();  ///< Fig. 11
  const std::vector<studies::CriticalAmplitudeSearch>& searches();  ///< Fig. 6
  const studies::FrequencyStudy& half_stiffness_frequencies();      ///< stick state
  /// Fig. 13: point i is at the frequency of criterion()[i] times the ratio of the first natural frequencies.
  const std::vector<studies::CriticalAmplitudePoint>& half_stiffness_criterion();
  const studies::LengthForceMap& length_force_map();                 ///< Fig. 14
  const studies::ClassificationStudy& classification();              ///< Fig. 12
  const std::vector<studies::BeamMotionStudy>& beam_motions();       ///< Fig. 3, in the paper's order
  const std::vector<studies::ContactHistory>& contact_histories();   ///< Figs. 4 and 5, in the paper's order
  const std::vector<studies::EventOrderStudy>& event_orders();       ///< spectral radii 0.9 and 1
  const std::vector<studies::DampedBenchmark>& damped_benchmarks();  ///< 25 and 70 Hz
  /// Those of contact_histories() that slip at 1 mm: 25, 35 and 70 Hz, undamped.
  const std::vector<studies::ConvergedHistory>& converged_histories();
  const std::vector<std::vector<studies::PracticeRun>>& usual_practice();  ///< against converged_histories()
  /// At 25 Hz: resolved in time, with a fixed step, and with the step that filters; growth observed.
  const std::vector<studies::HistoryRefinement>& history_growth();
  /// The filtering step with the spectral radii 0 and 0.5, at each frequency of converged_histories().
  const std::vector<studies::HistoryRefinement>& history_refinements();
  const std::vector<studies::EnergyAudit>& energy_audits();      ///< damped, then undamped, 25 Hz
  const std::vector<studies::SchemeRun>& schemes();              ///< paper's settings, 25 Hz, 1 mm
  const std::vector<comparison::WrongModelEffect>& wrong_models();  ///< of the damped benchmark, 25 Hz
  const studies::ForceSensitivity& force_sensitivity();          ///< of the four printed |f_max|
  const studies::SolutionVerification& solution_verification();
  const studies::CriterionMap&
  stiffness_map();                          ///< frequency and Young's modulus, at the amplitude of Fig. 4
  const studies::Design& design_example();  ///< the section of Fig. 14 over a band around its frequency
  const studies::Scope& scope();            ///< of the criterion: its horizon, damping, slenderness
  const studies::ModelForm& model_form();   ///< what an axial force of fixed direction, and shear, change
  const std::vector<std::vector<studies::VariantPlane>>&
  model_variants();  ///< what compliance and damping change
  const std::vector<studies::PrintedCheck>& printed_checks();
  const std::vector<studies::ErratumEvidence>& errata_evidence();

  static constexpr int points_per_element = 10;                        ///< of mode_shapes()
  static constexpr double shown_duration = 0.5;                        ///< of contact_histories(), s
  static constexpr double search_increment = 1e-5, search_cap = 1e-3;  ///< of searches(), m

 private:
  /// The damped case at another frequency and without its damping.
  [[nodiscard]] data::Case undamped_at(double hz) const;
  template <typename Study>
  const std::invoke_result_t<Study>& once(const std::string& name, const std::string& what,
                                          const Study& study);

  std::function<void(const std::string&)> announce_;
  std::filesystem::path folder_;
  data::Case paper_;
  data::Case damped_;
  data::Case half_stiffness_;
  data::Case flat_section_;
  data::HarmonicExcitation stick_excitation_;
  std::map<std::string, std::any> results_;
};

}  // namespace stickslip::report
