// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

#include "case_options.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "render/criterion_map.hpp"
#include "render/history_drawing.hpp"
#include "stickslip/analytic/held_motion.hpp"
#include "stickslip/analytic/random_reaction.hpp"
#include "stickslip/analytic/stick_reaction.hpp"
#include "studies/analyses/criterion_answer.hpp"
#include "studies/analyses/problem_warnings.hpp"
#include "studies/analyses/random_slip.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::cli {

namespace {

struct CriterionOptions {
  std::size_t samples{};
  CaseOptions problem;
  std::vector<std::string> more;
  std::string plan, output, figure;
};

std::vector<LabelledValue> rows_of(const data::Case& problem, const analytic::Criterion& criterion) {
  std::vector<LabelledValue> rows{
      {"largest |f| / N", "force_max_N", between(criterion.force_max)},
      {"friction limit mu_s P / N", "friction_limit_N", exact(criterion.friction_limit)}};
  if (problem.excitation().is_force())
    rows.push_back({"", "critical_amplitude_m", {nullptr, ""}});
  else
    rows.insert(rows.end(), {{"", "critical_amplitude_m", middle(criterion.critical_amplitude)},
                             {"critical amplitude / m", "critical_amplitude_bounds_m",
                              between(criterion.critical_amplitude)}});
  if (const auto [unit, scale, column, name] = shown_amplitude(problem); unit != "m") {
    const auto stated = 1.0 / problem.excitation().unit_amplitude() * criterion.critical_amplitude;
    rows.push_back({fmt::format("critical amplitude / {}", unit),
                    fmt::format("critical_{}", column),
                    {middle(stated).json, common_digits(scale * stated)}});
  }
  if (problem.excitation().amplitude() > 0.0)
    rows.push_back({"margin mu_s P / |f|", "", between(studies::margin_of(criterion))});
  rows.push_back({"verdict", "verdict", word(to_string(criterion.verdict))});
  return rows;
}

// Both criteria side by side in the text, and one after the other in JSON.
void add_criteria(Answer& answer, const data::Case& problem, const studies::CriterionAnswer& found) {
  const bool has_margin = problem.excitation().amplitude() > 0.0;
  const auto truncated = rows_of(problem, found.truncated), all = rows_of(problem, found.all_modes);
  answer.add_row("", {fmt::format("{} modes", problem.numerics.modes()), "all modes"});
  Answer all_modes;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const LabelledValue& row = truncated[i];
    if (!row.label.empty()) answer.add_row(row.label, {row.value.text, all[i].value.text});
    if (!row.key.empty()) answer.add_members({{row.key, row.value.json}});
    all_modes.add_row(all[i]);
  }
  answer.add_members({{"all_modes", all_modes.json},
                      {"margin", has_margin ? between(studies::margin_of(found.all_modes)).json : Json()}});
}

Value steady_force(const std::optional<studies::SteadyState>& steady) {
  if (!steady) return {nullptr, "none at a natural frequency"};
  const auto& [lower, upper] = steady->force;
  return lower == upper ? rounded(lower, 7) : middle(steady->force);
}

void add_steady_state(Answer& answer, const std::optional<studies::SteadyState>& steady, double duration,
                      bool is_force) {
  const Value force = steady_force(steady);
  const std::string end = !steady || steady->reached
                              ? ""
                              : fmt::format(", not reached within {} s", data::shortest_text(duration));
  answer.add_row("steady |f| / N", {"", force.text + end});
  if (!steady) return answer.add_members({{"steady", nullptr}});
  answer.add_row("verdict, steady", {"", std::string(to_string(steady->verdict))});
  answer.add_members({{"steady",
                       {{"force_N", force.json},
                        {"reached", steady->reached},
                        {"force_bounds_N", between(steady->force).json},
                        {"critical_amplitude_m", is_force ? Json() : middle(steady->critical_amplitude).json},
                        {"verdict", to_string(steady->verdict)}}}});
}

void add_best_change(Answer& answer, const std::optional<studies::Change>& best, const std::string& where) {
  if (!best) return answer.add_members({{"best_change", nullptr}});
  answer.add_row({"best change by a tenth",
                  "best_change",
                  {change_json(best), fmt::format("{} times {}: margin {:.4g}{}", best->key, best->factor,
                                                  best->margin, where)}});
}

