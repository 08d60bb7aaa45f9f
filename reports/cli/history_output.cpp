// SPDX-License-Identifier: MIT
#include "history_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "stickslip/data/case_file.hpp"

namespace stickslip::cli {

namespace {

// y(L/2) is a beam's alone.
using Columns = std::vector<studies::FurtherColumn>;

std::string column_names(bool with_midspan, const Columns& further) {
  std::string names = fmt::format(
      "time_s,base_displacement_m,tip_displacement_m,{}sliding_velocity_m_per_s,friction_force_N,state",
      with_midspan ? "midspan_displacement_m," : "");
  for (const auto& column : further) names += fmt::format(",{}", column.heading);
  return names + "\n";
}

std::string csv_line(const studies::HistoryRow& row, bool with_midspan, const Columns& further) {
  std::string line = data::shortest_text(row.time);
  const auto add = [&](double value) {
    if (!std::isfinite(value))
      data::throw_overflow(fmt::format("the history is not finite at {} s", data::shortest_text(row.time)));
    line += "," + data::shortest_text(value + 0.0);  // -0 becomes 0
  };
  add(row.base_displacement);
  add(row.tip_displacement);
  if (with_midspan) add(row.midspan_displacement);
  add(row.sliding_velocity);
  add(row.friction_force);
  line += fmt::format(",{}", data::to_string(row.state));
  for (const auto& column : further) add(row.*column.value);
  return line + "\n";
}

// Each once, in the order of the list. Throws data::FieldError for one of beams with another structure.
Columns further_columns_of(const data::Case& problem, const std::vector<std::string>& names) {
  Columns columns;
  for (const studies::FurtherColumn& column : studies::further_columns) {
    if (std::ranges::find(names, column.name) == names.end()) continue;
    if (column.of_beams_alone && problem.model() != nullptr)
      throw data::FieldError("--columns", std::string(column.name),
                             "left out for a [model], whose base is no clamp");
    columns.push_back(column);
  }
  return columns;
}

double end_of(const data::Case& problem, const HistoryOptions& options) {
  const double duration = problem.numerics.duration(), to = options.to.value_or(duration);
  if (to > options.from && to <= duration) return to;
  throw data::FieldError(options.to ? "--to" : "--from", options.to ? to : options.from,
                         options.to
                             ? fmt::format("above --from, {} s, and at most the duration, {} s",
                                           data::shortest_text(options.from), data::shortest_text(duration))
                             : fmt::format("below the duration, {} s", data::shortest_text(duration)));
}

long row_step_of(const data::Case& problem, const HistoryOptions& options, double span) {
  if (options.every) return *options.every;
  if (!options.rate) return studies::usual_row_step(problem, span);
  if (!(*options.rate >= 1e-9 && *options.rate <= 1e12))
    throw data::FieldError("--rate", *options.rate, "from 1e-09 to 1e+12 (1/s)");
  const double steps = (1.0 + 1e-9) / (*options.rate * problem.numerics.time_step());
  return std::max(1L, static_cast<long>(std::min(steps, 1e9)));
}

}  // namespace

HistoryOutput::HistoryOutput(const data::Case& problem, const HistoryOptions& options, bool is_held,
                             Outputs& outputs)
    : problem_(problem),
      is_beam_(problem.model() == nullptr),
      is_held_(is_held),
      columns_(further_columns_of(problem, options.columns)),
      outputs_(outputs),
      from_(options.from),
      to_(end_of(problem, options)),
      row_step_(row_step_of(problem, options, to_ - from_)) {
  if (!options.spectrum.empty()) window_ = studies::spectrum_window(problem, row_step_);
  outputs.open({{"--output", options.output},
                {"--events", options.events},
                {"--spectrum", options.spectrum},
                {"--figure", options.figure}});
  progress_ = &outputs.progress();
  if (!options.figure.empty())
    drawing_.emplace(problem, from_, to_,
                     (to_ - from_) / (static_cast<double>(row_step_) * problem.numerics.time_step()));
}

void HistoryOutput::add(const studies::HistoryRow& row, long step) {
  constexpr long between_looks = 1000;  // at the clock
  time_ = row.time;
  largest_force_ = std::max(largest_force_, std::abs(row.friction_force));
  largest_deflection_ = std::max(largest_deflection_, std::abs(row.tip_displacement - row.base_displacement));
  if (!row.displacement.empty()) bending_.include(row, problem_.beam().length());
  const long taken = taken_++;
  const bool is_row = taken % (row_step_ / step) == 0;
  if (is_row || taken % between_looks == 0) (*progress_)(row.time / problem_.numerics.duration());
  if (!is_row) return;
  if (window_) {
    tip_displacements_.push_back(row.tip_displacement);
    friction_forces_.push_back(row.friction_force);
  }
  const double rounding = 1e-9 * problem_.numerics.time_step();
  if (row.time < from_ - rounding || row.time > to_ + rounding) return;
  // The header not before, so that an error in the problem writes nothing.
  outputs_.file("--output")
      .write((rows_++ == 0 ? fmt::format("# {}\n{}", outputs_.heading("Motion of the contact"),
                                         column_names(is_beam_, columns_))
                           : "") +
             csv_line(row, is_beam_, columns_));
  if (drawing_) drawing_->add(row);
}

void HistoryOutput::finish(const studies::History& history) {
  outputs_.commit("--output");
  outputs_.write_table("--events", [&] {
    std::string text = "# Changes of contact\ntime_s,change,tip_displacement_m\n";
    for (const data::ContactEvent& event : history.events)
      text += fmt::format("{},{},{}\n", data::shortest_text(event.time), data::to_string(event.change),
                          data::shortest_text(event.position));
    return text;
  });
  outputs_.write_table("--spectrum", [&] { return spectrum_text(); });
  outputs_.draw(problem_.name,
                [&](const report::Look& look) { return drawing_->text(history, is_held_, look); });
}

std::string HistoryOutput::spectrum_text() {
  spectrum_ = studies::spectrum_of(tip_displacements_, friction_forces_, *window_,
                                   static_cast<double>(row_step_) * problem_.numerics.time_step());
  std::string text = fmt::format("# Spectrum{}\nfrequency_Hz,tip_displacement_m,friction_force_N\n",
                                 spectrum_.is_flat_top ? ", flat-top window" : "");
  for (const auto& line : spectrum_.lines)
    text += fmt::format("{},{},{}\n", data::shortest_text(line.frequency_hz),
                        data::shortest_text(line.tip_displacement), data::shortest_text(line.friction_force));
  return text;
}

}  // namespace stickslip::cli
