// SPDX-License-Identifier: MIT
#include "validation/study.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "stickslip/data/case_file.hpp"
#include "stickslip/data/csv_text.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/data/input_text.hpp"

namespace stickslip::validation {

namespace {

constexpr std::size_t longest_file = 50'000'000;

using Row = std::map<std::string, std::string>;

std::filesystem::path table(const std::string& name) {
  return data::data_directory() / "measurements" / name;
}

std::vector<Row> rows_of(const std::string& name) {
  const std::string text = data::read_table_text(table(name));
  data::CsvReader reader(table(name), text);
  std::vector<Row> rows;
  while (const auto cells = reader.next_row()) {
    Row row;
    for (std::size_t i = 0; i < cells->size(); ++i) row[reader.names()[i]] = (*cells)[i];
    rows.push_back(std::move(row));
  }
  return rows;
}

const std::string& cell(const Row& row, const std::string& column) {
  const auto found = row.find(column);
  if (found == row.end()) throw data::InputError("a table of measurements lacks the column " + column);
  return found->second;
}

double number(const Row& row, const std::string& column) {
  const auto value = data::finite_number(cell(row, column));
  if (!value)
    throw data::InputError("a table of measurements has no number in the column " + column + ": " +
                           cell(row, column));
  return *value;
}

// Record, quantity and form.
using Key = std::tuple<std::string, std::string, std::string>;

Key key_of(const Prediction& one) { return {one.record, one.quantity, one.form}; }

std::string unit_of(const std::string& quantity) {
  static const std::map<std::string, std::string> units{
      {"period", "s"}, {"fall_time", "s"}, {"slip_force", "N"}, {"peak_force", "N"}, {"energy", "J"}};
  const auto found = units.find(quantity);
  return found != units.end() ? found->second : quantity.starts_with("frequency") ? "Hz" : "1";
}

// The lines of predictions.csv that belong to an entry, as they stand.
std::string lines_of_entry(const std::string& entry) {
  const std::string text = data::read_bounded(table("predictions.csv"), longest_file);
  std::string lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (text.compare(begin, entry.size() + 1, entry + ",") == 0)
      lines += text.substr(begin, end - begin) + "\n";
    begin = end + 1;
  }
  return lines;
}

}  // namespace

std::vector<SetPoint> set_points() {
  std::vector<SetPoint> points;
  for (const Row& row : rows_of("records.csv"))
    points.push_back({cell(row, "record"), cell(row, "experiment"), cell(row, "file"), cell(row, "sha256"),
                      cell(row, "role"), number(row, "stiffness"), number(row, "speed"),
                      number(row, "tension"), number(row, "frequency")});
  return points;
}

FigureTable measured_figures() {
  FigureTable figures;
  for (const Row& row : rows_of("figures.csv"))
    figures[{cell(row, "record"), cell(row, "quantity")}] = {number(row, "value"), number(row, "uncertainty"),
                                                             static_cast<std::size_t>(number(row, "count"))};
  return figures;
}

std::vector<std::string> experiments_without_records(const std::filesystem::path& folder) {
  std::vector<std::string> all;
  for (const SetPoint& point : set_points()) {
    std::error_code none;  // a name that is too long is not there either
    if (!std::filesystem::exists((folder / point.file).parent_path(), none) &&
        std::ranges::find(all, point.experiment) == all.end())
      all.push_back(point.experiment);
  }
  return all;
}

FigureTable raw_figures(const std::filesystem::path& folder) {
  FigureTable all = measured_figures();
  const std::vector<std::string> absent = experiments_without_records(folder);
  bool is_read = false;
  for (const SetPoint& point : set_points()) {
    if (std::ranges::find(absent, point.experiment) != absent.end()) continue;
    const std::filesystem::path file = folder / point.file;
    is_read = true;
    if (data::sha256(data::read_bounded(file, longest_file)) != point.sha256)
      throw data::InputError(file.string() + ": is not the file that records.csv has the digest of");
    const Figures figures = point.experiment == "paper-slider"
                                ? read_slider(read_slider_record(file), point.slider())
                            : point.experiment == "strip" ? read_strip(read_spectrum(file))
                                                          : read_damper(read_damper_record(file));
    for (const auto& [quantity, figure] : figures) all[{point.record, quantity}] = figure;
  }
  if (!is_read)
    throw data::InputError(folder.string() + ": holds no folder of an experiment that records.csv names");
  return all;
}