void add_outlook(Answer& answer, const studies::CriterionAnswer& found, double frequency_hz) {
  if (!found.nearest) answer.add_members({{"nearest_natural_frequency", nullptr}});
  const auto [mode, hz, distance] = found.nearest.value_or(studies::StickFrequency{});
  const double share = 100.0 * std::abs(distance);
  if (found.nearest)
    answer.add_row({"nearest natural freq. / Hz",
                    "nearest_natural_frequency",
                    {{{"mode", mode}, {"frequency_hz", hz}, {"relative_distance", distance}},
                     fmt::format("{} (mode {}), {} % {}", rounded(hz, 7).text, mode,
                                 share < 99.5 ? fmt::format("{:.2g}", share) : fmt::format("{:.0f}", share),
                                 distance < 0.0 ? "below" : "above")}});
  add_best_change(answer, found.best_change,
                  fmt::format(" at {} Hz only; over a band see design", data::shortest_text(frequency_hz)));
}

Answer answer_for_one(const data::Case& problem, const studies::CriterionAnswer& found) {
  Answer answer;
  const data::Damping& damping = problem.damping;
  const bool is_damped = problem.is_damped();
  add_excitation(answer, problem);
  answer.add_members({{"duration_s", problem.numerics.duration()}, {"modes", problem.numerics.modes()}});
  if (!damping.is_none())
    answer.add_members({{"damping",
                         {{"kelvin_voigt_s", damping.kelvin_voigt()},
                          {"ratio", damping.ratio()},
                          {"mass_proportional_per_s", damping.mass_proportional()}}}});
  answer.add_line(conditions_of(problem) + (is_damped ? ", with damping\n" : "\n"));
  add_criteria(answer, problem, found);
  if (const auto& used = found.modes_used)
    answer.add_row({"held modes used",
                    "modes_used",
                    {{{"modes", used->modes},
                      {"moved_mass_kg", used->moved_mass},
                      {"residual_mass_share", used->residual_share}},
                     fmt::format("{}, residual mass {:.2g} %; {:.4g} kg move with base and contact",
                                 used->modes, 100.0 * used->residual_share, used->moved_mass)}});
  add_steady_state(answer, found.steady, problem.numerics.duration(), problem.excitation().is_force());
  add_outlook(answer, found, problem.excitation().frequency_hz());
  if (found.bending) add_bending(answer, problem.beam(), *found.bending, found.steady_draw_back);
  answer.add_line(fmt::format(
      "\nThe largest |f| is that of a start-up {}. Steady is without them; a margin below 1 slips.",
      is_damped ? "whose free vibrations decay with the damping of the case"
                : "without damping: its free vibrations do not decay"));
  return answer;
}

std::vector<std::string> warnings_about(const data::Case& problem, analytic::Verdict verdict,
                                        const std::optional<studies::Bending>& bending) {
  auto warnings = sentences_of(studies::criterion_warnings(problem));
  if (bending)
    if (const auto warning = studies::draw_back_warning(problem, bending->draw_back))
      warnings.push_back(*warning);
  if (verdict != analytic::Verdict::stick)
    if (const auto unstable = studies::instability_warning(problem)) warnings.push_back(unstable->sentence);
  return warnings;
}

data::Case case_of(const CaseOptions& options, const std::vector<data::Override>& point = {}) {
  data::Case problem = load_case(options, point);
  analytic::require_contact(problem);
  studies::require_feasible(problem);
  return problem;
}

