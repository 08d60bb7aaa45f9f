// SPDX-License-Identifier: MIT
#include "render/studies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <type_traits>

#include "comparison/comparison.hpp"
#include "comparison/diagnosis/wrong_models.hpp"
#include "render/report.hpp"
#include "render/study_table.hpp"
#include "stickslip/analytic/band_maximum.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/force_maximum.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/data/atomic_file.hpp"
#include "stickslip/data/csv_text.hpp"
#include "stickslip/data/paper.hpp"
#include "stickslip/data/problem.hpp"
#include "stickslip/data/reference.hpp"
#include "stickslip/data/uncertainty.hpp"
#include "stickslip/solver/energy_balance.hpp"
#include "studies/analyses/criterion_answer.hpp"
#include "studies/analyses/design_guide.hpp"
#include "studies/analyses/length_force_map.hpp"
#include "studies/analyses/slip_probability.hpp"
#include "studies/common/parallel.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/history_convergence.hpp"
#include "studies/verification/amplitude_limits.hpp"
#include "studies/verification/claimed_domain.hpp"
#include "studies/verification/classification.hpp"
#include "studies/verification/contact_histories.hpp"
#include "studies/verification/damped_benchmark.hpp"
#include "studies/verification/energy_audit.hpp"
#include "studies/verification/force_maximum.hpp"
#include "studies/verification/force_sensitivity.hpp"
#include "studies/verification/frequencies.hpp"
#include "studies/verification/further_uses.hpp"
#include "studies/verification/manufactured_solution.hpp"
#include "studies/verification/model_form.hpp"
#include "studies/verification/paper_checks.hpp"
#include "studies/verification/proposed_rig.hpp"
#include "studies/verification/scope.hpp"
#include "studies/verification/solution_verification.hpp"
#include "studies/verification/time_order.hpp"

// The members of the problem, and of what both implementations return, as studies hand them on.

namespace stickslip::data {
STICKSLIP_MEMBERS(Beam, (length(), "m"), (area(), "m^2"), (second_moment_of_area(), "m^4"),
                  (density(), "kg/m^3"), (youngs_modulus(), "Pa"), (axial_force(), "N"),
                  (axial_direction(), "1"), (shear_stiffness(), "N"))
STICKSLIP_MEMBERS(FrictionLaw, (static_coefficient(), "1"), (kinetic_coefficient(), "1"), (decay(), "s/m"),
                  (viscous(), "s/m"))
STICKSLIP_MEMBERS(ContactEvent, (change, "-"), (time, "s"), (position, "m"))
STICKSLIP_MEMBERS(HarmonicExcitation, (frequency_hz(), "Hz"), (amplitude(), "m"))
STICKSLIP_MEMBERS(NumericalSettings, (elements(), "1"), (time_step(), "s"), (spectral_radius(), "1"),
                  (velocity_threshold(), "m/s"), (modes(), "1"), (duration(), "s"))
STICKSLIP_MEMBERS(Contact, (friction))
STICKSLIP_MEMBERS(Case, (beam()), (contact), (excitation()), (numerics))
STICKSLIP_MEMBERS(PrintedNumber, (id, "-"), (value), (unit, "-"), (printed, "-"), (printed_unit, "-"),
                  (place, "-"), (meaning, "-"))
}  // namespace stickslip::data

namespace stickslip::analytic {
STICKSLIP_MEMBERS(Bounds, (lower), (upper), (midpoint()))
STICKSLIP_MEMBERS(FrequencyBand, (from_hz, "Hz"), (to_hz, "Hz"))
STICKSLIP_MEMBERS(EventDrivenEnergy, (kinetic, "J"), (potential, "J"), (base_work, "J"), (follower_work, "J"),
                  (damping_loss, "J"), (friction_loss, "J"))
}  // namespace stickslip::analytic

namespace stickslip::solver {
STICKSLIP_MEMBERS(EnergyBalance, (kinetic, "J"), (elastic, "J"), (base_work, "J"), (follower_work, "J"),
                  (damping_loss, "J"), (friction_loss, "J"), (capture_loss, "J"), (initial_energy, "J"),
                  (change(), "J"), (residual(), "J"))
}  // namespace stickslip::solver

namespace stickslip::report {

namespace {

// Critical amplitudes as computed and at 5 and 95 % of the inputs, amplitudes with 1 and 5 % of slip, and probabilities of slip.
struct WorkedUse {
  data::Case problem;
  std::string decisive;  // key
  double predicted, low, high, at_1, at_5, by_inputs, by_both, by_softer, softer_gpa;
};
STICKSLIP_MEMBERS(WorkedUse, (problem), (decisive, "-"), (predicted, "m"), (low, "m"), (high, "m"),
                  (at_1, "m"), (at_5, "m"), (by_inputs, "1"), (by_both, "1"), (by_softer, "1"),
                  (softer_gpa, "GPa"))

std::vector<std::function<void(Results&)>>& all_studies() {
  static std::vector<std::function<void(Results&)>> studies;
  return studies;
}

// No templates, because there are dozens of results.
std::size_t list(std::function<void(Results&)> study) {
  all_studies().push_back(std::move(study));
  return all_studies().size() - 1;
}

void write(const std::filesystem::path& folder, const char* name, nlohmann::json result) {
  std::filesystem::create_directories(folder);
  data::write_text(folder / fmt::format("{}.json", name), json_text(std::move(result)));
}

}  // namespace

/// A study: the name of its JSON file and what is announced before it runs. Every object is one of all_studies().
template <typename Result>
class Study {
 public:
  Study(const char* file, const char* sentence, Result (*function)(Results&))
      : name(file), what(sentence), run(function) {}

