// SPDX-License-Identifier: MIT
#include "support/ledgers.hpp"

#include <toml++/toml.h>
#include <stdexcept>

#include "stickslip/data/case_file.hpp"

namespace stickslip::testing {
namespace {

template <class Row, class Read>
std::vector<Row> rows_of(const char* file, const char* key, Read read) {
  const toml::table ledger = toml::parse_file((data::data_directory() / "paper" / file).string());
  std::vector<Row> rows;
  for (const auto& node : *ledger[key].as_array())
    rows.push_back(read([&](const char* name) { return (*node.as_table())[name].value_or(std::string()); }));
  return rows;
}

data::ClaimVerdict verdict_of(const std::string& id, const std::string& text) {
  using enum data::ClaimVerdict;
  for (const auto verdict : {holds, holds_with_correction, does_not_hold, not_determined})
    if (text == data::to_string(verdict)) return verdict;
  throw std::runtime_error(id + " has the verdict '" + text + "'");
}

}  // namespace

std::vector<Claim> claims() {
  return rows_of<Claim>("claims.toml", "claim", [](const auto& text) {
    return Claim{text("id"), verdict_of(text("id"), text("verdict")), text("correction"), text("figure"),
                 text("erratum")};
  });
}

std::vector<Erratum> errata() {
  return rows_of<Erratum>("errata.toml", "erratum", [](const auto& text) {
    return Erratum{text("id"), verdict_of(text("id"), text("verdict"))};
  });
}

std::vector<std::string> unstated_choices() {
  return rows_of<std::string>("errata.toml", "unstated", [](const auto& text) { return text("choice"); });
}

}  // namespace stickslip::testing
