#pragma once

#include <string>

#include "stickslip/mutants/mutant.hpp"
#include "stickslip/mutants/record.hpp"

namespace stickslip::report {

/// What the suite catches, as the last run of the mutants recorded it.
struct MutantRecord {
  std::vector<mutants::CuratedMutant> curated;
  mutants::KillMatrix matrix;
  mutants::GeneratedSample sample;
  std::vector<mutants::Equivalence> equivalences;
  std::vector<mutants::IdleTests> idle_tests;
};

/// Throws data::InputError for a record or a catalogue that cannot be used.
[[nodiscard]] MutantRecord read_mutant_record();

/// Rows, one for each curated mutant: number in the figure, mistake, its file, tests of each kind that kill
/// it.
[[nodiscard]] std::string curated_mutant_rows(const MutantRecord& record);

/// Rows, one for each component and operator: generated, killed, equivalent, surviving.
[[nodiscard]] std::string generated_mutant_rows(const MutantRecord& record);

/// Rows, one for each generated mutant that is proved equivalent: place, line as it was, line as it is,
/// proof.
[[nodiscard]] std::string equivalence_rows(const MutantRecord& record);

/// The tests that kill no curated mutant, a paragraph for each purpose.
[[nodiscard]] std::string idle_test_names(const MutantRecord& record);

}  // namespace stickslip::report
