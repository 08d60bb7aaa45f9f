// SPDX-License-Identifier: MIT
#include "record_file.hpp"

#include <algorithm>
#include <cmath>

#include "motion_shape.hpp"
#include "stickslip/data/csv_text.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/data/input_text.hpp"
#include "stickslip/data/units.hpp"

namespace stickslip::data {

namespace {

constexpr std::array<std::string_view, 4> si_units{"m", "m/s", "m/s^2", "N"};

class RecordReader {
 public:
  RecordReader(std::filesystem::path file, const RecordKeys& keys) : file_(std::move(file)), keys_(keys) {
    record_.quantity = keys.quantity;
  }

  [[nodiscard]] MotionRecord read() {
    record_.sha256 =
        read_lines(file_, limit::record_bytes.most, [this](std::string_view lines) { take(lines); });
    set_times();
    record_.samples.shrink_to_fit();
    return std::move(record_);
  }

 private:
  struct Source {
    std::size_t position;
    Unit unit;
  };

  void take(std::string_view lines) {
    const bool is_first = names_.empty();
    CsvReader csv(file_, lines, names_, lines_);
    if (is_first) find_columns(csv);
    while (const auto cells = csv.next_row()) {
      record_.samples.push_back(number(csv, samples_, *cells));
      if (!time_) continue;
      const double time = number(csv, *time_, *cells);
      if (!record_.times.empty() && !(time > record_.times.back()))
        throw InputError(csv.place(csv.line(), time_->position) + ": the time is " +
                         cells->at(time_->position) + ", but must be above that of the row before");
      record_.times.push_back(time);
    }
    lines_ = csv.lines();
  }

  void find_columns(const CsvReader& csv) {
    names_ = csv.names();
    const auto samples = column(csv, keys_.column);
    if (!samples) {
      std::vector<std::string> names;
      for (const std::string& name : names_) names.push_back(printable(name));
      throw InputError(csv.place(csv.line_of_names()) + ": the column " + printable(keys_.column) +
                       " is missing" + suggestion(keys_.column, names) + "; the file has " + joined(names));
    }
    record_.column = names_[samples->first];
    const auto& unit = keys_.unit ? keys_.unit : samples->second;
    if (!unit)
      throw FieldError(key_in(keys_.table, "unit"), "missing",
                       "given, as the name of the column " + printable(keys_.column) + " does not say it");
    record_.unit = *unit;
    samples_ = {samples->first,
                unit_of("unit", *unit, si_units.at(static_cast<std::size_t>(keys_.quantity)))};
    auto time = column(csv, "t");
    if (!time) time = column(csv, "time");
    if (time.has_value() == keys_.rate_hz.has_value())
      throw FieldError(key_in(keys_.table, "rate"), time ? shortest_text(*keys_.rate_hz) : "missing",
                       time ? "left out where the record has a column of time"
                            : "given where the record has no column t or time");
    if (time) time_ = {time->first, unit_of("file", time->second.value_or("s"), "s")};
  }

  // Where a column stands, and the unit that its name says.
  [[nodiscard]] std::optional<std::pair<std::size_t, std::optional<std::string>>> column(
      const CsvReader& csv, const std::string& name) const {
    std::optional<std::pair<std::size_t, std::optional<std::string>>> found;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      const auto header = header_named(names_[i], name);
      if (!header) continue;
      if (found) throw InputError(csv.place(csv.line_of_names(), i) + ": the column stands twice");
      found = {i, header->unit};
    }
    return found;
  }

  [[nodiscard]] Unit unit_of(std::string_view name, const std::string& text, std::string_view si) const {
    if (text == si) return {.si = si};
    const auto unit = unit_named(text);  // of g that of an acceleration
    if (!unit || unit->si != si)
      throw FieldError(key_in(keys_.table, name), printable(text), "a unit: " + units_convertible_to(si));
    return *unit;
  }

  [[nodiscard]] static double number(const CsvReader& csv, const Source& source,
                                     const CsvReader::Cells& cells) {
    const std::string& cell = cells[source.position];
    const auto number = csv.number(cell);
    if (!number || !std::isfinite(source.unit.to_si(*number)))
      throw InputError(csv.place(csv.line(), source.position) + ": the cell is '" + printable(cell) +
                       "', but must be a finite number");
    return source.unit.to_si(*number);
  }

