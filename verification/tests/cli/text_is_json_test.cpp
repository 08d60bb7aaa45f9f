// SPDX-License-Identifier: MIT
/// What a command prints for a reader is what it says in JSON: each number in the text, to its last digit.

#include <regex>

#include "support/command_line.hpp"
#include "support/random_cases.hpp"

namespace stickslip::testing {
namespace {

using Json = nlohmann::json;

// The numbers in a text as they stand there; no part of a word is one.
Words numbers_in(const std::string& text) {
  static const std::regex number("(^|[^A-Za-z0-9_.-])(-?[0-9]+(\\.[0-9]+)?(e[-+][0-9]+)?)(?![A-Za-z0-9_])");
  Words found;
  for (std::sregex_iterator at(text.begin(), text.end(), number); at != std::sregex_iterator(); ++at)
    found.push_back((*at)[2]);
  return found;
}

// Half of the last digit of a number.
double half_digit(const std::string& number) {
  const std::size_t e = std::min(number.find('e'), number.size()), point = number.find('.');
  const double exponent = e < number.size() ? std::stod(number.substr(e + 1)) : 0.0;
  const double decimals = point == std::string::npos ? 0.0 : static_cast<double>(e - point - 1);
  return 0.5 * std::pow(10.0, exponent - decimals);
}

bool is_rounded(const std::string& text, double value) {
  return std::abs(std::stod(text) - value) <= (1.0 + 1e-9) * half_digit(text) + 1e-12 * std::abs(value);
}

// All numbers, with what a text makes of them: margins by the modes that are kept, moduli and counts.
void collect(const Json& json, std::vector<double>& numbers) {
  if (json.is_number()) numbers.push_back(json.get<double>());
  if (!json.is_structured()) return;
  if (json.contains("friction_limit_N"))
    for (const char* bound : {"lower", "upper"})
      numbers.push_back(json["friction_limit_N"].get<double>() / json["force_max_N"][bound].get<double>());
  if (json.contains("imaginary"))
    numbers.push_back(std::hypot(json["real"].get<double>(), json["imaginary"].get<double>()));
  if (json.is_array()) numbers.push_back(static_cast<double>(json.size()));
  for (const auto& member : json) collect(member, numbers);
}

// A line of the text by the words with which it begins, or the lines under such a head, and the members of JSON in their order, of
// the answer or of the rows of an array.
struct Printed {
  std::string begin;
  Words members;
  std::string rows{};
};

struct Asked {
  std::string arguments;
  std::vector<Printed> lines;
};

const std::vector<Printed> bending{
    {"deflection of the beam / m", {"/deflection_m"}},
    {"draw-back of the tip / m", {"/draw_back_m"}},
    {"spring that keeps P / (N/m)", {"/keeping_spring_N_per_m"}},
};
const std::vector<Printed> cycle{
    {"period / s", {"/period_s"}},
    {"frequency / Hz", {"/frequency_hz"}},
    {"contact, peak to peak / m", {"/tip_peak_to_peak_m"}},
    {"largest sliding velocity / (m/s)", {"/largest_sliding_velocity_m_per_s"}},
    {"share of stick", {"/stick_share"}},
};
const std::vector<Asked> asked{
    {"criterion",
     {{"largest |f| / N", {"/force_max_N", "/all_modes/force_max_N"}},
      {"friction limit mu_s P / N", {"/friction_limit_N", "/all_modes/friction_limit_N"}},
      {"critical amplitude / m", {"/critical_amplitude_bounds_m", "/all_modes/critical_amplitude_bounds_m"}},
      {"margin mu_s P / |f|", {"", "/margin"}},
      {"verdict", {"/verdict", "/all_modes/verdict"}},
      {"verdict, steady", {"/steady/verdict"}},
      {"steady |f| / N", {"/steady/force_N"}},
      {"nearest natural freq. / Hz",
       {"/nearest_natural_frequency/frequency_hz", "/nearest_natural_frequency/mode"}},
      bending[0],
      bending[1],
      bending[2]}},
    {"design --band BAND --length LENGTH --force FORCE",
     {{"smallest margin mu_s P/|f_max|", {"/margin"}},
      {"smallest margin, steady", {"/steady_margin"}},
      {"at / Hz", {"/frequency_hz"}},
      {"largest |f| / N", {"/force_max_N"}},
      {"friction limit mu_s P / N", {"/friction_limit_N"}},
      {"length / m at P =", {"/from", "/to"}, "/lengths_m/intervals"},
      {"axial force / N at L =", {"/from", "/to"}, "/axial_forces_N/intervals"}}},
    {"uncertainty --samples 50",
     {{"probability of slip", {"/probability_of_slip", "/probability_lower", "/probability_upper"}},
      {"the same, all modes",
       {"/all_modes/probability_of_slip/value", "/all_modes/probability_of_slip/lower",
        "/all_modes/probability_of_slip/upper"}},
      {"margin of the case", {"/margin_of_case"}},
      {"quantile ", {"", "/critical_amplitude_m/value", "/margin/value"}, "/quantiles"},
      {"key ",
       {"/quantile_5", "/quantile_95", "/margin_at_quantile_5", "/margin_at_quantile_95",
        "/first_index/value", "/first_index/lower", "/first_index/upper", "/total_index/value",
        "/total_index/lower", "/total_index/upper"},
       "/keys"}}},
    {"periodic --settle 30", cycle},
    {"nvh --windows 3",
     {{"tip on wall, peak to peak / m",
       {"/peak_to_peak_m/value", "/peak_to_peak_m/lower", "/peak_to_peak_m/upper"}},
      {"travel / m", {"/travel_m"}},
      {"slips over travel / (1/m)", {"/slips_per_m"}},
      {"its coefficient of variation", {"/spacing_variation"}},
      {"A-weighted / dB re 1 N", {"/a_weighted_level_dB"}}}},
    {"squeal --speed SPEED --modes 3 --settle 5",
     {{"friction force on structure / N", {"/friction_force_on_beam_N"}},
      {"deflection of the contact / m", {"/tip_displacement_m", "/finite_element_tip_displacement_m"}},
      {"falling slope / (N s/m)", {"/falling_slope_Ns_per_m"}},
      {"mode ",
       {"", "/frequency_hz", "/damping_ratio", "/root/growth_per_s", "/finite_element_root/growth_per_s",
        "/slope_held_alone_Ns_per_m"},
       "/modes"}}},
};

class TextIsJson : public CommandLine {
 protected:
  // The member stands in the text, to its last digit; of bounds, what both ends round to, or both.
  static void expect_printed(const Json& member, const std::string& cells, std::size_t& at) {
    if (member.is_null()) return;
    if (member.is_string()) {
      EXPECT_TRUE(holds(cells, member.get<std::string>()));
      return;
    }
    const Words numbers = numbers_in(cells);
    ASSERT_LT(at, numbers.size()) << cells;
    if (member.is_number()) {
      EXPECT_TRUE(is_rounded(numbers[at], member.get<double>())) << numbers[at] << " " << member;
    } else {
      const double lower = member["lower"], upper = member["upper"];
      const bool is_common = is_rounded(numbers[at], lower) && is_rounded(numbers[at], upper);
      EXPECT_TRUE(is_common || (is_rounded(numbers[at], lower) && at + 1 < numbers.size() &&
                                is_rounded(numbers[++at], upper)))
          << cells << member;
      // With one digit more the ends would not be alike.
      const auto more = [&](double value) {
        return fmt::format("{:.{}e}", value,
                           std::ranges::count_if(numbers[at], [](char c) { return std::isdigit(c); }));
      };
      EXPECT_TRUE(!is_common || lower == upper || more(lower) != more(upper)) << numbers[at] << member;
    }
    ++at;
  }

