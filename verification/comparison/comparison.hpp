// SPDX-License-Identifier: MIT
#pragma once

/// The comparison of a user's results with the published reference data.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "comparison/wrong_models.hpp"
#include "stickslip/data/reference.hpp"
#include "stickslip/data/user_table.hpp"

namespace stickslip::studies {

/// The result of a comparison. With the error e of a point, the uncertainty u of the reference there and the
/// tolerance tol, all in the norm of the quantity, the point
/// - differs if e > tol + u;
/// - is undecided if it does not differ but u > tol;
/// - agrees otherwise.
///
/// A quantity differs if at least one of its points differs. It is undecided if no point differs but at least
/// one is undecided.
enum class Agreement { agrees, differs, undecided };

/// The result in one word: "agrees", "differs" or "undecided".
[[nodiscard]] std::string_view to_string(Agreement agreement) noexcept;

/// The share of the range of a curve, of a history or of a sequence of events that a verdict needs.
constexpr double least_range_coverage = 0.9;
/// The share of the rows of a table. It counts in each part of the table that the file begins, such as a beam.
constexpr double least_table_coverage = 0.1;

/// The settings of a comparison.
struct ComparisonSettings {
  /// A tolerance that replaces that of the data set.
  struct Tolerance {
    std::string quantity;  ///< the quantity; empty for all quantities
    double value{};
  };
  std::vector<Tolerance> tolerances;
  std::optional<double> until;  ///< latest time to compare, s; it cannot extend the horizon of the data set
  std::optional<data::UserTable> events;  ///< events of the same run, for a data set of the kind phases
  /// Whether it is searched what quantities that differ look like.
  bool diagnose = true;
  /// Is told the completed fraction of a search that takes longer.
  std::function<void(double)> progress{};
};

/// The result of a comparison and the compared values.
struct Comparison {
  struct Skipped {
    std::string reason;  ///< such as "beyond the horizon"
    std::size_t points{};
  };

  /// The compared points of one curve or of one sequence.
  struct Series {
    std::string group;             ///< such as "beam = paper"; empty if there is only one
    std::vector<double> abscissa;  ///< the row number if there is no abscissa
    std::vector<double> theirs, reference;
    std::vector<double> half_width;  ///< of the reference, interpolation included
    /// The largest difference that still agrees, in the unit of the quantity.
    std::vector<double> allowed;
  };

  struct Quantity {
    std::string name, unit;
    data::Norm norm{};
    double tolerance{};
    /// Error and uncertainty of the point with the largest e - u; empty if no point was compared.
    std::optional<double> error;
    std::optional<double> uncertainty;
    std::string where;
    Agreement agreement{};
    std::size_t compared{}, undecided{};
    std::vector<Skipped> skipped;
    std::vector<Series> series;
  };

  /// What one quantity of one group looks like: a mistake that the numbers show, another data set, or the wrong
  /// model that is nearest to the result.
  struct Likeness {
    std::string group;     ///< the first of several with the same sentence
    std::string quantity;  ///< the name of the compared quantity
    std::string sentence;
    std::optional<Diagnosis> diagnosis;  ///< empty if no diagnosis is possible; the sentence gives the reason
  };

  std::string name, title;
  data::ComparisonKind kind{};
  std::string abscissa, abscissa_unit;  ///< of the series; empty if it is the row number
  Agreement agreement{};
  /// The share of what is asked for that the file covers, the least of all groups of which it has rows; and the
  /// share that is needed. With less, what does not differ is undecided.
  double coverage{1.0}, required_coverage{};
  std::vector<Quantity> quantities;
  std::vector<std::string> remarks;  ///< rows and columns that are missing on either side, as sentences
  std::vector<Likeness> likenesses;
};

/// Compares the values of a user's table with a data set, point by point, according to the kind of the data
/// set:
/// - table: rows with the same primary key are compared. Words that differ are counted.
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
/// Nothing is said to agree if the file covers less than least_range_coverage or least_table_coverage. A
/// compared point of a curve covers a fortieth of the range on either side of it.
///
/// It is then searched what quantities that differ look like (likeness.hpp). The tolerance is taken as the
/// uncertainty of the user's values.
///
/// Throws data::InputError for an unknown data set, quantity of a tolerance, row, abscissa or word, and if
/// nothing can be compared.
[[nodiscard]] Comparison compare(const data::ReferencePackage& package, const std::string& name,
                                 const data::UserTable& theirs, const ComparisonSettings& settings = {});

}  // namespace stickslip::studies