  const char *const name, *const what;
  Result (*const run)(Results&);
  const std::size_t number = list([this](Results& r) { r(*this); });  // in all_studies()
};
template <typename Function>
Study(const char*, const char*, Function) -> Study<std::invoke_result_t<Function, Results&>>;

template <typename Result>
const Result& Results::operator()(const Study<Result>& study) {
  Kept& kept = results_[study.number];
  const std::lock_guard lock(kept.guard);  // another thread that asks for the same study waits
  if (!kept.result) {
    announce_(study.what);
    const std::shared_ptr<const Result> result(new Result(study.run(*this)));
    write(folder_, study.name, json_of(*result));
    kept.result = result;
  }
  return *static_cast<const Result*>(kept.result.get());
}

CsvTable comparison_table(const std::vector<validation::Comparison>& comparisons) {
  return study_table(
      "Measured and predicted: the error of the model lies in E +- 2 u_val", comparisons,
      "experiment, record, quantity, form, measured as D, measured_uncertainty as u_D, predicted as S, "
      "input_uncertainty as u_input, numerical_uncertainty as u_num, error as E, uncertainty as u_val, "
      "is_resolved as resolved, unit, blind, required");
}

Results::Results(std::function<void(const std::string&)> announce, std::filesystem::path folder,
                 const std::vector<data::Override>& overrides, std::string text)
    : drawn_by(std::move(text)),
      paper(data::load_case("paper", overrides)),
      damped(data::load_case("damped", overrides)),
      half_stiffness(data::load_case("paper-half-stiffness", overrides)),
      flat_section(data::load_case("paper-figure14", overrides)),
      announce_(std::move(announce)),
      folder_(std::move(folder)),
      results_(all_studies().size()) {}

void Results::run_all(const std::function<void(double)>& progress) {
  const unsigned threads = studies::thread_count();
  const studies::ScopedThreadCount one_each(1);
  studies::in_parallel(
      all_studies().size(), [this](std::size_t i) { all_studies()[i](*this); }, progress, threads);
}

namespace {

// ---- Cases

data::Case with_duration(const data::Case& problem, double seconds) {
  return data::with_value(problem, "excitation.duration", seconds);
}

data::HarmonicExcitation printed_excitation(const std::string& frequency_id,
                                            const std::string& amplitude_id) {
  return data::HarmonicExcitation({.frequency_hz = data::printed_number(frequency_id).value,
                                   .amplitude = data::printed_number(amplitude_id).value});
}

// The excitations of Sect. 5, whose |f_max| the paper prints.
std::vector<data::HarmonicExcitation> printed_excitations() {
  std::vector<data::HarmonicExcitation> excitations;
  for (const int hz : {15, 25, 35, 70})
    excitations.push_back(
        printed_excitation(fmt::format("excitation.frequency.{}", hz), "force_max.amplitude"));
  return excitations;
}

data::Case at_frequency(const data::Case& problem, double hz) {
  return data::with_value(problem, "excitation.frequency_hz", hz);
}

data::Case undamped_at(const Results& r, double hz) {
  return with(at_frequency(r.damped, hz), data::Damping());
}

const Study paper("paper", "the paper's case", [](Results& r) { return r.paper; });
const Study flat_section("flat_section", "the case of Fig. 14", [](Results& r) { return r.flat_section; });
const Study stick_excitation("stick_excitation", "the excitation of Fig. 9", [](Results& /*r*/) {
  return printed_excitation("figure9.frequency", "figure9.amplitude");
});

// ---- Studies

// They start in this order. The longest come first, so that no thread waits for them or for their results.

constexpr double shown_duration = 0.5;  // s
const Study contact_histories("contact_histories", "stick-slip histories (Figs. 4 and 5)",
                              [](Results& r) { return studies::contact_histories(r.paper, shown_duration); });

const Study damped_benchmarks("damped_benchmarks", "the damped benchmark by every method", [](Results& r) {
  std::vector<studies::DampedBenchmark> benchmarks;
  for (const int hz : {25, 70}) benchmarks.push_back(studies::damped_benchmark(at_frequency(r.damped, hz)));
  return benchmarks;
});

constexpr int shown_modes = 3;
const std::vector<int> meshes{4, 6, 8, 12, 16, 24, 32};

const Study stick_frequencies("stick_frequencies", "frequencies of the stick state", [](Results& r) {
  return studies::stick_frequency_study(r.paper.beam(), shown_modes, meshes);
});
const Study slip_frequencies("slip_frequencies", "frequencies of the slip state", [](Results& r) {
  return studies::slip_frequency_study(r.paper.beam(), shown_modes, meshes);
});
const Study half_stiffness_frequencies("half_stiffness_frequencies",
                                       "natural frequencies at half the stiffness", [](Results& r) {
                                         return studies::stick_frequency_study(r.half_stiffness.beam(),
                                                                               shown_modes, meshes);
                                       });

const Study flutter("flutter", "flutter load", [](Results& r) {
  return studies::flutter_study(r.paper.beam(), {4, 8, 16, 32});
});

constexpr int points_per_element = 10;
const Study mode_shapes("mode_shapes", "mode shapes (Fig. 7)", [](Results& r) {
  const int elements = r.paper.numerics.elements();
  return studies::mode_shape_study(r.paper.beam(), shown_modes, elements, points_per_element * elements + 1);
});

const Study time_orders("time_orders", "orders of the time integration", [](Results& /*r*/) {
  std::vector<studies::TimeOrderStudy> orders;
  for (const double radius : {0.0, 0.5, 0.9, 1.0})
    orders.push_back(studies::time_order_study(radius, {50, 100, 200, 400, 800, 1600}));
  return orders;
});

const Study manufactured_solution("manufactured_solution", "manufactured solutions", [](Results& r) {
  return studies::manufactured_solution_study(r.paper.beam());
});

const Study stick_history("stick_history", "stick-state histories under refinement (Fig. 9)", [](Results& r) {
  constexpr int levels = 4;
  return studies::stick_history_study(with(with_duration(r.paper, 1.0), r(stick_excitation)), levels);
});

const Study force_maxima("force_maxima", "largest static friction forces", [](Results& r) {
  std::vector<studies::ForceMaximumStudy> maxima;
  for (const auto& excitation : printed_excitations())
    maxima.push_back(studies::force_maximum_study(with(r.paper, excitation)));
  return maxima;
});

// Of Figs. 10 to 13: every quarter of a hertz, and every hundredth within half a hertz of a resonance, where the
// curve has a spike.
std::vector<double> criterion_frequencies(const studies::FrequencyStudy& natural) {
  constexpr double highest = 120.0;
  std::vector<double> frequencies;
  for (int i = 4; i <= static_cast<int>(4.0 * highest); ++i) frequencies.push_back(0.25 * i);
  for (const auto& mode : natural.modes)
    for (int i = -50; i <= 50; ++i)
      if (const double hz = mode.closed_form_hz + 0.01 * i; hz < highest) frequencies.push_back(hz);
  std::ranges::sort(frequencies);
  return frequencies;
}

const Study criterion("criterion", "critical amplitudes (Fig. 11)", [](Results& r) {
  return studies::critical_amplitude_curve(r.paper, criterion_frequencies(r(stick_frequencies)));
});

// Point i is at the frequency of criterion[i] times the ratio of the first natural frequencies.
const Study half_stiffness_criterion(
    "half_stiffness_criterion", "critical amplitudes at half the stiffness (Fig. 13)", [](Results& r) {
      const double ratio = r(half_stiffness_frequencies).modes.front().closed_form_hz /
                           r(stick_frequencies).modes.front().closed_form_hz;
      std::vector<double> frequencies = criterion_frequencies(r(stick_frequencies));
      for (double& hz : frequencies) hz *= ratio;
      return studies::critical_amplitude_curve(r.half_stiffness, frequencies);
    });

const Study half_stiffness_ratio("half_stiffness_ratio", "stiffness halved, compared", [](Results& r) {
  return studies::amplitude_ratio(r(half_stiffness_criterion), r(criterion));
});

const Study force_surface("force_surface", "largest forces (Fig. 10)", [](Results& r) {
  std::vector<double> natural;
  for (const auto& mode : r(stick_frequencies).modes) natural.push_back(mode.closed_form_hz);
  return studies::force_surface(studies::friction_limit(r.paper), r(criterion), natural);
});

const Study friction_curve("friction_curve", "friction law (Fig. 2)", [](Results& r) {
  return studies::friction_curve(r.paper.contact.friction, r.paper.beam().axial_force());
});

const Study searches("searches", "critical amplitudes by the paper's procedure (Fig. 6)", [](Results& r) {
  constexpr double increment = 1e-5, cap = 1e-3;  // m
  return studies::critical_amplitude_searches(r.paper, studies::figure6_frequencies(), increment, cap);
});

// By half a hertz.
const Study amplitude_limits("amplitude_limits", "critical amplitudes by model", [](Results& r) {
  std::vector<double> frequencies;
  for (int i = 4; i <= 314; ++i) frequencies.push_back(0.5 * i);
  return studies::amplitude_limits(r.paper, r.damped, frequencies);
});
// Of a beam outside the domain of the margin, by a fiftieth of its first natural frequency.
const Study stout_limits("stout_limits", "critical amplitudes of a stout beam", [](Results& r) {
  const data::Case problem = data::load_case("soft-short");
  const double first = analytic::stick_modes(problem.beam(), 1).front().frequency_hz();
  std::vector<double> frequencies;
  for (int i = 5; i <= 200; ++i) frequencies.push_back(0.02 * i * first);
  return studies::amplitude_limits(problem, r.damped, frequencies);
});

const Study amplitude_budget("amplitude_budget", "budget of the critical amplitude", [](Results& r) {
  constexpr std::size_t samples = 1000;
  const auto file = data::find_case("uncertain");
  return studies::amplitude_budget(r(amplitude_limits), r(force_maxima), data::read_case(file),
                                   data::read_uncertainty(file), samples);
});

const Study length_force_map("length_force_map", "length and axial force (Fig. 14)", [](Results& r) {
  return studies::length_force_map(r.flat_section, 0.4, 2.0, studies::figure14_axial_forces());
});

const Study classification("classification", "excitations of Fig. 12", [](Results& r) {
  return studies::classification_study(r.paper, studies::figure12_frequencies(),
                                       studies::figure12_amplitudes());
});

const Study measured("validation", "measurements of others",
                     [](Results& /*r*/) { return validation::comparisons(); });
const Study measured_bias("validation_bias", "bias and spread of the models",
                          [](Results& r) { return validation::biases(r(measured)); });
const Study further_uses("further_uses", "uses that the paper does not have",
                         [](Results& /*r*/) { return studies::further_uses(); });
/// Copies of the data sets, one as it is and one for each compared number, off by twice what agrees at any row.
struct JudgedCopies {
  int copies{}, wrong{};  ///< all; those that differ though they are the data, or agree though they are off
};
STICKSLIP_MEMBERS(JudgedCopies, (copies, "1"), (wrong, "1"))

JudgedCopies judged_copies() {
  JudgedCopies judged;
  const auto judge = [&](const comparison::Reference& reference, const data::UserTable& copy, bool is_equal) {
    comparison::Comparison comparison = comparison::compare(reference, copy);
    ++judged.copies;
    judged.wrong += is_equal != (comparison.agreement == comparison::Agreement::agrees);
    return comparison.quantities;
  };
  const data::ReferencePackage package = data::load_reference();
  for (const data::Resource& resource : package.resources) {
    if (!resource.comparison) continue;
    const comparison::Reference reference = comparison::read_reference(package, resource.name);
    data::UserTable copy;
    copy.columns = reference.table.columns;
    copy.lines.resize(reference.table.rows());
    for (const auto& quantity : judge(reference, copy, true)) {
      data::UserTable off = copy;
      const auto column = std::ranges::find(off.columns, quantity.name,
                                            [](const data::Column& one) { return one.field.name; });
      if (column == off.columns.end() ||
          !std::ranges::any_of(column->values, [](double x) { return std::isfinite(x); }))
        continue;  // words, and the phase of a sample
      double allowed = 0.0;
      for (const auto& series : quantity.series)
        for (const double one : series.allowed) allowed = std::max(allowed, one);
      for (double& value : column->values) value += 2.0 * allowed;
      judge(reference, off, false);
    }
  }
  return judged;
}
const Study copies("judged_copies", "copies of the data sets",
                   [](Results& /*r*/) { return judged_copies(); });
const Study rig("rig", "what a rig should measure",
                [](Results& /*r*/) { return studies::proposed_rig("rig"); });

// Those of contact_histories that slip at 1 mm: 25, 35 and 70 Hz, undamped.
const Study converged_histories("converged_histories", "converged histories", [](Results& r) {
  std::vector<studies::ConvergedHistory> converged;
  for (const auto& history : r(contact_histories))
    if (history.converged && history.amplitude == r.damped.excitation().amplitude())
      converged.push_back(*history.converged);
  return converged;
});

const Study usual_practice("usual_practice", "undamped histories as usual", [](Results& r) {
  std::vector<std::vector<studies::HistoryRun>> runs;
  for (const auto& history : r(converged_histories))
    runs.push_back(studies::usual_practice(r.paper, history));
  return runs;
});

// Resolved in time, 80 elements would take half a minute and 160 minutes.
const Study history_growth("history_growth", "growth of a disturbance on meshes", [](Results& r) {
  const studies::ConvergedHistory& reference = r(converged_histories).front();
  const data::Case problem = undamped_at(r, reference.frequency_hz);
  const auto refined = [&](const studies::StepRule& rule, const std::vector<int>& elements) {
    return studies::history_refinement(problem, reference, rule, elements, elements.back());
  };
  const std::vector<int> all{5, 10, 20, 40, 80, 160}, resolved(all.begin(), all.end() - 2);
  const double radius = r.paper.numerics.spectral_radius(), step = r.paper.numerics.time_step();
  return std::vector{refined({"resolved in time", 0.3, 0.0, radius}, resolved),
                     refined({"fixed step", 0.0, step, radius}, all),
                     refined({"filtering step", studies::filtering_angle, 0.0, 0.0}, all),
                     refined({"radiating tip", 1.2, 0.0, 1.0, 0.01}, resolved)};
});

const Study history_refinements("history_refinements", "undamped histories on meshes", [](Results& r) {
  std::vector<studies::HistoryRefinement> refinements;
  for (const auto& reference : r(converged_histories))
    for (const auto& [radius, elements] :
         {std::pair{0.0, std::vector{10, 20, 40, 80, 160}}, {0.5, {10, 20, 40, 80}}})
      refinements.push_back(studies::history_refinement(
          undamped_at(r, reference.frequency_hz), reference,
          {"filtering step", studies::filtering_angle, 0.0, radius}, elements, 0));
  return refinements;
});

const Study event_orders("event_orders", "orders through the events of a damped history", [](Results& r) {
  constexpr double duration = 0.12;  // s: seven events
  constexpr int elements = 10;
  std::vector<studies::EventOrderStudy> orders;
  for (const double radius : {r.paper.numerics.spectral_radius(), 1.0})
    orders.push_back(
        studies::event_order_study(r.damped, duration, elements, radius, {1, 2, 4, 8, 16, 32, 64}));
  return orders;
});

const Study energy_audits("energy_audits", "energy balance", [](Results& r) {
  const auto audit = [](const data::Case& problem, const std::vector<int>& elements) {
    constexpr double duration = 0.12;  // s
    constexpr int modes = 20;
    return studies::energy_audit(problem, duration, elements, modes,
                                 {2e-5, 1e-5, 5e-6, 2.5e-6, 1.25e-6, 6.25e-7});
  };
  return std::vector{audit(r.damped, {10}),
                     audit(undamped_at(r, r.damped.excitation().frequency_hz()), {5, 10, 20})};
});

const Study schemes("schemes", "contact schemes", [](Results& r) {
  return studies::compare_schemes(with(with_duration(r.paper, shown_duration), r.damped.excitation()));
});

const Study beam_motions("beam_motions", "motions of the whole beam (Fig. 3)", [](Results& r) {
  constexpr int snapshots = 9, places = 61;
  std::vector<studies::BeamMotionStudy> motions;
  for (const auto& excitation : printed_excitations()) {
    motions.push_back(studies::beam_motion_study(with(r.paper, excitation), snapshots, places));
  }
  return motions;
});

const Study wrong_models("wrong_models", "what the known mistakes change", [](Results& r) {
  constexpr double stick_duration = 1.0, contact_duration = 0.12;  // s
  return comparison::wrong_model_effects(r.damped, stick_duration, contact_duration);
});

const Study force_sensitivity("force_sensitivity", "what moves the printed forces",
                              [](Results& r) { return studies::force_sensitivity(r.paper); });

const Study solution_verification("solution_verification", "grid convergence of each result",
                                  [](Results& r) { return studies::solution_verification(r.paper); });

// The section of Fig. 14 over a band around its frequency.
const Study design_example("design_example", "lengths and forces that avoid slipping", [](Results& r) {
  const data::Case& problem = r.flat_section;
  const double hz = problem.excitation().frequency_hz();
  const analytic::FrequencyBand band{hz - 1.0, hz + 1.0};
  const auto scan = [&](std::string_view parameter, double from, double to) {
    return studies::design_scan(problem, parameter,
                                studies::range_below_buckling(problem, parameter, from, to), band);
  };
  return studies::Design{.band = band,
                         .margin = studies::band_margin(problem, band),
                         .lengths = scan("beam.length", 0.4, 2.0),
                         .forces = scan("beam.axial_force", 50.0, 5000.0)};
});

const Study scope("scope", "scope of the criterion", [](Results& r) {
  const auto& histories = r(converged_histories);
  const auto slow = std::ranges::find(histories, 35.0, &studies::ConvergedHistory::frequency_hz);
  return studies::scope(r.paper, r.damped, *slow);
});

const Study tested_cases("tested_cases", "dimensionless groups of the beams", [](Results& /*r*/) {
  std::vector<studies::DimensionlessCase> cases;
  for (const auto& [name, title] : data::list_cases()) {
    const data::Case problem = data::load_case(name);
    if (problem.model() == nullptr && problem.general_motion() == nullptr)
      cases.push_back(studies::dimensionless(problem));
  }
  return cases;
});

const Study claimed_domain("claimed_domain", "closed form against other models over the domain",
                           [](Results& r) {
                             constexpr std::size_t recomputed = 20;
                             return studies::claimed_domain(data::load_case("paper"), recomputed, r.drawn_by);
                           });

// The amplitude of contact-leaf is uncertain by the error of the model. The softer leaf has lower frequencies, as the measured strip.
const Study worked_use("worked_use", "probability of slip of a leaf", [](Results& r) {
  const data::Case problem = data::load_case("contact-leaf");
  const auto keys = data::read_uncertainty(data::find_case("contact-leaf"));
  const auto slip = [&](const std::string& certain, double value) {
    return studies::slip_uncertainty(with_value(problem, certain, value),
                                     studies::without(keys, {{certain, "", ""}}), {.is_short = true});
  };
  const double strip = std::ranges::find(r(measured_bias), "dimensions", &validation::Bias::form)->mean,
               softer_gpa =
                   0.1 * std::round(1e-8 * problem.beam().youngs_modulus() / std::pow(1.0 + strip, 2)),
               amplitude = problem.excitation().amplitude();
  const auto inputs = slip("excitation.amplitude", amplitude),
             both = studies::slip_uncertainty(problem, keys, {.is_short = true});
  const auto critical = [&](const auto& of, double p) {
    return amplitude * studies::quantile_of(of.margins, p).value;
  };
  return WorkedUse{problem,
                   both.tornado.at(both.decisive).key,
                   amplitude * inputs.nominal_margin,
                   critical(inputs, 0.05),
                   critical(inputs, 0.95),
                   critical(both, 0.01),
                   critical(both, 0.05),
                   inputs.probability_of_slip.value,
                   both.probability_of_slip.value,
                   slip("beam.youngs_modulus", 1e9 * softer_gpa).probability_of_slip.value,
                   softer_gpa};
});

const Study model_form("model_form", "criterion with an axial force of fixed direction", [](Results& r) {
  constexpr int lengths = 81;  // every 2 cm
  return studies::model_form(r.paper, r.half_stiffness, r.flat_section, lengths);
});

const Study model_variants(
    "model_variants", "criterion with contact compliance and with damping", [](Results& r) {
      constexpr int lengths = 17;        // every 10 cm
      constexpr std::size_t stride = 5;  // of the axial forces
      constexpr double rigid = std::numeric_limits<double>::infinity();
      std::vector<std::vector<studies::ModelPlane>> rows;
      for (const studies::ModelVariant& variant :
           {studies::ModelVariant{10.0, 0.0}, {100.0, 0.0}, {1000.0, 0.0}, {rigid, 0.005}, {rigid, 0.02}})
        rows.push_back(
            studies::variant_planes(variant, r.paper, r.half_stiffness, r.flat_section, lengths, stride));
      return rows;
    });

const Study printed_checks("printed_checks", "printed numbers",
                           [](Results& r) { return studies::printed_checks(r.paper); });
const Study errata_evidence("errata_evidence", "errata",
                            [](Results& r) { return studies::errata_evidence(r.paper); });

// ---- Figures

FigureData figure(const std::string& name, CsvTable table, std::vector<FigureData::Value> values = {}) {
  return {{{name, std::move(table)}}, std::move(values)};
}

// A sketch with the numbers of the case.
FigureData figure1(Results& r) {
  const data::BeamProperties beam = r.paper.beam().properties();
  return {{},
          {{"length", beam.length, "m"},
           {"axial_force", beam.axial_force, "N"},
           {"stiffness", beam.youngs_modulus * beam.second_moment_of_area, "N m^2"},
           {"mass", beam.density * beam.area, "kg/m"},
           {"static_coefficient", r.paper.contact.friction.static_coefficient(), "1"},
           {"kinetic_coefficient", r.paper.contact.friction.kinetic_coefficient(), "1"},
           {"decay", r.paper.contact.friction.decay(), "s/m"},
           {"limit", studies::friction_limit(r.paper), "N"}}};
}

FigureData figure2(Results& r) {
  const data::FrictionLaw& law = r.paper.contact.friction;
  const char* title =
      "Fig. 2: friction coefficient mu(v) of Eq. (7) and friction force f_d = -sgn(v) mu(v) P";
  return figure("fig2",
                study_table(title, r(friction_curve), "sliding_velocity, coefficient, friction_force"),
                {{"static_coefficient", law.static_coefficient(), "1"},
                 {"kinetic_coefficient", law.kinetic_coefficient(), "1"},
                 {"axial_force", r.paper.beam().axial_force(), "N"}});
}

FigureData convergence(Results& r) {
  return {{{"convergence", study_table("Relative error of the eigenvalue omega^2 on Hermite elements",
                                       std::vector{r(stick_frequencies), r(slip_frequencies)},
                                       "state, modes.mode, elements, element_length, modes.relative_error, "
                                       "modes.predicted_error")},
           {"convergence-time",
            study_table("Error of generalised-alpha on a damped chain of two masses", r(time_orders),
                        "spectral_radius, time_step, displacement_error, velocity_error, reaction_error")}},
          {}};
}

// Panel i, by rows, has the columns 2 i and 2 i + 1 and the value hz<i>; stick stands left, slip right.
FigureData figure7(Results& r) {
  const auto& study = r(mode_shapes);
  std::string columns = "position as x_over_L";
  std::vector<FigureData::Value> values{{"points_per_element", points_per_element, "1"}};
  for (std::size_t i = 0; i < study.curves.size(); ++i) {
    const auto& curve = study.curves[i];
    for (const char* method : {"closed_form", "finite_element"})
      columns += fmt::format(", curves.{}.{} as {}_{}_{}", i, method, curve.state(), curve.mode, method);
    values.push_back({fmt::format("hz{}", i + 1), curve.closed_form_hz, "Hz"});
  }
  return figure(
      "fig7", study_table("Fig. 7: mode shapes scaled to a largest deflection of 1", study, columns), values);
}

FigureData refinement(Results& r) {
  return figure("refinement",
                study_table("Sup-norm difference of finite elements and closed form in the stick state",
                            r(stick_history).levels,
                            "elements, time_step, displacement_error, predicted_displacement_error, "
                            "force_error, predicted_force_error"));
}

FigureData event_order(Results& r) {
  return figure("event-order",
                study_table("Errors through the events of a damped history", r(event_orders),
                            "spectral_radius, time_step, located.event_time_error as located_event_time, "
                            "at_end_of_step.event_time_error as end_of_step_event_time, "
                            "located.tip_error as located_tip, at_end_of_step.tip_error as end_of_step_tip"),
                {{"radius", r(event_orders).front().spectral_radius, "1"}});
}

FigureData figure9(Results& r) {
  const auto& first = r(stick_history).levels.front();
  const char* title =
      "Fig. 9: midspan displacement y(L/2, t) and static friction force f(t) of the stick state";
  return figure("fig9",
                study_table(title, r(stick_history),
                            "time, displacement as displacement_closed_form, "
                            "first_displacement as displacement_finite_element, "
                            "force as force_closed_form, first_force as force_finite_element"),
                {{"displacement_bound", first.predicted_displacement_error, "m"},
                 {"force_bound", first.predicted_force_error, "N"}});
}

void add_natural_frequencies(const studies::FrequencyStudy& study, const char* name, FigureData& data) {
  for (const auto& mode : study.modes)
    data.values.push_back({fmt::format("{}{}", name, mode.mode), mode.closed_form_hz, "Hz"});
}

FigureData figure_of_limits(Results& r, const char* name, const char* title, const char* columns) {
  FigureData data = figure(name, study_table(title, r(amplitude_limits).limits, columns));
  add_natural_frequencies(r(stick_frequencies), "natural", data);
  data.values.push_back({"distance", studies::resonance_distance, "1"});
  data.values.push_back({"highest", studies::domain_groups()[1].margin_greatest, "1"});  // over natural1
  return data;
}

FigureData limits(Results& r) {
  return figure_of_limits(r, "limits",
                          "Critical amplitude at a start-up and in steady vibration, closed form",
                          "frequency_hz, start_up, steady, damped_start_up, damped_steady");
}

FigureData models(Results& r) {
  const char* title = "Critical amplitude at a start-up in other models, closed form";
  const char* columns = "frequency_hz, start_up, shear, compliant";
  FigureData data = figure_of_limits(r, "models", title, columns);
  data.tables.push_back({"models-stout", study_table(title, r(stout_limits).limits, columns)});
  int mode = 0;
  for (const auto& one : analytic::stick_modes(data::load_case("soft-short").beam(), 2))
    data.values.push_back({fmt::format("stout{}", ++mode), one.frequency_hz(), "Hz"});
  return data;
}

FigureData budget(Results& r) {
  return figure("budget", study_table("What moves the critical amplitude of a start-up", r(amplitude_budget),
                                      "cause, kind, frequency_hz, fall in %, rise in %"));
}

// Row of a model, ratio, and 0 outside the domain of the margin, 1 in it, 2 at its corners.
FigureData domain(Results& r) {
  CsvTable table("Critical amplitude in other models over that of the closed form, over the box",
                 "model [-], row [1], case [1], ratio [1], place [1]");
  double row = 0.0;
  for (const auto& [model, change] : studies::domain_models()) {
    for (const studies::DomainCase& one : r(claimed_domain).cases) {
      table.add(model).add(row).add(one.index).add(1.0 + one.*change);
      table.add(one.index > 2 * studies::domain_cases ? 2.0
                : studies::is_in_margin(one)          ? 1.0
                                                      : 0.0)
          .end_row();
    }
    row += 1.0;
  }
  return {{{"domain", std::move(table)}}, {}};
}

FigureData figure12(Results& r) {
  FigureData data{
      {{"fig12",
        study_table("Fig. 12: verdict of either implementation at each excitation", r(classification).points,
                    "frequency_hz, amplitude, closed_form, finite_element, in_guard_band")},
       {"fig12-curve", study_table("Critical amplitude of stick-slip, closed form", r(criterion),
                                   "frequency_hz, critical_amplitude")}},
      {}};
  add_natural_frequencies(r(stick_frequencies), "natural", data);
  return data;
}

// Long form: panel and snapshot count from 1 in columns 1 and 3.
FigureData figure3(Results& r) {
  CsvTable table(
      "Fig. 3: motion y(x, t) of the beam over one period, by finite elements and without a mesh (closed "
      "form where the tip sticks throughout, else converged on free modes)",
      "panel [1], frequency_Hz [Hz], snapshot [1], time_s [s], periods_since_first_snapshot [1], tip_sticks "
      "[1], position_m [m], finite_element_displacement_m [m], continuous_beam_displacement_m [m]");
  int panel = 0;
  for (const auto& study : r(beam_motions)) {
    ++panel;
    const auto& rows = study.finite_element.rows;
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t k = 0; k < study.position.size(); ++k)
        table.add_numbers({static_cast<double>(panel), study.frequency_hz, static_cast<double>(i + 1),
                           rows[i].time, (rows[i].time - rows[0].time) * study.frequency_hz,
                           rows[i].state == data::ContactState::stick ? 1.0 : 0.0, study.position[k],
                           rows[i].displacement[k], study.reference.rows[i].displacement[k]});
  }
  return {{{"fig3", std::move(table)}}, {}};
}

// The tip histories of one amplitude that slip; panel i has the value hz<i> and the columns 2 i to 2 i + 1.
FigureData tip_histories(Results& r, const std::string& number) {
  std::vector<studies::ContactHistory> panels = r(contact_histories);
  std::erase_if(panels,
                [&](const auto& panel) { return !panel.figure.starts_with(number) || !panel.converged; });
  std::string columns = "0.converged.time";
  std::vector<FigureData::Value> values{{"shown", shown_duration, "s"},
                                        {"panels", static_cast<double>(panels.size()), "1"}};
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const double hz = panels[i].frequency_hz;
    values.push_back({fmt::format("hz{}", i + 1), hz, "Hz"});
    columns += fmt::format(", {0}.converged.tip as tip_displacement_{1}hz", i, hz);
    columns += fmt::format(", {0}.converged.tip_half_width as half_width_{1}hz", i, hz);
  }
  const std::string title =
      fmt::format("Fig. {}: tip displacement y(L, t) at A0 = {} m, converged, with half-width", number,
                  panels.front().amplitude);
  return figure("fig" + number, study_table(title, panels, columns), values);
}