  static void expect_members(const Json& object, const Words& members, const std::string& cells) {
    std::size_t at = 0;
    for (const std::string& member : members) {
      const Json::json_pointer pointer(member);
      if (!member.empty() && object.contains(pointer))
        expect_printed(object.at(pointer), cells, at);
      else if (!object.contains(pointer.parent_pointer()) || !object.at(pointer.parent_pointer()).is_null())
        ++at;  // a number that is none of the answer; what is null stands there as words
    }
  }

  static void expect_lines(const Words& lines, const Printed& printed, const Json& answer) {
    SCOPED_TRACE(printed.begin);
    auto line = std::ranges::find_if(lines, [&](const std::string& each) {
      return each.starts_with(printed.begin) &&
             (!printed.rows.empty() || each.substr(printed.begin.size()).starts_with(" "));
    });
    if (line == lines.end()) {
      EXPECT_FALSE(answer.contains(Json::json_pointer(printed.members.back())));
      return;
    }
    if (printed.rows.empty())
      return expect_members(answer, printed.members, line->substr(printed.begin.size()));
    for (const Json& row : answer.at(Json::json_pointer(printed.rows))) {
      ++line;
      std::string cells = *line;
      if (row.contains("key")) cells.erase(0, row["key"].get<std::string>().size());
      expect_members(row, printed.members, cells);
    }
  }

