// SPDX-License-Identifier: MIT
#include "comparison_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <pugixml.hpp>
#include <sstream>
#include <vector>

namespace stickslip::cli {

namespace {

using comparison::Agreement;
using comparison::Comparison;

std::string number_of(std::optional<double> value) { return value ? fmt::format("{:.3g}", *value) : "-"; }

// In the unit of the quantity, relative to it or in per cent of its range.
std::string measured(std::optional<double> value, const Comparison::Quantity& quantity) {
  if (value && quantity.norm == data::Norm::range) return number_of(100.0 * *value) + " %";
  const bool is_absolute = quantity.norm == data::Norm::absolute || quantity.norm == data::Norm::word;
  const bool has_unit = value && is_absolute && !quantity.unit.empty();
  return has_unit ? number_of(value) + " " + quantity.unit : number_of(value);
}

std::string verdict_of(const Comparison::Quantity& quantity) {
  const auto verdict = comparison::to_string(quantity.agreement);
  if (quantity.agreement != Agreement::undecided || quantity.compared == 0) return std::string(verdict);
  return fmt::format("{} ({} of {})", verdict, quantity.undecided, quantity.compared);
}

Table table_of(const std::vector<Comparison::Quantity>& quantities) {
  Table table;
  for (const char* header :
       {"quantity", "norm", "compared", "error", "at", "uncertainty", "tolerance", "verdict"})
    table.columns.push_back({header, ""});
  for (const auto& quantity : quantities)
    table.rows.push_back({word(quantity.name), word(to_string(quantity.norm)), count(quantity.compared),
                          word(measured(quantity.error, quantity)),
                          word(quantity.where.empty() ? "-" : quantity.where),
                          word(measured(quantity.uncertainty, quantity)),
                          word(measured(quantity.tolerance, quantity)), word(verdict_of(quantity))});
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

// Why a quantity does not agree, in one clause.
std::string reason_of(const Comparison::Quantity& quantity) {
  if (quantity.compared == 0 && quantity.error.value_or(0.0) == 0.0) return "no point could be compared";
  return fmt::format("error {} at {}, tolerance {}, uncertainty of the reference {}",
                     measured(quantity.error, quantity), quantity.where,
                     measured(quantity.tolerance, quantity), measured(quantity.uncertainty, quantity));
}

bool is_covered(const Comparison& comparison) { return comparison.coverage >= comparison.required_coverage; }

// "coverage: 58 %, at least 90 % needed"
std::string coverage_of(const Comparison& comparison) {
  return fmt::format("coverage: {:.3g} %, at least {:g} % needed", 100.0 * comparison.coverage,
                     100.0 * comparison.required_coverage);
}

std::string conclusion_of(const Comparison& comparison) {
  const auto verdict = comparison::to_string(comparison.agreement);
  if (comparison.agreement != Agreement::undecided) return std::string(verdict);
  if (!is_covered(comparison))
    return fmt::format("{}: nothing differs, but the file covers too little", verdict);
  return fmt::format("{}: nothing differs, but the reference does not settle everything", verdict);
}

std::string finding_name(comparison::Finding finding) {
  switch (finding) {
    case comparison::Finding::correct:
      return "correct";
    case comparison::Finding::mistaken:
      return "mistaken";
    case comparison::Finding::undecided:
      return "undecided";
    case comparison::Finding::unexplained:
      break;
  }
  return "unexplained";
}

Json json_of(const Comparison::Quantity& quantity) {
  Json object{{"quantity", quantity.name},        {"unit", quantity.unit},
              {"norm", to_string(quantity.norm)}, {"error", optional_json(quantity.error)},
              {"where", quantity.where},          {"uncertainty", optional_json(quantity.uncertainty)},
              {"tolerance", quantity.tolerance},  {"verdict", comparison::to_string(quantity.agreement)},
              {"compared", quantity.compared},    {"undecided", quantity.undecided},
              {"skipped", Json::array()},         {"series", Json::array()}};
  for (const auto& [reason, points] : quantity.skipped)
    object["skipped"].push_back({{"reason", reason}, {"points", points}});
  for (const auto& series : quantity.series)
    object["series"].push_back({{"group", series.group},
                                {"abscissa", series.abscissa},
                                {"theirs", series.theirs},
                                {"reference", series.reference},
                                {"half_width", series.half_width},
                                {"allowed", series.allowed}});
  return object;
}

Json json_of(const comparison::Diagnosis& diagnosis) {
  Json object{{"group", diagnosis.group},
              {"quantity", diagnosis.quantity},
              {"sentence", diagnosis.sentence},
              {"finding", nullptr}};
  if (!diagnosis.finding) return object;
  object["finding"] = finding_name(*diagnosis.finding);
  object["distance_from_truth"] = diagnosis.from_reference;
  object["uncertainty"] = diagnosis.uncertainty;
  object["required_ratio"] = diagnosis.required_ratio;
  object["named"] = diagnosis.named;
  object["ranking"] = Json::array();
  for (const comparison::Hypothesis& suspect : diagnosis.ranked)
    object["ranking"].push_back({{"name", suspect.name},
                                 {"distance", suspect.distance},
                                 {"distance_from_truth", suspect.from_reference}});
  return object;
}

auto count_of(const Comparison& comparison, Agreement agreement) {
  return std::ranges::count(comparison.quantities, agreement, &Comparison::Quantity::agreement);
}

}  // namespace

std::string text_of(const Comparison& comparison) {
  std::string text = fmt::format("{}: {}\n\n", comparison.name, comparison.title);
  text += table_of(comparison.quantities).text() + "\n";
  for (const auto& quantity : comparison.quantities)
    if (const std::string skipped = skipped_of(quantity); !skipped.empty())
      text += fmt::format("{}: not compared: {}\n", quantity.name, skipped);
  for (const std::string& remark : comparison.remarks) text += remark + "\n";
  text += coverage_of(comparison) + "\n";
  for (const auto& diagnosis : comparison.diagnoses)
    text += fmt::format("{}{}{}\n", prefix_of(comparison.quantities.size() > 1 ? diagnosis.quantity : ""),
                        prefix_of(diagnosis.group), diagnosis.sentence);
  return text + fmt::format("{}\n", conclusion_of(comparison));
}

Json json_of(const Comparison& comparison, const std::string& file) {
  Json object{{"data_set", comparison.name},
              {"title", comparison.title},
              {"kind", to_string(comparison.kind)},
              {"file", file},
              {"verdict", comparison::to_string(comparison.agreement)},
              {"abscissa", comparison.abscissa},
              {"abscissa_unit", comparison.abscissa_unit},
              {"coverage", comparison.coverage},
              {"required_coverage", comparison.required_coverage},
              {"quantities", Json::array()},
              {"remarks", comparison.remarks},
              {"diagnoses", Json::array()}};
  for (const auto& quantity : comparison.quantities) object["quantities"].push_back(json_of(quantity));
  for (const auto& diagnosis : comparison.diagnoses) object["diagnoses"].push_back(json_of(diagnosis));
  return object;
}

std::string junit_of(const Comparison& comparison, const std::string& file) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  const auto failures = static_cast<long long>(count_of(comparison, Agreement::differs));
  const auto skipped =
      static_cast<long long>(count_of(comparison, Agreement::undecided)) + (is_covered(comparison) ? 0 : 1);
  pugi::xml_node suites = document.append_child("testsuites"), suite = suites.append_child("testsuite");
  for (pugi::xml_node node : {suites, suite}) {
    node.append_attribute("name") = comparison.name.c_str();
    node.append_attribute("tests") = static_cast<long long>(comparison.quantities.size() + 1);
    node.append_attribute("failures") = failures;
    node.append_attribute("errors") = 0;
    if (node == suite) node.append_attribute("skipped") = skipped;
  }
  const auto add_case = [&](const std::string& name) {
    pugi::xml_node test = suite.append_child("testcase");
    test.append_attribute("classname") = comparison.name.c_str();
    test.append_attribute("name") = name.c_str();
    return test;
  };
  pugi::xml_node coverage = add_case("coverage");
  if (!is_covered(comparison))
    coverage.append_child("skipped").append_attribute("message") = coverage_of(comparison).c_str();
  for (const auto& quantity : comparison.quantities) {
    pugi::xml_node test = add_case(quantity.name);
    if (quantity.agreement == Agreement::agrees) continue;
    const bool differs = quantity.agreement == Agreement::differs;
    pugi::xml_node outcome = test.append_child(differs ? "failure" : "skipped");
    outcome.append_attribute("message") = reason_of(quantity).c_str();
    if (differs) outcome.append_attribute("type") = "differs";
  }
  suite.append_child("system-out").text() = (file + "\n" + text_of(comparison)).c_str();
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace stickslip::cli
