#include "values.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "findings.hpp"
#include "stickslip/benchmarks/speed_record.hpp"
#include "stickslip/mutants/verdict.hpp"
#include "stickslip/report/text_file.hpp"
#include "studies/common/input_matrix.hpp"
#include "study_json.hpp"

namespace stickslip::benchmarks {
STICKSLIP_JSON(SpeedComparison::Load, flops_per_step, bytes_per_step, share_of_flops, share_of_bytes)
STICKSLIP_JSON(SpeedComparison, work, plain, fast, fast_seconds, load, ratio())
}  // namespace stickslip::benchmarks

namespace stickslip::studies {
STICKSLIP_JSON(BadInputCount, where, defect, refused, accepted)
STICKSLIP_JSON(AcceptedCount, reason, rows)
}  // namespace stickslip::studies

namespace stickslip::report {

STICKSLIP_JSON(Environment, version, commit, date, compiler, eigen, gsl, rest)

namespace {

using nlohmann::json;

json speed(const benchmarks::SpeedRecord& record) {
  json scale = json::array();
  for (std::size_t i = 0; i < record.elements.size(); ++i)
    scale.push_back({{"elements", record.elements[i]},
                     {"seconds_per_element", record.seconds_per_element[i]},
                     {"relative", record.seconds_per_element[i] / record.seconds_per_element[0]}});
  return {{"processor", record.processor}, {"comparisons", record.comparisons}, {"scale", scale}};
}

json bad_input(const std::vector<studies::BadInput>& matrix) {
  return {{"by_defect", studies::count_by_defect(matrix)}, {"by_reason", studies::count_by_reason(matrix)}};
}

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

json curated_mutants(const mutants::KillMatrix& matrix) {
  const auto catalogue = mutants::curated_mutants();
  json rows = json::array();
  int number = 0;
  for (const auto& count : mutants::kill_counts(matrix)) {
    ++number;
    const auto mutant = std::ranges::find(catalogue, count.mutant, &mutants::CuratedMutant::name);
    if (mutant == catalogue.end()) continue;  // the suite says that the record is out of date
    rows.push_back({{"number", number},
                    {"mistake", mutant->mistake},
                    {"file", file_name(mutant->edits.front().file)},
                    {"unit", count.unit},
                    {"order", count.order},
                    {"paper", count.paper},
                    {"cross", count.cross}});
  }
  return rows;
}

json mutant_groups(const mutants::GeneratedSample& sample, const std::vector<mutants::Equivalence>& proofs) {
  std::map<std::pair<std::string, std::string>, mutants::GeneratedSample> groups;
  for (const auto& mutant : sample.mutants)
    groups[{mutants::component_of(mutant.file), mutant.kind}].mutants.push_back(mutant);
  json rows = json::array();
  for (const auto& [key, group] : groups) {
    const mutants::Score score = mutants::score(group, proofs);
    rows.push_back({{"component", key.first},
                    {"kind", key.second},
                    {"mutants", group.mutants.size()},
                    {"killed", score.killed},
                    {"equivalent", score.equivalent},
                    {"survived", score.survived}});
  }
  return rows;
}

json equivalences(const mutants::GeneratedSample& sample, const std::vector<mutants::Equivalence>& proofs) {
  json rows = json::array();
  for (const auto& mutant : sample.mutants) {
    const auto* proof = mutants::proof_of(mutant, proofs);
    if (proof == nullptr || !mutant.killed_by.empty()) continue;
    rows.push_back({{"file", file_name(mutant.file)},
                    {"line", mutant.line},
                    {"was", mutant.was},
                    {"is", mutant.is},
                    {"proof", proof->proof}});
  }
  return rows;
}

json idle_tests(const std::vector<mutants::TestName>& idle) {
  const auto ledger = mutants::idle_test_ledger();
  json rows = json::array();
  for (const mutants::IdleTests& entry : ledger) {
    std::vector<std::string> names;
    for (const mutants::TestName& test : idle)
      if (mutants::purpose_of(test, ledger) == &entry) names.push_back(test.name);
    if (!names.empty()) rows.push_back({{"purpose", entry.purpose}, {"tests", names}});
  }
  return rows;
}

json mutant_record() {
  const auto matrix = mutants::read_kill_matrix();
  const auto sample = mutants::read_generated_sample();
  const auto proofs = mutants::equivalences();
  const auto idle = mutants::idle_tests(matrix);
  const mutants::Score score = mutants::score(sample, proofs);
  return {{"curated", curated_mutants(matrix)},
          {"tests", matrix.tests.size()},
          {"escaped", mutants::survivors(matrix).size()},
          {"idle_tests", idle.size()},
          {"idle", idle_tests(idle)},
          {"generated", sample.mutants.size()},
          {"candidates", sample.candidates},
          {"seed", sample.seed},
          {"not_compiling", sample.not_compiling},
          {"same_code", sample.same_code},
          {"killed", score.killed},
          {"equivalent", score.equivalent},
          {"surviving", score.survived},
          {"score", score.value()},
          {"groups", mutant_groups(sample, proofs)},
          {"equivalences", equivalences(sample, proofs)}};
}

}  // namespace

void write_values(StudyResults& results, const Environment& environment,
                  const std::filesystem::path& folder) {
  results.run_all();
  const std::map<std::string, json> values{{"environment", environment},
                                           {"paper", results.paper()},
      {"flat_section", results.flat_section()},
      {"stick_excitation", results.stick_excitation()},
      {"findings", findings(results)},
                                           {"bad_input", bad_input(studies::input_matrix())},
                                           {"speed", speed(benchmarks::read_speed_record())},
                                           {"mutants", mutant_record()}};
  for (const auto& [name, value] : values) replace_text(folder / (name + ".json"), json_text(value));
}

}  // namespace stickslip::report