  // No number stands in the text that is none of JSON, as it is, in percent, in g or in mm.
  static void expect_all(const Words& lines, const Json& answer) {
    std::vector<double> numbers{0.0, 5.0, 95.0};
    collect(answer, numbers);
    for (const std::string& line : lines)
      for (const std::string& number : numbers_in(line))
        EXPECT_TRUE(std::ranges::any_of(
            numbers,
            [&](double value) {
              return std::ranges::any_of(std::array{1.0, 100.0, -100.0, 1.0 / 9.80665, 1e3},
                                         [&](double scale) { return is_rounded(number, scale * value); });
            }))
            << number << " in\n"
            << line;
  }
};

STICKSLIP_VERIFIES(TextIsJson, "U1");
TEST_F(TextIsJson, ToTheLastDigitOfEachNumber) {
  const CaseDomain domain{
      .highest_force = 0.8, .longest = 4.0, .fixed_direction = 0.0, .stated = 0.5, .units = 0.5};
  on_random_cases(2, domain, [&](CaseText text, RandomNumbers&) {
    text.set("numerics.modes", "6");
    text.set("numerics.elements", "24");
    const double hz = text.number("excitation.frequency_hz"), length = text.number("beam.length"),
                 force = text.number("beam.axial_force");
    std::ofstream("case.toml") << text.text()
                               << "[uncertainty]\n\"friction.static_coefficient\" = { distribution = "
                                  "'normal', mean = 0.5, standard_deviation = 0.02 }\n\"beam.density\" = { "
                                  "distribution = 'normal', mean = 1000.0, standard_deviation = 90.0 }\n";
    const std::map<std::string, std::string> places{
        {"BAND", fmt::format("{}:{}", hz, 1.1 * hz)},
        {"LENGTH", fmt::format("{}:{}", 0.9 * length, length)},
        {"FORCE", fmt::format("{}:{}", 0.9 * force, force)},
        {"SPEED", fmt::format("{}", hz * text.number("excitation.amplitude"))}};
    for (const auto& [arguments, printed] : asked) {
      Words words = words_of(arguments);
      for (std::string& word : words)
        if (places.contains(word)) word = places.at(word);
      words.insert(words.end(), {"case.toml", "--quiet", "--digits", "17"});
      SCOPED_TRACE(fmt::format("stickslip {}", fmt::join(words, " ")));
      const Outcome said = run_here(words);
      ASSERT_EQ(said.status, 0) << said.errors;
      words.emplace_back("--json");
      const Json answer = Json::parse(run_here(words).output);
      Words lines;
      std::istringstream stream(said.output);
      for (std::string line; std::getline(stream, line);) lines.push_back(line);
      for (const Printed& line : printed) expect_lines(lines, line, answer);
      lines.erase(lines.begin());  // of the beam, in other units
      expect_all(lines, answer);
    }
  });
}

}  // namespace
}  // namespace stickslip::testing
