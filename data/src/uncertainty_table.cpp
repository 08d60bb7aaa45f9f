// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <string_view>
#include <utility>

#include "case_entry.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/data/csv_text.hpp"
#include "stickslip/data/input_text.hpp"
#include "stickslip/data/toml_file.hpp"
#include "stickslip/data/units.hpp"

namespace stickslip::data {

namespace {

using Path = std::filesystem::path;

struct Kind {
  std::string_view name;
  DistributionKind kind;
  std::vector<std::string> keys;
  std::vector<double Distribution::*> numbers;  // of the keys; samples have texts
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{{"normal",
                                      DistributionKind::normal,
                                      {"mean", "standard_deviation"},
                                      {&Distribution::mean, &Distribution::standard_deviation}},
                                     {"lognormal",
                                      DistributionKind::lognormal,
                                      {"mean", "standard_deviation"},
                                      {&Distribution::mean, &Distribution::standard_deviation}},
                                     {"uniform",
                                      DistributionKind::uniform,
                                      {"lower", "upper"},
                                      {&Distribution::lower, &Distribution::upper}},
                                     {"triangular",
                                      DistributionKind::triangular,
                                      {"lower", "mode", "upper"},
                                      {&Distribution::lower, &Distribution::mode, &Distribution::upper}},
                                     {"samples", DistributionKind::samples, {"file", "column"}, {}}};
  return all;
}

std::string described(const toml::node* node) { return node == nullptr ? "missing" : describe(*node); }

// One distribution; every message begins with its place and ends with what is allowed.
class DistributionReader {
 public:
  DistributionReader(Path file, std::string key, const toml::node& node)
      : file_(std::move(file)), key_(std::move(key)), place_(place_of(file_, node)), table_(node.as_table()) {
    if (table_ == nullptr)
      fail("uncertainty." + quoted() + " is " + describe(node), "a table with a distribution");
  }

  [[nodiscard]] Distribution read() const {
    std::vector<std::string> names;
    for (const Kind& kind : kinds()) names.emplace_back(kind.name);
    const auto name = table_->get_as<std::string>("distribution");
    const auto word = name == nullptr ? std::string() : name->get();
    const auto kind = std::ranges::find(kinds(), word, &Kind::name);
    if (kind == kinds().end())
      fail(item("distribution") + " is " + described(table_->get("distribution")) + suggestion(word, names),
           "one of " + joined(names));
    for (const auto& [name_of_value, value] : *table_) {
      const std::string known(name_of_value.str());
      if (known != "distribution" && std::ranges::find(kind->keys, known) == kind->keys.end())
        throw InputError(place_ + ": unknown key " + printable(item(known)) + suggestion(known, kind->keys) +
                         ", but " + word + " has the keys " + joined(kind->keys));
    }
    return checked(values_of(*kind));
  }

 private:
  [[nodiscard]] std::string quoted() const { return "\"" + key_ + "\""; }
  [[nodiscard]] std::string item(const std::string& name) const {
    return "uncertainty." + quoted() + "." + name;
  }

  [[noreturn]] void fail(const std::string& what, const std::string& allowed) const {
    throw InputError(place_ + ": " + what + ", but must be " + allowed);
  }

  // With or without a unit, that of the key.
  [[nodiscard]] double number(const std::string& name) const {
    const auto* node = table_->get(name);
    if (node == nullptr) fail(item(name) + " is missing", "a finite number");
    try {
      const double value =
          number_of(item(name), {.unit = key_named(key_).magnitudes.unit}, entry_of(*node, place_));
      if (std::isfinite(value)) return value;
    } catch (const FieldError& error) {
      throw InputError(place_ + ": " + error.what());
    }
    fail(item(name) + " is " + describe(*node), "a finite number");
  }

  [[nodiscard]] std::string text(const std::string& name) const {
    const auto* value = table_->get_as<std::string>(name);
    if (value == nullptr || value->get().empty())
      fail(item(name) + " is " + described(table_->get(name)), "a string that is not empty");
    return value->get();
  }

  [[nodiscard]] Distribution values_of(const Kind& kind) const {
    Distribution result{.kind = kind.kind};
    for (std::size_t i = 0; i < kind.numbers.size(); ++i) result.*kind.numbers[i] = number(kind.keys[i]);
    if (kind.kind == DistributionKind::samples) {
      const Path samples = text("file");
      if (!is_inside(samples))
        fail(item("file") + " is " + printable(samples.string()), "a path inside the folder of the case");
      result.samples =
          column((file_.has_parent_path() ? file_.parent_path() : ".") / samples, text("column"));
    }
    return result;
  }

