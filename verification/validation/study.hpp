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

#include "studies/common/members.hpp"
#include "validation/estimators.hpp"

namespace stickslip::validation {

/// A record and the conditions under which it was taken, a row of records.csv. Those of the other experiment are 0.
struct SetPoint {
  std::string record;      ///< its name
  std::string experiment;  ///< paper-slider, friction-damper or strip
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

/// The figures read off the raw files below a folder, and those of figures.csv of the experiments that have no folder there. Throws
/// data::InputError if there is none at all, and if the digest of a file is not that of records.csv.
[[nodiscard]] FigureTable raw_figures(const std::filesystem::path& folder);

/// The experiments of records.csv that have no folder of raw files below a folder, each once.
[[nodiscard]] std::vector<std::string> experiments_without_records(const std::filesystem::path& folder);

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

/// What the code predicts now and predictions.csv does not hold as its latest entry, a sentence for each: a new prediction needs a
/// new entry with its reason.
[[nodiscard]] std::vector<std::string> unrecorded_predictions();

struct Comparison {
  std::string experiment, record, quantity, form;
  std::string unit;                ///< of all numbers; 1 for a pure one
  double measured{};               ///< D
  double measured_uncertainty{};   ///< u_D
  double predicted{};              ///< S
  double input_uncertainty{};      ///< u_input
  double numerical_uncertainty{};  ///< u_num
  bool blind{};  ///< predicted before the record was read: entry 1 of log.csv, no record of calibration

  [[nodiscard]] double error() const { return predicted - measured; }  ///< E = S - D
  [[nodiscard]] double uncertainty() const;  ///< u_val = √(u_D² + u_input² + u_num²)
  /// Whether |E| ≥ u_val: the error of the model lies in E ± 2 u_val. Otherwise nothing was resolved.
  [[nodiscard]] bool is_resolved() const;
  [[nodiscard]] bool contains_zero() const;  ///< whether E ± 2 u_val does
  /// What the use of the model requires: E ± 2 u_val within ± this part of D; 0 where it requires nothing. Written down after these
  /// comparisons and before any of a beam under axial load: 20 % for forces and energies, because a margin of the criterion between
  /// 0.8 and 1.2 is no verdict, and 5 % for frequencies and fall times, half of the distance from a resonance that is kept.
  [[nodiscard]] double required() const;
};

/// Every recorded prediction, that of its latest entry, in the order of the table.
[[nodiscard]] std::vector<Comparison> comparisons(const FigureTable& figures = measured_figures());

/// Bias and spread of one quantity, of all modes together, over the points of an experiment that are blind, or over those that are not.
struct Bias {
  std::string experiment, quantity, form;
  std::size_t points{}, resolved{}, beyond{};  ///< all; with |E| ≥ u_val; with zero outside E ± 2 u_val
  bool blind{};                                ///< Comparison::blind
  double mean{};                               ///< of E/D
  double spread{};                             ///< its standard deviation
  double resolved_mean{};                      ///< of E/D over the resolved points; 0 if there are none
  double required{};                           ///< Comparison::required()
  std::size_t within{};                        ///< of the points, those with E ± 2 u_val within it
};

[[nodiscard]] std::vector<Bias> biases(const std::vector<Comparison>& comparisons);

STICKSLIP_MEMBERS(Comparison, (experiment, "-"), (record, "-"), (quantity, "-"), (form, "-"), (unit, "-"),
                  (measured, "SI"), (measured_uncertainty, "SI"), (predicted, "SI"),
                  (input_uncertainty, "SI"), (numerical_uncertainty, "SI"), (error(), "SI"),
                  (uncertainty(), "SI"), (is_resolved(), "-"), (contains_zero(), "-"), (blind, "-"),
                  (required(), "1"))
STICKSLIP_MEMBERS(Bias, (experiment, "-"), (quantity, "-"), (form, "-"), (points, "1"), (resolved, "1"),
                  (beyond, "1"), (blind, "-"), (mean, "1"), (spread, "1"), (resolved_mean, "1"),
                  (required, "1"), (within, "1"))

}  // namespace stickslip::validation