FigureData figure4(Results& r) { return tip_histories(r, "4"); }
FigureData figure5(Results& r) { return tip_histories(r, "5"); }

// Run 0 is the uncertainty of the reference.
CsvTable benchmark_events(const std::vector<studies::DampedBenchmark>& benchmarks) {
  CsvTable events(
      "Damped benchmark: events of the reference and differences of other runs to it",
      "frequency_Hz [Hz], run [1], method [-], elements_or_modes [1], time_step_s [s], event_time_s [s], "
      "change [-], position_m [m], time_difference_s [s], position_difference_m [m]");
  for (const auto& benchmark : benchmarks) {
    const auto add = [&](int number, const studies::BenchmarkRun& run, std::size_t i,
                         const studies::EventDifference& difference) {
      const auto& event = benchmark.events[i];
      events.add(benchmark.frequency_hz).add(number).add(run.method).add(run.size).add(run.time_step);
      events.add(event.time).add(data::to_string(event.change)).add(event.position);
      events.add(difference.time).add(difference.position).end_row();
    };
    studies::BenchmarkRun reference;
    reference.method = "uncertainty of the reference";
    reference.size = benchmark.modes;
    for (std::size_t i = 0; i < benchmark.events.size(); ++i)
      add(0, reference, i, benchmark.uncertainties[i]);
    int number = 0;
    for (const auto& run : benchmark.runs) {
      ++number;
      for (std::size_t i = 0; i < run.each.size(); ++i) add(number, run, i, run.each[i]);
    }
  }
  return events;
}

