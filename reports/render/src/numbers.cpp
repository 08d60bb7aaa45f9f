#include "numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>
#include <utility>

#include "findings.hpp"
#include "latex_table.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/data/paper.hpp"
#include "stickslip/report/latex_text.hpp"
#include "studies/stick_slip/contact_growth.hpp"
#include "traceability.hpp"
#include "units.hpp"

namespace stickslip::report {

namespace {

constexpr double microsecond = 1e-6;  // s

class Macros {
 public:
  void define(std::string_view name, const std::string& latex) {
    text_ += fmt::format("\\newcommand{{\\{}}}{{{}}}\n", name, latex);
  }
  template <typename Count>
  void count(std::string_view name, Count value) {
    define(name, fmt::format("{}", value));
  }
  void plain(std::string_view name, double value) { define(name, typeset(data::shortest_text(value))); }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

void define_environment(const Environment& environment, Macros& macros) {
  macros.define("ReportVersion", escape(environment.version));
  macros.define("ReportCommit", escape(environment.commit));
  macros.define("ReportDate", escape(environment.date));
  macros.define("CompilerName", escape(environment.compiler));
  macros.define("EigenVersion", escape(environment.eigen));
  macros.define("GslVersion", escape(environment.gsl));
}

void define_case(const data::Case& paper, Macros& macros) {
  macros.define("SecondMoment", scientific(paper.beam.second_moment_of_area(), 4));
  macros.define("FrictionLimit",
                significant(paper.friction.static_coefficient() * paper.beam.axial_force(), 3));
  macros.count("CaseElements", paper.numerics.elements());
  macros.define("CaseTimeStep", scientific(paper.numerics.time_step(), 1));
  macros.count("CaseModes", paper.numerics.modes());
  macros.plain("CaseDuration", paper.numerics.duration());
  macros.define("EventTolerance", scientific(analytic::EventDrivenSettings{}.tolerance, 1));
  macros.plain("CaseRadius", paper.numerics.spectral_radius());
  macros.plain("ThresholdDeceleration", paper.numerics.velocity_threshold() / paper.numerics.time_step());
  macros.define("VelocityThreshold", scientific(paper.numerics.velocity_threshold(), 1));
}

void define_frequencies(StudyResults& results, Macros& macros) {
  const auto& stick = results.stick_frequencies().modes;
  macros.define("StickOneHz", fixed(stick[0].closed_form_hz, 2));
  macros.define("StickTwoHz", fixed(stick[1].closed_form_hz, 2));
  double difference = 0.0;
  for (const auto& curve : results.mode_shapes().curves)
    difference = std::max(difference, curve.largest_difference);
  macros.define("LargestShapeDifference", scientific(difference, 2));
  macros.define("FlutterClosedForm", fixed(results.flutter().closed_form, 6));
  macros.define("FlutterOrder", order_text(results.flutter().observed_order));
}

void define_manufactured(StudyResults& results, Macros& macros) {
  const auto& meshes = results.manufactured().space.front().elements;
  macros.count("ManufacturedCoarsest", meshes.front());
  macros.count("ManufacturedFinest", meshes.back());
  macros.plain("ManufacturedTimeLoad", results.manufactured().time.front().load_factor);
}

void define_stick_history(StudyResults& results, Macros& macros) {
  const auto& study = results.stick_history();
  const auto& first = study.levels.front();
  const auto& finest = study.levels.back();
  macros.plain("StickHz", results.stick_excitation().frequency_hz());
  macros.plain("StickAmplitude", results.stick_excitation().amplitude() / millimetre);
  macros.define("StickDuration", significant(study.time.back(), 1));
  macros.define("DisplacementPeak", scientific(study.displacement_peak, 4));
  macros.define("ForcePeak", significant(study.force_peak, 4));
  macros.define("DisplacementError", scientific(first.displacement_error, 2));
  macros.define("DisplacementErrorPredicted", scientific(first.predicted_displacement_error, 2));
  macros.define("DisplacementErrorRelative",
                significant(100.0 * first.displacement_error / study.displacement_peak, 2));
  macros.define("ForceError", significant(first.force_error, 2));
  macros.define("ForceErrorPredicted", significant(first.predicted_force_error, 2));
  macros.define("ForceErrorRelative", significant(100.0 * first.force_error / study.force_peak, 2));
  macros.define("DisplacementOrder", order_text(study.displacement_order));
  macros.define("DisplacementOrderPredicted", fixed(study.predicted_displacement_order, 2));
  macros.define("ForceOrder", order_text(study.force_order));
  macros.define("ForceOrderPredicted", fixed(study.predicted_force_order, 2));
  macros.count("FinestElements", finest.elements);
  macros.define("FinestTimeStep", scientific(finest.time_step, 3));
  macros.define("FinestDisplacementRelative",
                scientific(finest.displacement_error / study.displacement_peak, 2));
  macros.define("FinestForceRelative", scientific(finest.force_error / study.force_peak, 2));
}

double largest_printed_force_difference(const std::vector<studies::ForceMaximumStudy>& maxima) {
  double largest = 0.0;
  for (const auto& row : maxima)
    largest = std::max(
        largest, percent_difference(
                     row.sampled, data::printed_number(fmt::format("force_max.{}", row.frequency_hz)).value));
  return largest;
}

void define_force_maxima(StudyResults& results, Macros& macros) {
  const auto& maxima = results.force_maxima();
  const ForceDifferences largest = force_differences(maxima);
  macros.plain("HzA", maxima[0].frequency_hz);
  macros.plain("HzB", maxima[2].frequency_hz);
  macros.plain("HzC", maxima[1].frequency_hz);
  macros.plain("HzD", maxima[3].frequency_hz);
  macros.plain("PrintedAmplitude", maxima.front().amplitude / millimetre);
  macros.define("ForceSamplingLargest", significant(largest.sampling, 2));
  macros.define("ForceTruncationLargest", significant(largest.truncation, 2));
  macros.define("ForceDiscretisationLargest", significant(largest.discretisation, 2));
  macros.define("ForcePredictionLargest", significant(largest.prediction, 2));
  macros.define("PrintedForceLargest", significant(largest_printed_force_difference(maxima), 2));
}

void define_classification(StudyResults& results, Macros& macros) {
  const PointCounts points = point_counts(results.classification());
  const Range guard = guard_range(results.classification());
  macros.count("GridPoints", points.all);
  macros.count("GridAgreeing", points.agreeing);
  macros.count("GridInGuard", points.in_guard);
  macros.count("GridDisagreeingInside", points.disagreeing_inside);
  macros.count("GridDisagreeingOutside", points.disagreeing_outside);
  macros.define("GuardSmallest", significant(100.0 * guard.lowest, 2));
  macros.define("GuardLargest", significant(100.0 * guard.highest, 2));
}

void define_searches(StudyResults& results, Macros& macros) {
  const auto& searches = results.searches();
  int runs = 0;
  for (const auto& search : searches) runs += search.runs;
  macros.count("SearchFrequencies", searches.size());
  macros.count("SearchAgreeing", std::ranges::count_if(searches, &studies::CriticalAmplitudeSearch::agree));
  macros.count("SearchRuns", runs);
  macros.plain("SearchIncrement", StudyResults::search_increment / millimetre);
  macros.plain("SearchCap", StudyResults::search_cap / millimetre);
}

// Critical amplitude at half the stiffness over that at the full one, at corresponding frequencies.
std::vector<double> half_stiffness_ratios(StudyResults& results) {
  const auto& full = results.criterion();
  const auto& half = results.half_stiffness_criterion();
  std::vector<double> ratios;
  for (std::size_t i = 0; i < full.size(); ++i)
    ratios.push_back(half[i].critical_amplitude / full[i].critical_amplitude);
  std::ranges::sort(ratios);
  return ratios;
}

void define_criterion_diagrams(StudyResults& results, Macros& macros) {
  const std::vector<double> ratios = half_stiffness_ratios(results);
  const auto& half = results.half_stiffness_frequencies().modes;
  macros.define("HalfOneHz", fixed(half[0].closed_form_hz, 2));
  macros.define("HalfTwoHz", fixed(half[1].closed_form_hz, 2));
  macros.define("HalfRatioMedian", fixed(ratios[ratios.size() / 2], 2));
  macros.define("HalfRatioLowTenth", fixed(ratios[ratios.size() / 10], 2));
  macros.define("HalfRatioHighTenth", fixed(ratios[ratios.size() - 1 - ratios.size() / 10], 2));

  const data::Case& flat = results.flat_section();
  const auto resonance = [&](int mode) {
    return studies::resonance_length(flat.beam, mode, flat.excitation.frequency_hz());
  };
  const double height = std::sqrt(12.0 * flat.beam.second_moment_of_area() / flat.beam.area());
  macros.define("BucklingCoefficient", fixed(buckling_coefficient(flat.beam), 2));
  macros.define("FlatHeight", significant(height, 1));
  macros.define("FlatWidth", significant(flat.beam.area() / height, 1));
  macros.plain("FlatLength", flat.beam.length());
  macros.plain("FlatHz", flat.excitation.frequency_hz());
  macros.plain("FlatAmplitude", flat.excitation.amplitude() / millimetre);
  macros.plain("FlatForce", flat.beam.axial_force());
  macros.define("FlatLengthOne", fixed(resonance(1).value(), 4));
  macros.define("FlatLengthTwo", fixed(resonance(2).value(), 4));
}

void define_histories(StudyResults& results, Macros& macros) {
  const auto& histories = results.contact_histories();
  const HistoryFindings findings = history_findings(histories);
  macros.count("VerdictsTotal", histories.size());
  macros.count("VerdictsAgreeing", findings.verdicts_agreeing);
  macros.define("FirstSlipLargestDifference", significant(findings.first_slip_difference / microsecond, 2));
  macros.define("HalfWidthLargest", significant(100.0 * findings.half_widths.highest, 1));
  double least = 1.0, largest = 0.0;  // errors of usual practice
  for (const auto& runs : results.usual_practice())
    for (const auto& run : runs) {
      least = std::min(least, run.largest_error);
      largest = std::max(largest, run.largest_error);
    }
  macros.define("PracticeLeast", significant(100.0 * least, 2));
  macros.define("PracticeLargest", significant(100.0 * largest, 2));
  macros.plain("ShownDuration", StudyResults::shown_duration);
  macros.plain("SmallAmplitude", histories.front().amplitude / millimetre);
  macros.plain("LargeAmplitude", histories.back().amplitude / millimetre);
}

void define_events(StudyResults& results, Macros& macros) {
  const auto& benchmarks = results.damped_benchmarks();
  const auto& finest = finest_stepped(benchmarks.front());
  macros.plain("LowHz", benchmarks.front().frequency_hz);
  macros.plain("HighHz", benchmarks.back().frequency_hz);
  macros.plain("MiddleHz", results.converged_histories()[1].frequency_hz);
  const auto& meshes = results.history_refinements().front().runs;
  for (std::size_t i = 0; i < meshes.size(); ++i)
    macros.count(fmt::format("Mesh{}", "ABCDE"[i]), static_cast<std::size_t>(meshes[i].elements));
  macros.define("KelvinVoigt", scientific(benchmarks.front().kelvin_voigt, 2));
  macros.define("ShortestStick", significant(benchmarks.front().shortest_stick / microsecond, 2));
  std::size_t merged = 0;
  for (const auto& benchmark : benchmarks)
    merged += (benchmark.history.events.size() - benchmark.events.size()) / 2;
  macros.define("MergedSticks", merged == 0 ? "none" : std::to_string(merged));
  macros.define("DampingPercent", fixed(100.0 * std::numbers::pi * benchmarks.front().kelvin_voigt *
                                            results.stick_frequencies().modes.front().closed_form_hz,
                                        1));
  macros.count("BenchmarkModes", benchmarks.front().modes);
  macros.count("BenchmarkElements", finest.size);
  macros.define("BenchmarkStep", significant(finest.time_step / microsecond, 2));
  macros.count("BenchmarkEventsLow", benchmarks.front().events.size());
  macros.count("BenchmarkEventsHigh", benchmarks.back().events.size());
  double time = 0.0, position = 0.0, first_time = 0.0, first_position = 0.0;
  for (const auto& benchmark : benchmarks) {
    const auto& run = finest_stepped(benchmark);
    time = std::max(time, run.all.time);
    position = std::max(position, run.all.position);
    first_time = std::max(first_time, run.first_ten.time);
    first_position = std::max(first_position, run.first_ten.position);
  }
  macros.define("BenchmarkFirstTime", scientific(first_time, 1));
  macros.define("BenchmarkFirstPosition", scientific(first_position, 1));
  macros.define("BenchmarkAllTime", scientific(time, 1));
  macros.define("BenchmarkAllPosition", scientific(position, 1));

  const auto& orders = results.event_orders();
  macros.count("EventOrderElements", orders.front().elements);
  macros.plain("EventOrderDuration", orders.front().duration);
  macros.count("EventOrderEvents", orders.front().events);

  macros.define("BeamGrowthBound",
                significant(studies::beam_growth_bound(results.paper().beam, results.paper().friction), 2));
  macros.define("FilteringAngle", significant(studies::filtering_angle, 2));
  macros.define("Perturbation", scientific(studies::perturbation, 1));
  macros.define("ShortestPlateau", significant(studies::shortest_plateau / millisecond, 1));
  const std::size_t literal_plateaus = results.schemes().back().plateaus.size();
  macros.define("LiteralPlateaus", literal_plateaus == 0 ? "none" : std::to_string(literal_plateaus));

  const auto& damped_audit = results.energy_audits().front();
  const auto& damped_mesh = damped_audit.meshes.front();
  const auto& undamped_meshes = results.energy_audits().back().meshes;
  macros.define("EnergyOrderDamped", order_text(damped_mesh.observed_order));
  macros.plain("EnergyDuration", damped_audit.duration);
  macros.count("EnergyElementsDamped", damped_mesh.elements);
  macros.count("EnergyElementsSmall", undamped_meshes[0].elements);
  macros.count("EnergyElementsMiddle", undamped_meshes[1].elements);
  macros.count("EnergyElementsLarge", undamped_meshes.back().elements);
  macros.define("EnergyOrderSmall", order_text(undamped_meshes[0].observed_order));
  macros.define("EnergyOrderMiddle", order_text(undamped_meshes[1].observed_order));
  double unresolved = 0.0;
  for (const auto& balance : undamped_meshes.back().stepped)
    unresolved = std::max(unresolved, std::abs(balance.residual() / balance.base_work));
  macros.define("EnergyUnresolved", scientific(unresolved, 1));
}

void define_motions(StudyResults& results, Macros& macros) {
  double stick = 0.0, predicted = 0.0, relative = 0.0, half_width = 0.0;
  for (const auto& motion : results.beam_motions()) {
    if (motion.stick_difference > stick) {
      stick = motion.stick_difference;
      predicted = motion.predicted_stick_difference;
    }
    relative = std::max(relative, motion.difference / motion.peak);
    half_width = std::max(half_width, motion.half_width / motion.peak);
  }
  macros.plain("MotionAmplitude", results.beam_motions().front().amplitude / millimetre);
  macros.count("MotionSnapshots", results.beam_motions().front().reference.snapshots.size());
  macros.define("MotionStickDifference", scientific(stick, 2));
  macros.define("MotionStickPredicted", scientific(predicted, 2));
  macros.define("MotionDifferenceRelative", significant(100.0 * relative, 2));
  macros.define("MotionHalfWidth", significant(100.0 * half_width, 1));
}

// "(a) half a unit of the last digit; (b) ..."
std::string reasons_text(const std::vector<std::string>& reasons) {
  std::string text;
  for (std::size_t i = 0; i < reasons.size(); ++i)
    text += fmt::format("{}({}) {}", i > 0 ? "; " : "", letter_of(reasons[i], reasons), typeset(reasons[i]));
  return text;
}

void define_paper(StudyResults& results, Macros& macros) {
  const auto& checks = results.printed_checks();
  const auto& evidence = results.errata_evidence();
  macros.count("ErrataTotal", data::errata().size());
  macros.count("EvidenceTotal", evidence.size());
  macros.count("EvidenceConfirmed", std::ranges::count_if(evidence, confirmed));
  macros.count("PrintedTotal", checks.size());
  macros.count("PrintedAgreeing", std::ranges::count_if(checks, &studies::PrintedCheck::agrees));
  macros.define("PrintedReasons", reasons_text(printed_reasons(checks)));
}

void define_solution_verification(StudyResults& results, Macros& macros) {
  const auto& study = results.solution_verification();
  const auto asymptotic = [](const auto& result) { return result.convergence.asymptotic; };
  const auto covered = [](const auto& result) { return result.covered; };
  macros.plain("VerifiedRatio", study.ratio);
  macros.plain("VerifiedOrder", study.formal_order);
  macros.count("VerifiedTotal", study.results.size());
  macros.count("VerifiedCovered", std::ranges::count_if(study.results, covered));
  macros.count("VerifiedAsymptotic", std::ranges::count_if(study.results, asymptotic));
  macros.count("VerifiedAsymptoticCovered", std::ranges::count_if(study.results, [&](const auto& result) {
                 return asymptotic(result) && covered(result);
               }));
  macros.define("UncertaintySources", reasons_text(uncertainty_sources(results)));
  const auto& search = results.force_sensitivity().search;
  macros.count("SearchMostModes", search.most_modes);
  macros.count("SearchSteps", search.sampling_steps.size());
  macros.count("SearchTrials", static_cast<std::size_t>(search.most_modes) * search.sampling_steps.size());
  macros.define("SearchReturningAll",
                search.returning_all == 0 ? "none" : std::to_string(search.returning_all));
  macros.count("SearchMostReturned", search.most_returned.returned);
  macros.count("SearchBestModes", search.most_returned.modes);
  macros.define("SearchBestStep", scientific(search.most_returned.sampling_step, 1));
}

void define_wrong_models(StudyResults& results, Macros& macros) {
  const auto& study = results.wrong_models();
  macros.count("WrongModelCount", study.effects.size());
  macros.plain("WrongModelStickDuration", study.stick_duration);
  macros.plain("WrongModelContactDuration", study.contact_duration);
  macros.define("WrongModelUncertainty", significant(100.0 * study.contact_uncertainty, 1));
}

void define_agreement(StudyResults& results, Macros& macros) {
  const auto values = compared_values(results);
  for (const auto& [name, reference] : {std::pair{"Printed", "printed"}, {"Exact", "closed form"}}) {
    const Agreement agreement = agreement_with(values, reference);
    macros.count(fmt::format("{}Count", name), agreement.count);
    macros.define(fmt::format("{}Bias", name), significant(100.0 * agreement.bias, 2));
    macros.define(fmt::format("{}Spread", name), significant(100.0 * agreement.spread, 2));
  }
}

void define_design(StudyResults& results, Macros& macros) {
  const auto& design = results.design_example();
  macros.plain("DesignFrom", design.band.from_hz);
  macros.plain("DesignTo", design.band.to_hz);
  macros.define("DesignMargin", significant(design.margin.margin.lower, 3));
  macros.define("DesignWorst", significant(design.margin.frequency_hz, 4));
}

void define_traceability(const std::vector<TestResult>& tests, Macros& macros) {
  const auto claims = data::claims();
  macros.count("ClaimsTotal", claims.size());
  macros.count("ClaimsHolding", claims_with(claims, data::ClaimVerdict::holds));
  macros.count("ClaimsCorrected", claims_with(claims, data::ClaimVerdict::holds_with_correction));
  macros.count("ClaimsFailing", claims_with(claims, data::ClaimVerdict::does_not_hold));
  const TestCounts counts = test_counts(tests);
  macros.define("TestsSentence",
                tests.empty()
                    ? "This report was made without a test run: the tables below are empty."
                    : fmt::format("{} tests ran before this report was made; {} of them failed.",
                                  counts.tests, counts.failed == 0 ? "none" : std::to_string(counts.failed)));
  macros.count("TestsComparing", counts.comparing);
  macros.count("TestsTight", counts.tight);
  macros.count("TestsGenerous", counts.generous);
  macros.count("Requirements", counts.requirements);
  macros.count("Comparisons", counts.comparisons);
}

}  // namespace

std::string make_numbers(StudyResults& results, const Environment& environment,
                         const std::vector<TestResult>& tests) {
  Macros macros;
  define_environment(environment, macros);
  define_case(results.paper(), macros);
  define_frequencies(results, macros);
  define_manufactured(results, macros);
  define_stick_history(results, macros);
  define_force_maxima(results, macros);
  define_classification(results, macros);
  define_searches(results, macros);
  define_criterion_diagrams(results, macros);
  define_histories(results, macros);
  define_events(results, macros);
  define_motions(results, macros);
  define_paper(results, macros);
  define_solution_verification(results, macros);
  define_wrong_models(results, macros);
  define_agreement(results, macros);
  define_design(results, macros);
  define_traceability(tests, macros);
  return macros.text();
}

}  // namespace stickslip::report
