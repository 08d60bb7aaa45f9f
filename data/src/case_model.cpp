// SPDX-License-Identifier: MIT
#include "case_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include "matrix_file.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/data/input_text.hpp"

namespace stickslip::data {

namespace {

constexpr std::array<std::string_view, 3> direction_names{"x", "y", "z"};
constexpr double millimetres = 1e3;  // N/mm in N/m, t in kg, N s/mm in N s/m

// Degrees of freedom as a key names them.
struct Selection {
  std::string path;             // "model.base"
  std::vector<int> numbers;     // rows from 1, or nodes
  std::string node_file;        // in place of nodes
  std::vector<int> directions;  // of nodes, 1 is x; none of rows
  std::vector<double> weights;  // none: equal shares

  bool operator==(const Selection&) const = default;
  [[nodiscard]] bool by_nodes() const noexcept { return !directions.empty(); }
  [[nodiscard]] bool is_weighted() const { return path == "model.contact" || path == "model.load"; }

  [[noreturn]] void refuse(const std::string& value) const {
    throw FieldError(
        path, value,
        is_weighted()
            ? "a row from 1, or { rows = [41, 43], weights = [0.5, 0.5] }, or { nodes = [37], direction "
              "= \"z\" }" +
                  std::string(path == "model.contact" ? ": a case has one contact" : "")
            : "rows from 1, as [1, 2], or { nodes = [37] or \"set.nam\", direction = \"z\" or [\"x\", "
              "\"y\", \"z\"] }");
  }
};

std::vector<int> integers_in(const Selection& of, const toml::node& node) {
  std::vector<int> numbers;
  const auto take = [&](const toml::node& element) {
    const auto* integer = element.as_integer();
    if (integer == nullptr || integer->get() < 1 || !std::in_range<int>(integer->get()))
      of.refuse(describe(element));
    numbers.push_back(static_cast<int>(integer->get()));
  };
  if (const auto* list = node.as_array())
    for (const toml::node& element : *list) take(element);
  else
    take(node);
  if (numbers.empty()) of.refuse("empty");
  return numbers;
}

std::vector<int> directions_in(const Selection& of, const toml::node& node) {
  std::vector<int> directions;
  const auto take = [&](const toml::node& element) {
    const auto* name = element.as_string();
    const auto* const found =
        name == nullptr ? direction_names.end() : std::ranges::find(direction_names, name->get());
    if (found == direction_names.end()) of.refuse("given with direction " + describe(element));
    directions.push_back(static_cast<int>(found - direction_names.begin()) + 1);
  };
  if (const auto* list = node.as_array())
    for (const toml::node& element : *list) take(element);
  else
    take(node);
  if (directions.empty()) of.refuse("given without a direction");
  return directions;
}

void read_table(const toml::table& table, const std::string& place, Selection& of) {
  for (const auto& [key, value] : table) {
    if (key == "rows") {
      of.numbers = integers_in(of, value);
    } else if (key == "nodes") {
      if (const auto* name = value.as_string())
        of.node_file = name->get();
      else
        of.numbers = integers_in(of, value);
    } else if (key == "direction") {
      of.directions = directions_in(of, value);
    } else if (key == "weights" && of.is_weighted()) {
      of.weights = numbers_of(of.path, {}, entry_of(value, place));
    } else {
      of.refuse("given with " + printable(key.str()));
    }
  }
  if (table.contains("rows") == table.contains("nodes")) of.refuse("given without either of rows and nodes");
  if (table.contains("nodes") != of.by_nodes())
    of.refuse(of.by_nodes() ? "given with direction and rows" : "given with nodes and no direction");
}

std::optional<Selection> selection_of(const std::string& path, const Entries& entries) {
  const auto found = entries.find(path);
  if (found == entries.end()) return std::nullopt;
  const Entry& entry = found->second;
  Selection of{path, {}, {}, {}, {}};
  if (const auto* row = std::get_if<std::int64_t>(&entry.value))
    of.numbers = integers_in(of, toml::value<std::int64_t>(*row));
  else if (const auto* list = std::get_if<toml::array>(&entry.value); list != nullptr && !of.is_weighted())
    of.numbers = integers_in(of, *list);
  else if (const auto* table = std::get_if<toml::table>(&entry.value))
    read_table(*table, entry.place, of);
  else
    of.refuse(entry.description);
  return of;
}

// All that [model] says.
struct ModelKeys {
  std::map<std::string, std::string> files;  // names, by keys
  std::optional<Selection> base, fixed, contact, load;
  double unit{1.0};

