// SPDX-License-Identifier: MIT
#include "case_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "stickslip/analytic/stick_reaction.hpp"
#include "stickslip/data/csv_text.hpp"

namespace stickslip::cli {

void add_set_option(CLI::App& command, std::vector<std::string>& overrides, const std::string& help) {
  command.add_option("--set", overrides, help)->type_name("TABLE.KEY=VALUE")->allow_extra_args(false);
}

void add_case_options(CLI::App& command, CaseOptions& options) {
  options.rigid_for = command.get_name();
  command.add_option("CASE", options.name, "A name that 'stickslip cases' lists, or the path of a TOML file")
      ->capture_default_str();
  add_set_option(command, options.overrides, "Replace a key of the case, as in beam.length=1.8; repeatable");
  add_json_option(command);
  command
      .add_option_function<int>(
          "--digits", [](const int& digits) { set_most_digits(digits); },
          "Significant digits in the text at most (default: 6; --json has all of them)")
      ->transform(integer_between(1, 17));
}

CLI::Option* add_key_option(CLI::App& command, CaseOptions& options, const std::string& name,
                            const std::string& key, const std::string& help) {
  const auto take = [&options, key, name](const std::string& text) {
    options.keys.push_back({key, text, name});
  };
  return command.add_option_function<std::string>(name, take, help)->type_name("NUMBER[UNIT]");
}

void add_excitation_options(CLI::App& command, CaseOptions& options) {
  add_key_option(command, options, "--hz", "excitation.frequency_hz",
                 "Excitation frequency, Hz (else that of the case)");
  add_key_option(command, options, "--amplitude", "excitation.amplitude",
                 "Amplitude of the base, m or with a unit of displacement, velocity or acceleration, as "
                 "0.2mm or 0.5g (else "
                 "that of the case)");
}

void add_duration_option(CLI::App& command, CaseOptions& options, const std::string& otherwise) {
  add_key_option(command, options, "--duration", "excitation.duration", "Duration, s (" + otherwise + ")");
}

std::vector<data::Override> overrides_of(const CaseOptions& options) {
  std::vector<data::Override> overrides;
  for (const auto& text : options.overrides) overrides.push_back(data::Override::parse(text));
  overrides.insert(overrides.end(), options.keys.begin(), options.keys.end());
  return overrides;
}

std::vector<std::vector<data::Override>> read_rows(const std::string& file, std::string_view what) {
  const std::string text = data::read_table_text(file);
  data::CsvReader csv(file, text);
  std::vector<std::vector<data::Override>> rows;
  while (const auto cells = csv.next_row()) {
    auto& row = rows.emplace_back();
    for (std::size_t i = 0; i < cells->size(); ++i)
      row.push_back({csv.names()[i], (*cells)[i], csv.place(csv.line(), i)});
  }
  if (rows.empty())
    throw data::InputError(fmt::format("{}: {} has no rows, but must have at least one", file, what));
  return rows;
}

data::Case load_case(const CaseOptions& options, const std::vector<data::Override>& more) {
  auto overrides = overrides_of(options);
  overrides.insert(overrides.end(), more.begin(), more.end());
  data::Case problem = data::load_case(options.name, overrides);
  if (!options.rigid_for.empty())
    data::require_rigid(problem.contact.compliance,
                        fmt::format("the command {}; respond takes it", options.rigid_for));
  return problem;
}

std::string mesh_key_of(const CaseOptions& options) {
  for (const data::Override& given : overrides_of(options))
    for (const char* const key : {"numerics.elements", "numerics.spectral_radius"})
      if (data::state_the_same(given.key, key)) return key;
  return "";
}

void add_method(Answer& answer, const studies::MethodChoice& choice) {
  if (!choice.reason.empty()) answer.add_line(fmt::format("{}: {}", choice.method->name, choice.reason));
  answer.add_members({{"method", choice.method->name},
                      {"method_reason", choice.reason.empty() ? Json() : Json(choice.reason)}});
}

data::NumericalSettings numerics_up_to(double frequency_hz, const data::Case& problem) {
  return restated(problem, {{"excitation.frequency_hz", frequency_hz}}).numerics;
}

void require_no_fixed_value(const CaseOptions& options, std::string_view varied, std::string_view option) {
  for (const data::Override& fixed : options.keys)
    if (data::state_the_same(fixed.key, varied))
      throw data::InputError(fmt::format("{} is given, but {} varies {}", fixed.place, option, varied));
}

data::Override override_with(const std::string& key, double value, const std::string& option) {
  return {key, data::shortest_text(value), option};
}

std::vector<std::string> sentences_of(const std::vector<studies::Warning>& warnings) {
  std::vector<std::string> sentences;
  for (const auto& warning : warnings) sentences.push_back(warning.sentence);
  return sentences;
}

Json change_json(const std::optional<studies::Change>& change) {
  if (!change) return nullptr;
  return {{"key", change->key}, {"factor", change->factor}, {"margin", change->margin}};
}

namespace {

// Millimetres below a metre.
std::string length_text(double metres) {
  return metres < 1.0 ? fmt::format("{:.4g} mm", 1e3 * metres) : fmt::format("{:.4g} m", metres);
}

std::string section_text(const data::Case& problem) {
  const data::Section& section = problem.section;
  if (!section.is_given())
    return fmt::format(", A = {:.5g} mm^2, I = {:.5g} mm^4", 1e6 * problem.beam().area(),
                       1e12 * problem.beam().second_moment_of_area());
  if (std::isnan(section.diameter))
    return fmt::format(" x {} x {}", length_text(section.width), length_text(section.height));
  return fmt::format(
      ", diameter {}{}", length_text(section.diameter),
      std::isnan(section.wall_thickness) ? "" : ", wall " + length_text(section.wall_thickness));
}

// The material with these numbers or, without one, the numbers.
std::string material_text(const data::Beam& beam) {
  for (const data::Material& material : data::list_materials())
    if (material.density == beam.density() && material.youngs_modulus == beam.youngs_modulus())
      return material.name;
  return fmt::format("E = {:.4g} GPa, rho = {:.4g} kg/m^3", 1e-9 * beam.youngs_modulus(), beam.density());
}

}  // namespace

namespace {

std::string beam_text(const data::Case& problem) {
  const data::Beam& beam = problem.beam();
  const double share = 100.0 * problem.normal_force() / analytic::buckling_load(problem);
  return fmt::format("{}{}, {}, P = {:.6g} N ({})", length_text(beam.length()), section_text(problem),
                     material_text(beam), beam.axial_force(),
                     share < 0.0 ? "tension" : fmt::format("{:.3g} % of buckling", share));
}

std::string model_text(const data::Model& model) {
  if (const auto& one = model.properties(); model.is_mass())
    return fmt::format("one mass {:.4g} kg, spring {:.4g} N/m, damper {:.4g} N s/m, N = {:.6g} N", one.mass,
                       one.stiffness, one.damping, one.normal_force);
  const data::StructureMatrices& matrices = model.matrices();
  std::vector<int> rows;
  for (const data::WeightedRow& of : matrices.contact) rows.push_back(of.row + 1);
  return fmt::format(
      "matrices of {} rows, {} of the base, contact {}, N = {:.6g} N, which is not in the matrices unless "
      "they "
      "hold it",
      matrices.rows, matrices.base.size(),
      rows.size() > 3 ? fmt::format("on {} rows", rows.size())
                      : fmt::format("row{} {}", rows.size() > 1 ? "s" : "", fmt::join(rows, ", ")),
      model.normal_force());
}

}  // namespace

std::string case_line(const data::Case& problem) {
  return fmt::format("{}: {}, mu {:.4g}/{:.4g}\n", problem.name,
                     problem.model() == nullptr ? beam_text(problem) : model_text(*problem.model()),
                     problem.contact.friction.static_coefficient(),
                     problem.contact.friction.kinetic_coefficient());
}

ShownAmplitude shown_amplitude(const data::Case& problem) {
  if (problem.has(data::Feature::general_motion)) {
    const std::string_view name = analytic::is_proportional_to_scale(problem) ? "scale" : "factor";
    return {"1", 1.0, name, name};
  }
  const data::Key& key = data::stated_amplitude(problem.excitation());
  if (problem.excitation().motion().amplitude_of == data::AmplitudeOf::displacement)
    return {key.magnitudes.unit, 1.0, key.axis.column};
  return {key.axis.unit(), key.axis.scale, key.axis.column};
}

namespace {

// "a sum of 3 sines up to 35 Hz".
std::string text_of(const data::GeneralMotion& motion) {
  const auto text = data::shortest_text;
  const auto sentence = [&](const auto& of) -> std::string {
    using Type = std::remove_cvref_t<decltype(of)>;
    if constexpr (std::is_same_v<Type, std::vector<data::Sine>>)
      return fmt::format("a sum of {} sines up to {} Hz", of.size(), text(motion.highest_frequency_hz()));
    else if constexpr (std::is_same_v<Type, data::Sweep>)
      return fmt::format("a sweep from {} to {} Hz", text(of.from_hz), text(of.to_hz));
    else if constexpr (std::is_same_v<Type, data::Shock>)
      return fmt::format("a shock of {} s", text(of.duration));
    else if constexpr (std::is_same_v<Type, data::PowerSpectrum>)
      return fmt::format("a random motion from {} to {} Hz, seed {}", text(of.points.front().frequency_hz),
                         text(of.points.back().frequency_hz), of.seed);
    else
      return fmt::format("the record {} of {} rows, up to {:.4g} Hz", of.file, of.samples.size(),
                         motion.highest_frequency_hz());
  };
  return (motion.is_force() ? "force on the load: " : "") + std::visit(sentence, motion.statement()) +
         (motion.scale() == 1.0 ? "" : fmt::format(" times {}", text(motion.scale())));
}

}  // namespace

void add_excitation(Answer& answer, const data::Case& problem,
                    const std::optional<analytic::FrequencyBand>& band) {
  if (problem.general_motion() != nullptr)  // the problem has it
    return answer.add_members({{"frequency_hz", nullptr},
                               {"amplitude_m", nullptr},
                               {"stated_as", nullptr},
                               {"stated_amplitude", nullptr}});
  const auto& excitation = problem.excitation();
  const bool has_none = excitation.is_force() || (band && excitation.unit_amplitude() != 1.0);
  answer.add_members(band ? Json{{"band_hz", {band->from_hz, band->to_hz}}}
                          : Json{{"frequency_hz", excitation.frequency_hz()}});
  answer.add_members({{"amplitude_m", has_none ? Json() : Json(excitation.amplitude())},
                      {"stated_as", data::stated_amplitude(excitation).name()},
                      {"stated_amplitude", excitation.stated()}});
}

namespace {

// "25 Hz, 1 mm (0.001 m)".
std::string sine_text(const data::Case& problem, const std::optional<analytic::FrequencyBand>& band) {
  const auto text = data::shortest_text;
  const auto [unit, scale, column, name] = shown_amplitude(problem);
  std::string amplitude = fmt::format("{} {}", exact(scale * problem.excitation().stated()).text, unit);
  if (unit != "m" && !band && !problem.excitation().is_force())
    amplitude += fmt::format(" ({} m)", exact(problem.excitation().amplitude()).text);
  return fmt::format(
      "{} Hz, {}",
      band ? text(band->from_hz) + " to " + text(band->to_hz) : text(problem.excitation().frequency_hz()),
      amplitude);
}

}  // namespace

std::string conditions_of(const data::Case& problem, const std::optional<analytic::FrequencyBand>& band) {
  const auto* base = problem.general_motion();
  const auto& wall = problem.contact.wall_motion;
  return fmt::format("{}{}, 0 to {} s", base != nullptr ? text_of(*base) : sine_text(problem, band),
                     wall ? ", wall: " + text_of(*wall) : "",
                     data::shortest_text(problem.numerics.duration()));
}

void add_bending(Answer& answer, const data::Beam& beam, const studies::Bending& bending,
                 const std::optional<double>& steady) {
  const double spring = studies::spring_that_keeps(beam, bending.draw_back);
  answer.add_row({"deflection of the beam / m", "deflection_m", rounded(bending.deflection, 3)});
  answer.add_row({"draw-back of the tip / m",
                  "draw_back_m",
                  {bending.draw_back, rounded(bending.draw_back, 3).text +
                                          (steady ? ", steady " + rounded(*steady, 3).text : "")}});
  if (steady) answer.add_members({{"steady_draw_back_m", *steady}});
  answer.add_row({"spring that keeps P / (N/m)",
                  "keeping_spring_N_per_m",
                  {finite_json(spring), std::isfinite(spring) ? "below " + rounded(spring, 3).text : "any"}});
}

namespace {

Json structure_json(const data::Model& model) {
  if (model.is_mass()) return Json::object({{"kind", "mass"}});
  const data::StructureMatrices& matrices = model.matrices();
  const auto rows = [](const std::vector<int>& of) {
    Json json = Json::array();
    for (const int row : of) json.push_back(row + 1);
    return json;
  };
  const auto weighted = [](const std::vector<data::WeightedRow>& of) {
    Json json = Json::array();
    for (const auto& [row, weight] : of) json.push_back({{"row", row + 1}, {"weight", weight}});
    return json;
  };
  Json files = Json::array();
  for (const auto& [key, name, digest] : matrices.files)
    files.push_back({{"key", key}, {"name", name}, {"sha256", digest}});
  return {{"kind", "matrices"},
          {"rows", matrices.rows},
          {"base", rows(matrices.base)},
          {"fixed", rows(matrices.fixed)},
          {"contact", weighted(matrices.contact)},
          {"load", weighted(matrices.load)},
          {"files", files}};
}

std::string_view name_of(data::AmplitudeOf kind) {
  return data::key_named(data::amplitude_keys.at(static_cast<std::size_t>(kind))).name();
}

Json json_of(const std::vector<data::Sine>& sines) {
  Json list = Json::array();
  for (const data::Sine& one : sines)
    list.push_back({{"frequency_hz", one.frequency_hz},
                    {"stated_amplitude", one.amplitude},
                    {"stated_as", name_of(one.amplitude_of)},
                    {"phase_rad", one.phase}});
  return {{"kind", "sines"}, {"sines", list}};
}

Json json_of(const data::Sweep& sweep) {
  return {{"kind", "sweep"},
          {"from_hz", sweep.from_hz},
          {"to_hz", sweep.to_hz},
          {sweep.is_logarithmic ? "octaves_per_s" : "hz_per_s", sweep.rate},
          {"stated_amplitude", sweep.amplitude},
          {"stated_as", name_of(sweep.amplitude_of)}};
}

Json json_of(const data::Shock& shock) {
  constexpr std::array names{"half-sine", "sawtooth", "trapezoid", "rectangle"};
  return {{"kind", "shock"},
          {"shape", names.at(static_cast<std::size_t>(shock.shape))},
          {"shock_duration", shock.duration},
          {"stated_amplitude", shock.amplitude},
          {"stated_as", name_of(shock.amplitude_of)}};
}

Json json_of(const data::MotionRecord& record) {
  constexpr std::array names{"displacement", "velocity", "acceleration", "force"};
  Json json{{"kind", "record"},        {"file", record.file},
            {"sha256", record.sha256}, {"rows", record.samples.size()},
            {"column", record.column}, {"quantity", names.at(static_cast<std::size_t>(record.quantity))},
            {"unit", record.unit}};
  for (const auto& [name, value] : {std::pair{"high_pass_hz", record.high_pass_hz},
                                    {"initial_displacement", record.initial_displacement},
                                    {"initial_velocity", record.initial_velocity}})
    if (value) json[name] = *value;
  return json;
}

Json json_of(const data::PowerSpectrum& spectrum) {
  Json points = Json::array();
  for (const auto& [hz, density] : spectrum.points) points.push_back({hz, density});
  Json json{{"kind", "spectrum"},
            {"density_of", name_of(spectrum.quantity)},
            {"density_si", points},
            {"unit", spectrum.unit},
            {"seed", spectrum.seed}};
  if (!spectrum.file.empty()) json.update({{"file", spectrum.file}, {"sha256", spectrum.sha256}});
  return json;
}

void add_motion(Json& table, const data::GeneralMotion& motion) {
  table.update(std::visit([](const auto& stated) { return json_of(stated); }, motion.statement()));
}

}  // namespace

Json problem_json(const data::Case& problem) {
  Json tables;
  const auto numbers = data::numbers_of(problem);
  for (const data::Key& key : data::case_keys())
    if (const auto found = numbers.find(std::string(key.path)); found != numbers.end())
      tables[std::string(key.table())][std::string(key.name())] = key.member.is_flag ? Json(true)
                                                                  : key.member.is_integer
                                                                      ? Json(static_cast<int>(found->second))
                                                                      : finite_json(found->second);
  if (const auto* motion = problem.general_motion()) {
    add_motion(tables["excitation"], *motion);
  } else {
    tables["excitation"]["amplitude"] = problem.excitation().amplitude();
    tables["excitation"]["stated_as"] = data::stated_amplitude(problem.excitation()).name();
  }
  if (const auto& motion = problem.contact.wall_motion) add_motion(tables["wall"], *motion);
  if (const auto& ratios = problem.damping.properties().ratios; !ratios.empty())
    tables["damping"]["ratios"] = ratios;
  if (const data::Model* model = problem.model()) tables["structure"] = structure_json(*model);
  return tables;
}

}  // namespace stickslip::cli
