#pragma once

/// What Won, Lee and Chung (2018) print: every number with its digits and its place, the verdicts of Figs. 4
/// and 5, the errata, and what the paper leaves unstated.
/// Files: data/paper/printed-numbers.toml and data/paper/errata.toml.

#include <string>
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

/// One row of the errata ledger.
struct Erratum {
  std::string id;  ///< "E1"
  std::string place;
  std::string printed;
  std::string holds;
  std::string established;  ///< how
};

/// Something that a recomputation needs and the paper does not say.
struct Unstated {
  std::string subject;
  std::string choice;  ///< what is used here
  std::string reason;
};

/// In the order of the page. Throws InputError if the file is missing or malformed, an id stands twice, or a
/// value is not what its printed digits say.
[[nodiscard]] std::vector<PrintedNumber> printed_numbers();

/// In the order of the figures. Throws InputError if the file is missing or malformed.
[[nodiscard]] std::vector<PrintedVerdict> printed_verdicts();

/// E1, E2, ... Throws InputError if the file is missing or malformed, or an id stands twice.
[[nodiscard]] std::vector<Erratum> errata();

/// Throws InputError if the file is missing or malformed.
[[nodiscard]] std::vector<Unstated> unstated();

/// The printed number with this id. Throws std::out_of_range naming the id.
[[nodiscard]] PrintedNumber printed_number(const std::string& id);

}  // namespace stickslip::data