  // That of a header such as "E [GPa]", "E (GPa)", "E / GPa" or "E_GPa"; that of the key, if it states none.
  [[nodiscard]] Unit unit_in(const std::string& header) const {
    const std::string_view si = key_named(key_).magnitudes.unit;
    if (const auto stated = header_of(header).unit) {
      const auto unit = unit_named(*stated);
      if (!unit || unit->si != si)
        fail(item("column") + " is " + printable(header), "a column in one of " + units_convertible_to(si));
      return *unit;
    }
    for (auto at = header.find('_'); at != std::string::npos; at = header.find('_', at + 1))
      if (const auto unit = unit_named(header.substr(at + 1)); unit && unit->si == si) return *unit;
    return {.si = si};
  }

  // No message quotes the file: the case may be of someone else, and name any file.
  [[nodiscard]] std::vector<double> column(const Path& file, const std::string& name) const {
    const std::string content = read_table_text(file);
    CsvReader reader(file, content);
    const auto& names = reader.names();
    auto found = std::ranges::find(names, name);
    if (found == names.end())
      found =
          std::ranges::find(names, name, [](const std::string& header) { return header_of(header).name; });
    if (found == names.end()) fail(item("column") + " is " + printable(name), "a column of " + file.string());
    const Unit unit = unit_in(*found);
    const auto index = static_cast<std::size_t>(found - names.begin());
    std::vector<double> samples;
    while (const auto row = reader.next_row()) {
      const auto value = reader.number((*row)[index]);
      if (!value || !std::isfinite(unit.to_si(*value)))
        throw InputError(reader.place(reader.line(), index) + ": is no finite number, but must be one");
      samples.push_back(unit.to_si(*value));
    }
    if (samples.size() < 2)
      throw InputError(file.string() + ": has " + std::to_string(samples.size()) +
                       " rows, but must have at least 2");
    std::ranges::sort(samples);
    return samples;
  }

  [[nodiscard]] Distribution checked(Distribution d) const {
    const auto require = [&](bool holds, const std::string& name, const std::string& allowed) {
      if (!holds) fail(item(name) + " is " + described(table_->get(name)), allowed);
    };
    if (d.kind == DistributionKind::normal || d.kind == DistributionKind::lognormal) {
      require(d.standard_deviation > 0.0, "standard_deviation", "above 0");
      require(d.kind == DistributionKind::normal || d.mean > 0.0, "mean", "above 0 for lognormal");
    }
    if (d.kind == DistributionKind::uniform || d.kind == DistributionKind::triangular)
      require(d.upper > d.lower, "upper", "above lower");
    if (d.kind == DistributionKind::triangular)
      require(d.lower <= d.mode && d.mode <= d.upper, "mode", "from lower to upper");
    for (const double value : {d.mean, d.lower, d.mode, d.upper}) require_magnitude(key_, value, place_);
    for (const double value : d.samples) require_magnitude(key_, value, place_);
    return d;
  }

