// SPDX-License-Identifier: MIT
#pragma once

/// A data set as its own result, and what a comparison says about it.

#include "comparison/diagnosis/diagnosis.hpp"
#include "stickslip/data/case_file.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {

/// The data that are published, and a small package with a data set of each kind.
inline const data::ReferencePackage& published_package() {
  static const auto package = data::load_reference();
  return package;
}
inline const data::ReferencePackage& small_package() {
  static const auto package = data::load_reference(std::filesystem::path(STICKSLIP_SOURCE_DIRECTORY) /
                                                   "verification/tests/golden/reference");
  return package;
}

inline comparison::Settings with_tolerance(const std::string& quantity, double tolerance,
                                           std::optional<double> until = std::nullopt) {
  return {.tolerances = {{quantity, tolerance}}, .until = until, .events = {}};
}
inline comparison::Settings until(double time) { return {.tolerances = {}, .until = time, .events = {}}; }

inline comparison::Comparison::Quantity quantity_of(const comparison::Comparison& comparison,
                                                    const std::string& name) {
  return *std::ranges::find(comparison.quantities, name, &comparison::Comparison::Quantity::name);
}

inline std::size_t skipped_for(const comparison::Comparison::Quantity& quantity, const std::string& reason) {
  const auto found = std::ranges::find_if(
      quantity.skipped, [&](const auto& skipped) { return skipped.first.starts_with(reason); });
  return found == quantity.skipped.end() ? 0 : found->second;
}

/// A data set as its own result, or some of its columns, in which a test changes rows and cells.
class OwnCopy {
 public:
  OwnCopy(const data::ReferencePackage& package, const std::string& set,
          const std::vector<std::string>& columns = {})
      : package_(&package), reference_(comparison::read_reference(package, set)) {
    table.file = "mine.csv";
    table.lines.resize(reference().rows());
    std::iota(table.lines.begin(), table.lines.end(), 2);
    for (const data::Column& column : reference().columns)
      if (columns.empty() || std::ranges::count(columns, column.field.name) > 0)
        table.columns.push_back(column);
  }

  data::UserTable table;

  [[nodiscard]] const data::ReferenceTable& reference() const { return reference_.table; }
  [[nodiscard]] comparison::Reference& data_set() {
    return reference_;
  }  ///< of which a test changes rules and cells
  [[nodiscard]] std::vector<double>& operator[](const std::string& name) { return column(name).values; }
  [[nodiscard]] std::vector<std::string>& words(const std::string& name) { return column(name).text; }

  /// Keeps the rows of which the number satisfies a condition.
  OwnCopy& keep(const std::function<bool(std::size_t)>& is_kept) {
    for (std::size_t row = table.rows(); row-- > 0;) {
      if (is_kept(row)) continue;
      for_each_column([row](auto& cells) { cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(row)); });
    }
    return *this;
  }
  OwnCopy& keep_first(std::size_t count) {
    return keep([=](std::size_t row) { return row < count; });
  }
  OwnCopy& erase(std::size_t erased) {
    return keep([=](std::size_t row) { return row != erased; });
  }
  OwnCopy& repeat(std::size_t row) {
    for_each_column([row](auto& cells) {
      const auto cell = cells[row];
      cells.insert(cells.begin() + static_cast<std::ptrdiff_t>(row), cell);
    });
    return *this;
  }

  /// The comparison with the data set, that for one quantity, and what is said of what differs.
  [[nodiscard]] comparison::Comparison compared(const comparison::Settings& settings = {}) const {
    return comparison::compare(reference_, table, settings);
  }
  [[nodiscard]] comparison::Comparison::Quantity compared(const std::string& quantity,
                                                          const comparison::Settings& settings = {}) const {
    return quantity_of(compared(settings), quantity);
  }
  [[nodiscard]] std::vector<comparison::Diagnosis> diagnosed(
      const comparison::Settings& settings = {}, const std::function<void(double)>& progress = {}) const {
    return comparison::diagnose(compared(settings), *package_, reference(), table, progress);
  }

  /// Why it cannot be compared; "accepted" if it can.
  [[nodiscard]] std::string error_message(const comparison::Settings& settings = {}) const {
    return error_message_if_any<data::InputError>([&] { static_cast<void>(compared(settings)); })
        .value_or("accepted");
  }

 private:
  data::Column& column(const std::string& name) {
    return *std::ranges::find(table.columns, name, [](const auto& one) { return one.field.name; });
  }
  template <class Change>
  void for_each_column(const Change& change) {
    for (data::Column& one : table.columns) {
      change(one.text);
      change(one.values);
    }
    change(table.lines);
  }

  const data::ReferencePackage* package_;
  comparison::Reference reference_;
};

/// A data set of the small package, and one that is published.
inline OwnCopy own_copy(const std::string& set, const std::vector<std::string>& columns = {}) {
  return {small_package(), set, columns};
}
inline OwnCopy published_copy(const std::string& set, const std::vector<std::string>& columns = {}) {
  return {published_package(), set, columns};
}

/// The settings with the events of the same run.
inline comparison::Settings with_events(const OwnCopy& events) {
  return {.tolerances = {}, .until = {}, .events = events.table};
}

/// A published case with the mesh, the step and the threshold of the paper, with which `compare` runs wrong models
/// of damped cases.
inline data::Case with_the_settings_of_the_paper(const std::string& name) {
  const data::Case problem = data::load_case(name);
  return with_value(with(problem, data::load_case("paper").numerics), "excitation.duration",
                    problem.numerics.duration());
}

}  // namespace stickslip::testing
