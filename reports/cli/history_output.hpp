// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "command.hpp"
#include "render/history_drawing.hpp"
#include "studies/history/history.hpp"

namespace stickslip::cli {

/// Which rows of a history are written, and to which files; an empty name is no file.
struct HistoryOptions {
  std::optional<long> every;   ///< time steps from row to row, else by `rate`
  std::optional<double> rate;  ///< rows in a second at least, else by studies::usual_row_step()
  double from{};               ///< s
  std::optional<double> to;    ///< s, else the end
  std::string output = "-", events, spectrum, figure;
  std::vector<std::string> columns;  ///< names of studies::further_columns
};

class HistoryOutput {
 public:
  /// Of a contact that `is_held`, or follows the slip. Opens the files. Throws data::InputError for rows that a history cannot have, and as Outputs::open().
  HistoryOutput(const data::Case& problem, const HistoryOptions& options, bool is_held, Outputs& outputs);

  /// Takes what comes each `step` time steps, the row step or a divisor of it. Throws data::InputError if a row that is written is
  /// not finite.
  void add(const studies::HistoryRow& row, long step);

  /// Writes the changes of contact, spectra and figure, and puts all files in place.
  void finish(const studies::History& history);

  [[nodiscard]] double time() const { return time_; }  ///< of the last row, s; any thread may ask
  [[nodiscard]] long row_step() const { return row_step_; }
  [[nodiscard]] long rows() const { return rows_; }
  [[nodiscard]] double largest_force() const { return largest_force_; }            ///< max |f|, N
  [[nodiscard]] double largest_deflection() const { return largest_deflection_; }  ///< max |y(L) - h|, m
  [[nodiscard]] const studies::Bending& bending() const { return bending_; }       ///< of rows with positions
  /// None without --spectrum. Complete after finish().
  [[nodiscard]] const std::optional<studies::SpectrumWindow>& window() const { return window_; }
  [[nodiscard]] const studies::Spectrum& spectrum() const { return spectrum_; }

 private:
  [[nodiscard]] std::string spectrum_text();

  const data::Case& problem_;
  bool is_beam_, is_held_;
  std::vector<studies::FurtherColumn> columns_;
  Outputs& outputs_;
  report::Progress* progress_{};
  double from_, to_;
  long row_step_;
  std::optional<report::HistoryDrawing> drawing_;
  std::optional<studies::SpectrumWindow> window_;
  studies::Spectrum spectrum_;
  std::vector<double> tip_displacements_, friction_forces_;

  std::atomic<double> time_{};
  long taken_{}, rows_{};
  double largest_force_{}, largest_deflection_{};
  studies::Bending bending_;
};

}  // namespace stickslip::cli
