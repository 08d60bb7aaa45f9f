// SPDX-License-Identifier: MIT
#include "map_records.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <limits>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "case_options.hpp"
#include "output_file.hpp"
#include "range_text.hpp"
#include "render/criterion_map.hpp"
#include "render/text_file.hpp"
#include "stickslip/data/input_text.hpp"
#include "stickslip/data/sha256.hpp"
#include "stickslip/version.hpp"

namespace stickslip::cli {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t check_digits = 16;

std::string program() { return fmt::format("stickslip {} (commit {})", version, commit); }

// JSON has no infinity, the decay of a jump, and holds null for it.
std::map<std::string, double> numbers_of(const Json& json) {
  std::map<std::string, double> numbers;
  for (const auto& [key, value] : json.items())
    numbers[key] = value.is_null() ? std::numeric_limits<double>::infinity() : value.get<double>();
  return numbers;
}

std::vector<std::string> names_of(const std::vector<const studies::MotionQuantity*>& quantities) {
  std::vector<std::string> names;
  for (const auto* quantity : quantities) names.emplace_back(quantity->name);
  return names;
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

studies::MapTask task_of(const Json& json) {
  return {.problem = data::case_with(json.at("case"), numbers_of(json.at("numbers"))),
          .x = parse_axis("x", json.at("x").get<std::string>()),
          .y = parse_axis("y", json.at("y").get<std::string>()),
          .method = json.at("method") == closed_form_method ? studies::MapMethod::closed_form
                                                            : studies::MapMethod::finite_elements,
          .states_only = json.at("states_only"),
          .quantities = quantities_named(json.at("quantities").get<std::vector<std::string>>()),
          .transient = json.at("transient"),
          .tolerance = json.at("tolerance")};
}

constexpr std::size_t most_parts = 1'000'000;

bool is_part(const MapPart& part) {
  return 1 <= part.part && part.part <= part.parts && part.parts <= most_parts;
}

constexpr std::size_t largest_shard = 500'000'000;  // bytes, more than the largest map takes

// The first digits of the SHA-256 digest of a line; that of a record depends on the first line of the file, too.
std::string check_of(std::string_view content, std::string_view header = {}) {
  return data::sha256(std::string(header) + std::string(content)).substr(0, check_digits);
}

// The line with its check.
std::string checked(std::string_view content, std::string_view header = {}) {
  return fmt::format("{},{}\n", content, check_of(content, header));
}

std::string header_line(const studies::MapTask& task, const MapPart& part) {
  return checked(to_json(task, part).dump());
}

std::string record(std::size_t number, const studies::MapEvaluation& evaluation, std::string_view header) {
  if (!evaluation.unit_force) {
    std::string text = fmt::format("{},{}", number, report::to_string(evaluation.state));
    for (const auto& [value, change] : evaluation.response)
      text += fmt::format(",{},{}", data::shortest_text(value), data::shortest_text(change));
    return checked(text, header);
  }
  return checked(fmt::format("{},{},{}", number, data::shortest_text(evaluation.unit_force->lower),
                             data::shortest_text(evaluation.unit_force->upper)),
                 header);
}

// The first line of a text, without its end and its check; nothing if it is torn or damaged.
std::optional<std::string_view> first_content(std::string_view text, std::string_view header = {}) {
  const std::size_t end = text.find('\n');
  if (end == std::string_view::npos || end <= check_digits) return std::nullopt;
  const std::string_view content = text.substr(0, end - check_digits - 1);
  if (text.substr(0, end + 1) != checked(content, header)) return std::nullopt;
  return content;
}

struct Record {
  std::size_t number{};
  studies::MapEvaluation evaluation;
};

// NUMBER,LOWER,UPPER of |f|, or NUMBER,STATE and behind it VALUE,CHANGE of each quantity.
std::optional<Record> parse_record(std::string_view content) {
  const auto cells = split(content, ',');
  const auto number = parse<std::size_t>(cells.front());
  if (!number || cells.size() < 2) return std::nullopt;
  const auto state = std::ranges::find(all_states, cells[1],
                                       [](studies::CellState known) { return report::to_string(known); });
  const bool has_state = state != all_states.end();
  std::vector<double> numbers;
  for (std::size_t i = has_state ? 2 : 1; i < cells.size(); ++i) {
    const auto value = parse<double>(cells[i]);
    if (!value) return std::nullopt;
    numbers.push_back(*value);
  }
  if (has_state ? numbers.size() % 2 != 0 : numbers.size() != 2) return std::nullopt;
  if (!has_state)
    return Record{
        *number,
        {.unit_force = analytic::Bounds{numbers[0], numbers[1]}, .state = studies::CellState::stick}};
  Record record{*number, {.unit_force = {}, .state = *state, .response = {}}};
  for (std::size_t i = 0; i < numbers.size(); i += 2)
    record.evaluation.response.push_back({numbers[i], numbers[i + 1]});
  return record;
}

// Takes the records that follow the first line, up to the first that is torn, damaged, double or not among
// the numbers of the part, and returns how much of the text that is.
struct Taken {
  std::size_t records{}, length{};
};

Taken take_records(std::string_view text, std::size_t header_length, const std::vector<std::size_t>& numbers,
                   studies::MapEvaluations& evaluations) {
  const std::string header = check_of(text.substr(0, header_length));
  Taken taken{.records = 0, .length = header_length};
  while (const auto content = first_content(text.substr(taken.length), header)) {
    const auto next = parse_record(*content);
    if (!next || !std::ranges::binary_search(numbers, next->number) || evaluations[next->number]) break;
    evaluations[next->number] = next->evaluation;
    ++taken.records;
    taken.length += content->size() + check_digits + 2;
  }
  return taken;
}

// Which entry of two first lines differs, but the last one, the part.
std::optional<std::string> difference(const Json& found, const Json& wanted) {
  for (const auto& [key, value] : wanted.items())
    if (value.is_object() && found.contains(key) && found.at(key).is_object()) {
      if (auto inside = difference(found.at(key), value)) return inside;
    } else if (key != "part" && found.value(key, Json()) != value)
      return fmt::format("its {} is {}, but must be {}", key, found.value(key, Json()).dump(), value.dump());
  return std::nullopt;
}

std::optional<Json> header_of(std::string_view text) {
  const auto content = first_content(text);
  if (!content) return std::nullopt;
  Json json = Json::parse(*content, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  return json;
}

std::string shard_in(const std::string& file) {
  try {
    return data::read_bounded(file, largest_shard);
  } catch (const data::InputError& error) {
    throw data::InputError(std::string("--merge: ") + error.what());
  }
}

void require_all(const std::vector<std::string>& file_of_part, const std::string& one) {
  constexpr std::size_t named = 5;
  std::vector<std::size_t> missing;
  for (std::size_t part = 1; part <= file_of_part.size(); ++part)
    if (file_of_part[part - 1].empty()) missing.push_back(part);
  if (missing.empty()) return;
  const std::size_t shown = std::min(missing.size(), named);
  throw data::InputError(
      fmt::format("--merge: shard {}{} of {} {} missing beside {}",
                  fmt::join(missing.begin(), missing.begin() + static_cast<std::ptrdiff_t>(shown), ", "),
                  missing.size() > shown ? fmt::format(" and {} more", missing.size() - shown) : "",
                  file_of_part.size(), missing.size() == 1 ? "is" : "are", one));
}

}  // namespace

std::vector<const studies::MotionQuantity*> quantities_named(const std::vector<std::string>& names) {
  std::vector<const studies::MotionQuantity*> quantities;
  for (const std::string& name : names)
    if (const auto* named = &studies::motion_quantity(name); std::ranges::count(quantities, named) == 0)
      quantities.push_back(named);
  return quantities;
}

MapPart parse_part(std::string_view text) {
  const std::size_t slash = text.find('/');
  const auto part = parse<std::size_t>(text.substr(0, slash));
  const auto parts =
      slash == std::string_view::npos ? std::nullopt : parse<std::size_t>(text.substr(slash + 1));
  if (!part || !parts || !is_part({*part, *parts}))
    throw data::FieldError("--shard", fmt::format("'{}'", data::printable(text)),
                           fmt::format("K/M with integers 1 <= K <= M <= {}", most_parts));
  return {*part, *parts};
}

std::string shard_text(const studies::MapTask& task, const MapPart& part,
                       const studies::MapEvaluations& evaluations) {
  const std::string header = header_line(task, part);
  const std::string check = check_of(header);
  std::string text = header;
  for (const std::size_t number : part.numbers(evaluations.size()))
    text += record(number, evaluations.at(number).value(), check);
  return text;
}

bool holds_shard(const fs::path& file, const studies::MapTask& task, const MapPart& part) {
  std::error_code error;
  if (!fs::is_regular_file(file, error) || fs::file_size(file, error) > largest_shard) return false;
  const std::string text = report::read_text(file), header = header_line(task, part);
  if (!text.starts_with(header)) return false;
  studies::MapEvaluations evaluations(studies::evaluation_count(task));
  const auto numbers = part.numbers(evaluations.size());
  const Taken taken = take_records(text, header.size(), numbers, evaluations);
  return taken.length == text.size() && taken.records == numbers.size();
}

MergedMap merged(const std::vector<std::string>& files) {
  std::optional<MergedMap> map;
  Json first;
  std::vector<std::string> file_of_part;
  for (const std::string& file : files) {
    const auto fail = [&](const std::string& why) {
      throw data::InputError(fmt::format("--merge: {} {}", file, why));
    };
    const std::string text = shard_in(file);
    const auto header = header_of(text);
    if (!header) fail("is no shard of a map");
    if (header->value("program", "") != program())
      fail(fmt::format("was made by {}, but must be by {}", header->value("program", "another program"),
                       program()));
    const MapPart part{.part = header->at("part"), .parts = header->at("parts")};
    if (!is_part(part))
      fail(fmt::format("is shard {} of {}, but must be one of 1 to {}", part.part, part.parts, part.parts));
    if (!map) {
      map = MergedMap{task_of(*header), studies::MapEvaluations()};
      map->evaluations.resize(studies::evaluation_count(map->task));
      first = *header;
      file_of_part.resize(part.parts);
    }
    if (const auto why = difference(*header, first)) fail("is a shard of another map: " + *why);
    if (!file_of_part[part.part - 1].empty())
      fail(
          fmt::format("is shard {} of {}, but so is {}", part.part, part.parts, file_of_part[part.part - 1]));
    file_of_part[part.part - 1] = file;
    const auto numbers = part.numbers(map->evaluations.size());
    const Taken taken = take_records(text, text.find('\n') + 1, numbers, map->evaluations);
    if (taken.length != text.size()) fail(fmt::format("is damaged in line {}", taken.records + 2));
    if (taken.records != numbers.size())
      fail(fmt::format("is not finished: it holds {} of {} evaluations", taken.records, numbers.size()));
  }
  require_all(file_of_part, files.front());
  return *std::move(map);
}

UnfinishedMap::UnfinishedMap(fs::path file, const studies::MapTask& task, const MapPart& part,
                             studies::MapEvaluations& evaluations)
    : file_(std::move(file)), header_(header_line(task, part)), evaluations_(evaluations) {
  if (file_.empty()) return;
  open();
  const std::string text = report::read_text(file_);
  Taken taken;
  if (text.starts_with(header_)) {
    taken = take_records(text, header_.size(), part.numbers(evaluations.size()), evaluations);
  } else if (!header_.starts_with(text)) {
    ::close(descriptor_);
    const auto found = header_of(text);
    const std::string why = !found
                                ? "it is no beginning of a map"
                                : difference(*found, header_of(header_).value())  // as read: infinity is null
                                      .value_or(fmt::format("its part is {}, but must be {}",
                                                            found->value("part", Json()).dump(), part.part));
    throw data::InputError(
        fmt::format("{} belongs to other work: {}; remove it or name another --output", file_.string(), why));
  }
  if (::ftruncate(descriptor_, static_cast<off_t>(taken.length)) != 0) fail();
  if (taken.length == 0) append(header_);
  found_ = kept_ = taken.records;
}

UnfinishedMap::~UnfinishedMap() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::size_t UnfinishedMap::kept() const {
  const std::lock_guard lock(guard_);
  return kept_;
}

void UnfinishedMap::keep(std::span<const std::size_t> numbers) {
  if (file_.empty()) return;
  const std::string header = check_of(header_);
  std::string text;
  for (const std::size_t number : numbers) text += record(number, *evaluations_[number], header);
  const std::lock_guard lock(guard_);
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
  descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail();
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  ::close(descriptor_);
  throw data::InputError(fmt::format(
      "{} is being written by another run; wait for it or name another --output", file_.string()));
}

void UnfinishedMap::append(const std::string& text) {
  std::string_view rest = text;
  while (!rest.empty()) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail();
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
}

void UnfinishedMap::fail() const {
  throw OutputError(
      fmt::format("{} cannot be written: {}", file_.string(), std::generic_category().message(errno)));
}

}  // namespace stickslip::cli