// A row for each case and point, with all modes.
Answer table_of_cases(const CriterionOptions& options, Outputs& outputs) {
  const auto points = options.plan.empty() ? std::vector<std::vector<data::Override>>(1)
                                           : read_rows(options.plan, "the plan");
  std::vector<CaseOptions> cases{options.problem};
  for (const std::string& name : options.more) cases.emplace_back(options.problem).name = name;
  Table table{.columns = {{"case", "case"}}, .rows = {}};
  for (const data::Override& key : points.front()) table.columns.push_back({key.key, key.key});
  table.columns.insert(table.columns.end(), {{"f / Hz", "frequency_hz"},
                                             {"A_0 / m", "amplitude_m"},
                                             {"largest |f| / N", "force_max_N"},
                                             {"friction limit / N", "friction_limit_N"},
                                             {"critical amplitude / m", "critical_amplitude_m"},
                                             {"margin", "margin"},
                                             {"verdict", "verdict"},
                                             {"", "force_lower_N"},
                                             {"", "force_upper_N"},
                                             {"steady |f| / N", "steady_force_N"}});
  if (cases.size() == 1) outputs.set_case(load_case(options.problem));
  outputs.open({{"--output", options.output}, {"--figure", options.figure}});
  const std::size_t rows = cases.size() * points.size();
  report::Progress& progress = outputs.progress("", rows);
  Answer answer;
  std::map<std::size_t, double> margins;
  const Value none{nullptr, "-"};
  for (const CaseOptions& one : cases)
    for (const auto& point : points) {
      const data::Case problem = case_of(one, point);
      const auto found = analytic::criterion_with_all_modes(problem, 1e-10);
      const bool is_sine = problem.general_motion() == nullptr, is_motion = is_sine && !problem.is_force();
      auto& row = table.rows.emplace_back(std::vector{word(problem.name)});
      for (const data::Override& key : point) row.push_back(word(key.value));
      row.insert(row.end(),
                 {is_sine ? exact(problem.excitation().frequency_hz()) : none,
                  is_motion ? exact(problem.excitation().amplitude()) : none, middle(found.force_max),
                  exact(found.friction_limit), is_motion ? middle(found.critical_amplitude) : none,
                  analytic::load(problem) > 0.0 ? middle(studies::margin_of(found)) : none,
                  word(to_string(found.verdict)), exact(found.force_max.lower), exact(found.force_max.upper),
                  is_sine ? steady_force(studies::steady_state(problem)) : none});
      if (analytic::load(problem) > 0.0)
        margins.emplace(table.rows.size(), studies::margin_of(found).midpoint());
      for (const std::string& warning :
           warnings_about(problem, found.verdict, studies::held_bending(problem)))
        add_warning(answer, problem.name + ": " + warning);
      progress(static_cast<double>(table.rows.size()) / static_cast<double>(rows));
    }
  answer.add_table("cases", table);
  outputs.write_table("--output", [&] { return "# Criterion with all modes\n" + table.csv(); });
  if (outputs.has("--figure") && margins.empty())
    throw data::FieldError("--figure", options.figure, "left out where nothing moves");
  outputs.draw(cases.size() == 1 ? cases.front().name : "",
               [&](const report::Look& look) { return report::draw(margins, look); });
  return answer;
}

// What the estimate of a record's interpolation is of its largest acceleration, if there is one.
void add_interpolation(Answer& answer, const data::GeneralMotion& motion, double largest) {
  if (!(motion.interpolation_error() > 0.0)) return;
  const double share = motion.interpolation_error() / largest;
  answer.add_row({"interpolation of the record",
                  "interpolation_share",
                  {share, fmt::format("may change its acceleration by {:.2g} %", 100.0 * share)}});
}

// The three largest of some shares of 1.
std::string largest_shares(std::vector<std::pair<std::string, double>> shares) {
  std::ranges::stable_sort(shares, std::greater(), [](const auto& share) { return std::abs(share.second); });
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, shares.size()); ++i)
    text += fmt::format("{}{}: {:.0f} %", i == 0 ? "" : ", ", shares[i].first, 100.0 * shares[i].second);
  return text;
}

// Of held modes, whose members are shares times `whole`.
void add_shares(Answer& answer, const std::vector<double>& shares, std::string_view member,
                double whole = 1.0) {
  std::vector<std::pair<std::string, double>> named;
  for (const double share : shares)
    named.emplace_back(fmt::format("mode {}", named.size() + 1), share / whole);
  answer.add_row({"shares in it", std::string(member), {shares, largest_shares(std::move(named))}});
}

// Of bands, likewise.
void add_bands(Answer& answer, const std::vector<analytic::BandShare>& found, double whole) {
  Json bands = Json::array();
  std::vector<std::pair<std::string, double>> named;
  for (const auto& [from, to, force] : found) {
    const bool has_end = std::isfinite(to);
    bands.push_back({{"from_hz", from}, {"to_hz", has_end ? Json(to) : Json()}, {"share", force / whole}});
    named.emplace_back(
        has_end ? fmt::format("{:g} to {:g} Hz", from, to) : fmt::format("above {:g} Hz", from),
        force / whole);
  }
  answer.add_row({"bands in it", "band_shares", {bands, largest_shares(std::move(named))}});
}