FigureData benchmark(Results& r) {
  const auto& all = r(damped_benchmarks);
  return {{{"benchmark", benchmark_events(all)},
           {"benchmark-histories",
            study_table("Damped benchmark: tip displacement y(L, t) of the reference", all,
                        "0.history.rows.time, 0.history.rows.tip_displacement as tip_25hz, "
                        "1.history.rows.tip_displacement as tip_70hz")}},
          {{"shown", all.front().duration, "s"},
           {"hz1", all.front().frequency_hz, "Hz"},
           {"hz2", all.back().frequency_hz, "Hz"}}};
}

// Undamped histories as they are usually computed, next to the converged one. Row j of panels has the value
// hz<j>.
FigureData practice(Results& r) {
  CsvTable table("Undamped tip displacement y(L, t): converged (run 0) and as usually computed",
                 "frequency_Hz [Hz], run [1], method [-], elements [1], time_step_s [s], spectral_radius "
                 "[1], largest_error_percent [%], time_s [s], tip_displacement_m [m]");
  FigureData data{{}, {{"shown", shown_duration, "s"}}};
  for (std::size_t j = 0; j < r(converged_histories).size(); ++j) {
    const auto& converged = r(converged_histories)[j];
    data.values.push_back({fmt::format("hz{}", j + 1), converged.frequency_hz, "Hz"});
    std::vector<studies::HistoryRun> runs = r(usual_practice)[j];
    runs.insert(runs.begin(), {.method = "converged", .tip_displacement = converged.tip});
    for (std::size_t k = 0; k < runs.size(); ++k)
      for (std::size_t n = 0; n < converged.time.size(); ++n) {
        table.add(converged.frequency_hz).add(static_cast<double>(k)).add(runs[k].method);
        table.add(runs[k].elements).add(runs[k].time_step).add(runs[k].spectral_radius);
        table.add(100.0 * runs[k].error).add(converged.time[n]).add(runs[k].tip_displacement[n]);
        table.end_row();
      }
  }
  data.tables.push_back({"practice", std::move(table)});
  return data;
}

