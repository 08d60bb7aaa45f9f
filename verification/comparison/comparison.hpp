// SPDX-License-Identifier: MIT
#pragma once

/// The comparison of a user's results with the published reference data.

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "stickslip/data/reference.hpp"
#include "stickslip/data/user_table.hpp"

namespace stickslip::comparison {

/// The result of a comparison. With the error e of a point, the uncertainty u of the reference there and the
/// tolerance tol, all in the norm of the quantity, the point
/// - differs if e > tol + u;
/// - is undecided if it does not differ but u > tol;
/// - agrees otherwise.
///
/// A quantity differs if at least one of its points differs. It is undecided if no point differs but at least
/// one is undecided.
enum class Agreement { agrees, differs, undecided };

inline constexpr std::array<std::string_view, 3> agreement_names{"agrees", "differs", "undecided"};
[[nodiscard]] constexpr std::string_view to_string(Agreement agreement) noexcept {
  return agreement_names[static_cast<std::size_t>(agreement)];
}

/// The share of the range of a curve, of a history or of a sequence of events that a verdict needs.
constexpr double least_range_coverage = 0.9;

/// How far a result gets. It is strict if it agrees to the tolerances of the data set, whatever others are asked for. Else it
/// has the last level that its scaled error does not exceed, and no level if the file covers too little.
inline constexpr std::array<std::string_view, 5> level_names{"none", "1e-1", "1e-2", "1e-3", "strict"};
/// The scaled error that a level allows beyond the tolerances; with none no level is asked for.
inline constexpr std::array<double, 5> level_limits{0.0, 1e-1, 1e-2, 1e-3, 0.0};
constexpr std::size_t strict_level = level_names.size() - 1;

/// A data set to compare with, read once.
struct Reference {
  data::ReferenceTable table;
  std::optional<data::ReferenceTable> events{};  ///< of a history with stick and slip
};

/// Throws what data::read_table() throws.
[[nodiscard]] Reference read_reference(const data::ReferencePackage& package, const std::string& name);

/// A history of one's own in place of a data set: the displacements of tip and middle, which the file of `stickslip respond` has,
/// as smooth curves without a half-width and with a tolerance of 1 % of their range. Forces jump and are left out. Throws what
/// data::read_user_table() throws, to which is_quoted goes.
[[nodiscard]] Reference own_run(const std::filesystem::path& file, bool is_quoted = true);

struct Settings {
  /// Tolerances that replace those of the data set, by the quantity; "" for all quantities.
  std::map<std::string, double> tolerances;
  /// The level that is asked for, an index in level_names: a value also agrees if its scaled error does not exceed it, and is
  /// undecided only if its uncertainty exceeds it as well; so of words and events the share that is wrong. It does not hold for a
  /// quantity whose tolerance is replaced.
  std::size_t level{strict_level};
  std::optional<double> until;  ///< latest time to compare, s; it cannot extend the horizon of the data set
  std::optional<data::UserTable> events{};  ///< events of the same run, for a data set of the kind phases
  /// The first and the last number of rows of the data set that the file must have, counted from 1; empty: of all rows.
  std::vector<std::pair<std::size_t, std::size_t>> rows{};
};

struct Comparison {
  /// The compared points of one curve or of one sequence.
  struct Series {
    std::string group;             ///< such as "beam = paper"; empty if there is only one
    std::vector<double> abscissa;  ///< the row number if there is no abscissa
    std::vector<double> theirs, reference;
    std::vector<double> half_width;  ///< of the reference, interpolation included
    /// The largest difference that still agrees, in the unit of the quantity.
    std::vector<double> allowed;

    [[nodiscard]] bool differs_at(std::size_t i) const {
      return !(std::abs(theirs[i] - reference[i]) <= allowed[i]);  // NaN differs
    }
  };

  struct Quantity {
    std::string name, unit;
    data::Norm norm{};
    double tolerance{};
    double own_tolerance{};  ///< of the data set
    bool is_strict{true};    ///< agrees to own_tolerance
    /// The largest error beyond the half-width, over the range (norm range) or the largest |reference| of the group; of words
    /// and events the share that is wrong.
    double scaled_error{};
    std::size_t level{};  ///< index in level_names
    std::size_t required_level{strict_level};
    /// Error and uncertainty of the point with the largest e - u; empty if no point was compared.
    std::optional<double> error;
    std::optional<double> uncertainty;
    std::string where;
    Agreement agreement{};
    std::size_t compared{}, undecided{};
    /// Points that were not compared, with the reason, such as "beyond the horizon".
    std::vector<std::pair<std::string, std::size_t>> skipped;
    std::vector<Series> series;
  };

  std::string name, title;
  data::ComparisonKind kind{};
  std::string abscissa, abscissa_unit;  ///< of the series; empty if it is the row number
  Agreement agreement{};
  std::size_t level{};                       ///< the least of quantities and parts, an index in level_names
  std::size_t required_level{strict_level};  ///< Settings::level
  /// The share of what is asked for that the file covers: of the rows of a table, else of the range, the least of all
  /// groups; and the share that is needed. With less, what does not differ is undecided.
  double coverage{1.0}, required_coverage{1.0};
  /// The rows that the file has, of a curve or a sequence those of the groups that it begins, and all rows of the data set.
  std::size_t rows{}, all_rows{};
  std::string row_numbers;  ///< of those that it has, such as "1:12,15"
  std::vector<Quantity> quantities;
  std::vector<std::string> remarks;  ///< rows and columns that are missing on either side, as sentences
  double horizon = std::numeric_limits<double>::infinity();  ///< s; nothing later was compared
  std::vector<Comparison> parts;  ///< of each of several sequences of events; its name is that of the group
};

/// Compares the values of a user's table with a data set, point by point, according to the kind of the data
/// set:
/// - table: rows with the same primary key are compared. Words that differ are counted, also in a column that may hold certain
///   words only and is not named in the rule.
/// - curve: if the data set states an interpolation, the reference is evaluated at the user's abscissas by the
///   polynomial through its samples. The stated bound of its error and the amplified half-widths of the samples
///   count as uncertainty. If not, the user's samples are interpolated to the abscissas of the reference where
///   they are at least as dense, and else the reference is interpolated; the estimated error
///   (samples.hpp) counts as uncertainty. Abscissas coincide to 1e-9 of the range.
/// - events: the two sequences are aligned in time (match()). Missing and additional events are counted, and
///   times and positions of the pairs are compared. Before that, phases shorter than the shortest phase of the
///   data set are taken out of both. An event within tolerance of the horizon may be on either side of it.
///   Events of the reference after the last one of the user are undecided, unless a latest time is given.
/// - phases: like curve, but with samples of the same phase only. Points between the event times of the
///   reference and of the user are skipped, and points at which the two sequences of events are in different
///   phases. If the user's event times are unknown, points within the tolerance of the event times and within
///   one of the user's sampling intervals (but no more than the shortest phase) of an event of the reference are
///   skipped. A sample in a different phase outside these intervals is an error of the quantity "phase".
///
/// Nothing is said to agree if the file covers less than least_range_coverage or lacks a row or a group that it must have. A
/// compared point of a curve covers a fortieth of the range on either side of it.
///
/// Throws data::InputError for an unknown quantity of a tolerance, row, abscissa or word, for row numbers that are none or
/// of a data set that is one curve or sequence, and if nothing can be compared.
[[nodiscard]] Comparison compare(const Reference& reference, const data::UserTable& theirs,
                                 const Settings& settings = {});

}  // namespace stickslip::comparison