  bool operator==(const ModelKeys&) const = default;
};

ModelKeys keys_of(const Entries& entries) {
  ModelKeys keys;
  for (const char* path :
       {"model.mass_matrix", "model.stiffness_matrix", "model.damping_matrix", "model.dofs"})
    if (const auto found = entries.find(path); found != entries.end()) {
      const auto* name = std::get_if<std::string>(&found->second.value);
      if (name == nullptr) throw FieldError(path, found->second.description, "the name of a file");
      keys.files.emplace(path, *name);
    }
  keys.base = selection_of("model.base", entries);
  keys.fixed = selection_of("model.fixed", entries);
  keys.contact = selection_of("model.contact", entries);
  keys.load = selection_of("model.load", entries);
  for (const auto& of : {keys.base, keys.fixed, keys.contact, keys.load})
    if (of && !of->node_file.empty()) keys.files.emplace(of->path, of->node_file);
  if (const auto found = entries.find("model.units"); found != entries.end())
    keys.unit = name_of("model.units", found->second, {"m", "mm"}) == "mm" ? millimetres : 1.0;
  for (const auto& [path, name] : keys.files)
    if (!is_inside(name))
      throw FieldError(path, printable(name), "a file in the folder of the case or below, without \"..\"");
  return keys;
}

// Throws InputError for what is missing.
void require_complete(const std::filesystem::path& case_file, const ModelKeys& keys) {
  const auto require = [&](bool is_there, std::string_view path, std::string_view why) {
    if (!is_there)
      throw InputError(case_file.string() + ": " + std::string(path) +
                       " is missing, but a case must hold it" + std::string(why));
  };
  require(keys.files.contains("model.mass_matrix"), "model.mass_matrix", " beside model.stiffness_matrix");
  require(keys.files.contains("model.stiffness_matrix"), "model.stiffness_matrix",
          " beside model.mass_matrix");
  require(keys.contact.has_value(), "model.contact", " where [model] names matrices");
  require(keys.base || keys.load, "model.base", " unless excitation.force acts on model.load");
}

// Makes the structure from the texts of its files.
class StructureReader {
 public:
  StructureReader(const ModelKeys& keys, std::map<std::string, std::pair<std::string, std::string>> texts)
      : keys_(keys), texts_(std::move(texts)) {}

  [[nodiscard]] StructureMatrices read() {
    if (const auto found = texts_.find("model.dofs"); found != texts_.end()) {
      const auto all = degrees_of_freedom_in(found->second.first, found->second.second);
      for (std::size_t row = 0; row < all.size(); ++row) row_of_.emplace(all[row], static_cast<int>(row));
      made_.rows = static_cast<int>(all.size());
    }
    made_.stiffness = matrix("model.stiffness_matrix");
    made_.mass = matrix("model.mass_matrix");
    if (texts_.contains("model.damping_matrix")) made_.damping = matrix("model.damping_matrix");
    for (const WeightedRow& of : rows_of(keys_.base)) made_.base.push_back(of.row);
    for (const WeightedRow& of : rows_of(keys_.fixed)) made_.fixed.push_back(of.row);
    require_apart("model.fixed", made_.fixed, "model.base", made_.base);
    hold_other_directions();
    made_.contact = rows_of(keys_.contact);
    made_.load = rows_of(keys_.load);
    for (const auto& [path, all] :
         {std::pair{"model.contact", &made_.contact}, {"model.load", &made_.load}}) {
      std::vector<int> rows;
      for (const WeightedRow& of : *all) rows.push_back(of.row);
      require_apart(path, rows, "model.base", made_.base);
      require_apart(path, rows, keys_.fixed ? "model.fixed" : "the held directions of model.base",
                    made_.fixed);
    }
    require_unit_sum();
    return std::move(made_);
  }

 private:
  std::vector<MatrixEntry> matrix(const std::string& path) {
    const auto& [file, text] = texts_.at(path);
    SymmetricMatrix read = matrix_in(file, text, row_of_.empty() ? std::nullopt : std::optional(made_.rows));
    if (made_.rows == 0) made_.rows = read.rows;
    if (read.rows != made_.rows)
      throw InputError(file + ": has " + std::to_string(read.rows) + " rows, but must have " +
                       std::to_string(made_.rows) + " as " +
                       texts_.at(row_of_.empty() ? "model.stiffness_matrix" : "model.dofs").first);
    for (MatrixEntry& entry : read.entries) entry.value *= keys_.unit;
    return std::move(read.entries);
  }

  std::vector<int> nodes_of(const Selection& of) {
    if (row_of_.empty())
      throw FieldError(of.path, "given by nodes", "given by rows where model.dofs is missing");
    if (of.node_file.empty()) return of.numbers;
    const auto& [file, text] = texts_.at(of.path);
    return node_set_in(file, text);
  }

