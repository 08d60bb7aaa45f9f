#include "traceability.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "latex_table.hpp"
#include "stickslip/report/latex_text.hpp"

namespace stickslip::report {

namespace {

std::string full_name(const TestResult& test) { return test.suite + "." + test.name; }

// Nothing where the test has passed.
std::string outcome(const TestResult& test) {
  if (test.skipped) return " \\textbf{(skipped)}";
  return test.passed ? "" : " \\textbf{(failed)}";
}

std::string name_cell(const TestResult& test) { return breakable(full_name(test)) + outcome(test); }

std::string margin_text(double margin) { return margin == 0.0 ? "0" : compact_number(margin, 2); }

std::vector<std::string> comparison_cells(const TestComparison& comparison) {
  return {compact_number(comparison.computed, 5), compact_number(comparison.expected, 5),
          compact_number(comparison.error, 2), compact_number(comparison.tolerance, 2),
          margin_text(comparison.margin)};
}

// Calls visit(first, last) for the tests of each requirement, in their order.
void for_each_requirement(const std::vector<TestResult>& tests, const auto& visit) {
  for (auto first = tests.begin(); first != tests.end();) {
    const auto last = std::find_if(
        first, tests.end(), [&](const TestResult& test) { return test.requirement != first->requirement; });
    visit(first, last);
    first = last;
  }
}

std::string reference_to(const std::string& label) {
  return fmt::format("{}~\\ref{{{}}}",
                     label.starts_with("fig:")   ? "Fig."
                     : label.starts_with("tab:") ? "Table"
                                                 : "Section",
                     label);
}

bool is_tight(const ToleranceEntry& entry) { return entry.margin > 0.5; }
bool is_generous(const ToleranceEntry& entry) { return entry.margin < 1e-3; }

std::string derivation_cell(const ToleranceEntry& entry) {
  return typeset(with_powers_of_ten(entry.derivation));
}

std::string rows_of_those_that(const std::vector<TestResult>& tests,
                               bool (*are_listed)(const ToleranceEntry&)) {
  Rows rows;
  for (const TestResult& test : tests)
    for (const ToleranceEntry& entry : test.tolerances)
      if (are_listed(entry))
        rows.add({name_cell(test), entry.tolerance_class, compact_number(entry.error, 2),
                  compact_number(entry.tolerance, 2), margin_text(entry.margin), derivation_cell(entry)});
  return rows.text();
}

}  // namespace

TestCounts test_counts(const std::vector<TestResult>& tests) {
  TestCounts counts;
  counts.tests = tests.size();
  std::set<std::string> requirements;
  for (const TestResult& test : tests) {
    requirements.insert(test.requirement);
    counts.failed += test.passed || test.skipped ? 0 : 1;
    counts.comparisons += test.comparisons;
    if (!test.worst) continue;
    ++counts.comparing;
    counts.tight += static_cast<std::size_t>(std::ranges::count_if(test.tolerances, is_tight));
    counts.generous += static_cast<std::size_t>(std::ranges::count_if(test.tolerances, is_generous));
  }
  counts.requirements = requirements.size();
  return counts;
}

std::size_t claims_with(const std::vector<data::Claim>& claims, data::ClaimVerdict verdict) {
  return static_cast<std::size_t>(std::ranges::count(claims, verdict, &data::Claim::verdict));
}

std::string requirement_rows(const std::vector<TestResult>& tests) {
  Rows rows;
  for_each_requirement(tests, [&](auto first, auto last) {
    const auto failed =
        std::count_if(first, last, [](const TestResult& test) { return !test.passed && !test.skipped; });
    double margin = -1.0;
    for (auto test = first; test != last; ++test)
      if (test->worst) margin = std::max(margin, test->worst->margin);
    rows.add({first->requirement, typeset(first->requirement_text), typeset(first->source),
              std::to_string(last - first), failed == 0 ? "0" : fmt::format("\\textbf{{{}}}", failed),
              margin < 0.0 ? "--" : margin_text(margin)});
  });
  return rows.text();
}

std::string named_comparison_rows(const std::vector<TestResult>& tests) {
  Rows rows;
  for (const TestResult& test : tests)
    for (const TestComparison& comparison : test.named) {
      std::vector<std::string> cells{breakable(comparison.name), breakable(full_name(test))};
      std::ranges::copy(comparison_cells(comparison), std::back_inserter(cells));
      rows.add(cells);
    }
  return rows.text();
}

std::string tolerance_rows(const std::vector<TestResult>& tests, const std::string& tolerance_class) {
  Rows rows;
  for (const TestResult& test : tests)
    for (const ToleranceEntry& entry : test.tolerances)
      if (entry.tolerance_class == tolerance_class)
        rows.add({name_cell(test), std::to_string(entry.comparisons), compact_number(entry.error, 2),
                  compact_number(entry.tolerance, 2), margin_text(entry.margin), derivation_cell(entry)});
  return rows.text();
}

std::string generous_rows(const std::vector<TestResult>& tests) {
  return rows_of_those_that(tests, is_generous);
}

std::string tight_rows(const std::vector<TestResult>& tests) { return rows_of_those_that(tests, is_tight); }

std::string comparison_rows(const std::vector<TestResult>& tests) {
  Rows rows;
  for_each_requirement(tests, [&](auto first, auto last) {
    if (std::none_of(first, last, [](const TestResult& test) { return test.worst.has_value(); })) return;
    rows.space();
    rows.add_heading(fmt::format("\\textbf{{{}}} {} \\emph{{({})}}", first->requirement,
                                 typeset(first->requirement_text), typeset(first->source)),
                     7);
    for (auto test = first; test != last; ++test) {
      if (!test->worst) continue;
      std::vector<std::string> cells{name_cell(*test)};
      std::ranges::copy(comparison_cells(*test->worst), std::back_inserter(cells));
      cells.push_back(test->worst->tolerance_class);
      rows.add(cells);
    }
  });
  return rows.text();
}

std::string logical_tests(const std::vector<TestResult>& tests) {
  std::string text;
  for_each_requirement(tests, [&](auto first, auto last) {
    std::string names, suite;
    for (auto test = first; test != last; ++test) {
      if (test->worst) continue;
      if (!names.empty()) names += test->suite == suite ? ", " : "; ";
      if (test->suite != suite) names += fmt::format("\\emph{{{}:}} ", breakable(test->suite));
      suite = test->suite;
      names += breakable(test->name) + outcome(*test);
    }
    if (!names.empty()) text += fmt::format("\\par\\noindent\\textbf{{{}}} {}.\n", first->requirement, names);
  });
  return text;
}

std::string bad_input_rows(const std::vector<TestResult>& tests) {
  std::map<std::string, std::map<std::string, std::pair<int, int>>> table;  // by defect, then place
  for (const TestResult& test : tests)
    for (const auto& [key, counts] : test.bad_input) {
      const std::size_t dot = key.find('.');
      auto& [refused, accepted] = table[key.substr(dot + 1)][key.substr(0, dot)];
      refused += counts.first;
      accepted += counts.second;
    }
  Rows rows;
  for (auto& [defect, places] : table) {
    std::vector<std::string> cells{escape(defect)};
    for (const char* place : {"case file", "option", "column", "package"})
      cells.insert(cells.end(), {std::to_string(places[place].first), std::to_string(places[place].second)});
    rows.add(cells);
  }
  return rows.text();
}

std::string accepted_input_rows(const std::vector<TestResult>& tests) {
  std::map<std::string, int> counts;
  for (const TestResult& test : tests)
    for (const auto& [reason, count] : test.accepted_input) counts[reason] += count;
  std::vector<std::pair<std::string, int>> sorted(counts.begin(), counts.end());
  std::ranges::stable_sort(sorted, std::ranges::greater{}, &std::pair<std::string, int>::second);
  Rows rows;
  for (const auto& [reason, count] : sorted) rows.add({escape(reason), std::to_string(count)});
  return rows.text();
}

std::string claim_rows(const std::vector<data::Claim>& claims, const std::vector<TestResult>& tests) {
  Rows rows;
  for (const data::Claim& claim : claims) {
    const auto test = std::ranges::find(tests, claim.id, &TestResult::claim);
    std::string found = test == tests.end() ? "not run" : typeset(with_powers_of_ten(test->finding));
    if (!claim.correction.empty())
      found += fmt::format("\\par\\emph{{Instead:}} {}", typeset(claim.correction));
    std::vector<std::string> pointers;
    if (!claim.figure.empty()) pointers.push_back(reference_to(claim.figure));
    if (!claim.erratum.empty()) pointers.push_back("erratum " + claim.erratum);
    if (!pointers.empty()) found += fmt::format(" ({})", fmt::join(pointers, ", "));
    const std::string verdict(data::to_string(claim.verdict));
    rows.add({fmt::format("\\emph{{{}:}} {}", typeset(claim.place), typeset(claim.claim)), typeset(claim.how),
              claim.verdict == data::ClaimVerdict::holds ? verdict : fmt::format("\\textbf{{{}}}", verdict),
              found});
    rows.space();
  }
  return rows.text();
}

}  // namespace stickslip::report