// Rule k of the table has the name rule<k>.
FigureData growth(Results& r) {
  FigureData data =
      figure("growth",
             study_table("Undamped histories of generalised-alpha on meshes", r(history_growth),
                         "# as rule, runs.elements, runs.time_step, runs.spectral_radius, runs.growth_bound, "
                         "runs.observed_growth, runs.error in %"),
             {{"beam", r(history_growth).front().beam_growth_bound, "1/s"}});
  int rule = 0;
  for (const auto& series : r(history_growth))
    data.values.push_back({fmt::format("rule{}", ++rule), 0.0, "-", series.rule.name});
  return data;
}

// The points are the excitations A to D whose |f_max| the paper prints.
FigureData figure10(Results& r) {
  CsvTable points("Fig. 10: the excitations A to D",
                  "letter [-], frequency_Hz [Hz], amplitude_m [m], force_max_N [N]");
  const char* letter = "ACBD";
  for (const auto& force : r(force_maxima)) {
    points.add(std::string_view(letter++, 1)).add(force.frequency_hz).add(force.amplitude);
    points.add(force.truncated.midpoint()).end_row();
  }
  return {{{"fig10", study_table("Fig. 10: largest static friction force |f_max| over 0 to 10 s, closed form",
                                 r(force_surface), "frequency_hz, amplitude, force_max", TableShape::grid)},
           {"fig10-points", std::move(points)}},
          {{"limit", studies::friction_limit(r.paper), "N"}}};
}

