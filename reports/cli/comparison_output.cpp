// SPDX-License-Identifier: MIT
#include "comparison_output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>

#include "stickslip/data/input_text.hpp"

namespace stickslip::cli {

namespace {

using comparison::Agreement;
using comparison::Comparison;
using comparison::level_names;

std::string number_of(std::optional<double> value) { return value ? fmt::format("{:.3g}", *value) : "-"; }

// In the unit of the quantity, relative to it or in per cent of its range.
std::string measured(std::optional<double> value, const Comparison::Quantity& quantity) {
  if (value && quantity.norm == data::Norm::range) return number_of(100.0 * *value) + " %";
  const bool is_absolute = quantity.norm == data::Norm::absolute || quantity.norm == data::Norm::word;
  const bool has_unit = value && is_absolute && !quantity.unit.empty();
  return has_unit ? number_of(value) + " " + quantity.unit : number_of(value);
}

// " at level 1e-2"; nothing if no level is asked for.
std::string at_level(const Comparison& comparison) {
  if (comparison.required_level == comparison::strict_level) return "";
  return fmt::format(" at level {}", level_names.at(comparison.required_level));
}

std::string tolerance_of(const Comparison::Quantity& quantity) {
  const std::string tolerance = measured(quantity.tolerance, quantity);
  if (quantity.required_level == comparison::strict_level) return tolerance;
  return fmt::format("{} or level {}", tolerance, level_names.at(quantity.required_level));
}

std::string verdict_of(const Comparison::Quantity& quantity) {
  const auto verdict = comparison::to_string(quantity.agreement);
  if (quantity.agreement != Agreement::undecided || quantity.compared == 0) return std::string(verdict);
  return fmt::format("{} ({} of {})", verdict, quantity.undecided, quantity.compared);
}

// Why a quantity does not agree, in one clause.
std::string reason_of(const Comparison::Quantity& quantity) {
  if (quantity.compared == 0 && quantity.error.value_or(0.0) == 0.0) return "no point could be compared";
  return fmt::format("error {} at {}, tolerance {}, uncertainty of the reference {}",
                     measured(quantity.error, quantity), quantity.where, tolerance_of(quantity),
                     measured(quantity.uncertainty, quantity));
}

// The verdict on each sequence of events, with the first thing that differs in it.
Table part_table(const std::vector<Comparison>& parts) {
  Table table{.columns = {{"part", ""}, {"verdict", ""}, {"level", ""}, {"worst", ""}}, .rows = {}};
  for (const Comparison& part : parts) {
    const auto worst = std::ranges::find(part.quantities, part.agreement, &Comparison::Quantity::agreement);
    const bool is_told = part.agreement != Agreement::agrees && worst != part.quantities.end();
    table.rows.push_back(
        {word(part.name), word(to_string(part.agreement)), word(level_names.at(part.level)),
         word(is_told ? fmt::format("{}: {} at {}", worst->name, measured(worst->error, *worst), worst->where)
                      : "-")});
  }
  return table;
}

Table quantity_table(const std::vector<Comparison::Quantity>& quantities) {
  Table table;
  for (const char* header :
       {"quantity", "norm", "compared", "error", "at", "uncertainty", "tolerance", "verdict"})
    table.columns.push_back({header, ""});
  for (const auto& quantity : quantities)
    table.rows.push_back({word(quantity.name), word(to_string(quantity.norm)), count(quantity.compared),
                          word(measured(quantity.error, quantity)),
                          word(quantity.where.empty() ? "-" : quantity.where),
                          word(measured(quantity.uncertainty, quantity)), word(tolerance_of(quantity)),
                          word(verdict_of(quantity))});
  return table;
}

// "2 beyond the horizon, 3 outside the range of the data set"
std::string skipped_of(const Comparison::Quantity& quantity) {
  std::string text;
  for (const auto& [reason, points] : quantity.skipped)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", points, reason);
  return text;
}

std::string prefix_of(const std::string& group) { return group.empty() ? "" : group + ": "; }

bool is_covered(const Comparison& comparison) { return comparison.coverage >= comparison.required_coverage; }

// "coverage: 58 %, at least 90 % needed"
std::string coverage_of(const Comparison& comparison) {
  return fmt::format("coverage: {:.3g} %, at least {:g} % needed", 100.0 * comparison.coverage,
                     100.0 * comparison.required_coverage);
}

// " in 12 of 120 rows"; nothing for the whole.
std::string part_of(const Comparison& comparison) {
  if (comparison.rows == comparison.all_rows) return "";
  return fmt::format(" in {} of {} rows", comparison.rows, comparison.all_rows);
}

// The outcome of a test case: nothing, or the name of the element that says what else.
struct TestCase {
  std::string name, outcome, type, message;
};

TestCase test_case(const std::string& name, Agreement agreement, const std::string& message) {
  if (agreement == Agreement::agrees) return {name, "", "", ""};
  return {name, agreement == Agreement::differs ? "failure" : "error", std::string(to_string(agreement)),
          message};
}

std::vector<TestCase> test_cases_of(const Judged& judged) {
  if (!judged.comparison) return {{"file", "error", "refused", judged.refusal}};
  const Comparison& comparison = *judged.comparison;
  std::vector<TestCase> cases{test_case("coverage" + part_of(comparison),
                                        is_covered(comparison) ? Agreement::agrees : Agreement::undecided,
                                        coverage_of(comparison))};
  for (const auto& quantity : comparison.quantities)
    cases.push_back(test_case(quantity.name, quantity.agreement, reason_of(quantity)));
  for (const auto& part : comparison.parts)
    cases.push_back(test_case(part.name, part.agreement, conclusion_of(part)));
  return cases;
}

}  // namespace

std::string conclusion_of(const Comparison& comparison) {
  const std::string agrees = "agrees" + part_of(comparison) + at_level(comparison),
                    &rows = comparison.row_numbers;
  if (comparison.agreement == Agreement::agrees) return agrees;
  if (comparison.agreement == Agreement::differs) return "differs" + at_level(comparison);
  const bool settled = std::ranges::all_of(
      comparison.quantities, [](const auto& quantity) { return quantity.agreement == Agreement::agrees; });
  if (settled && !part_of(comparison).empty())
    return agrees + ", but more are asked for" +
           (rows.size() > 40 ? "" : fmt::format("; --rows {} asks for these alone", rows));
  return is_covered(comparison) ? "undecided: nothing differs, but the reference does not settle everything"
                                : "undecided: nothing differs, but the file covers too little";
}

std::string text_of(const std::vector<Judged>& all) {
  Table table{.columns = {{"data set", ""}, {"file", ""}, {"level", ""}, {"verdict", ""}}, .rows = {}};
  for (const Judged& one : all)
    table.rows.push_back({word(one.name), word(one.file),
                          word(one.comparison ? level_names.at(one.comparison->level) : "-"),
                          word(one.comparison ? conclusion_of(*one.comparison) : "refused: " + one.refusal)});
  return table.text();
}

std::string text_of(const Judged& judged) {
  if (!judged.comparison) return judged.refusal + "\n";
  const Comparison& comparison = *judged.comparison;
  std::string text = fmt::format("{}: {}\n\n", comparison.name, comparison.title);
  text += quantity_table(comparison.quantities).text() + "\n";
  if (!comparison.parts.empty()) text += part_table(comparison.parts).text() + "\n";
  for (const auto& quantity : comparison.quantities)
    if (const std::string skipped = skipped_of(quantity); !skipped.empty())
      text += fmt::format("{}: not compared: {}\n", quantity.name, skipped);
  for (const std::string& remark : comparison.remarks) text += remark + "\n";
  text += coverage_of(comparison) + "\n";
  text += fmt::format("level: {} of {}\n", level_names.at(comparison.level),
                      fmt::join(level_names.begin() + 1, level_names.end(), ", "));
  for (const auto& diagnosis : judged.diagnoses)
    text += fmt::format("{}{}{}\n", prefix_of(comparison.quantities.size() > 1 ? diagnosis.quantity : ""),
                        prefix_of(diagnosis.group), diagnosis.sentence);
  return text + fmt::format("{}\n", conclusion_of(comparison));
}

std::string junit_of(const std::vector<Judged>& all) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node suites = document.append_child("testsuites");
  std::vector<TestCase> every;
  const auto set = [](pugi::xml_node node, const char* attribute, const std::string& value) {
    node.append_attribute(attribute) = data::plain_text(value).c_str();
  };
  const auto describe = [&](pugi::xml_node node, const std::string& name,
                            const std::vector<TestCase>& cases) {
    const auto number_of = [&](const char* outcome) {
      return static_cast<long long>(std::ranges::count(cases, outcome, &TestCase::outcome));
    };
    set(node, "name", name);
    node.append_attribute("tests") = static_cast<long long>(cases.size());
    node.append_attribute("failures") = number_of("failure");
    node.append_attribute("errors") = number_of("error");
  };
  for (const Judged& judged : all) {
    pugi::xml_node suite = suites.append_child("testsuite");
    const auto cases = test_cases_of(judged);
    describe(suite, judged.name, cases);
    for (const TestCase& one : cases) {
      pugi::xml_node test = suite.append_child("testcase");
      set(test, "classname", judged.name);
      set(test, "name", one.name);
      if (one.outcome.empty()) continue;
      pugi::xml_node outcome = test.append_child(one.outcome.c_str());
      set(outcome, "message", one.message);
      set(outcome, "type", one.type);
    }
    suite.append_child("system-out").text() = data::plain_text(judged.file + "\n" + text_of(judged)).c_str();
    every.insert(every.end(), cases.begin(), cases.end());
  }
  describe(suites, all.size() == 1 ? all.front().name : "stickslip compare", every);
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace stickslip::cli
