// SPDX-License-Identifier: MIT
#pragma once

/// What Won, Lee and Chung (2018) print: every number with its digits and its place, and the verdicts of Figs. 4 and 5, from
/// data/paper/printed-numbers.toml. The claims and errata of the folder are read by the tests and the report.

#include <array>
#include <cstddef>
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
[[nodiscard]] constexpr std::string_view to_string(ClaimVerdict verdict) noexcept {
  constexpr std::array<std::string_view, 4> names{"holds", "holds with correction", "does not hold",
                                                  "not determined"};
  return names[static_cast<std::size_t>(verdict)];
}

/// In the order of the page. Throws InputError if the file is missing or malformed, an id stands twice, or a
/// value is not what its printed digits say.
[[nodiscard]] std::vector<PrintedNumber> printed_numbers();

/// In the order of the figures. Throws InputError if the file is missing or malformed.
[[nodiscard]] std::vector<PrintedVerdict> printed_verdicts();

/// The printed number with this id. Throws std::out_of_range naming the id.
[[nodiscard]] PrintedNumber printed_number(const std::string& id);

}  // namespace stickslip::data
