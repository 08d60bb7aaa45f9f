#include "figures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>

#include "stickslip/data/paper.hpp"

namespace stickslip::report {

namespace {

std::string variable(double value) { return csv_number(value); }

std::string word_of(bool slips) { return slips ? "stick-slip" : "stick"; }

std::string state_of(const studies::ModeShapeStudy::Curve& curve) { return curve.slip ? "slip" : "stick"; }

// Four tip histories of one amplitude; panel i has the variables hz<i>, trusted<i>, slips<i>.
FigureData tip_histories(StudyResults& results, const std::string& figure) {
  const auto& all = results.contact_histories();
  const auto verdicts = data::printed_verdicts();
  std::vector<const studies::ContactHistory*> panels;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (verdicts[i].figure.starts_with(figure)) panels.push_back(&all[i]);

  std::vector<CsvColumn> columns{{"time_s", "s"}};
  FigureData data;
  data.variables.emplace_back("panels", std::to_string(panels.size()));
  data.variables.emplace_back("shown", variable(StudyResults::shown_duration));
  for (const auto* panel : panels) {
    const std::string i = std::to_string(columns.size());
    columns.push_back({fmt::format("tip_displacement_{}hz_m", panel->frequency_hz), "m"});
    data.variables.emplace_back("hz" + i, variable(panel->frequency_hz));
    data.variables.emplace_back("trusted" + i, variable(panel->trusted_until));
    data.variables.emplace_back("slips" + i, panel->finite_element_slip ? "1" : "0");
  }
  CsvTable table(fmt::format("Fig. {}: tip displacement y(L, t) at A0 = {} m, {} finite elements", figure,
                             panels.front()->amplitude, results.paper().numerics.elements()),
                 columns);
  for (std::size_t n = 0; n < panels.front()->time.size(); ++n) {
    std::vector<double> row{panels.front()->time[n]};
    for (const auto* panel : panels) row.push_back(panel->tip_displacement[n]);
    table.add_numbers(row);
  }
  data.tables.push_back({"fig" + figure, std::move(table)});
  return data;
}

FigureData figure4(StudyResults& results) { return tip_histories(results, "4"); }
FigureData figure5(StudyResults& results) { return tip_histories(results, "5"); }

// Panel i, by rows, has the variables title<i> and hz<i>; its columns are 2 i and 2 i + 1.
FigureData figure7(StudyResults& results) {
  const auto& study = results.mode_shapes();
  std::vector<CsvColumn> columns{{"x_over_L", "1"}};
  FigureData data;
  data.variables.emplace_back("points_per_element", std::to_string(StudyResults::points_per_element));
  for (std::size_t i = 0; i < study.curves.size(); ++i) {
    const auto& curve = study.curves[i];
    const std::string name = fmt::format("{}_{}", state_of(curve), curve.mode);
    columns.push_back({name + "_closed_form", "1"});
    columns.push_back({name + "_finite_element", "1"});
    data.variables.emplace_back(fmt::format("title{}", i + 1),
                                fmt::format("'{} state, mode {}: {:.3f} Hz'", curve.slip ? "Slip" : "Stick",
                                            curve.mode, curve.closed_form_hz));
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
    data.variables.emplace_back(fmt::format("natural{}", mode.mode), variable(mode.closed_form_hz));
}

FigureData figure11(StudyResults& results) {
  FigureData data;
  data.tables.push_back({"fig11", criterion_table(results)});
  add_natural_frequencies(results, data);
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
                    word_of(point.closed_form_slips), word_of(point.finite_element_slips),
                    point.in_guard_band ? "1" : "0"});
  FigureData data;
  data.tables.push_back({"fig12", std::move(points)});
  data.tables.push_back({"fig12-curve", criterion_table(results)});
  add_natural_frequencies(results, data);
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

}  // namespace

const std::vector<Figure>& all_figures() {
  static const std::vector<Figure> figures{
      {"fig7", figure7},   {"convergence", convergence}, {"fig9", figure9}, {"refinement", refinement},
      {"fig11", figure11}, {"fig12", figure12},          {"fig4", figure4}, {"fig5", figure5}};
  return figures;
}

}  // namespace stickslip::report
