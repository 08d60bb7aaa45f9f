// SPDX-License-Identifier: MIT
#pragma once

/// Validation in the form of ASME V&V 20 (2009): measured figures D, predictions S and the comparison error E = S - D.
///
/// The tables in data/measurements hold the records, the figures read off them, and the predictions. A prediction that has been
/// recorded stays: a new one is a new entry, with a date and a reason, in log.csv.

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "validation/estimators.hpp"

namespace stickslip::validation {

/// A record and the conditions under which it was taken, a row of records.csv. Those of the other experiment are 0.
struct SetPoint {
  std::string record;      ///< its name
  std::string experiment;  ///< paper-slider or friction-damper
  std::string file;        ///< below the folder of all records
  std::string sha256;      ///< of the file
  std::string role;        ///< calibration or prediction
  double stiffness{};      ///< k, N/m
  double speed{};          ///< V, m/s
  double tension{};        ///< of the band, lbf
  double frequency{};      ///< Hz

  [[nodiscard]] Slider slider() const { return {.stiffness = stiffness, .speed = speed}; }
};

/// The rows of records.csv. Throws data::InputError for a table that lacks a column.
[[nodiscard]] std::vector<SetPoint> set_points();

/// By record and quantity, in SI units and parts of the weight.
using FigureTable = std::map<std::pair<std::string, std::string>, Figure>;

/// The figures that stand in figures.csv.
[[nodiscard]] FigureTable measured_figures();

/// The figures read off the raw file of a record. Throws data::InputError if its digest is not that of records.csv.
[[nodiscard]] Figures read_raw(const SetPoint& point, const std::filesystem::path& folder);

/// What a model says of a quantity of a record.
struct Prediction {
  std::string record, quantity;
  std::string form;  ///< of the model
  double value{};
  double input_uncertainty{};      ///< u_input, by the calibration and the conditions
  double numerical_uncertainty{};  ///< u_num
  int entry{};                     ///< in log.csv
};

/// The predictions as the code makes them from the figures of the records of calibration, without those of the others; of
/// the damper's others the amplitude, which is prescribed.
[[nodiscard]] std::vector<Prediction> predictions();

/// Those of predictions.csv. Throws data::InputError for an entry whose rows are not those that log.csv has the digest of.
[[nodiscard]] std::vector<Prediction> recorded_predictions();

/// A prediction beside the figure measured.
struct Comparison {
  std::string experiment;
  Prediction prediction;  ///< S, u_input, u_num
  Figure measured;        ///< D, u_D

  [[nodiscard]] double error() const;        ///< E = S - D
  [[nodiscard]] double uncertainty() const;  ///< u_val = √(u_D² + u_input² + u_num²)
  /// Whether |E| ≥ u_val: the error of the model lies in E ± 2 u_val. Otherwise nothing was resolved.
  [[nodiscard]] bool is_resolved() const;
  [[nodiscard]] bool contains_zero() const;  ///< whether E ± 2 u_val does
};

/// Every recorded prediction, that of its latest entry, in the order of the table.
[[nodiscard]] std::vector<Comparison> comparisons();

/// Bias and spread of one quantity over all points of an experiment.
struct Bias {
  std::string experiment, quantity, form;
  std::size_t points{}, resolved{}, beyond{};  ///< all; with |E| ≥ u_val; with zero outside E ± 2 u_val
  double mean{};                               ///< of E/D
  double spread{};                             ///< its standard deviation
};

[[nodiscard]] std::vector<Bias> biases(const std::vector<Comparison>& comparisons);

}  // namespace stickslip::validation
