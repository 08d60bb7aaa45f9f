#pragma once

/// What a record of mutants says of the suite.

#include <string>
#include <vector>

#include "stickslip/mutants/mutant.hpp"
#include "stickslip/mutants/record.hpp"

namespace stickslip::mutants {

/// How many tests of each kind kill a curated mutant.
struct KillCount {
  std::string mutant;
  int unit{}, order{}, paper{}, cross{};

  [[nodiscard]] int tests() const { return unit + order + paper + cross; }
  [[nodiscard]] int kinds() const { return (unit > 0) + (order > 0) + (paper > 0) + (cross > 0); }
};

/// Of each mutant of the matrix, in its order.
[[nodiscard]] std::vector<KillCount> kill_counts(const KillMatrix& matrix);

/// The tests that face every mutant and kill none.
[[nodiscard]] std::vector<TestName> idle_tests(const KillMatrix& matrix);

/// The entry of the ledger that names a test or its suite; null if none does.
[[nodiscard]] const IdleTests* purpose_of(const TestName& test, const std::vector<IdleTests>& ledger);

/// A sentence for each idle test without an entry in the ledger, and for each name there that belongs to no
/// idle test.
[[nodiscard]] std::vector<std::string> faults(const std::vector<IdleTests>& ledger, const KillMatrix& matrix);

/// A sentence for each mutant that fewer than two tests of different kinds kill.
[[nodiscard]] std::vector<std::string> survivors(const KillMatrix& matrix);

/// The proof that a generated mutant is equivalent; null if there is none.
[[nodiscard]] const Equivalence* proof_of(const GeneratedResult& mutant,
                                          const std::vector<Equivalence>& proofs);

/// Of a sample: killed, proved equivalent, neither; and the share of killed among those not equivalent.
struct Score {
  int killed{}, equivalent{}, survived{};

  [[nodiscard]] double value() const { return static_cast<double>(killed) / (killed + survived); }
};

[[nodiscard]] Score score(const GeneratedSample& sample, const std::vector<Equivalence>& proofs);

/// A sentence for each generated mutant that no test kills and that is not proved equivalent.
[[nodiscard]] std::vector<std::string> survivors(const GeneratedSample& sample,
                                                 const std::vector<Equivalence>& proofs);

/// A line for people.
[[nodiscard]] std::string summary(const KillMatrix& matrix);
[[nodiscard]] std::string summary(const GeneratedSample& sample, const std::vector<Equivalence>& proofs);

}  // namespace stickslip::mutants
