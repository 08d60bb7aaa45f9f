// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "output_file.hpp"
#include "studies/history/history.hpp"

namespace stickslip::cli {

/// The files of a history; an empty name is no file.
struct HistoryFiles {
  std::string output = "-";
  std::string events;
  std::string spectrum;
  std::string figure;
  long every = 1;  ///< rows are so many time steps apart
};

/// Writes a history, its rows as they come.
class HistoryOutput {
 public:
  /// Opens the files. Throws as OutputFile and open_figure().
  HistoryOutput(const data::Case& problem, const HistoryFiles& files);

  /// Throws data::InputError if the row is not finite.
  void add(const studies::HistoryRow& row);

  /// Writes the changes of contact, spectra and figure, and puts all files in place.
  void finish(const studies::History& history);

  void discard() const noexcept;

  [[nodiscard]] double time() const { return time_; }  ///< of the last row, s; any thread may ask
  [[nodiscard]] long rows() const { return rows_; }
  [[nodiscard]] double largest_force() const { return largest_force_; }  ///< max |f| over the rows, N

 private:
  void write_spectrum();

  const data::Case& problem_;
  const HistoryFiles& files_;
  OutputFile output_;
  std::optional<OutputFile> events_, spectrum_, figure_;
  std::atomic<double> time_{};
  long rows_{};
  double largest_force_{};
  std::string drawn_;                                        // the rows, for the figure
  std::vector<double> tip_displacements_, friction_forces_;  // of the rows, for the spectra
};

}  // namespace stickslip::cli