  std::vector<WeightedRow> rows_of(const std::optional<Selection>& selection) {
    if (!selection) return {};
    const Selection& of = *selection;
    std::vector<WeightedRow> rows;
    for (const int node : of.by_nodes() ? nodes_of(of) : std::vector<int>())
      for (const int direction : of.directions) {
        const auto found = row_of_.find({node, direction});
        if (found == row_of_.end())
          throw FieldError(of.path,
                           "node " + std::to_string(node) + " in " +
                               std::string(direction_names.at(static_cast<std::size_t>(direction) - 1)),
                           "a degree of freedom of model.dofs: *BOUNDARY takes out what it holds");
        rows.push_back({found->second});
      }
    if (!of.by_nodes())
      for (const int row : of.numbers) rows.push_back({row - 1});
    std::set<int> different;
    for (const auto& [row, weight] : rows)
      if (row >= made_.rows || !different.insert(row).second)
        throw FieldError(
            of.path, "row " + std::to_string(row + 1) + (row < made_.rows ? " twice" : ""),
            row < made_.rows ? "different rows" : "rows from 1 to " + std::to_string(made_.rows));
    if (!of.weights.empty() && of.weights.size() != rows.size())
      throw FieldError(of.path, "given with " + std::to_string(of.weights.size()) + " weights",
                       "given with " + std::to_string(rows.size()) + ", one for each row");
    for (std::size_t i = 0; i < rows.size(); ++i)
      rows[i].weight = of.weights.empty() ? 1.0 / static_cast<double>(rows.size()) : of.weights[i];
    return rows;
  }

  static void require_apart(const std::string& path, const std::vector<int>& rows, std::string_view other,
                            const std::vector<int>& others) {
    for (const int row : rows)
      if (std::ranges::find(others, row) != others.end())
        throw FieldError(path, "row " + std::to_string(row + 1), "a row apart from " + std::string(other));
  }

  // Of the nodes of the base.
  void hold_other_directions() {
    if (!keys_.base || !keys_.base->by_nodes()) return;
    std::set<int> held(made_.fixed.begin(), made_.fixed.end());
    for (const int node : nodes_of(*keys_.base))
      for (int direction = 1; direction <= 6; ++direction)
        if (const auto found = row_of_.find({node, direction});
            found != row_of_.end() && std::ranges::find(made_.base, found->second) == made_.base.end())
          held.insert(found->second);
    made_.fixed.assign(held.begin(), held.end());
  }

  void require_unit_sum() const {
    double sum = 0.0;
    for (const WeightedRow& of : made_.contact) sum += of.weight;
    if (!(std::abs(sum - 1.0) <= 1e-9))
      throw FieldError("model.contact", "given with weights of sum " + shortest_text(sum),
                       "given with weights of sum 1");
    for (const WeightedRow& of : made_.load)
      if (!std::isfinite(of.weight)) throw FieldError("model.load", of.weight, "of finite weights");
  }

  const ModelKeys& keys_;
  std::map<std::string, std::pair<std::string, std::string>> texts_;  // file and its text, by keys
  std::map<NodeDirection, int> row_of_;
  StructureMatrices made_;
};

}  // namespace

bool is_of_matrices(const Key& key) {
  return key.is_of(StructureKind::matrices) && !key.is_of(StructureKind::mass) && key.table() == "model";
}

std::shared_ptr<const StructureMatrices> matrices_of(const std::filesystem::path& case_file,
                                                     const Entries& entries, bool reads_files) {
  static std::mutex mutex;
  static std::map<std::string, std::string> last_digests;
  static ModelKeys last_keys;
  static std::weak_ptr<const StructureMatrices> last;
  const ModelKeys keys = keys_of(entries);
  require_complete(case_file, keys);
  StructureMatrices made;
  if (!reads_files) {
    if (keys.load) made.load = {{}};
    return std::make_shared<const StructureMatrices>(std::move(made));
  }
  std::map<std::string, std::string> digests;
  std::map<std::string, std::pair<std::string, std::string>> texts;
  for (const auto& [path, name] : keys.files) {
    const auto file = case_file.parent_path() / name;
    const auto& text =
        texts.emplace(path, std::pair{file.string(), read_bounded(file, limit::matrix_bytes.most)})
            .first->second.second;
    digests.emplace(path, sha256(text));
    made.files.push_back({path, name, digests.at(path)});
  }
  const std::lock_guard lock(mutex);
  if (const auto same = last.lock(); same != nullptr && keys == last_keys && digests == last_digests)
    return same;
  std::vector<ModelFile> files = std::move(made.files);
  made = StructureReader(keys, std::move(texts)).read();
  made.files = std::move(files);
  auto matrices = std::make_shared<const StructureMatrices>(std::move(made));
  last = matrices;
  last_keys = keys;
  last_digests = std::move(digests);
  return matrices;
}

}  // namespace stickslip::data