FigureData figure13(Results& r) {
  FigureData data = figure(
      "fig13",
      study_table("Fig. 13: critical amplitude with the flexural rigidity EI and with EI/2, closed form",
                  std::vector{r(criterion), r(half_stiffness_criterion)},
                  "0.frequency_hz, 0.critical_amplitude, 1.frequency_hz as half_stiffness_frequency, "
                  "1.critical_amplitude as half_stiffness_critical_amplitude"));
  add_natural_frequencies(r(stick_frequencies), "natural", data);
  add_natural_frequencies(r(half_stiffness_frequencies), "half", data);
  return data;
}

// Grid lines of one axial force.
FigureData figure14(Results& r) {
  const auto& study = r(length_force_map);
  return {
      {{"fig14", study_table("Fig. 14: |f_max|/(mu_s P) over beam length and axial force, closed form",
                             study.lines, "length, axial_force, force_ratio", TableShape::grid)},
       {"fig14-limits", study_table("Fig. 14: lengths of resonance with the excitation and of buckling",
                                    study.lines, "axial_force, resonance_1, resonance_2, buckling_length")}},
      {{"hz", study.frequency_hz, "Hz"},
       {"buckling_coefficient", study.buckling_coefficient, "1"},
       {"case_length", r.flat_section.beam().length(), "m"},
       {"case_force", r.flat_section.beam().axial_force(), "N"}}};
}

