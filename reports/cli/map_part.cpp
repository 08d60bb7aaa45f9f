// SPDX-License-Identifier: MIT
#include "map_part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <system_error>

#include "case_options.hpp"
#include "range_text.hpp"
#include "stickslip/data/atomic_file.hpp"
#include "stickslip/data/input_text.hpp"

namespace stickslip::cli {

namespace {

// JSON has no infinity, the decay of a jump, and holds null for it.
std::map<std::string, double> numbers_of(const Json& json) {
  std::map<std::string, double> numbers;
  for (const auto& [key, value] : json.items())
    numbers[key] = value.is_null() ? std::numeric_limits<double>::infinity() : value.get<double>();
  return numbers;
}

Json to_json(const studies::MapTask& task, const MapPart& part) {
  return {{"program", program()},
          {"case", task.problem.name},
          {"numbers", data::numbers_of(task.problem)},
          {"x", axis_text(task.x)},
          {"y", axis_text(task.y)},
          {"method", task.method->name},
          {"states_only", task.states_only},
          {"quantities", names_of(task.quantities)},
          {"transient", task.transient},
          {"tolerance", task.tolerance},
          {"parts", part.parts},
          {"part", part.part}};
}

}  // namespace

studies::MapTask task_of(const Json& json) {
  const auto quantities = json.at("quantities").get<std::string>();
  return {.problem = data::case_with(json.at("case"), numbers_of(json.at("numbers"))),
          .x = parse_axis("x", json.at("x").get<std::string>()),
          .y = parse_axis("y", json.at("y").get<std::string>()),
          .method = json.at("method") == studies::closed_form().name ? &studies::closed_form()
                                                                     : &studies::finite_elements(),
          .states_only = json.at("states_only"),
          .quantities =
              quantities_named(quantities.empty() ? std::vector<std::string_view>() : split(quantities, ',')),
          .transient = json.at("transient"),
          .tolerance = json.at("tolerance")};
}

std::string part_header(const studies::MapTask& task, const MapPart& part) {
  std::string text = fmt::format("# {}\nevaluation,lower,upper,state", to_json(task, part).dump());
  for (const auto* quantity : task.quantities) text += fmt::format(",{0},{0}_change", quantity->name);
  return text + "\n";
}

std::optional<Json> description_in(std::string_view text) {
  if (!text.starts_with("# ")) return std::nullopt;
  Json json = Json::parse(text.substr(2, text.find('\n') - 2), nullptr, false);
  if (!json.is_object()) return std::nullopt;
  return json;
}

std::optional<std::string> difference(Json found, Json wanted) {
  for (Json* description : {&found, &wanted}) description->erase("part");
  const Json changes = Json::diff(found, wanted);
  if (changes.empty()) return std::nullopt;
  const Json::json_pointer entry(changes.front().at("path").get<std::string>());
  const auto text = [&](const Json& json) {
    return json.contains(entry) ? json.at(entry).dump() : "missing";
  };
  return fmt::format("its {} is {}, but must be {}", entry.back(), text(found), text(wanted));
}

std::string part_row(const studies::MapTask& task, std::size_t number,
                     const studies::MapEvaluation& evaluation) {
  std::string text = evaluation.unit_force
                         ? fmt::format("{},{},{},", number, data::shortest_text(evaluation.unit_force->lower),
                                       data::shortest_text(evaluation.unit_force->upper))
                         : fmt::format("{},,,{}", number, studies::name_of(evaluation.state));
  for (const auto& [value, change] : evaluation.response)
    text += fmt::format(",{},{}", data::shortest_text(value), data::shortest_text(change));
  if (evaluation.response.empty()) text.append(2 * task.quantities.size(), ',');
  return text + "\n";
}

namespace {

std::optional<studies::MapEvaluation> evaluation_in(std::span<const std::string_view> cells) {
  const auto number = [&](std::size_t column) { return parse<double>(cells[column]); };
  const auto state = std::ranges::find(all_states, cells[3], studies::name_of);
  if (state == all_states.end()) {
    if (!cells[3].empty() || !number(1) || !number(2)) return std::nullopt;
    return studies::MapEvaluation{.unit_force = analytic::Bounds{*number(1), *number(2)},
                                  .state = analytic::Verdict::stick};
  }
  studies::MapEvaluation evaluation{.unit_force = {}, .state = *state};
  if (cells.size() == 4 || cells[4].empty()) return evaluation;
  for (std::size_t column = 4; column < cells.size(); column += 2) {
    if (!number(column) || !number(column + 1)) return std::nullopt;
    evaluation.response.push_back({*number(column), *number(column + 1)});
  }
  return evaluation;
}

}  // namespace

PartRows read_rows(std::string_view text, const studies::MapTask& task, const MapPart& part,
                   studies::MapEvaluations& evaluations) {
  const auto numbers = part.numbers(evaluations.size());
  PartRows rows{.count = 0, .end = part_header(task, part).size()};
  for (auto end = text.find('\n', rows.end); end != std::string_view::npos; end = text.find('\n', rows.end)) {
    const auto cells = split(text.substr(rows.end, end - rows.end), ',');
    if (cells.size() != 4 + 2 * task.quantities.size()) break;
    const auto number = parse<std::size_t>(cells.front());
    const auto evaluation = evaluation_in(cells);
    if (!number || !evaluation || !std::ranges::binary_search(numbers, *number) || evaluations[*number])
      break;
    evaluations[*number] = *evaluation;
    ++rows.count;
    rows.end = end + 1;
  }
  return rows;
}

std::vector<const studies::MotionQuantity*> quantities_named(const std::vector<std::string_view>& names) {
  std::vector<const studies::MotionQuantity*> quantities;
  for (const std::string_view name : names)
    if (const auto* named = &studies::motion_quantity(name); std::ranges::count(quantities, named) == 0)
      quantities.push_back(named);
  return quantities;
}

std::string names_of(const std::vector<const studies::MotionQuantity*>& quantities) {
  std::string names;
  for (const auto* quantity : quantities)
    names += fmt::format("{}{}", names.empty() ? "" : ",", quantity->name);
  return names;
}

MapPart parse_part(std::string_view text) {
  const std::size_t slash = text.find('/');
  const auto part = parse<std::size_t>(text.substr(0, slash));
  const auto parts =
      slash == std::string_view::npos ? std::nullopt : parse<std::size_t>(text.substr(slash + 1));
  if (!part || !parts || !MapPart{*part, *parts}.exists())
    throw data::FieldError("--shard", fmt::format("'{}'", data::printable(text)),
                           fmt::format("K/M with integers 1 <= K <= M <= {}", most_parts));
  return {*part, *parts};
}

std::string part_text(const studies::MapTask& task, const MapPart& part,
                      const studies::MapEvaluations& evaluations) {
  std::string text = part_header(task, part);
  for (const std::size_t number : part.numbers(evaluations.size()))
    text += part_row(task, number, evaluations.at(number).value());
  return text;
}

bool holds_part(const std::filesystem::path& file, const studies::MapTask& task, const MapPart& part) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error) ||
      std::filesystem::file_size(file, error) > data::limit::shard_bytes.most)
    return false;
  const std::string text = data::read_text(file);
  studies::MapEvaluations evaluations(studies::evaluation_count(task));
  if (!text.starts_with(part_header(task, part))) return false;
  const PartRows rows = read_rows(text, task, part, evaluations);
  return rows.end == text.size() && rows.count == part.numbers(evaluations.size()).size();
}

}  // namespace stickslip::cli
