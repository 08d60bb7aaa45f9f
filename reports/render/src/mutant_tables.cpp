#include "mutant_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include "latex_table.hpp"
#include "stickslip/mutants/verdict.hpp"
#include "stickslip/report/latex_text.hpp"

namespace stickslip::report {

namespace {

std::string code(const std::string& text) { return fmt::format("\\code{{{}}}", escape(text)); }

std::string file_name(const std::string& path) {
  return breakable(std::filesystem::path(path).filename().string());
}

}  // namespace

MutantRecord read_mutant_record() {
  return {.curated = mutants::curated_mutants(),
          .matrix = mutants::read_kill_matrix(),
          .sample = mutants::read_generated_sample(),
          .equivalences = mutants::equivalences(),
          .idle_tests = mutants::idle_test_ledger()};
}

std::string curated_mutant_rows(const MutantRecord& record) {
  const auto counts = mutants::kill_counts(record.matrix);
  Rows rows;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const auto mutant = std::ranges::find(record.curated, counts[i].mutant, &mutants::CuratedMutant::name);
    if (mutant == record.curated.end()) continue;  // the suite says that the record is out of date
    std::vector<std::string> cells{std::to_string(i + 1), typeset(mutant->mistake),
                                   file_name(mutant->edits.front().file)};
    for (const int count : {counts[i].unit, counts[i].order, counts[i].paper, counts[i].cross})
      cells.push_back(std::to_string(count));
    rows.add(cells);
  }
  return rows.text();
}

std::string generated_mutant_rows(const MutantRecord& record) {
  std::map<std::pair<std::string, std::string>, mutants::GeneratedSample> groups;
  for (const auto& mutant : record.sample.mutants)
    groups[{mutants::component_of(mutant.file), mutant.kind}].mutants.push_back(mutant);
  Rows rows;
  for (const auto& [key, group] : groups) {
    const mutants::Score score = mutants::score(group, record.equivalences);
    rows.add({key.first, key.second, std::to_string(group.mutants.size()), std::to_string(score.killed),
              std::to_string(score.equivalent), std::to_string(score.survived)});
  }
  return rows.text();
}

std::string equivalence_rows(const MutantRecord& record) {
  Rows rows;
  for (const auto& mutant : record.sample.mutants) {
    const auto* proof = mutants::proof_of(mutant, record.equivalences);
    if (proof == nullptr || !mutant.killed_by.empty()) continue;
    rows.add({fmt::format("{}:{}", file_name(mutant.file), mutant.line),
              fmt::format("{} \\newline {}", code(mutant.was), code(mutant.is)), typeset(proof->proof)});
    rows.space();
  }
  return rows.text();
}

std::string idle_test_names(const MutantRecord& record) {
  const auto idle = mutants::idle_tests(record.matrix);
  std::string text;
  for (const mutants::IdleTests& entry : record.idle_tests) {
    std::string names;
    for (const mutants::TestName& test : idle)
      if (mutants::purpose_of(test, record.idle_tests) == &entry)
        names += (names.empty() ? "" : ", ") + breakable(test.name);
    if (!names.empty())
      text += fmt::format("\\par\\noindent\\textbf{{{}}}: {}.\n", typeset(entry.purpose), names);
  }
  return text;
}

}  // namespace stickslip::report
