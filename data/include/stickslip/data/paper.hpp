// SPDX-License-Identifier: MIT
#pragma once

/// What Won, Lee and Chung (2018) print: every number with its digits and its place, the verdicts of Figs. 4
/// and 5, every claim that can be tested with what became of it, the errata, and what the paper leaves
/// unstated. Files: data/paper/printed-numbers.toml, data/paper/claims.toml and data/paper/errata.toml.

#include <string>
#include <string_view>
#include <vector>

namespace stickslip::data {

/// A number as the paper prints it.
struct PrintedNumber {
  std::string id;            ///< "frequency.stick.1"
  double value{};            ///< in SI units
  std::string unit;          ///< SI unit of value, "Hz"; "1" if it has none
  std::string printed;       ///< the digits on the page: "25.0", "3.03 x 10^4", "(1/12) x 10^-6"
  std::string printed_unit;  ///< the unit on the page, "mm"
  bool is_given{};           ///< an input that the authors chose (exact as printed); else a result (rounded)
  double half_digit{};       ///< half a unit of the last printed digit, in SI units: a result's own accuracy
  std::string place;         ///< "Sect. 5, text on Fig. 13"
  std::string meaning;       ///< one sentence
  std::string erratum;       ///< id of the erratum that corrects or explains it ("E1"), or empty
};

/// A verdict of Figs. 4 and 5.
struct PrintedVerdict {
  double frequency_hz{};  ///< Hz
  double amplitude{};     ///< A0, m
  std::string verdict;    ///< "stick" or "stick-slip"
  std::string figure;     ///< "4a"
};

/// What became of a claim, an erratum or a printed number: one scale for all of them.
enum class ClaimVerdict {
  holds,                  ///< as printed
  holds_with_correction,  ///< once a slip of the pen is put right: a symbol, sign, unit, word or reference
  does_not_hold,          ///< as printed: something else does
  not_determined  ///< by what the paper states: with one choice of what it leaves open it holds, with another not
};

/// "holds", "holds with correction", "does not hold" or "not determined".
[[nodiscard]] std::string_view to_string(ClaimVerdict verdict) noexcept;

/// One row of the errata ledger.
struct Erratum {
  std::string id;  ///< "E1"
  std::string place;
  std::string printed;
  std::string holds;
  std::string established;  ///< how
  ClaimVerdict verdict{};   ///< of the printed text; never holds
};

/// Something that a recomputation needs and the paper does not say.
struct Unstated {
  std::string subject;
  std::string choice;  ///< what is used here
  std::string reason;
};

/// A statement of the paper that can be true or false.
struct Claim {
  std::string id;     ///< "fig6.generally-decreases"
  std::string place;  ///< "Sect. 3, text on Fig. 6"
  std::string claim;  ///< a short quotation or a close paraphrase
  std::string how;    ///< one sentence: how it is tested, and what a qualitative word is taken to mean
  ClaimVerdict verdict{};
  std::string correction;  ///< what holds instead; empty if the claim holds
  std::string figure;   ///< the report's figure or table that shows it, by its label, "fig:search", or empty
  std::string erratum;  ///< id of the erratum about it ("E10"), or empty
};

/// In the order of the page. Throws InputError if the file is missing or malformed, an id stands twice, or a
/// value is not what its printed digits say.
[[nodiscard]] std::vector<PrintedNumber> printed_numbers();

/// In the order of the figures. Throws InputError if the file is missing or malformed.
[[nodiscard]] std::vector<PrintedVerdict> printed_verdicts();

/// E1, E2, ... Throws InputError if the file is missing or malformed, or an id stands twice.
[[nodiscard]] std::vector<Erratum> errata();

/// In the order of the page. Throws InputError if the file is missing or malformed, an id stands twice, a
/// correction is missing or not called for, or an erratum does not exist.
[[nodiscard]] std::vector<Claim> claims();

/// Throws InputError if the file is missing or malformed.
[[nodiscard]] std::vector<Unstated> unstated();

/// The printed number with this id. Throws std::out_of_range naming the id.
[[nodiscard]] PrintedNumber printed_number(const std::string& id);

}  // namespace stickslip::data
