#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "stickslip/certified/beam.hpp"
#include "stickslip/certified/real.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/reference/package.hpp"

namespace stickslip::reference {

/// A case as it is published: its decimals are exact.
struct NamedBeam {
  std::string name;  ///< of the case file
  data::Case problem;
  certified::Beam beam;
};

[[nodiscard]] NamedBeam named_beam(const std::string& name);

/// The beams of the data package: the paper's, a steel strip, a soft short one, one near buckling, one in
/// tension.
[[nodiscard]] const std::vector<NamedBeam>& beams();

/// The decimal that stands in a case file.
[[nodiscard]] certified::Rational exact(double value);

/// The cells of a row.
class Row {
 public:
  Row& text(std::string cell);
  Row& number(double value);
  Row& number(int value);
  /// Value and radius, two cells. Throws std::runtime_error unless the radius is below 1e-28 of the value, or
  /// of `scale` if that is larger.
  Row& enclosed(const certified::Real& value, double scale = 0.0);
  /// Value and radius, two cells: the value to the digits that the radius leaves, and one more.
  Row& converged(double value, double radius);

  operator std::vector<std::string>() const { return cells_; }

 private:
  std::vector<std::string> cells_;
};

/// Columns: a key, a value with its radius, an exact value.
[[nodiscard]] data::Field word(std::string name, std::string description);
[[nodiscard]] data::Field integer(std::string name, std::string description);
[[nodiscard]] data::Field exact_number(std::string name, std::string unit, std::string description);
/// Adds the column and that of its radius.
void add_value(std::vector<data::Field>& fields, const std::string& name, const std::string& unit,
               const std::string& description, data::ValueClass value_class);

/// "stickslip 1.0.0".
[[nodiscard]] std::string software();

/// Without fields and rows.
[[nodiscard]] DataSet data_set(std::string name, std::string path, std::string title,
                               std::string description);

/// Compared row by row, or along an abscissa without interpolation.
[[nodiscard]] data::ComparisonRule by_rows(std::vector<data::ComparedValue> values);
[[nodiscard]] data::ComparisonRule along(std::string abscissa, std::vector<data::ComparedValue> values);

/// Diagnosed in a case, or for each beam in the case of its name.
[[nodiscard]] data::DiagnosisRule in_case(std::string quantity, std::string name, std::string abscissa,
                                          std::string value);
[[nodiscard]] data::DiagnosisRule for_each_beam(std::string quantity, std::string abscissa,
                                                std::string value);

[[nodiscard]] data::Provenance enclosed_by(std::string method, std::string settings,
                                           std::vector<std::string> checks);

// The recipes.
[[nodiscard]] DataSet beam_table();
[[nodiscard]] DataSet stick_frequencies();
[[nodiscard]] DataSet slip_frequencies();
[[nodiscard]] DataSet critical_loads();
[[nodiscard]] DataSet participation();
[[nodiscard]] DataSet static_shapes();
[[nodiscard]] DataSet mode_shapes();
[[nodiscard]] DataSet stick_history_of_ten_modes();
[[nodiscard]] DataSet stick_history();
[[nodiscard]] DataSet friction_maxima();
[[nodiscard]] DataSet critical_amplitudes();
[[nodiscard]] DataSet classification();
[[nodiscard]] DataSet length_force_ratios();
[[nodiscard]] DataSet stick_slip_events();
[[nodiscard]] DataSet stick_slip_history();
[[nodiscard]] DataSet undamped_history(
    std::string_view name);  ///< of the data set, one of those in recipes()
[[nodiscard]] DataSet undamped_sticks();
[[nodiscard]] DataSet single_mass_events();
[[nodiscard]] DataSet friction_powers();
[[nodiscard]] DataSet manufactured_motion();

}  // namespace stickslip::reference