  Path file_;
  std::string key_, place_;
  const toml::table* table_;
};

[[noreturn]] void throw_unknown(const std::string& place, const std::string& key, const toml::node& value,
                                const std::vector<std::string>& keys) {
  const bool unquoted =
      std::ranges::any_of(keys, [&](const auto& known) { return known.starts_with(key + "."); });
  const std::string is_unknown = place + ": unknown key uncertainty." + printable(key);
  if (unquoted && value.is_table())
    throw InputError(is_unknown + ", but the key of a case must stand in quotes, as \"" + key + ".name\"");
  throw InputError(is_unknown + suggestion(key, keys) +
                   ", but must be \"correlation\" or a key of a case that is no integer, in quotes");
}

// The key that the numbers of the distribution are of, by their units.
std::string stated_by(const std::string& key, const toml::node& distribution) {
  if (const auto* table = distribution.as_table())
    for (const auto& [name, value] : *table)
      if (const auto text = value.value_exact<std::string>())
        if (const Key& stated = key_stated(key, *text); stated.path != key) return std::string(stated.path);
  return key;
}

// One row of `correlation`, into the matrix. `pairs` are those of the rows before it.
void set_correlation(const Path& file, const toml::node& row,
                     std::set<std::pair<std::size_t, std::size_t>>& pairs, Uncertainty& result) {
  const auto fail = [&](const std::string& what) {
    throw InputError(
        place_of(file, row) + ": uncertainty.correlation " + what +
        ", but must hold rows such as [\"a.b\", \"c.d\", 0.5] of two different keys of [uncertainty] and a "
        "number between -1 and 1");
  };
  const auto* items = row.as_array();
  if (items == nullptr || items->size() != 3) fail("has a row that is " + describe(row) + " of another form");
  std::array<std::size_t, 2> pair{};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto name = (*items)[i].value_exact<std::string>();
    const auto found = std::ranges::find_if(
        result.keys, [&](const UncertainKey& key) { return state_the_same(key.key, name.value_or("")); });
    if (found == result.keys.end()) fail("names " + describe((*items)[i]) + ", which has no distribution");
    pair[i] = static_cast<std::size_t>(found - result.keys.begin());
  }
  const auto value = (*items)[2].value<double>();
  if (pair[0] == pair[1]) fail("names " + result.keys[pair[0]].key + " twice");
  if (!value || !(std::abs(*value) < 1.0)) fail("has the coefficient " + describe((*items)[2]));
  if (!pairs.insert(std::minmax(pair[0], pair[1])).second)
    fail("has two rows of " + result.keys[pair[0]].key + " and " + result.keys[pair[1]].key);
  for (const std::size_t i : {0U, 1U})
    result.correlation[pair[i] * result.keys.size() + pair[1 - i]] = *value;
}

}  // namespace

double Distribution::mean_value() const {
  switch (kind) {
    case DistributionKind::uniform:
      return std::midpoint(lower, upper);
    case DistributionKind::triangular:
      return (lower + mode + upper) / 3.0;
    case DistributionKind::samples:
      return std::accumulate(samples.begin(), samples.end(), 0.0) / static_cast<double>(samples.size());
    default:
      return mean;
  }
}

std::vector<double> cholesky_factor(const std::vector<double>& matrix, std::size_t size) {
  std::vector<double> factor(size * size);
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double rest = matrix[i * size + j];
      for (std::size_t k = 0; k < j; ++k) rest -= factor[i * size + k] * factor[j * size + k];
      if (i == j && !(rest > 1e-12)) return {};
      factor[i * size + j] = i == j ? std::sqrt(rest) : rest / factor[j * size + j];
    }
  return factor;
}

Uncertainty uncertainty_of(const Path& file, const toml::node& node) {
  const auto* table = node.as_table();
  if (table == nullptr)
    throw InputError(place_of(file, node) + ": uncertainty is " + describe(node) + ", but must be a table");
  std::vector<std::string> keys;
  for (const Key& key : case_keys())
    if (key.is_real()) keys.emplace_back(key.path);
  Uncertainty result;
  for (const auto& [name, value] : *table) {
    const std::string named(name.str());
    if (named == "correlation") continue;
    if (std::ranges::find(keys, named) == keys.end())
      throw_unknown(place_of(file, value), named, value, keys);
    const std::string key = stated_by(named, value);
    for (const UncertainKey& other : result.keys)
      if (state_the_same(other.key, key))
        throw InputError(place_of(file, value) + ": uncertainty.\"" + named +
                         "\" is given, but must be missing where \"" + other.key + "\" is given");
    result.keys.push_back({key, DistributionReader(file, key, value).read(), place_of(file, value)});
  }
  const std::size_t count = result.keys.size();
  if (count == 0)
    throw InputError(place_of(file, node) + ": uncertainty has no distribution, but must have one or more");
  result.correlation.assign(count * count, 0.0);
  for (std::size_t i = 0; i < count; ++i) result.correlation[i * count + i] = 1.0;
  const auto* correlation = table->get("correlation");
  if (correlation == nullptr) return result;
  const auto* rows = correlation->as_array();
  if (rows == nullptr)
    throw InputError(place_of(file, *correlation) + ": uncertainty.correlation is " + describe(*correlation) +
                     ", but must be an array of rows [\"a.b\", \"c.d\", 0.5]");
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  for (const auto& row : *rows) set_correlation(file, row, pairs, result);
  if (cholesky_factor(result.correlation, count).empty())
    throw InputError(place_of(file, *correlation) +
                     ": uncertainty.correlation is contradictory, but must be a positive definite matrix");
  return result;
}

}  // namespace stickslip::data
