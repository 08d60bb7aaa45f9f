#include "stickslip/mutants/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace stickslip::mutants {

namespace {

int& count_of(KillCount& counts, const std::string& kind) {
  if (kind == "unit") return counts.unit;
  if (kind == "order") return counts.order;
  if (kind == "paper") return counts.paper;
  if (kind == "cross") return counts.cross;
  throw std::invalid_argument(kind + " is no kind of tests; unit, order, paper and cross are");
}

// "Suite" or "Suite.Name" stands for "Instance/Suite.Name/parameter".
bool stands_for(const std::string& name, const std::string& test) {
  const std::size_t dot = test.find('.'), before = test.find('/');
  const std::size_t begin = before < dot ? before + 1 : 0;
  const std::string plain = test.substr(begin, test.find('/', dot) - begin);
  return name == plain || plain.starts_with(name + '.');
}

}  // namespace

std::vector<KillCount> kill_counts(const KillMatrix& matrix) {
  std::vector<KillCount> counts;
  for (std::size_t mutant = 0; mutant < matrix.mutants.size(); ++mutant) {
    auto& count = counts.emplace_back(KillCount{.mutant = matrix.mutants[mutant]});
    for (std::size_t test = 0; test < matrix.tests.size(); ++test)
      if (matrix.fates[test][mutant] == Fate::killed) ++count_of(count, matrix.tests[test].kind);
  }
  return counts;
}

std::vector<TestName> idle_tests(const KillMatrix& matrix) {
  std::vector<TestName> idle;
  for (std::size_t test = 0; test < matrix.tests.size(); ++test)
    if (std::ranges::all_of(matrix.fates[test], [](Fate fate) { return fate == Fate::survives; }))
      idle.push_back(matrix.tests[test]);
  return idle;
}

const IdleTests* purpose_of(const TestName& test, const std::vector<IdleTests>& ledger) {
  const auto entry = std::ranges::find_if(ledger, [&](const IdleTests& tests) {
    return std::ranges::any_of(tests.names, [&](const auto& name) { return stands_for(name, test.name); });
  });
  return entry == ledger.end() ? nullptr : &*entry;
}

std::vector<std::string> faults(const std::vector<IdleTests>& ledger, const KillMatrix& matrix) {
  const std::vector<TestName> idle = idle_tests(matrix);
  std::vector<std::string> sentences;
  for (const TestName& test : idle)
    if (purpose_of(test, ledger) == nullptr)
      sentences.push_back(
          fmt::format("{} kills no curated mutant, and nothing says what it is for", test.name));
  for (const IdleTests& entry : ledger)
    for (const std::string& name : entry.names)
      if (std::ranges::none_of(idle, [&](const TestName& test) { return stands_for(name, test.name); }))
        sentences.push_back(fmt::format("{} is said to kill no curated mutant, but is no such test", name));
  return sentences;
}

std::vector<std::string> survivors(const KillMatrix& matrix) {
  std::vector<std::string> sentences;
  for (const KillCount& count : kill_counts(matrix))
    if (count.kinds() < 2)
      sentences.push_back(fmt::format(
          "{} is killed by {} tests of {} kinds (unit {}, order {}, paper {}, cross {}), but must be by two "
          "kinds",
          count.mutant, count.tests(), count.kinds(), count.unit, count.order, count.paper, count.cross));
  return sentences;
}

const Equivalence* proof_of(const GeneratedResult& mutant, const std::vector<Equivalence>& proofs) {
  const auto proof = std::ranges::find_if(proofs, [&](const Equivalence& entry) {
    return entry.file == mutant.file && entry.was == mutant.was && entry.is == mutant.is;
  });
  return proof == proofs.end() ? nullptr : &*proof;
}

Score score(const GeneratedSample& sample, const std::vector<Equivalence>& proofs) {
  Score result;
  for (const GeneratedResult& mutant : sample.mutants)
    ++(!mutant.killed_by.empty()             ? result.killed
       : proof_of(mutant, proofs) != nullptr ? result.equivalent
                                             : result.survived);
  return result;
}

std::vector<std::string> survivors(const GeneratedSample& sample, const std::vector<Equivalence>& proofs) {
  std::vector<std::string> sentences;
  for (const GeneratedResult& mutant : sample.mutants)
    if (mutant.killed_by.empty() && proof_of(mutant, proofs) == nullptr)
      sentences.push_back(fmt::format("{}:{}: no test sees '{}' for '{}' ({}, {})", mutant.file, mutant.line,
                                      mutant.is, mutant.was, mutant.kind, mutant.name));
  return sentences;
}

std::string summary(const KillMatrix& matrix) {
  return fmt::format(
      "{} curated mutants, {} tests: {} mutants not killed by two kinds of tests, {} tests kill none",
      matrix.mutants.size(), matrix.tests.size(), survivors(matrix).size(), idle_tests(matrix).size());
}

std::string summary(const GeneratedSample& sample, const std::vector<Equivalence>& proofs) {
  const Score result = score(sample, proofs);
  return fmt::format(
      "{} generated mutants of {} candidates (seed {}; {} more do not compile, {} are the same code): {} "
      "killed, {} "
      "proved equivalent, {} survive; score {:.1f} %",
      sample.mutants.size(), sample.candidates, sample.seed, sample.not_compiling, sample.same_code,
      result.killed, result.equivalent, result.survived, 100.0 * result.value());
}

}  // namespace stickslip::mutants
