// SPDX-License-Identifier: MIT
#include "support/claims.hpp"

#include <filesystem>

#include "stickslip/data/case_file.hpp"
#include "stickslip/data/toml_file.hpp"

namespace stickslip::testing {
namespace {

using data::Record;

std::filesystem::path ledger(const char* file) { return data::data_directory() / "paper" / file; }

data::ClaimVerdict verdict_of(const Record& record) {
  using enum data::ClaimVerdict;
  const std::string text = record.text("verdict");
  for (const auto verdict : {holds, holds_with_correction, does_not_hold, not_determined})
    if (text == data::to_string(verdict)) return verdict;
  record.fail_unless("verdict", "holds, holds with correction, does not hold or not determined");
}

}  // namespace

std::vector<Claim> claims() {
  return data::read_all(ledger("claims.toml"), "claim",
                        {"id", "place", "claim", "how", "verdict", "correction", "figure", "erratum"},
                        [](const Record& record) {
                          for (const char* key : {"place", "claim", "how"}) (void)record.text(key);
                          return Claim{record.text("id"), verdict_of(record),
                                       record.optional_text("correction"), record.optional_text("figure"),
                                       record.optional_text("erratum")};
                        });
}

std::vector<Erratum> errata() {
  return data::read_all(ledger("errata.toml"), "erratum",
                        {"id", "place", "printed", "holds", "established", "verdict"},
                        [](const Record& record) {
                          for (const char* key : {"place", "printed", "holds", "established"})
                            (void)record.text(key);
                          return Erratum{record.text("id"), verdict_of(record)};
                        });
}

std::vector<std::string> unstated_choices() {
  return data::read_all(ledger("errata.toml"), "unstated", {"subject", "choice", "reason"},
                        [](const Record& record) {
                          for (const char* key : {"subject", "reason"}) (void)record.text(key);
                          return record.text("choice");
                        });
}

}  // namespace stickslip::testing