// The decadic logarithm of error over tolerance, from -1 to 6, of each code in each problem that a code in verification/peers has
// done: the usual settings, which come first, and the best. Nothing where there is no driver; state 1 where the code cannot do the problem.
FigureData scoreboard(Results& /*r*/) {
  using Key = std::pair<std::string, std::string>;
  const auto file = templates_directory().parent_path() / "verification" / "peers" / "scoreboard.csv";
  const std::string text = data::read_table_text(file);
  data::CsvReader reader(file, text);
  std::vector<std::string> codes, problems;
  std::map<Key, std::vector<double>> ratios;
  const auto column = [&](const char* name) {
    return static_cast<std::size_t>(std::ranges::find(reader.names(), name) - reader.names().begin());
  };
  const auto note = [](std::vector<std::string>& names, const std::string& name) {
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  };
  while (const auto row = reader.next_row()) {
    const Key key{row->at(column("code")), row->at(column("problem"))};
    note(codes, key.first);
    auto& values = ratios[key];
    if (const std::string& ratio = row->at(column("ratio")); !ratio.empty()) {
      note(problems, key.second);
      values.push_back(std::clamp(std::log10(std::stod(ratio)), -1.0, 6.0));
    }
  }
  CsvTable table(
      "Error over tolerance of other codes, as decadic logarithm from -1 to 6",
      "code [-], problem [-], problem_number [1], code_number [1], state [1], usual [1], best [1]");
  for (std::size_t j = 0; j < codes.size(); ++j)
    for (std::size_t i = 0; i < problems.size(); ++i) {
      const auto found = ratios.find({codes[j], problems[i]});
      table.add(codes[j]).add(problems[i]).add(static_cast<double>(i)).add(static_cast<double>(j));
      const bool ran = found != ratios.end() && !found->second.empty();
      table.add(found != ratios.end() && !ran ? 1.0 : 0.0);
      table.add(ran ? std::optional(found->second.front()) : std::nullopt);
      table.add(ran ? std::optional(std::ranges::min(found->second)) : std::nullopt).end_row();
    }
  return figure("scoreboard", std::move(table));
}

