#include "test_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <map>
#include <pugixml.hpp>
#include <string_view>
#include <tuple>

#include "stickslip/data/case_file.hpp"

namespace stickslip::report {

namespace fs = std::filesystem;

namespace {

using Properties = std::map<std::string, std::string>;

double number(const std::string& text, const fs::path& file) {
  double value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    throw data::InputError(fmt::format("{}: '{}' stands where a number is expected", file.string(), text));
  return value;
}

// So many fields separated by "; ", and the derivation, which may hold the separator, as the last.
std::vector<std::string> fields_of(const std::string& key, std::string_view text, std::size_t count,
                                   const fs::path& file) {
  constexpr std::string_view separator = "; ";
  std::vector<std::string> fields;
  while (fields.size() + 1 < count) {
    const std::size_t end = text.find(separator);
    if (end == std::string_view::npos)
      throw data::InputError(fmt::format("{}: {} must have {} fields", file.string(), key, count));
    fields.emplace_back(text.substr(0, end));
    text.remove_prefix(end + separator.size());
  }
  fields.emplace_back(text);
  return fields;
}

ToleranceEntry tolerance_entry(const std::string& tolerance_class, const std::vector<std::string>& fields,
                               const fs::path& file) {
  return {.tolerance_class = tolerance_class,
          .comparisons = static_cast<int>(number(fields[0], file)),
          .error = number(fields[1], file),
          .tolerance = number(fields[2], file),
          .margin = number(fields[3], file),
          .derivation = fields[4]};
}

TestComparison named_comparison(const std::string& name, const std::vector<std::string>& fields,
                                const fs::path& file) {
  return {.name = name,
          .computed = number(fields[0], file),
          .expected = number(fields[1], file),
          .error = number(fields[2], file),
          .tolerance = number(fields[3], file),
          .margin = number(fields[4], file),
          .tolerance_class = fields[5]};
}

void read_comparisons(Properties& properties, const fs::path& file, TestResult& result) {
  const auto value = [&](const char* key) { return number(properties[key], file); };
  result.comparisons = properties.contains("comparisons") ? static_cast<int>(value("comparisons")) : 0;
  if (result.comparisons > 0)
    result.worst = {.name = "",
                    .computed = value("computed"),
                    .expected = value("expected"),
                    .error = value("error"),
                    .tolerance = value("tolerance"),
                    .margin = value("margin"),
                    .tolerance_class = properties["class"]};
  constexpr std::string_view compared = "compared.", tolerances = "tolerances.";
  constexpr std::string_view bad = "bad_input.", accepted = "accepted_input.";
  const auto count = [&](const std::string& text) { return static_cast<int>(number(text, file)); };
  for (const auto& [key, text] : properties) {
    if (key.starts_with(bad)) {
      const auto counts = fields_of(key, text, 2, file);
      result.bad_input[key.substr(bad.size())] = {count(counts[0]), count(counts[1])};
    }
    if (key.starts_with(accepted)) result.accepted_input[key.substr(accepted.size())] = count(text);
    if (key.starts_with(compared))
      result.named.push_back(
          named_comparison(key.substr(compared.size()), fields_of(key, text, 7, file), file));
    if (key.starts_with(tolerances))
      result.tolerances.push_back(
          tolerance_entry(key.substr(tolerances.size()), fields_of(key, text, 5, file), file));
  }
}

TestResult read_test(const pugi::xml_node& test, const std::string& kind, const fs::path& file) {
  Properties properties;
  for (const auto& property : test.child("properties").children("property"))
    properties[property.attribute("name").value()] = property.attribute("value").value();
  TestResult result;
  result.kind = kind;
  result.suite = test.attribute("classname").value();
  if (const std::size_t slash = result.suite.find('/'); slash != std::string::npos)
    result.suite.erase(0, slash + 1);
  result.name = test.attribute("name").value();
  result.skipped = static_cast<bool>(test.child("skipped"));
  result.passed = !test.child("failure") && !result.skipped &&
                  std::string_view(test.attribute("status").value()) == "run";
  result.requirement = properties["requirement"];
  result.requirement_text = properties["requirement_text"];
  result.source = properties["source"];
  if (const std::string& position = properties["requirement_position"]; !position.empty())
    result.requirement_position = static_cast<int>(number(position, file));
  result.claim = properties["claim"];
  result.finding = properties["finding"];
  read_comparisons(properties, file, result);
  return result;
}

}  // namespace

std::vector<TestResult> read_test_results(const fs::path& folder) {
  std::error_code error;
  std::vector<TestResult> results;
  for (const auto& entry : fs::recursive_directory_iterator(folder, error)) {
    if (entry.path().extension() != ".xml") continue;
    constexpr std::uintmax_t largest = 50'000'000;
    if (entry.is_regular_file() && entry.file_size() > largest)
      throw data::InputError(
          fmt::format("{}: is larger than the {} bytes that are allowed", entry.path().string(), largest));
    pugi::xml_document document;
    if (const auto parsed = document.load_file(entry.path().c_str()); !parsed)
      throw data::InputError(fmt::format("{}: {}", entry.path().string(), parsed.description()));
    const std::string place = entry.path().lexically_relative(folder).string();
    for (const auto& suite : document.child("testsuites").children("testsuite"))
      for (const auto& test : suite.children("testcase"))
        results.push_back(read_test(test, place.substr(0, place.find('.')), entry.path()));
  }
  if (results.empty())
    throw data::InputError(fmt::format(
        "the folder of test results is {}, but must hold GoogleTest's XML files", folder.string()));
  std::ranges::sort(results, {}, [](const TestResult& result) {
    return std::tie(result.requirement_position, result.suite, result.name, result.kind);
  });
  return results;
}

}  // namespace stickslip::report