Answer answer_for_motion(const data::Case& problem, const analytic::MotionReaction& found) {
  Answer answer;
  const double limit = studies::friction_limit(problem);
  const analytic::Bounds largest = found.largest();
  const analytic::Verdict verdict = analytic::verdict_of(largest, limit);
  answer.add_members({{"duration_s", problem.numerics.duration()}, {"modes", problem.numerics.modes()}});
  answer.add_line(conditions_of(problem) + (problem.is_damped() ? ", with damping\n" : "\n"));
  answer.add_row({"largest |f| / N", "force_max_N", between(largest)});
  answer.add_row({"at / s", "time_of_force_max_s", rounded(found.time, 7)});
  answer.add_row({"friction limit mu_s P / N", "friction_limit_N", exact(limit)});
  if (largest.upper > 0.0) {
    const analytic::Bounds margin = limit / largest;
    answer.add_row({"margin mu_s P / |f|", "margin", between(margin)});
    if (analytic::is_proportional_to_scale(problem))
      answer.add_row({"critical scale", "critical_scale", between(analytic::load(problem) * margin)});
  }
  answer.add_row({"verdict", "verdict", word(to_string(verdict))});
  if (verdict != analytic::Verdict::stick && found.first_excess)
    answer.add_row({"first slip at / s", "first_slip_s", rounded(*found.first_excess, 9)});
  else
    answer.add_members({{"first_slip_s", nullptr}});
  answer.add_row({"modes left out / N",
                  "omitted_force_N",
                  {found.omitted, fmt::format("change it by {:.2g} at most", found.omitted)}});
  if (!found.shares.empty() && largest.upper > 0.0)
    add_shares(answer, found.shares, "mode_shares_N", found.of_modes.midpoint());
  if (!found.bands.empty()) add_bands(answer, found.bands, found.of_modes.midpoint());
  if (const auto* base = problem.general_motion())
    add_interpolation(answer, *base, found.largest_acceleration);
  return answer;
}

Answer criterion_of_motion(const data::Case& problem, const CriterionOptions& options, Outputs& outputs) {
  outputs.open({{"--figure", options.figure}});
  report::Progress& progress = outputs.progress("");
  const auto found = analytic::motion_reaction(
      problem, problem.numerics.modes(), [&](double time) { progress(time / problem.numerics.duration()); });
  Answer answer = answer_for_motion(problem, found);
  answer.warnings = sentences_of(studies::criterion_warnings(problem));
  require_finite(answer.json);
  outputs.draw(problem.name, [&](const report::Look& look) {
    return report::held_drawing(problem, found.first_excess, look);
  });
  return answer;
}

// The probability of slip, counted and by two laws.
void add_probabilities(Answer& answer, const data::Case& problem, const studies::RandomSlip& found) {
  const double limit = studies::friction_limit(problem), time = problem.numerics.duration();
  const auto& reaction = found.reaction;
  const auto percent = [](double share) { return fmt::format("{:.3g} %", 100.0 * share); };
  const Value counted = estimated(found.probability, 5);
  answer.add_row(
      {"P(slip), counted",
       "probability_counted",
       {counted.json, fmt::format("{} ... {}: {} of {} realisations", percent(found.probability.lower),
                                  percent(found.probability.upper), found.slips, found.samples)}});
  for (const auto& [law, key, probability] :
       {std::tuple("P(slip), Vanmarcke's law", "probability_vanmarcke", reaction.vanmarcke(limit, time)),
        {"P(slip), Poisson's law", "probability_poisson", reaction.poisson(limit, time)}})
    answer.add_row({law, key, {probability, percent(probability)}});
  answer.add_members({{"samples", found.samples}, {"slips", found.slips}});
  if (!analytic::is_proportional_to_scale(problem)) return;
  constexpr double rare = 0.01;
  const double scale = analytic::load(problem) * limit / reaction.exceeded_with(rare, time);
  answer.add_row({"scale for 1 % of that", "critical_scale", {scale, significant(scale, 4)}});
}