FigureData intervals(Results& r) {
  return {{{"validation", comparison_table(r(measured))},
           {"validation-bias",
            study_table(
                "Mean and standard deviation of E/D over all set points", r(measured_bias),
                "experiment, quantity, form, blind, points, resolved, beyond, mean, spread, resolved_mean")}},
          {}};
}

FigureData rig_drawing(Results& r) {
  const data::Case problem = data::load_case("rig");
  return figure(
      "rig",
      study_table(
          "First frequency with the tip free, and the accuracy that decides on the direction of the force",
          r(rig).frequencies, "length, load, following_hz, fixed_hz, accuracy"),
      {{"beam_length", problem.beam().length(), "m"},
       {"section_width", data::value_of(problem, "section.width"), "m"},
       {"section_height", data::value_of(problem, "section.height"), "m"},
       {"axial_force", problem.beam().axial_force(), "N"},
       {"static_coefficient", problem.contact.friction.static_coefficient(), "1"}});
}

}  // namespace

const std::vector<Figure>& all_figures() {
  static const std::vector<Figure> figures{{"fig1", figure1},
                                           {"limits", limits},
                                           {"domain", domain},
                                           {"fig2", figure2},
                                           {"convergence", convergence},
                                           {"fig7", figure7},
                                           {"refinement", refinement},
                                           {"event-order", event_order},
                                           {"fig9", figure9},
                                           {"fig12", figure12},
                                           {"fig3", figure3},
                                           {"fig4", figure4},
                                           {"fig5", figure5},
                                           {"benchmark", benchmark},
                                           {"practice", practice},
                                           {"growth", growth},
                                           {"fig10", figure10},
                                           {"fig13", figure13},
                                           {"fig14", figure14},
                                           {"validation", intervals},
                                           {"rig", rig_drawing},
                                           {"scoreboard", scoreboard},
                                           {"models", models},
                                           {"budget", budget}};
  return figures;
}

}  // namespace stickslip::report
