// SPDX-License-Identifier: MIT
#include "render/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "render/criterion_map.hpp"
#include "render/findings.hpp"
#include "stickslip/data/paper.hpp"
#include "stickslip/solver/contact_system.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/stick_slip/contact_growth.hpp"

namespace stickslip::report {

namespace {

// Four tip histories of one amplitude; panel i has the values hz<i> and slips<i>, and the columns 2 i and 2 i
// + 1.
FigureData tip_histories(StudyResults& results, const std::string& figure) {
  const auto& all = results.contact_histories();
  const auto verdicts = data::printed_verdicts();
  std::vector<const studies::ContactHistory*> panels;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (verdicts[i].figure.starts_with(figure)) panels.push_back(&all[i]);

  std::vector<CsvColumn> columns{{"time_s", "s"}};
  FigureData data;
  data.values.push_back({"shown", StudyResults::shown_duration, "s"});
  const std::vector<double>* time = nullptr;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    columns.push_back({fmt::format("tip_displacement_{}hz_m", panels[i]->frequency_hz), "m"});
    columns.push_back({fmt::format("half_width_{}hz_m", panels[i]->frequency_hz), "m"});
    data.values.push_back({fmt::format("hz{}", i + 1), panels[i]->frequency_hz, "Hz"});
    data.values.push_back({fmt::format("slips{}", i + 1), panels[i]->converged ? 1.0 : 0.0, "1"});
    if (panels[i]->converged) time = &panels[i]->converged->time;
  }
  CsvTable table(fmt::format("Fig. {}: tip displacement y(L, t) at A0 = {} m, converged, with half-width",
                             figure, panels.front()->amplitude),
                 columns);
  for (std::size_t n = 0; time != nullptr && n < time->size(); ++n) {
    std::vector<double> row{(*time)[n]};
    for (const auto* panel : panels) {
      row.push_back(panel->converged ? panel->converged->tip[n] : 0.0);
      row.push_back(panel->converged ? panel->converged->tip_half_width[n] : 0.0);
    }
    table.add_numbers(row);
  }
  data.tables.push_back({"fig" + figure, std::move(table)});
  return data;
}

// Undamped histories as they are usually computed, next to the converged one. Row j of panels has the value
// hz<j>.
FigureData practice(StudyResults& results) {
  CsvTable table("Undamped tip displacement y(L, t): converged (run 0) and as usually computed",
                 {{"frequency_Hz", "Hz"},
                  {"run", "1"},
                  {"method", "-"},
                  {"elements", "1"},
                  {"time_step_s", "s"},
                  {"spectral_radius", "1"},
                  {"largest_error_percent", "%"},
                  {"time_s", "s"},
                  {"tip_displacement_m", "m"}});
  FigureData data;
  data.values.push_back({"shown", StudyResults::shown_duration, "s"});
  for (std::size_t j = 0; j < results.converged_histories().size(); ++j) {
    const auto& converged = results.converged_histories()[j];
    const auto add = [&](std::size_t run, const studies::PracticeRun& history) {
      for (std::size_t n = 0; n < converged.time.size(); ++n)
        table.add_row({csv_number(converged.frequency_hz), std::to_string(run), history.method,
                       std::to_string(history.elements), csv_number(history.time_step),
                       csv_number(history.spectral_radius), csv_number(100.0 * history.largest_error),
                       csv_number(converged.time[n]), csv_number(history.tip_displacement[n])});
    };
    data.values.push_back({fmt::format("hz{}", j + 1), converged.frequency_hz, "Hz"});
    add(0, {.method = "converged", .tip_displacement = converged.tip});
    for (std::size_t run = 0; run < results.usual_practice()[j].size(); ++run)
      add(run + 1, results.usual_practice()[j][run]);
  }
  data.tables.push_back({"practice", std::move(table)});
  return data;
}

// The force jumps at v = 0, which stands there twice.
FigureData figure2(StudyResults& results) {
  const data::FrictionLaw& law = results.paper().friction;
  const double normal_force = results.paper().beam.axial_force();
  CsvTable table("Fig. 2: friction coefficient mu(v) of Eq. (7) and friction force f_d = -sgn(v) mu(v) P",
                 {{"sliding_velocity_m_per_s", "m/s"}, {"coefficient", "1"}, {"friction_force_N", "N"}});
  const auto add = [&](double velocity, double sign) {
    const double coefficient = solver::friction_coefficient(law, velocity);
    table.add_numbers({velocity, coefficient, -sign * coefficient * normal_force});
  };
  constexpr int per_unit = 20, units = 5;  // rows per m/s, m/s
  for (int i = -units * per_unit; i <= 0; ++i) add(static_cast<double>(i) / per_unit, -1.0);
  for (int i = 0; i <= units * per_unit; ++i) add(static_cast<double>(i) / per_unit, 1.0);
  FigureData data;
  data.values = {{"static_coefficient", law.static_coefficient(), "1"},
                 {"kinetic_coefficient", law.kinetic_coefficient(), "1"},
                 {"axial_force", normal_force, "N"}};
  data.tables.push_back({"fig2", std::move(table)});
  return data;
}

// Drawings that hold no numbers.
FigureData schematic(StudyResults& /*results*/) { return {}; }

// Long form: panel and snapshot count from 1 in columns 1 and 3.
FigureData figure3(StudyResults& results) {
  CsvTable table(
      "Fig. 3: motion y(x, t) of the beam over one period, by finite elements and without a mesh (closed "
      "form where the tip sticks throughout, else converged on free modes)",
      {{"panel", "1"},
       {"frequency_Hz", "Hz"},
       {"snapshot", "1"},
       {"time_s", "s"},
       {"periods_since_first_snapshot", "1"},
       {"tip_sticks", "1"},
       {"position_m", "m"},
       {"finite_element_displacement_m", "m"},
       {"continuous_beam_displacement_m", "m"}});
  int panel = 0;
  for (const auto& study : results.beam_motions()) {
    ++panel;
    const auto& snapshots = study.finite_element.snapshots;
    for (std::size_t i = 0; i < snapshots.size(); ++i)
      for (std::size_t k = 0; k < study.finite_element.position.size(); ++k)
        table.add_numbers({static_cast<double>(panel), study.frequency_hz, static_cast<double>(i + 1),
                           snapshots[i].time, (snapshots[i].time - snapshots[0].time) * study.frequency_hz,
                           snapshots[i].sticks ? 1.0 : 0.0, study.finite_element.position[k],
                           snapshots[i].displacement[k], study.reference.snapshots[i].displacement[k]});
  }
  FigureData data;
  data.tables.push_back({"fig3", std::move(table)});
  return data;
}

FigureData figure4(StudyResults& results) { return tip_histories(results, "4"); }
FigureData figure5(StudyResults& results) { return tip_histories(results, "5"); }

// Panel i, by rows, has the columns 2 i and 2 i + 1 and the value hz<i>; stick stands left, slip right.
FigureData figure7(StudyResults& results) {
  const auto& study = results.mode_shapes();
  std::vector<CsvColumn> columns{{"x_over_L", "1"}};
  FigureData data;
  data.values.push_back({"points_per_element", static_cast<double>(StudyResults::points_per_element), "1"});
  for (std::size_t i = 0; i < study.curves.size(); ++i) {
    const auto& curve = study.curves[i];
    const std::string name = fmt::format("{}_{}", state_of(curve), curve.mode);
    columns.push_back({name + "_closed_form", "1"});
    columns.push_back({name + "_finite_element", "1"});
    data.values.push_back({fmt::format("hz{}", i + 1), curve.closed_form_hz, "Hz"});
  }
  CsvTable table("Fig. 7: mode shapes scaled to a largest deflection of 1", columns);
  for (std::size_t n = 0; n < study.position.size(); ++n) {
    std::vector<double> row{study.position[n]};
    for (const auto& curve : study.curves)
      row.insert(row.end(), {curve.closed_form[n], curve.finite_element[n]});
    table.add_numbers(row);
  }
  data.tables.push_back({"fig7", std::move(table)});
  return data;
}

FigureData figure9(StudyResults& results) {
  const auto& study = results.stick_history();
  CsvTable table("Fig. 9: midspan displacement y(L/2, t) and static friction force f(t) of the stick state",
                 {{"time_s", "s"},
                  {"displacement_closed_form_m", "m"},
                  {"displacement_finite_element_m", "m"},
                  {"force_closed_form_N", "N"},
                  {"force_finite_element_N", "N"}});
  for (std::size_t n = 0; n < study.time.size(); ++n)
    table.add_numbers({study.time[n], study.displacement[n], study.first_displacement[n], study.force[n],
                       study.first_force[n]});
  FigureData data;
  data.tables.push_back({"fig9", std::move(table)});
  return data;
}

CsvTable criterion_table(StudyResults& results) {
  CsvTable table("Critical amplitude of stick-slip, closed form",
                 {{"frequency_Hz", "Hz"}, {"critical_amplitude_m", "m"}});
  for (const auto& point : results.criterion())
    table.add_numbers({point.frequency_hz, point.critical_amplitude});
  return table;
}

void add_natural_frequencies(StudyResults& results, FigureData& data) {
  for (const auto& mode : results.stick_frequencies().modes)
    data.values.push_back({fmt::format("natural{}", mode.mode), mode.closed_form_hz, "Hz"});
}

FigureData figure11(StudyResults& results) {
  FigureData data;
  data.tables.push_back({"fig11", criterion_table(results)});
  add_natural_frequencies(results, data);
  return data;
}

// A search that found nothing up to the cap has the cap and the mark 1.
FigureData figure6(StudyResults& results) {
  CsvTable table("Fig. 6: critical amplitude by finite elements, by search and by one linear run",
                 {{"frequency_Hz", "Hz"},
                  {"searched_amplitude_m", "m"},
                  {"above_the_cap", "1"},
                  {"linear_amplitude_m", "m"},
                  {"runs", "1"}});
  for (const auto& search : results.searches())
    table.add_numbers({search.frequency_hz, search.searched.value_or(StudyResults::search_cap),
                       search.searched ? 0.0 : 1.0, search.linear, static_cast<double>(search.runs)});
  FigureData data;
  data.tables.push_back({"fig6", std::move(table)});
  return data;
}

FigureData figure12(StudyResults& results) {
  CsvTable points("Fig. 12: verdict of either implementation at each excitation", {{"frequency_Hz", "Hz"},
                                                                                   {"amplitude_m", "m"},
                                                                                   {"closed_form", "-"},
                                                                                   {"finite_element", "-"},
                                                                                   {"in_guard_band", "1"}});
  for (const auto& point : results.classification().points)
    points.add_row({csv_number(point.frequency_hz), csv_number(point.amplitude),
                    verdict_of(point.closed_form_slips), verdict_of(point.finite_element_slips),
                    point.in_guard_band ? "1" : "0"});
  FigureData data;
  data.tables.push_back({"fig12", std::move(points)});
  data.tables.push_back({"fig12-curve", criterion_table(results)});
  add_natural_frequencies(results, data);
  return data;
}

// The excitations A to D whose |f_max| the paper prints, as force_maxima() has them: 15, 25, 35, 70 Hz.
constexpr const char* excitation_letters[] = {"A", "C", "B", "D"};

// |f_max| is proportional to the amplitude and reaches mu_s P at the critical one. Grid lines of one
// frequency, amplitudes ascending: every hertz, and the points within 2 Hz of a natural frequency every 0.25
// Hz.
FigureData figure10(StudyResults& results) {
  const double limit = studies::friction_limit(results.paper());
  const auto near_resonance = [&](double hz) {
    return std::ranges::any_of(results.stick_frequencies().modes,
                               [&](const auto& mode) { return std::abs(hz - mode.closed_form_hz) < 2.0; });
  };
  CsvTable surface("Fig. 10: largest static friction force |f_max| over 0 to 10 s, closed form",
                   {{"frequency_Hz", "Hz"}, {"amplitude_m", "m"}, {"force_max_N", "N"}});
  for (const auto& point : results.criterion()) {
    const double hz = point.frequency_hz;
    const double step = near_resonance(hz) ? 0.25 : 1.0;
    if (std::abs(hz - step * std::round(hz / step)) > 1e-9) continue;
    for (int i = 1; i <= 20; ++i) {
      const double amplitude = 0.05e-3 * i;
      surface.add_numbers({hz, amplitude, limit * amplitude / point.critical_amplitude});
    }
    surface.end_grid_line();
  }
  CsvTable points("Fig. 10: the excitations A to D",
                  {{"letter", "-"}, {"frequency_Hz", "Hz"}, {"amplitude_m", "m"}, {"force_max_N", "N"}});
  const auto& maxima = results.force_maxima();
  for (std::size_t i = 0; i < maxima.size(); ++i)
    points.add_row({excitation_letters[i], csv_number(maxima[i].frequency_hz),
                    csv_number(maxima[i].amplitude), csv_number(maxima[i].truncated.midpoint())});
  FigureData data;
  data.values.push_back({"limit", limit, "N"});
  data.tables.push_back({"fig10", std::move(surface)});
  data.tables.push_back({"fig10-points", std::move(points)});
  return data;
}

FigureData figure13(StudyResults& results) {
  const auto& full = results.criterion();
  const auto& half = results.half_stiffness_criterion();
  CsvTable table("Fig. 13: critical amplitude with the flexural rigidity EI and with EI/2, closed form",
                 {{"frequency_Hz", "Hz"},
                  {"critical_amplitude_m", "m"},
                  {"half_stiffness_frequency_Hz", "Hz"},
                  {"half_stiffness_critical_amplitude_m", "m"}});
  for (std::size_t i = 0; i < full.size(); ++i)
    table.add_numbers(
        {full[i].frequency_hz, full[i].critical_amplitude, half[i].frequency_hz, half[i].critical_amplitude});
  FigureData data;
  data.tables.push_back({"fig13", std::move(table)});
  add_natural_frequencies(results, data);
  for (const auto& mode : results.half_stiffness_frequencies().modes)
    data.values.push_back({fmt::format("half{}", mode.mode), mode.closed_form_hz, "Hz"});
  return data;
}

// Grid lines of one axial force.
FigureData figure14(StudyResults& results) {
  CsvTable ratios("Fig. 14: |f_max|/(mu_s P) over beam length and axial force, closed form",
                  {{"length_m", "m"}, {"axial_force_N", "N"}, {"force_ratio", "1"}});
  CsvTable limits(
      "Fig. 14: lengths of resonance with the excitation and of buckling",
      {{"axial_force_N", "N"}, {"resonance_1_m", "m"}, {"resonance_2_m", "m"}, {"buckling_length_m", "m"}});
  for (const auto& line : results.length_force_map().lines) {
    for (std::size_t i = 0; i < line.length.size(); ++i)
      ratios.add_numbers({line.length[i], line.axial_force, line.force_ratio[i]});
    ratios.end_grid_line();
    limits.add_row({csv_number(line.axial_force), csv_number(line.resonance_1), csv_number(line.resonance_2),
                    csv_number(line.buckling_length)});
  }
  FigureData data;
  data.tables.push_back({"fig14", std::move(ratios)});
  data.tables.push_back({"fig14-limits", std::move(limits)});
  data.values.push_back({"hz", results.flat_section().excitation.frequency_hz(), "Hz"});
  data.values.push_back({"buckling_coefficient", buckling_coefficient(results.flat_section().beam), "1"});
  return data;
}

void add_frequency_rows(const studies::FrequencyStudy& study, const std::string& state, double length,
                        CsvTable& table) {
  for (const auto& mode : study.modes)
    for (std::size_t i = 0; i < study.elements.size(); ++i)
      table.add_row({state, std::to_string(mode.mode), std::to_string(study.elements[i]),
                     csv_number(length / study.elements[i]), csv_number(mode.relative_error[i]),
                     csv_number(mode.predicted_error[i])});
}

FigureData convergence(StudyResults& results) {
  const double length = results.paper().beam.length();
  CsvTable meshes("Relative error of the eigenvalue omega^2 on Hermite elements", {{"state", "-"},
                                                                                   {"mode", "1"},
                                                                                   {"elements", "1"},
                                                                                   {"element_length_m", "m"},
                                                                                   {"relative_error", "1"},
                                                                                   {"predicted_error", "1"}});
  add_frequency_rows(results.stick_frequencies(), "stick", length, meshes);
  add_frequency_rows(results.slip_frequencies(), "slip", length, meshes);

  CsvTable steps("Error of generalised-alpha on a damped chain of two masses",
                 {{"spectral_radius", "1"},
                  {"time_step_s", "s"},
                  {"displacement_error_m", "m"},
                  {"velocity_error_m_per_s", "m/s"},
                  {"reaction_error_N", "N"}});
  for (const auto& study : results.time_orders())
    for (std::size_t i = 0; i < study.time_step.size(); ++i)
      steps.add_numbers({study.spectral_radius, study.time_step[i], study.displacement_error[i],
                         study.velocity_error[i], study.reaction_error[i]});
  FigureData data;
  data.tables.push_back({"convergence", std::move(meshes)});
  data.tables.push_back({"convergence-time", std::move(steps)});
  return data;
}

FigureData refinement(StudyResults& results) {
  CsvTable table("Sup-norm difference of finite elements and closed form in the stick state",
                 {{"elements", "1"},
                  {"time_step_s", "s"},
                  {"displacement_error_m", "m"},
                  {"predicted_displacement_error_m", "m"},
                  {"force_error_N", "N"},
                  {"predicted_force_error_N", "N"}});
  for (const auto& level : results.stick_history().levels)
    table.add_numbers({static_cast<double>(level.elements), level.time_step, level.displacement_error,
                       level.predicted_displacement_error, level.force_error, level.predicted_force_error});
  FigureData data;
  data.tables.push_back({"refinement", std::move(table)});
  return data;
}

// Run 0 is the uncertainty of the reference.
FigureData benchmark(StudyResults& results) {
  const auto& all = results.damped_benchmarks();
  CsvTable histories("Damped benchmark: tip displacement y(L, t) of the reference",
                     {{"time_s", "s"}, {"tip_25hz_m", "m"}, {"tip_70hz_m", "m"}});
  for (std::size_t n = 0; n < all.front().history.time.size(); ++n)
    histories.add_numbers({all.front().history.time[n], all.front().history.tip_displacement[n],
                           all.back().history.tip_displacement[n]});
  CsvTable events("Damped benchmark: events of the reference and differences of other runs to it",
                  {{"frequency_Hz", "Hz"},
                   {"run", "1"},
                   {"method", "-"},
                   {"elements_or_modes", "1"},
                   {"time_step_s", "s"},
                   {"event_time_s", "s"},
                   {"change", "-"},
                   {"position_m", "m"},
                   {"time_difference_s", "s"},
                   {"position_difference_m", "m"}});
  FigureData data;
  for (const auto& benchmark : all) {
    const auto add = [&](std::size_t run, const std::string& method, int size, double step, std::size_t i,
                         double time, double position) {
      const auto& event = benchmark.events[i].event;
      events.add_row({csv_number(benchmark.frequency_hz), std::to_string(run), method, std::to_string(size),
                      csv_number(step), csv_number(event.time), event.onset ? "onset" : "capture",
                      csv_number(event.position), csv_number(time), csv_number(position)});
    };
    for (std::size_t i = 0; i < benchmark.events.size(); ++i)
      add(0, "uncertainty of the reference", benchmark.modes, 0.0, i, benchmark.events[i].time_uncertainty,
          benchmark.events[i].position_uncertainty);
    for (std::size_t k = 0; k < benchmark.runs.size(); ++k) {
      const auto& run = benchmark.runs[k];
      for (std::size_t i = 0; i < run.each.size(); ++i)
        add(k + 1, run.method, run.size, run.time_step, i, run.each[i].time, run.each[i].position);
    }
  }
  data.values.push_back({"shown", all.front().duration, "s"});
  for (std::size_t j = 0; j < all.size(); ++j)
    data.values.push_back({fmt::format("hz{}", j + 1), all[j].frequency_hz, "Hz"});
  data.tables.push_back({"benchmark", std::move(events)});
  data.tables.push_back({"benchmark-histories", std::move(histories)});
  return data;
}

FigureData event_order(StudyResults& results) {
  CsvTable table("Errors through the events of a damped history", {{"spectral_radius", "1"},
                                                                   {"time_step_s", "s"},
                                                                   {"located_event_time_s", "s"},
                                                                   {"end_of_step_event_time_s", "s"},
                                                                   {"located_tip_m", "m"},
                                                                   {"end_of_step_tip_m", "m"}});
  for (const auto& study : results.event_orders())
    for (std::size_t i = 0; i < study.time_step.size(); ++i)
      table.add_numbers({study.spectral_radius, study.time_step[i], study.located.event_time_error[i],
                         study.at_end_of_step.event_time_error[i], study.located.tip_error[i],
                         study.at_end_of_step.tip_error[i]});
  FigureData data;
  data.values.push_back({"radius", results.event_orders().front().spectral_radius, "1"});
  data.tables.push_back({"event-order", std::move(table)});
  return data;
}

// Rule k of the table has the name rule<k>.
FigureData growth(StudyResults& results) {
  CsvTable table("Undamped histories of generalised-alpha on meshes", {{"rule", "1"},
                                                                       {"elements", "1"},
                                                                       {"time_step_s", "s"},
                                                                       {"spectral_radius", "1"},
                                                                       {"growth_bound_per_s", "1/s"},
                                                                       {"observed_growth_per_s", "1/s"},
                                                                       {"error_percent", "%"}});
  FigureData data;
  const auto& series = results.history_growth();
  for (std::size_t k = 0; k < series.size(); ++k) {
    data.values.push_back({fmt::format("rule{}", k + 1), series[k].rule.name, "-"});
    for (const auto& run : series[k].runs)
      table.add(static_cast<double>(k + 1))
          .add(run.elements)
          .add(run.time_step)
          .add(run.spectral_radius)
          .add(run.growth_bound)
          .add(run.observed_growth)
          .add(100.0 * run.error)
          .end_row();
  }
  data.values.push_back(
      {"beam", studies::beam_growth_bound(results.paper().beam, results.paper().friction), "1/s"});
  data.tables.push_back({"growth", std::move(table)});
  return data;
}

FigureData energy(StudyResults& results) {
  CsvTable table("Unexplained energy of the time stepper over the base work, spectral radius 1",
                 {{"kelvin_voigt_s", "s"},
                  {"elements", "1"},
                  {"time_step_s", "s"},
                  {"residual_J", "J"},
                  {"base_work_J", "J"},
                  {"event_driven_residual_J", "J"}});
  for (const auto& audit : results.energy_audits())
    for (const auto& mesh : audit.meshes)
      for (std::size_t i = 0; i < audit.time_step.size(); ++i)
        table.add_numbers({audit.kelvin_voigt, static_cast<double>(mesh.elements), audit.time_step[i],
                           mesh.stepped[i].residual(), mesh.stepped[i].base_work,
                           audit.event_driven_residual()});
  FigureData data;
  data.values.push_back(
      {"damped_elements", static_cast<double>(results.energy_audits().front().meshes.front().elements), "1"});
  const auto& undamped = results.energy_audits().back().meshes;
  for (std::size_t i = 0; i < undamped.size(); ++i)
    data.values.push_back(
        {fmt::format("undamped_elements{}", i + 1), static_cast<double>(undamped[i].elements), "1"});
  data.tables.push_back({"energy", std::move(table)});
  return data;
}

FigureData scatter(StudyResults& results) {
  CsvTable table("Computed values against their references", {{"what", "-"},
                                                              {"reference", "-"},
                                                              {"known_erratum", "1"},
                                                              {"computed", "SI"},
                                                              {"expected", "SI"},
                                                              {"relative_difference", "1"}});
  const auto values = checked_results(results.printed_checks(), results.solution_verification());
  for (const auto& value : values) {
    std::string what = value.what;
    std::ranges::replace(what, ',', ';');
    table.add_row({what, value.reference, value.known_erratum ? "1" : "0", csv_number(value.computed),
                   csv_number(value.expected), csv_number(value.relative_difference())});
  }
  FigureData data;
  for (const auto& [name, reference] : {std::pair{"printed", "printed"}, {"exact", "mesh-free"}}) {
    const Differences differences = differences_from(values, reference);
    data.values.push_back({fmt::format("{}_count", name), static_cast<double>(differences.count), "1"});
    data.values.push_back({fmt::format("{}_bias", name), differences.bias, "1"});
    data.values.push_back({fmt::format("{}_spread", name), differences.spread, "1"});
  }
  data.tables.push_back({"scatter", std::move(table)});
  return data;
}

FigureData map(StudyResults& results) {
  data::Case problem = results.paper();
  problem.excitation = results.stick_excitation();
  return figure_of(problem, results.stiffness_map());
}

}  // namespace

