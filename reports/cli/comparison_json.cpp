// SPDX-License-Identifier: MIT
#include "comparison_json.hpp"

namespace stickslip::cli {

namespace {

using comparison::Comparison;
using comparison::level_names;

Json json_of(const Comparison::Quantity& quantity) {
  Json object{{"quantity", quantity.name},
              {"unit", quantity.unit},
              {"norm", to_string(quantity.norm)},
              {"error", optional_json(quantity.error)},
              {"where", quantity.where},
              {"uncertainty", optional_json(quantity.uncertainty)},
              {"tolerance", quantity.tolerance},
              {"verdict", comparison::to_string(quantity.agreement)},
              {"level", level_names.at(quantity.level)},
              {"scaled_error", finite_json(quantity.scaled_error)},
              {"compared", quantity.compared},
              {"undecided", quantity.undecided},
              {"skipped", Json::array()},
              {"series", Json::array()}};
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
  object["finding"] = comparison::finding_names.at(static_cast<std::size_t>(*diagnosis.finding));
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

Json json_of(const Comparison& comparison, const std::string& file) {
  Json object{
      {"data_set", comparison.name},
      {"title", comparison.title},
      {"kind", to_string(comparison.kind)},
      {"file", file},
      {"verdict", comparison::to_string(comparison.agreement)},
      {"conclusion", conclusion_of(comparison)},
      {"level", level_names.at(comparison.level)},
      {"required_level", level_names.at(comparison.required_level)},
      {"rows",
       {{"compared", comparison.rows}, {"of", comparison.all_rows}, {"numbers", comparison.row_numbers}}},
      {"abscissa", comparison.abscissa},
      {"abscissa_unit", comparison.abscissa_unit},
      {"coverage", comparison.coverage},
      {"required_coverage", comparison.required_coverage},
      {"quantities", Json::array()},
      {"remarks", comparison.remarks},
      {"parts", Json::array()},
      {"diagnoses", Json::array()}};
  for (const auto& quantity : comparison.quantities) object["quantities"].push_back(json_of(quantity));
  for (const auto& part : comparison.parts) object["parts"].push_back(json_of(part, file));
  return object;
}

}  // namespace

Json json_of(const Judged& judged) {
  if (!judged.comparison)
    return {{"data_set", judged.name},
            {"file", judged.file},
            {"verdict", "refused"},
            {"conclusion", judged.refusal}};
  Json object = json_of(*judged.comparison, judged.file);
  for (const auto& diagnosis : judged.diagnoses) object["diagnoses"].push_back(json_of(diagnosis));
  return object;
}

Json json_of(const std::vector<Judged>& all) {
  Json array = Json::array();
  for (const Judged& one : all) array.push_back(json_of(one));
  return array;
}

}  // namespace stickslip::cli
