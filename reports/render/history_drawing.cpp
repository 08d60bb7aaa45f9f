// SPDX-License-Identifier: MIT
#include "render/history_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "studies/common/problem_parameter.hpp"
#include "studies/history/method.hpp"

namespace stickslip::report {

HistoryDrawing::HistoryDrawing(const data::Case& problem, double from, double to, double rows)
    : problem_(problem),
      from_(from),
      to_(to),
      width_(rows > 2.0 * columns ? (to - from) / columns : 0.0),
      table_("Motion of the contact",
             "time [s], base [m], tip [m], midspan [m], wall [m], force [N], load [N], state [-]") {}

HistoryDrawing::Values HistoryDrawing::values_of(const studies::HistoryRow& row) const {
  const auto* base = problem_.general_motion();
  const auto& wall = problem_.contact.wall_motion;
  return {row.base_displacement,
          row.tip_displacement,
          row.midspan_displacement,
          (wall ? wall->displacement(row.time) : 0.0) +
              (problem_.contact.wall.moves_with_base() ? row.base_displacement : 0.0),
          row.friction_force,
          base != nullptr && base->is_force() ? -base->acceleration(row.time) : 0.0};  // of 1 kg
}

void HistoryDrawing::add(const studies::HistoryRow& row) {
  const double column = width_ > 0.0 ? std::floor((row.time - from_) / width_) : row.time;
  if (column != column_) end_column();
  column_ = column;
  const Values values = values_of(row);
  const auto found = std::ranges::find(extremes_, row.state, &Extremes::state);
  if (found == extremes_.end()) {
    extremes_.push_back({row.state, row.time, row.time, values, values});
    return;
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] < found->smallest[i]) found->falls[i] = true;
    if (values[i] > found->largest[i]) found->falls[i] = false;
    found->smallest[i] = std::min(found->smallest[i], values[i]);
    found->largest[i] = std::max(found->largest[i], values[i]);
  }
  found->last = row.time;
}

void HistoryDrawing::end_column() {
  for (Extremes& of : extremes_) {
    for (std::size_t i = 0; i < of.falls.size(); ++i)
      if (of.falls[i]) std::swap(of.smallest[i], of.largest[i]);
    const auto write = [&](double time, const Values& values) {
      table_.add(time);
      for (const double value : values) table_.add(value);
      table_.add(data::to_string(of.state)).end_row();
    };
    write(of.first, of.smallest);
    if (of.last > of.first) write(of.last, of.largest);
  }
  extremes_.clear();
}

// From an onset to the capture after it, joined if less than a column is between them. A history that begins in slip has a capture
// first.
CsvTable HistoryDrawing::slips_of(const studies::History& history) const {
  CsvTable slips("Slips", "begin [s], end [s]");
  double begin = history.events.empty() ? to_ : from_;
  std::pair band{from_, from_};  // gnuplot takes no empty table
  const auto add = [&](double end) {
    const std::pair next{std::max(begin, from_), std::min(end, to_)};
    begin = to_;
    if (!(next.second > next.first)) return;
    if (next.first - band.second < width_) {
      band.second = next.second;
      return;
    }
    slips.add_numbers({band.first, band.second});
    band = next;
  };
  for (const data::ContactEvent& event : studies::onsets_and_captures(history.events)) {
    if (event.change == data::ContactChange::capture)
      add(event.time);
    else
      begin = event.time;
  }
  add(to_);
  slips.add_numbers({band.first, band.second});
  return slips;
}

std::string HistoryDrawing::text(const studies::History& history, bool is_held, const Look& look,
                                 const studies::SlipReadouts* readouts) {
  end_column();
  const auto* motion = problem_.general_motion();
  const bool is_load = motion != nullptr && motion->is_force();
  const auto flag = [](const char* name, bool is_so) {
    return FigureData::Value{name, is_so ? 1.0 : 0.0, "1"};
  };
  const auto& [friction, compliance, wall, wall_motion] = problem_.contact;
  std::vector<FigureData::Value> values{
      {"limit", studies::friction_limit(problem_), "N"},
      {"force_name", 0.0, "-", is_held ? "holding force" : "friction force"},
      {"base_name", 0.0, "-", wall.moves_with_base() && !wall_motion ? "base and wall" : "base"},
      {"wall_speed", wall.speed(), "m/s"},
      {"first_slip", history.first_slip.value_or(0.0), "s"},
      flag("follows_slip", !is_held),
      flag("has_first_slip", is_held && history.first_slip),
      flag("has_base", !problem_.is_force()),
      flag("has_wall", wall_motion.has_value()),
      flag("has_load", is_load)};
  std::map<std::string, std::string> tables{{"history.csv", table_.text()},
                                            {"history-slips.csv", slips_of(history).text()}};
  if (readouts != nullptr) {
    CsvTable windows("Windows", "begin [s], slips [1], peak to peak [m], drawn [1]");
    double longest = 0.0, widest = 0.0;
    for (const studies::ReadoutWindow& each : readouts->windows) {
      windows.add_numbers({each.begin, each.slips, each.range(), each.begin == from_ ? 1.0 : 0.0});
      if (each.slips == 0.0) continue;
      longest = std::max(longest, readouts->window / each.slips);
      widest = std::max(widest, each.range());
    }
    tables.emplace("history-windows.csv", windows.text());
    values.insert(values.end(),
                  {{"window", readouts->window, "s"}, {"longest", longest, "s"}, {"widest", widest, "m"}});
  }
  tables.emplace("history-values.csv", values_table(values).text());
  return drawing_of(readouts == nullptr ? "history" : "nvh", look, tables);
}

std::string held_drawing(const data::Case& problem, const std::optional<double>& first_excess,
                         const Look& look) {
  constexpr double most_rows = 2e5;  // of a long record
  const double duration = problem.numerics.duration(), step = problem.numerics.time_step();
  const long every = std::max(studies::usual_row_step(problem, duration),
                              static_cast<long>(std::min(duration / (most_rows * step), 1e9)));
  HistoryDrawing drawing(problem, 0.0, duration, duration / (static_cast<double>(every) * step));
  studies::History history =
      studies::closed_form().run(problem, {.every = every}, {}, [&](const auto& row) { drawing.add(row); });
  history.first_slip = first_excess;
  return drawing.text(history, true, look);
}

std::string readouts_drawing(const data::Case& problem, const studies::History& history,
                             const studies::SlipReadouts& readouts, const Look& look) {
  const double from = std::ranges::max_element(readouts.windows, {}, &studies::ReadoutWindow::slips)->begin,
               to = from + readouts.window;
  HistoryDrawing drawing(problem, from, to, readouts.window / readouts.row_step);
  for (const studies::HistoryRow& row : history.rows)
    if (row.time >= from && row.time <= to) drawing.add(row);
  return drawing.text(history, false, look, &readouts);
}

}  // namespace stickslip::report