CsvTable values_table(const std::vector<FigureData::Value>& values) {
  CsvTable table("Single values of the figure", {{"name", "-"}, {"value", "see last column"}, {"unit", "-"}});
  for (const auto& [name, value, unit] : values) {
    const auto* text = std::get_if<std::string>(&value);
    table.add_row({name, text != nullptr ? *text : csv_number(std::get<double>(value)), unit});
  }
  return table;
}

const std::vector<Figure>& all_figures() {
  static const std::vector<Figure> figures{{"scatter", scatter},
                                           {"fig1", schematic},
                                           {"fig2", figure2},
                                           {"fig8", schematic},
                                           {"convergence", convergence},
                                           {"fig7", figure7},
                                           {"refinement", refinement},
                                           {"event-order", event_order},
                                           {"energy", energy},
                                           {"fig9", figure9},
                                           {"fig6", figure6},
                                           {"fig12", figure12},
                                           {"fig3", figure3},
                                           {"fig4", figure4},
                                           {"fig5", figure5},
                                           {"benchmark", benchmark},
                                           {"practice", practice},
                                           {"growth", growth},
                                           {"fig10", figure10},
                                           {"fig11", figure11},
                                           {"fig13", figure13},
                                           {"fig14", figure14},
                                           {"map", map}};
  return figures;
}

}  // namespace stickslip::report
