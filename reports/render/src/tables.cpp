#include "tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "findings.hpp"
#include "latex_table.hpp"
#include "mutant_tables.hpp"
#include "paper_index.hpp"
#include "stickslip/data/paper.hpp"
#include "stickslip/report/latex_text.hpp"
#include "traceability.hpp"
#include "units.hpp"

namespace stickslip::report {

namespace {

std::string word_of(bool slips) { return slips ? "stick-slip" : "stick"; }
std::string without_full_stop(std::string text) {
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::string summary(StudyResults& results) {
  Rows rows;
  const auto order_range = [](const Range& range) {
    return fmt::format("order {} to {}", fixed(range.lowest, 2), fixed(range.highest, 2));
  };
  const Range stick = orders_of(results.stick_frequencies()), slip = orders_of(results.slip_frequencies());
  rows.add({"Natural frequencies, stick and slip state",
            order_range({std::min(stick.lowest, slip.lowest), std::max(stick.highest, slip.highest)}),
            "order 4 in element length"});
  const auto& flutter = results.flutter();
  rows.add({fmt::format("Flutter load, {} elements", flutter.elements.back()),
            fmt::format("{} $EI/L^2$", fixed(flutter.finite_element.back(), 5)),
            fmt::format("{} $EI/L^2$", fixed(flutter.closed_form, 5))});
  rows.add({"Generalised-$\\alpha$: motion and reaction", order_range(orders_of(results.time_orders())),
            "order 2 in time step"});
  const auto& level = results.stick_history().levels.front();
  rows.add({"Fig.~9, displacement, paper's settings", scientific(level.displacement_error, 2) + "\\unit{m}",
            "at most " + scientific(level.predicted_displacement_error, 2) + "\\unit{m}"});
  rows.add({"Fig.~9, friction force, paper's settings", significant(level.force_error, 2) + "\\unit{N}",
            "at most " + significant(level.predicted_force_error, 2) + "\\unit{N}"});
  const auto forces = force_differences(results.force_maxima());
  rows.add({"$\\fmax$ at four excitations, finite elements",
            fmt::format("within {}\\,\\% of closed form", significant(forces.discretisation, 2)),
            fmt::format("as predicted to {}\\,\\%", significant(forces.prediction, 2))});
  const auto points = point_counts(results.classification());
  rows.add({"Fig.~12, verdicts on a grid",
            fmt::format("{} of {} agree; {} differ outside guard", points.agreeing, points.all,
                        points.disagreeing_outside),
            "none differ outside it"});
  const auto& histories = results.contact_histories();
  rows.add({"Figs.~4 and 5, verdicts with the paper",
            fmt::format("{} of {} agree", history_findings(histories).verdicts_agreeing, histories.size()),
            "all"});
  const auto& orders = results.event_orders().front();
  rows.add({"Event times, located (not located)",
            fmt::format("order {} ({})", fixed(orders.located.event_time_order.order, 2),
                        fixed(orders.at_end_of_step.event_time_order.order, 2)),
            "order 2 (1) in time step"});
  double time = 0.0, position = 0.0;
  std::size_t events = 0;
  for (const auto& benchmark : results.damped_benchmarks()) {
    const auto& run = finest_stepped(benchmark);
    time = std::max(time, run.all.time);
    position = std::max(position, run.all.position);
    events += benchmark.events.size();
  }
  rows.add({fmt::format("Damped stick-slip, {} events, both methods", events),
            fmt::format("{}\\unit{{s}}, {}\\unit{{m}}", scientific(time, 1), scientific(position, 1)),
            "mesh and step error"});
  const auto& verified = results.solution_verification().results;
  rows.add({"Grid convergence index over true error",
            fmt::format("covers {} of {} results",
                        std::ranges::count_if(verified, [](const auto& result) { return result.covered; }),
                        verified.size()),
            "all in the asymptotic range"});
  const auto& checks = results.printed_checks();
  rows.add({"Printed numbers recomputed",
            fmt::format("{} of {} agree", std::ranges::count_if(checks, &studies::PrintedCheck::agrees),
                        checks.size()),
            "all but errata (Table~\\ref{tab:printed})"});
  return rows.text();
}

std::string parameters(StudyResults& results) {
  const data::Case& paper = results.paper();
  Rows rows;
  const auto add = [&](const char* name, const char* symbol, double value, const char* unit) {
    rows.add({name, symbol, compact_number(value, 4), unit_text(unit)});
  };
  add("Length", "$L$", paper.beam.length(), "m");
  add("Cross-sectional area", "$A$", paper.beam.area(), "m^2");
  add("Second moment of area", "$I$", paper.beam.second_moment_of_area(), "m^4");
  add("Density", "$\\rho$", paper.beam.density(), "kg/m^3");
  add("Young's modulus", "$E$", paper.beam.youngs_modulus(), "Pa");
  add("Axial force, compression", "$P$", paper.beam.axial_force(), "N");
  add("Static friction coefficient", "$\\mu_s$", paper.friction.static_coefficient(), "1");
  add("Kinetic friction coefficient", "$\\mu_m$", paper.friction.kinetic_coefficient(), "1");
  add("Decay", "$\\alpha$", paper.friction.decay(), "s/m");
  rows.space();
  add("Finite elements", "", paper.numerics.elements(), "1");
  add("Time step", "$\\Delta t$", paper.numerics.time_step(), "s");
  add("Spectral radius at infinite frequency", "$\\rhoinf$", paper.numerics.spectral_radius(), "1");
  add("Velocity threshold", "$\\varepsilon$", paper.numerics.velocity_threshold(), "m/s");
  add("Modes of the closed form", "$N$", paper.numerics.modes(), "1");
  add("Duration for $\\fmax$", "", paper.numerics.duration(), "s");
  return rows.text();
}

std::string unstated() {
  Rows rows;
  for (const auto& row : data::unstated()) {
    rows.add({typeset(row.subject), typeset(row.choice), typeset(row.reason)});
    rows.space();
  }
  return rows.text();
}

void add_frequencies(const studies::FrequencyStudy& study, const studies::ModeShapeStudy& shapes, bool slip,
                     Rows& rows) {
  for (const auto& mode : study.modes)
    for (const auto& curve : shapes.curves)
      if (curve.slip == slip && curve.mode == mode.mode)
        rows.add({slip ? "slip" : "stick", std::to_string(mode.mode), fixed(mode.closed_form_hz, 5),
                  fixed(curve.finite_element_hz, 5),
                  scientific(curve.finite_element_hz / mode.closed_form_hz - 1.0, 2),
                  order_text(mode.observed_order), fixed(mode.leading_constant_ratio, 3)});
}

std::string frequencies(StudyResults& results) {
  Rows rows;
  add_frequencies(results.stick_frequencies(), results.mode_shapes(), false, rows);
  rows.space();
  add_frequencies(results.slip_frequencies(), results.mode_shapes(), true, rows);
  return rows.text();
}

std::string flutter(StudyResults& results) {
  const auto& study = results.flutter();
  Rows rows;
  for (std::size_t i = 0; i < study.elements.size(); ++i)
    rows.add({std::to_string(study.elements[i]), fixed(study.finite_element[i], 6),
              scientific(study.finite_element[i] / study.closed_form - 1.0, 2)});
  return rows.text();
}

std::string orders(StudyResults& results) {
  Rows rows;
  for (const auto& study : results.time_orders())
    rows.add({plain_number(study.spectral_radius), order_text(study.displacement_order),
              order_text(study.velocity_order), order_text(study.reaction_order)});
  return rows.text();
}

std::string name_of(studies::ManufacturedTip tip) {
  switch (tip) {
    case studies::ManufacturedTip::stick:
      return "stick";
    case studies::ManufacturedTip::slip:
      return "slip";
    default:
      return "slip, friction law";
  }
}

// Error over prediction on the finest level.
std::string constant_text(const studies::PredictedErrors& errors) {
  return errors.predicted.empty() ? "" : fixed(errors.error.back() / errors.predicted.back(), 4);
}

std::string manufactured_space(StudyResults& results) {
  Rows rows;
  for (const auto& row : results.manufactured().space) {
    const auto& tip = row.tip == studies::ManufacturedTip::slip ? row.tip_deflection : row.force;
    rows.add({name_of(row.tip), plain_number(row.load_factor), order_text(row.deflection.order),
              order_text(row.slope.order), order_text(row.curvature.order), order_text(tip.order),
              constant_text(row.deflection), constant_text(row.curvature), constant_text(tip)});
  }
  return rows.text();
}

std::string manufactured_time(StudyResults& results) {
  Rows rows;
  for (const auto& row : results.manufactured().time)
    rows.add({name_of(row.tip), plain_number(row.spectral_radius), order_text(row.displacement.order),
              order_text(row.velocity.order), row.force.error.empty() ? "" : order_text(row.force.order),
              constant_text(row.displacement)});
  return rows.text();
}

std::string refinement(StudyResults& results) {
  Rows rows;
  for (const auto& level : results.stick_history().levels)
    rows.add({std::to_string(level.elements), scientific(level.time_step, 3),
              scientific(level.displacement_error, 2), scientific(level.predicted_displacement_error, 2),
              scientific(level.force_error, 2), scientific(level.predicted_force_error, 2)});
  return rows.text();
}

std::string force(StudyResults& results) {
  Rows rows;
  for (const auto& row : results.force_maxima()) {
    const auto printed = data::printed_number(fmt::format("force_max.{}", row.frequency_hz));
    rows.add({plain_number(row.frequency_hz), typeset(printed.printed), fixed(row.sampled, 2),
              fixed(row.truncated.midpoint(), 2), fixed(row.converged.midpoint(), 2),
              fixed(row.finite_element, 2), fixed(row.predicted_finite_element, 2)});
  }
  return rows.text();
}

std::vector<std::string> guard_cells(const studies::ClassifiedFrequency& frequency) {
  return {plain_number(frequency.frequency_hz), significant(frequency.critical_amplitude / millimetre, 4),
          fixed(100.0 * frequency.relative_truncation_error, 2),
          fixed(100.0 * frequency.relative_discretisation_error, 2),
          fixed(100.0 * frequency.relative_guard(), 2)};
}

// Two frequencies a row, the second half beside the first.
std::string guard(StudyResults& results) {
  const auto& frequencies = results.classification().frequencies;
  const std::size_t half = (frequencies.size() + 1) / 2;
  Rows rows;
  for (std::size_t i = 0; i < half; ++i) {
    auto cells = guard_cells(frequencies[i]);
    if (i + half < frequencies.size()) {
      const auto right = guard_cells(frequencies[i + half]);
      cells.insert(cells.end(), right.begin(), right.end());
    }
    rows.add(cells);
  }
  return rows.text();
}

std::string guard_points(StudyResults& results) {
  const auto& study = results.classification();
  Rows rows;
  for (const auto& point : study.points) {
    if (!point.in_guard_band) continue;
    for (const auto& frequency : study.frequencies)
      if (frequency.frequency_hz == point.frequency_hz)
        rows.add({plain_number(point.frequency_hz), fixed(point.amplitude / millimetre, 2),
                  fixed(100.0 * (point.amplitude / frequency.critical_amplitude - 1.0), 2),
                  fixed(100.0 * frequency.relative_guard(), 2), word_of(point.closed_form_slips),
                  word_of(point.finite_element_slips)});
  }
  return rows.text();
}

std::string verified_results(StudyResults& results) {
  const std::vector<std::string> sources = uncertainty_sources(results);
  Rows rows;
  for (const auto& result : results.solution_verification().results) {
    const auto& convergence = result.convergence;
    rows.add(
        {typeset(result.quantity + (result.unit == "1" ? "" : ", " + result.unit)),
         result.printed ? compact_number(*result.printed, 6) : "--",
         compact_number(result.levels.front().value, 6), compact_number(result.levels.back().value, 6),
         convergence.observed_order ? fixed(*convergence.observed_order, 2) : "--",
         convergence.asymptotic ? "yes" : "no", compact_number(convergence.index, 2),
         compact_number(result.true_error, 2), yes_or_no(result.covered),
         fmt::format("{} ({})", compact_number(result.uncertainty, 2), letter_of(result.obtained, sources))});
  }
  return rows.text();
}

std::string signed_percent(double value) {
  const std::string text = fixed(std::abs(value), 2);
  const bool is_zero = text.find_first_of("123456789") == std::string::npos;
  return is_zero ? text : fmt::format("${}{}$", value > 0.0 ? "+" : "-", text);
}

// A line between the settings of one factor and the next.
std::string sensitivity(StudyResults& results) {
  Rows rows;
  std::string factor;
  bool closed_form = true;
  for (const auto& row : results.force_sensitivity().rows) {
    const bool goes_on = row.factor == factor && row.closed_form == closed_form;
    if (!goes_on && !factor.empty()) rows.space();
    factor = row.factor;
    closed_form = row.closed_form;
    std::vector<std::string> cells{
        goes_on ? "" : fmt::format("{}{}", row.closed_form ? "" : "FE: ", typeset(row.factor)),
        typeset(with_powers_of_ten(row.setting)) + (row.left_open ? "*" : "")};
    for (std::size_t i = 0; i < row.force.size(); ++i) {
      cells.push_back(significant(row.force[i], 5));
      cells.push_back(signed_percent(row.change[i]));
    }
    rows.add(cells);
  }
  return rows.text();
}

std::string input_sensitivity(StudyResults& results) {
  Rows rows;
  for (const auto& input : results.force_sensitivity().inputs) {
    std::vector<std::string> cells{typeset(input.input)};
    for (std::size_t i = 0; i < input.relative.size(); ++i) {
      cells.push_back(significant(input.relative[i], 2));
      cells.push_back(fmt::format("{} \\ldots{{}} {}", signed_percent(input.lowest_change[i]),
                                  signed_percent(input.highest_change[i])));
    }
    rows.add(cells);
  }
  return rows.text();
}

std::string determined_digits(StudyResults& results) {
  Rows rows;
  for (const auto& digits : results.force_sensitivity().digits) {
    const auto printed = data::printed_number(fmt::format("force_max.{}", digits.frequency_hz));
    std::vector<std::string> cells{plain_number(digits.frequency_hz), typeset(printed.printed)};
    for (const auto* range : {&digits.formula, &digits.method, &digits.problem}) {
      cells.push_back(fmt::format("{} \\ldots{{}} {}", significant(range->force.lower, 6),
                                  significant(range->force.upper, 6)));
      cells.push_back(std::to_string(range->digits));
      cells.push_back(yes_or_no(range->holds_printed));
    }
    rows.add(cells);
  }
  return rows.text();
}

std::string design_rows(const studies::DesignScan& scan, int decimals) {
  Rows rows;
  for (const auto& interval : scan.intervals) {
    std::string why = interval.buckled ? "no stick state" : "slips";
    if (!interval.sticks && !interval.resonances.empty())
      why += fmt::format(": natural frequency {} in the band", fmt::join(interval.resonances, ", "));
    rows.add({fmt::format("{} \\ldots{{}} {}", fixed(interval.from, decimals), fixed(interval.to, decimals)),
              interval.sticks ? "sticks" : why});
  }
  return rows.text();
}

std::string verdicts(StudyResults& results) {
  const auto printed = data::printed_verdicts();
  const auto& histories = results.contact_histories();
  const auto time = [](const std::optional<double>& seconds) {
    return seconds ? fixed(*seconds / millisecond, 3) : "--";
  };
  Rows rows;
  for (std::size_t i = 0; i < histories.size(); ++i) {
    const auto& history = histories[i];
    rows.add({printed[i].figure, plain_number(history.frequency_hz), fixed(history.amplitude / millimetre, 1),
              printed[i].verdict, word_of(history.criterion_slips),
              word_of(history.finite_element_slip.has_value()), time(history.closed_form_slip),
              time(history.finite_element_slip),
              history.converged ? significant(100.0 * history.converged->largest_half_width(), 1) : "--"});
  }
  return rows.text();
}

std::string scheme_name(solver::ContactScheme scheme) {
  switch (scheme) {
    case solver::ContactScheme::located:
      return "located inside the step";
    case solver::ContactScheme::end_of_step:
      return "at the end of the step";
    case solver::ContactScheme::paper:
      return "the letter of the paper";
  }
  return "";
}

std::string schemes(StudyResults& results) {
  Rows rows;
  for (const auto& run : results.schemes()) {
    std::vector<std::string> plateaus;
    for (std::size_t i = 0; i < std::min<std::size_t>(3, run.plateaus.size()); ++i)
      plateaus.push_back(fixed(run.plateaus[i].tip_displacement / millimetre, 3));
    rows.add({scheme_name(run.scheme), run.first_slip ? fixed(*run.first_slip / millisecond, 3) : "--",
              std::to_string(run.events),
              plateaus.empty() ? "none" : fmt::format("{}", fmt::join(plateaus, ", ")),
              fixed(run.largest_tip_displacement / millimetre, 2),
              significant(100.0 * run.relative_residual(), 2)});
  }
  return rows.text();
}

std::string event_orders(StudyResults& results) {
  Rows rows;
  for (const auto& study : results.event_orders())
    for (const auto& [name, order] :
         {std::pair{"located", &study.located}, {"at the end of the step", &study.at_end_of_step}})
      rows.add({fixed(study.spectral_radius, 1), name, order_text(order->event_time_order),
                order_text(order->event_position_order), order_text(order->tip_order),
                scientific(order->event_time_error.back(), 1),
                scientific(order->event_position_error.back(), 1)});
  return rows.text();
}

// Both histories side by side: ten events each.
std::string benchmark_events(StudyResults& results) {
  Rows rows;
  const auto cells = [](const studies::BenchmarkEvent& event) {
    return std::vector<std::string>{event.event.onset ? "slip" : "stick", fixed(event.event.time, 7),
                                    scientific(event.time_uncertainty, 1),
                                    fixed(event.event.position / millimetre, 5),
                                    scientific(event.position_uncertainty, 1)};
  };
  const auto& all = results.damped_benchmarks();
  for (std::size_t i = 0; i < 10; ++i) {
    std::vector<std::string> row{std::to_string(i + 1)};
    for (const auto& benchmark : all)
      for (const auto& cell : cells(benchmark.events[i])) row.push_back(cell);
    rows.add(row);
  }
  return rows.text();
}

std::string difference_text(double value) { return std::isinf(value) ? "--" : scientific(value, 1); }

std::string benchmark_runs(StudyResults& results) {
  Rows rows;
  const auto& all = results.damped_benchmarks();
  for (std::size_t i = 0; i < all.front().runs.size(); ++i) {
    const auto& run = all.front().runs[i];
    std::vector<std::string> row{run.method, std::to_string(run.size),
                                 run.time_step > 0.0 ? scientific(run.time_step, 2) : "--"};
    for (const auto& benchmark : all) {
      const auto& here = benchmark.runs[i];
      row.push_back(difference_text(here.first_ten.time));
      row.push_back(difference_text(here.first_ten.position));
      row.push_back(difference_text(here.all.time));
    }
    rows.add(row);
  }
  return rows.text();
}

// In per cent; less than a thousandth of one is none.
std::string change_text(const std::optional<double>& change) {
  constexpr double smallest = 1e-3;
  if (!change) return "--";
  if (std::isinf(*change)) return "$\\infty$";
  return std::abs(100.0 * *change) < smallest ? "0" : compact_number(100.0 * *change, 2);
}

std::string wrong_model_rows(StudyResults& results) {
  Rows rows;
  for (const auto& effect : results.wrong_models().effects)
    rows.add({fmt::format("\\texttt{{{}}}: {}. {}", escape(effect.wrong_model.name),
                          typeset(effect.wrong_model.mistake), typeset(effect.wrong_model.place)),
              change_text(effect.stick_frequency), change_text(effect.slip_frequency),
              change_text(effect.force_maximum), change_text(effect.stick_force),
              change_text(effect.stick_displacement), change_text(effect.first_slip),
              change_text(effect.tip_displacement)});
  return rows.text();
}

// A row for each run of usual practice: its largest error at each frequency.
std::string usual_practice(StudyResults& results) {
  Rows rows;
  const auto& practice = results.usual_practice();
  for (std::size_t run = 0; run < practice.front().size(); ++run) {
    const auto& first = practice.front()[run];
    const bool steps = first.time_step > 0.0;
    std::vector<std::string> row{first.method, std::to_string(first.elements),
                                 steps ? scientific(first.time_step, 1) : "--",
                                 steps ? plain_number(first.spectral_radius) : "--"};
    for (const auto& runs : practice) row.push_back(fixed(100.0 * runs[run].largest_error, 1));
    rows.add(row);
  }
  return rows.text();
}

// A row for each level of each method: step, modes, and the difference to the finest at each frequency.
std::string converged_levels(StudyResults& results) {
  Rows rows;
  const auto& histories = results.converged_histories();
  for (std::size_t level = 0; level < histories.front().levels.size(); ++level) {
    const auto& first = histories.front().levels[level];
    std::vector<std::string> row{first.method, scientific(first.time_step, 2),
                                 first.modes > 0 ? std::to_string(first.modes) : "all"};
    for (const auto& history : histories) {
      row.push_back(level == 0 ? "--" : significant(100.0 * history.levels[level].difference, 2));
      row.push_back(std::to_string(history.levels[level].changes));
    }
    rows.add(row);
  }
  return rows.text();
}

std::string history_growth(StudyResults& results) {
  Rows rows;
  for (const auto& series : results.history_growth()) {
    for (const auto& run : series.runs)
      rows.add({series.rule.name, plain_number(run.spectral_radius), std::to_string(run.elements),
                scientific(run.time_step, 2), compact_number(run.highest_angle, 2),
                fixed(run.growth_bound, 0), fixed(run.observed_growth, 0),
                compact_number(100.0 * run.error, 2), std::to_string(run.changes)});
    rows.space();
  }
  return rows.text();
}

// Each on 10, 20, 40, 80 and, if it is there, 160 elements.
std::string history_refinements(StudyResults& results) {
  Rows rows;
  const std::size_t columns = results.history_refinements().front().runs.size();
  for (const auto& refinement : results.history_refinements()) {
    std::vector<std::string> cells{plain_number(refinement.frequency_hz),
                                   plain_number(refinement.rule.spectral_radius)};
    for (const auto& run : refinement.runs) cells.push_back(compact_number(100.0 * run.error, 2));
    cells.resize(columns + 2, "--");
    cells.push_back(order_text(refinement.order));
    rows.add(cells);
  }
  return rows.text();
}

std::string energy(StudyResults& results) {
  Rows rows;
  const auto joule = [](double value) {
    return std::abs(value) < 1e-4 ? scientific(value, 1) : fixed(value, 5);
  };
  for (const auto& audit : results.energy_audits()) {
    const std::string damping =
        audit.kelvin_voigt > 0.0 ? scientific(audit.kelvin_voigt, 2) : std::string("0");
    const auto& exact = audit.event_driven;
    rows.add({damping, fmt::format("event-driven, {} modes", audit.modes),
              joule(exact.kinetic + exact.potential - audit.event_driven_initial), joule(exact.base_work),
              joule(exact.follower_work), joule(exact.damping_loss), joule(exact.friction_loss),
              scientific(audit.event_driven_residual(), 1)});
    for (const auto& mesh : audit.meshes) {
      const auto& stepped = mesh.stepped.back();
      rows.add({damping,
                fmt::format("{} elements, $\\Delta t = {}$ s", mesh.elements,
                            scientific(audit.time_step.back(), 2)),
                joule(stepped.energy() - stepped.initial_energy), joule(stepped.base_work),
                joule(stepped.follower_work), joule(stepped.damping_loss), joule(stepped.friction_loss),
                scientific(stepped.residual(), 1)});
    }
  }
  return rows.text();
}

std::string errata() {
  Rows rows;
  for (const auto& erratum : data::errata()) {
    rows.add({fmt::format("\\textbf{{{}}} {}", erratum.id, typeset(erratum.place)), typeset(erratum.printed),
              fmt::format("{}\\par\\emph{{How:}} {}", typeset(erratum.holds), typeset(erratum.established))});
    rows.space();
  }
  return rows.text();
}

std::string evidence(StudyResults& results) {
  Rows rows;
  for (const auto& row : results.errata_evidence())
    rows.add({row.erratum, typeset(row.unit == "1" ? row.quantity : row.quantity + ", " + row.unit),
              compact_number(row.as_printed, 6), compact_number(row.corrected, 6),
              compact_number(row.reference, 6), compact_number(row.tolerance, 2), yes_or_no(confirmed(row))});
  return rows.text();
}

std::string printed(StudyResults& results) {
  const auto& checks = results.printed_checks();
  const std::vector<std::string> reasons = printed_reasons(checks);
  Rows rows;
  for (const auto& check : checks) {
    const std::string unit =
        check.printed.printed_unit.empty() ? check.printed.unit : check.printed.printed_unit;
    rows.add({without_full_stop(typeset(check.printed.meaning)), typeset(check.printed.place),
              fmt::format("{} {}", typeset(check.printed.printed), unit_text(unit)),
              compact_number(check.computed, 6),
              fmt::format("{} ({})", compact_number(check.allowed, 2), letter_of(check.because, reasons)),
              typeset(check.method), yes_or_no(check.agrees())});
  }
  return rows.text();
}

std::string environment_rows(const Environment& environment) {
  Rows rows;
  rows.add(
      {"Program", escape(fmt::format("stickslip {}, commit {}", environment.version, environment.commit))});
  rows.add({"Compiler", escape(environment.compiler)});
  rows.add({"Libraries", escape(fmt::format("Eigen {}, GSL {}", environment.eigen, environment.gsl))});
  for (const auto& [item, value] : environment.rest) rows.add({escape(item), escape(value)});
  return rows.text();
}

}  // namespace

Document make_tables(StudyResults& results, const Environment& environment,
                     const std::vector<TestResult>& tests, const std::vector<studies::BadInput>& inputs) {
  return {{"table-summary.tex", summary(results)},
          {"table-parameters.tex", parameters(results)},
          {"table-unstated.tex", unstated()},
          {"table-frequencies.tex", frequencies(results)},
          {"table-flutter.tex", flutter(results)},
          {"table-orders.tex", orders(results)},
          {"table-manufactured-space.tex", manufactured_space(results)},
          {"table-manufactured-time.tex", manufactured_time(results)},
          {"table-refinement.tex", refinement(results)},
          {"table-force.tex", force(results)},
          {"table-guard.tex", guard(results)},
          {"table-guard-points.tex", guard_points(results)},
          {"table-verified.tex", verified_results(results)},
          {"table-sensitivity.tex", sensitivity(results)},
          {"table-inputs.tex", input_sensitivity(results)},
          {"table-digits.tex", determined_digits(results)},
          {"table-design-lengths.tex", design_rows(results.design_example().lengths, 3)},
          {"table-design-forces.tex", design_rows(results.design_example().forces, 1)},
          {"table-verdicts.tex", verdicts(results)},
          {"table-schemes.tex", schemes(results)},
          {"table-event-orders.tex", event_orders(results)},
          {"table-energy.tex", energy(results)},
          {"table-mutants.tex", mutant_rows()},
          {"table-equivalent-mutants.tex", equivalent_mutant_rows()},
          {"table-benchmark-events.tex", benchmark_events(results)},
          {"table-benchmark-runs.tex", benchmark_runs(results)},
          {"table-usual-practice.tex", usual_practice(results)},
          {"table-converged-levels.tex", converged_levels(results)},
          {"table-history-growth.tex", history_growth(results)},
          {"table-history-refinements.tex", history_refinements(results)},
          {"table-wrong-models.tex", wrong_model_rows(results)},
          {"table-errata.tex", errata()},
          {"table-evidence.tex", evidence(results)},
          {"table-printed.tex", printed(results)},
          {"table-claims.tex", claim_rows(data::claims(), tests)},
          {"table-paper-index.tex", paper_index_rows(tests, data::claims())},
          {"table-requirements.tex", requirement_rows(tests)},
          {"table-named-comparisons.tex", named_comparison_rows(tests)},
          {"table-comparisons.tex", comparison_rows(tests)},
          {"table-round-off.tex", tolerance_rows(tests, "round-off")},
          {"table-discretisation.tex", tolerance_rows(tests, "discretisation")},
          {"table-reference.tex", tolerance_rows(tests, "reference")},
          {"table-tight.tex", tight_rows(tests)},
          {"table-generous.tex", generous_rows(tests)},
          {"logical-tests.tex", logical_tests(tests)},
          {"table-bad-input.tex", bad_input_rows(tests)},
          {"table-accepted-input.tex", accepted_input_rows(tests)},
          {"table-environment.tex", environment_rows(environment)}};
}

}  // namespace stickslip::report
