#pragma once

/// Somebody else's results against the published reference data.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "comparison/wrong_models.hpp"
#include "stickslip/data/reference.hpp"
#include "stickslip/data/user_table.hpp"

namespace stickslip::studies {

/// With e the error of a point, u the uncertainty of the reference there and tol the tolerance, all in the
/// norm of the quantity: a point differs if e > tol + u; it is undecided if it does not differ, but u > tol;
/// else it agrees. A quantity differs if one of its points does, and is undecided if none differs but one is
/// undecided.
enum class Agreement { agrees, differs, undecided };

/// "agrees", "differs", "undecided".
[[nodiscard]] std::string_view to_string(Agreement agreement) noexcept;

struct ComparisonSettings {
  /// A tolerance in place of that of the data set.
  struct Tolerance {
    std::string quantity;  ///< empty: of all
    double value{};
  };
  std::vector<Tolerance> tolerances;
  std::optional<double> until;  ///< s: compare nothing later, even if the horizon of the data set is
  std::optional<data::UserTable> events;  ///< of the same run, for a data set of the kind phases
  bool diagnose = true;                   ///< liken what differs to the wrong models
};

/// What was compared, with the verdict.
struct Comparison {
  struct Skipped {
    std::string reason;  ///< "beyond the horizon"
    std::size_t points{};
  };

  /// The points that were compared of one curve, or of one sequence.
  struct Series {
    std::string group;             ///< "beam = paper"; empty if there is only one
    std::vector<double> abscissa;  ///< the row number where there is none
    std::vector<double> theirs, reference;
    std::vector<double> half_width;  ///< of the reference, interpolation included
    std::vector<double> allowed;     ///< the largest difference that agrees, in the unit of the quantity
  };

  struct Quantity {
    std::string name, unit;
    data::Norm norm{};
    double tolerance{};
    /// Of the point that decides: the one with the largest e - u. Nothing if no point was compared.
    std::optional<double> error;
    std::optional<double> uncertainty;
    std::string where;
    Agreement agreement{};
    std::size_t compared{}, undecided{};
    std::vector<Skipped> skipped;
    std::vector<Series> series;
  };

  /// Which wrong model it looks like.
  struct Likeness {
    std::string group;
    std::string sentence;
    std::optional<Diagnosis> diagnosis;  ///< nothing if there can be none; the sentence says why
  };

  std::string name, title;
  data::ComparisonKind kind{};
  std::string abscissa, abscissa_unit;  ///< of the series; empty for row numbers
  Agreement agreement{};
  std::vector<Quantity> quantities;
  std::vector<std::string> remarks;  ///< what is missing on either side, in sentences
  std::vector<Likeness> likenesses;
};

/// Compares the values of a table with a data set, point by point.
///
/// table: rows by primary key. curve: at their abscissas, by Lagrange's polynomial through the reference's
/// samples, whose error bound and amplified half-widths count as uncertainty; where the data set knows no
/// interpolation the abscissas must coincide (to 1e-9). events: first the sequence of changes up to the
/// horizon, then times and positions of the common beginning; an event of a run that is within tolerance of
/// the horizon may lie on either side of it. phases: as curve, but from samples of the same phase only.
/// Between the reference's time of an event and theirs nothing is compared; if theirs is not known, nothing
/// within one of their sampling distances of the reference's. A sample in another phase outside these is an
/// error of the quantity "phase".
///
/// A difference is likened to the wrong models if the data set says which quantity it is. Their result counts
/// as being as uncertain as the tolerance allows.
///
/// Throws data::InputError for an unknown data set, quantity of a tolerance, row, abscissa or word, and if
/// nothing can be compared.
[[nodiscard]] Comparison compare(const data::ReferencePackage& package, const std::string& name,
                                 const data::UserTable& theirs, const ComparisonSettings& settings = {});

}  // namespace stickslip::studies