std::vector<Prediction> recorded_predictions() {
  for (const Row& row : rows_of("log.csv"))
    if (data::sha256(lines_of_entry(cell(row, "entry"))) != cell(row, "sha256"))
      throw data::InputError("predictions.csv: the rows of entry " + cell(row, "entry") +
                             " are not those that log.csv has the digest of");
  std::vector<Prediction> all;
  for (const Row& row : rows_of("predictions.csv"))
    all.push_back({cell(row, "record"), cell(row, "quantity"), cell(row, "form"), number(row, "value"),
                   number(row, "u_input"), number(row, "u_num"), static_cast<int>(number(row, "entry"))});
  return all;
}

std::vector<std::string> unrecorded_predictions() {
  // The rows hold six digits of a value and two of an uncertainty.
  const auto near = [](double made, double recorded, double relative) {
    return std::abs(made - recorded) <= relative * std::abs(recorded) + 1e-12;
  };
  std::map<Key, Prediction> latest;
  for (const Prediction& one : recorded_predictions()) latest[key_of(one)] = one;
  std::vector<std::string> all;
  for (const Prediction& one : predictions()) {
    const auto found = latest.find(key_of(one));
    if (found == latest.end() || !near(one.value, found->second.value, 2e-5) ||
        !near(one.input_uncertainty, found->second.input_uncertainty, 0.06) ||
        !near(one.numerical_uncertainty, found->second.numerical_uncertainty, 0.06))
      all.push_back(one.record + ", " + one.quantity + ", " + one.form + ": " + std::to_string(one.value) +
                    " is not recorded");
    if (found != latest.end()) latest.erase(found);
  }
  for (const auto& [key, one] : latest)
    all.push_back(one.record + ", " + one.quantity + ", " + one.form +
                  ": recorded, but not predicted any more");
  return all;
}

double Comparison::uncertainty() const {
  return std::hypot(measured_uncertainty, input_uncertainty, numerical_uncertainty);
}

bool Comparison::is_resolved() const { return std::abs(error()) >= uncertainty(); }

bool Comparison::contains_zero() const { return std::abs(error()) <= 2.0 * uncertainty(); }

double Comparison::required() const {
  if (quantity.starts_with("frequency") || quantity == "fall_time") return 0.05;
  return quantity.find("force") != std::string::npos || quantity == "energy" ? 0.2 : 0.0;
}

std::vector<Comparison> comparisons(const FigureTable& figures) {
  std::map<std::string, SetPoint> points;
  for (const SetPoint& point : set_points()) points[point.record] = point;
  std::vector<Comparison> all;
  std::map<Key, std::size_t> places;
  for (const Prediction& one : recorded_predictions()) {
    const auto [place, is_new] = places.try_emplace(key_of(one), all.size());
    if (is_new) all.emplace_back();
    const Figure& figure = figures.at({one.record, one.quantity});
    all[place->second] = {points.at(one.record).experiment,
                          one.record,
                          one.quantity,
                          one.form,
                          unit_of(one.quantity),
                          figure.value,
                          figure.uncertainty,
                          one.value,
                          one.input_uncertainty,
                          one.numerical_uncertainty,
                          one.entry == 1 && points.at(one.record).role == "prediction"};
  }
  return all;
}

std::vector<Bias> biases(const std::vector<Comparison>& comparisons) {
  std::vector<Bias> all;
  std::map<std::tuple<std::string, std::string, std::string, bool>, std::vector<const Comparison*>> groups;
  for (const Comparison& one : comparisons)
    groups[{one.experiment, one.quantity.substr(0, one.quantity.find_last_not_of("_0123456789") + 1),
            one.form, !one.blind}]
        .push_back(&one);
  for (const auto& [key, group] : groups) {
    Bias bias{.experiment = std::get<0>(key),
              .quantity = std::get<1>(key),
              .form = std::get<2>(key),
              .points = group.size(),
              .blind = !std::get<3>(key),
              .required = group.front()->required()};
    const auto n = static_cast<double>(group.size());
    for (const Comparison* one : group) {
      bias.mean += one->error() / one->measured / n;
      if (one->is_resolved()) ++bias.resolved, bias.resolved_mean += one->error() / one->measured;
      if (!one->contains_zero()) ++bias.beyond;
      if (std::abs(one->error()) + 2.0 * one->uncertainty() <= one->required() * std::abs(one->measured))
        ++bias.within;
    }
    if (bias.resolved > 0) bias.resolved_mean /= static_cast<double>(bias.resolved);
    for (const Comparison* one : group)
      bias.spread += std::pow(one->error() / one->measured - bias.mean, 2) / std::max(1.0, n - 1.0);
    bias.spread = std::sqrt(bias.spread);
    all.push_back(bias);
  }
  return all;
}

}  // namespace stickslip::validation
