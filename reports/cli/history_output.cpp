// SPDX-License-Identifier: MIT
#include "history_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "command.hpp"
#include "render/drawing.hpp"
#include "stickslip/data/case_file.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/spectrum.hpp"

namespace stickslip::cli {

namespace {

std::string csv_line(const studies::HistoryRow& row) {
  std::string line = data::shortest_text(row.time);
  for (const double value : {row.base_displacement, row.tip_displacement, row.midspan_displacement,
                             row.sliding_velocity, row.friction_force}) {
    if (!std::isfinite(value))
      data::throw_overflow(fmt::format("the history is not finite at {} s", data::shortest_text(row.time)));
    line += "," + data::shortest_text(value + 0.0);  // -0 becomes 0
  }
  return fmt::format("{},{}\n", line, data::to_string(row.state));
}

}  // namespace

HistoryOutput::HistoryOutput(const data::Case& problem, const HistoryFiles& files)
    : problem_(problem), files_(files), output_(files.output) {
  open_if_named(spectrum_, files.spectrum);
  open_if_named(events_, files.events);
  open_figure(figure_, files.figure);
}

void HistoryOutput::add(const studies::HistoryRow& row) {
  std::string text = csv_line(row);
  if (rows_ == 0)  // not before, so that an error in the problem writes nothing
    text =
        "time_s,base_displacement_m,tip_displacement_m,midspan_displacement_m,sliding_velocity_m_per_s,"
        "friction_force_N,state\n" +
        text;
  output_.write(text);
  if (figure_) drawn_ += text;
  if (spectrum_) {
    tip_displacements_.push_back(row.tip_displacement);
    friction_forces_.push_back(row.friction_force);
  }
  time_ = row.time;
  ++rows_;
  largest_force_ = std::max(largest_force_, std::abs(row.friction_force));
}

void HistoryOutput::finish(const studies::History& history) {
  output_.commit();
  if (events_) {
    events_->write("time_s,change,tip_displacement_m\n");
    for (const data::ContactEvent& event : history.events)
      events_->write(fmt::format("{},{},{}\n", data::shortest_text(event.time), data::to_string(event.change),
                                 data::shortest_text(event.position)));
    events_->commit();
  }
  if (spectrum_) write_spectrum();
  if (!figure_) return;
  const report::CsvTable values = report::values_table({{"limit", studies::friction_limit(problem_), "N"}});
  figure_->write(report::drawing_of("history", figure_format(files_.figure),
                                    {{"history.csv", drawn_}, {"history-values.csv", values.text()}}));
  figure_->commit();
}

void HistoryOutput::write_spectrum() {
  const double row_step = static_cast<double>(files_.every) * problem_.numerics.time_step();
  const auto rows = studies::spectrum_rows(problem_, files_.every);
  spectrum_->write("frequency_Hz,tip_displacement_m,friction_force_N\n");
  for (const auto& line : studies::spectrum_of(tip_displacements_, friction_forces_, rows, row_step))
    spectrum_->write(fmt::format("{},{},{}\n", data::shortest_text(line.frequency_hz),
                                 data::shortest_text(line.tip_displacement),
                                 data::shortest_text(line.friction_force)));
  spectrum_->commit();
}

void HistoryOutput::discard() const noexcept {
  output_.discard();
  for (const auto* file : {&events_, &figure_, &spectrum_})
    if (*file) (*file)->discard();
}

}  // namespace stickslip::cli