  void set_times() {
    auto& times = record_.times;
    const std::size_t rows = record_.samples.size();
    if (!time_ || rows < 2) {
      record_.step = 1.0 / keys_.rate_hz.value_or(1.0);
      times.clear();
      return;
    }
    record_.begin = times.front();
    record_.step = (times.back() - times.front()) / static_cast<double>(rows - 1);
    for (double& time : times) time -= record_.begin;
    std::vector<double> steps(rows - 1);
    for (std::size_t i = 0; i + 1 < rows; ++i) steps[i] = times[i + 1] - times[i];
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::ranges::nth_element(steps, middle);
    double off = 0.0;
    for (std::size_t i = 0; i + 1 < rows; ++i) {
      const double step = times[i + 1] - times[i];
      if (step > 1.5 * *middle || *middle > 1.5 * step)
        throw InputError(file_.string() + ": the time step behind row " + std::to_string(i + 1) + " is " +
                         short_text(step) + " s, but must be near the usual one, " + short_text(*middle) +
                         " s: the record has a gap");
      off = std::max(off, std::abs(times[i] - static_cast<double>(i) * record_.step));
    }
    if (off > 0.01 * record_.step) return times.shrink_to_fit();
    times = {};
  }

  std::filesystem::path file_;
  RecordKeys keys_;
  CsvReader::Cells names_;
  std::size_t lines_{};
  Source samples_{};
  std::optional<Source> time_;
  MotionRecord record_;
};

}  // namespace

MotionRecord read_record(const std::filesystem::path& file, const RecordKeys& keys) {
  return RecordReader(file, keys).read();
}

PowerSpectrum read_spectrum_unit(const std::string& table, const std::string& unit) {
  const std::string allowed =
      "that of a density, as \"g^2/Hz\", \"(m/s^2)^2/Hz\", \"(m/s)^2/Hz\", \"mm^2/Hz\" or \"N^2/Hz\"";
  constexpr std::string_view end = "^2/Hz";
  std::string_view inner = unit;
  if (!inner.ends_with(end)) throw FieldError(key_in(table, "unit"), printable(unit), allowed);
  inner.remove_suffix(end.size());
  if (inner.starts_with('(') && inner.ends_with(')')) inner = inner.substr(1, inner.size() - 2);
  const auto known = unit_named(inner);  // of g that of an acceleration
  const auto quantity = known ? std::ranges::find(si_units, known->si) : si_units.end();
  if (quantity == si_units.end()) throw FieldError(key_in(table, "unit"), printable(unit), allowed);
  const double one = known->to_si(1.0);
  PowerSpectrum spectrum;
  spectrum.quantity = static_cast<AmplitudeOf>(std::distance(si_units.begin(), quantity));
  spectrum.unit = unit;
  spectrum.to_si = one * one;
  return spectrum;
}

void read_spectrum(const std::filesystem::path& file, const std::string& table,
                   const std::optional<std::string>& column, PowerSpectrum& spectrum) {
  const std::string text = read_table_text(file);
  spectrum.sha256 = sha256(text);
  CsvReader csv(file, text);
  std::optional<std::size_t> frequency, density;
  std::string unit = "Hz";
  for (std::size_t i = 0; i < csv.names().size(); ++i) {
    auto header = header_named(csv.names()[i], "f");
    if (!header) header = header_named(csv.names()[i], "frequency");
    if (header && !frequency) {
      frequency = i;
      unit = header->unit.value_or(unit);
    } else if (column ? header_named(csv.names()[i], *column).has_value() : csv.names().size() == 2) {
      density = i;
    }
  }
  if (!frequency)
    throw InputError(csv.place(csv.line_of_names()) +
                     ": the column f or frequency is missing; the file has " + joined(csv.names()));
  if (!density)
    throw FieldError(key_in(table, "column"), column ? printable(*column) : "missing",
                     "one of the columns of " + file.filename().string() + ", " + joined(csv.names()));
  const auto hertz = unit_named(unit);
  if (!hertz || hertz->si != "Hz")
    throw InputError(csv.place(csv.line_of_names(), *frequency) + ": the unit is " + printable(unit) +
                     ", but must be one of frequency, as Hz");
  while (const auto cells = csv.next_row()) {
    const auto number = [&](std::size_t at) {
      const auto value = csv.number(cells->at(at));
      if (!value || !std::isfinite(*value))
        throw InputError(csv.place(csv.line(), at) + ": the cell is '" + printable(cells->at(at)) +
                         "', but must be a finite number");
      return *value;
    };
    spectrum.points.push_back({hertz->to_si(number(*frequency)), number(*density) * spectrum.to_si});
  }
}

}  // namespace stickslip::data