Answer criterion_of_random_motion(const data::Case& problem, const CriterionOptions& options,
                                  Outputs& outputs) {
  if (!options.figure.empty())
    throw data::FieldError("--figure", options.figure,
                           "left out with a spectrum; respond --figure draws a realisation");
  outputs.open({});
  const auto found = studies::random_slip(problem, options.samples, std::ref(outputs.progress("")));
  const auto& reaction = found.reaction;
  const double limit = studies::friction_limit(problem), sigma = reaction.deviation,
               largest = reaction.expected_largest(problem.numerics.duration());
  Answer answer;
  answer.add_members({{"duration_s", problem.numerics.duration()}, {"modes", problem.numerics.modes()}});
  answer.add_line(conditions_of(problem) + ", with damping\n");
  answer.add_row({"standard deviation of f / N", "deviation_N", {sigma, significant(sigma, 6)}});
  answer.add_row({"with twice the modes",
                  "deviation_with_twice_the_modes_N",
                  {found.deviation_of_more_modes, significant(found.deviation_of_more_modes, 6)}});
  answer.add_row({"friction limit mu_s P / N", "friction_limit_N", exact(limit)});
  if (sigma > 0.0) {
    answer.add_row(
        {"limit over deviation", "limit_over_deviation", {limit / sigma, significant(limit / sigma, 4)}});
    answer.add_row(
        {"crossings of it / (1/s)",
         "crossings_per_s",
         {reaction.crossings(limit), fmt::format("{} (Rice)", significant(reaction.crossings(limit), 4))}});
    answer.add_row({"expected largest |f| / N",
                    "expected_largest_N",
                    {largest, fmt::format("{} (Davenport)", significant(largest, 4))}});
    add_shares(answer, reaction.mode_shares, "mode_shares");
    add_bands(answer, reaction.bands, 1.0);
  }
  add_probabilities(answer, problem, found);
  const double even = reaction.exceeded_with(0.5, problem.numerics.duration());
  if (even > 0.0)
    answer.add_row({"margin at even odds", "margin", {limit / even, significant(limit / even, 4)}});
  add_best_change(answer, even > 0.0 ? studies::best_change(problem) : std::nullopt, "");
  answer.warnings = sentences_of(studies::criterion_warnings(problem));
  require_finite(answer.json);
  return answer;
}

Answer criterion(const CriterionOptions& options, Outputs& outputs) {
  if (!options.more.empty() || !options.plan.empty() || !options.output.empty())
    return table_of_cases(options, outputs);
  const data::Case problem = case_of(options.problem);
  outputs.set_case(problem);
  if (problem.is_random()) return criterion_of_random_motion(problem, options, outputs);
  if (options.samples > 0)
    throw data::FieldError("--samples", std::to_string(options.samples), "left out without a spectrum");
  if (problem.has(data::Feature::general_motion)) return criterion_of_motion(problem, options, outputs);
  outputs.open({{"--figure", options.figure}});
  const auto found = studies::criterion_answer(problem);
  Answer answer = answer_for_one(problem, found);
  answer.warnings = warnings_about(problem, found.all_modes.verdict, found.bending);
  require_finite(answer.json);
  outputs.draw(problem.name, [&](const report::Look& look) {
    return report::draw(problem, studies::critical_amplitude_curve(problem), look);
  });
  return answer;
}

void add_options(CLI::App& command, CriterionOptions& options) {
  add_case_options(command, options.problem);
  command.add_option("CASES", options.more, "Further cases: a row each in one table");
  add_file_option(command, "--plan", options.plan,
                  "CSV file with a column for each key that it varies, as beam.length, and a row for each "
                  "point: a row each in the table");
  add_file_option(command, "--output", options.output, "CSV file for the table, '-' for standard output");
  add_excitation_options(command, options.problem);
  add_integer_option(command, "--samples", options.samples, 1, 1'000'000,
                     "With a spectrum: realisations in which slip is counted (default: up to 1000)");
  add_figure_option(command, options.figure);
  command.get_option("--figure")
      ->description(
          "Figure to draw: the critical amplitude, or the margins of the rows of a table, a .png, .pdf, .svg "
          "or .tex file");
}

}  // namespace

void add_criterion_command(CLI::App& app) {
  add<CriterionOptions>(
      app, {.name = "criterion",
            .help = "Whether stick-slip occurs, and from which amplitude on (closed form)",
            .examples = {"stickslip criterion steel-strip --hz 30 --figure criterion.png",
                         "stickslip criterion paper steel-strip --hz 30 --amplitude 0.1mm --output table.csv",
                         "stickslip criterion paper --set beam.length=1.8 --amplitude 0.5e-3 --json"},
            .add_options = add_options,
            .run = criterion});
}

}  // namespace stickslip::cli
