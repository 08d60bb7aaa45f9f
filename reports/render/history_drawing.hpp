// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "render/drawing.hpp"
#include "studies/analyses/slip_readouts.hpp"
#include "studies/history/history.hpp"

namespace stickslip::report {

/// A drawing of a history (figures/history.gp) in bounded memory: all rows or, of more than two for each of the columns of a figure, the
/// smallest and the largest values in each column, those in stick and those in slip apart, in the order in which they come.
class HistoryDrawing {
 public:
  /// Of about so many rows, `from` to `to` (s).
  HistoryDrawing(const data::Case& problem, double from, double to, double rows);

  void add(const studies::HistoryRow& row);

  /// The drawing with the slips of the history as bands or, where the contact is held, its first slip as a line, as the bytes of a file.
  /// Beside it are the windows of `readouts`, if there are any (figures/nvh.gp). Throws as draw() does.
  [[nodiscard]] std::string text(const studies::History& history, bool is_held, const Look& look,
                                 const studies::SlipReadouts* readouts = nullptr);

 private:
  static constexpr double columns = 1000.0;
  // Base, tip, midspan and wall (m), f and the force on the load of a model (N).
  using Values = std::array<double, 6>;
  // Of the rows of a column with the same state.
  struct Extremes {
    data::ContactState state{};
    double first{}, last{};  // s
    Values smallest{}, largest{};
    std::array<bool, std::tuple_size_v<Values>>
        falls{};  // whether the smallest value comes after the largest one
  };

  [[nodiscard]] Values values_of(const studies::HistoryRow& row) const;
  void end_column();
  [[nodiscard]] CsvTable slips_of(const studies::History& history) const;

  const data::Case& problem_;
  double from_, to_, width_;  // s; the width of a column, 0: a column for each row
  std::optional<double> column_;
  std::vector<Extremes> extremes_;  // of each state in the column, in the order in which they come
  CsvTable table_;
};

/// A drawing of the force that would hold the contact under a general motion, with its first excess of the limit (s).
[[nodiscard]] std::string held_drawing(const data::Case& problem, const std::optional<double>& first_excess,
                                       const Look& look);

/// A drawing of read-outs: the history in the window with the most slips, the first of these, and a point for each window with slips.
[[nodiscard]] std::string readouts_drawing(const data::Case& problem, const studies::History& history,
                                           const studies::SlipReadouts& readouts, const Look& look);

}  // namespace stickslip::report
