// SPDX-License-Identifier: MIT
#include "map_part.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "case_options.hpp"
#include "command.hpp"
#include "range_text.hpp"
#include "render/criterion_map.hpp"
#include "stickslip/data/atomic_file.hpp"
#include "stickslip/data/input_text.hpp"

namespace stickslip::cli {

namespace {

[[noreturn]] void fail_to_merge(const std::string& file, const std::string& why) {
  throw data::InputError(fmt::format("--merge: {} {}", file, why));
}

struct PartFile {
  std::string text;
  Json description;
  MapPart part;
};

std::string text_in(const std::string& file) try {
  return data::read_bounded(file, largest_file);
} catch (const data::InputError& error) {
  throw data::InputError(std::string("--merge: ") + error.what());
}

PartFile opened(const std::string& file) try {
  std::string text = text_in(file);
  const auto description = description_in(text);
  if (!description) fail_to_merge(file, "is no shard of a map");
  if (const auto by = description->value("program", "another program"); by != program())
    fail_to_merge(file, fmt::format("was made by {}, but must be by {}", by, program()));
  const MapPart part{.part = description->at("part"), .parts = description->at("parts")};
  if (!part.exists())
    fail_to_merge(file, fmt::format("is shard {} of {}, but must be one of 1 to {}", part.part, part.parts,
                                    part.parts));
  (void)task_of(*description);
  return {std::move(text), *description, part};
} catch (const Json::exception&) {
  fail_to_merge(file, "is no shard of a map");
}

void require_all(const std::vector<std::string>& file_of_part, const std::string& one) {
  constexpr std::size_t named = 5;
  std::vector<std::size_t> missing;
  for (std::size_t part = 1; part <= file_of_part.size(); ++part)
    if (file_of_part[part - 1].empty()) missing.push_back(part);
  if (missing.empty()) return;
  const std::size_t more = missing.size() - std::min(missing.size(), named);
  throw data::InputError(fmt::format("--merge: shard {}{} of {} {} missing beside {}",
                                     fmt::join(std::span(missing).first(missing.size() - more), ", "),
                                     more > 0 ? fmt::format(" and {} more", more) : "", file_of_part.size(),
                                     missing.size() == 1 ? "is" : "are", one));
}

}  // namespace

namespace fs = std::filesystem;

namespace {

// JSON has no infinity, the decay of a jump, and holds null for it.
std::map<std::string, double> numbers_of(const Json& json) {
  std::map<std::string, double> numbers;
  for (const auto& [key, value] : json.items())
    numbers[key] = value.is_null() ? std::numeric_limits<double>::infinity() : value.get<double>();
  return numbers;
}

Json to_json(const studies::MapTask& task, const MapPart& part) {
  return {
      {"program", program()},
      {"case", task.problem.name},
      {"numbers", data::numbers_of(task.problem)},
      {"x", axis_text(task.x)},
      {"y", axis_text(task.y)},
      {"method", task.method == studies::MapMethod::closed_form ? closed_form_method : finite_element_method},
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
          .method = json.at("method") == closed_form_method ? studies::MapMethod::closed_form
                                                            : studies::MapMethod::finite_elements,
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
                         : fmt::format("{},,,{}", number, report::to_string(evaluation.state));
  for (const auto& [value, change] : evaluation.response)
    text += fmt::format(",{},{}", data::shortest_text(value), data::shortest_text(change));
  if (evaluation.response.empty()) text.append(2 * task.quantities.size(), ',');
  return text + "\n";
}

namespace {

std::optional<studies::MapEvaluation> evaluation_in(std::span<const std::string_view> cells) {
  const auto number = [&](std::size_t column) { return parse<double>(cells[column]); };
  const auto state = std::ranges::find(all_states, cells[3],
                                       [](studies::CellState known) { return report::to_string(known); });
  if (state == all_states.end()) {
    if (!cells[3].empty() || !number(1) || !number(2)) return std::nullopt;
    return studies::MapEvaluation{.unit_force = analytic::Bounds{*number(1), *number(2)},
                                  .state = studies::CellState::stick};
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

bool holds_part(const fs::path& file, const studies::MapTask& task, const MapPart& part) {
  std::error_code error;
  if (!fs::is_regular_file(file, error) || fs::file_size(file, error) > largest_file) return false;
  const std::string text = data::read_text(file);
  studies::MapEvaluations evaluations(studies::evaluation_count(task));
  if (!text.starts_with(part_header(task, part))) return false;
  const PartRows rows = read_rows(text, task, part, evaluations);
  return rows.end == text.size() && rows.count == part.numbers(evaluations.size()).size();
}

MergedMap merged(const std::vector<std::string>& files) {
  const PartFile first = opened(files.front());
  MergedMap map{task_of(first.description), {}};
  map.evaluations.resize(studies::evaluation_count(map.task));
  std::vector<std::string> file_of_part(first.part.parts);
  for (const std::string& name : files) {
    const PartFile file = opened(name);
    if (const auto why = difference(file.description, first.description))
      fail_to_merge(name, "is a shard of another map: " + *why);
    std::string& same_part = file_of_part[file.part.part - 1];
    if (!same_part.empty())
      fail_to_merge(
          name, fmt::format("is shard {} of {}, but so is {}", file.part.part, file.part.parts, same_part));
    same_part = name;
    const PartRows rows = read_rows(file.text, map.task, file.part, map.evaluations);
    if (rows.end != file.text.size())
      fail_to_merge(name, fmt::format("is damaged in line {}", rows.count + 3));
    if (const auto count = file.part.numbers(map.evaluations.size()).size(); rows.count != count)
      fail_to_merge(name, fmt::format("is not finished: it holds {} of {} evaluations", rows.count, count));
  }
  require_all(file_of_part, files.front());
  return map;
}

namespace fs = std::filesystem;

UnfinishedMap::UnfinishedMap(fs::path file, const studies::MapTask& task, const MapPart& part,
                             studies::MapEvaluations& evaluations)
    : file_(std::move(file)), task_(task), evaluations_(evaluations) {
  if (file_.empty()) return;
  open();
  const std::string text = data::read_text(file_), wanted = part_header(task, part);
  PartRows rows;
  if (text.starts_with(wanted)) {
    rows = read_rows(text, task, part, evaluations);
  } else if (!wanted.starts_with(text)) {
    std::fclose(stream_);
    const auto found = description_in(text);
    const std::string why =
        !found ? "it is no beginning of a map"
               : difference(*found, description_in(wanted).value())  // as read: infinity is null
                     .value_or(fmt::format("its part is {}, but must be {}",
                                           found->value("part", Json()).dump(), part.part));
    throw data::InputError(
        fmt::format("{} belongs to other work: {}; remove it or name another --output", file_.string(), why));
  }
  if (::ftruncate(::fileno(stream_), static_cast<off_t>(rows.end)) != 0) fail();
  if (rows.end == 0) append(wanted);
  found_ = kept_ = rows.count;
}

UnfinishedMap::~UnfinishedMap() {
  if (stream_ != nullptr) std::fclose(stream_);
}

void UnfinishedMap::keep(std::span<const std::size_t> numbers) {
  if (file_.empty()) return;
  std::string text;
  for (const std::size_t number : numbers) text += part_row(task_, number, *evaluations_[number]);
  append(text);
  kept_ += numbers.size();
}

void UnfinishedMap::remove_if_impossible(const std::function<void()>& work) {
  try {
    work();
  } catch (const data::InputError&) {
    remove();
    throw;
  }
}

void UnfinishedMap::remove() {
  std::error_code ignored;  // nothing is left to be done about a file that cannot be removed
  if (!file_.empty()) fs::remove(file_, ignored);
}

void UnfinishedMap::open() {
  stream_ = std::fopen(file_.c_str(), "abe");
  if (stream_ == nullptr) fail();
  if (::flock(::fileno(stream_), LOCK_EX | LOCK_NB) == 0) return;
  std::fclose(stream_);
  throw data::InputError(fmt::format(
      "{} is being written by another run; wait for it or name another --output", file_.string()));
}

void UnfinishedMap::append(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stream_) != text.size() || std::fflush(stream_) != 0) fail();
}

void UnfinishedMap::fail() const {
  throw data::OutputError(
      fmt::format("{} cannot be written: {}", file_.string(), std::generic_category().message(errno)));
}

}  // namespace stickslip::cli
