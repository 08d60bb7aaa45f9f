// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "command.hpp"
#include "map_part.hpp"
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
  return data::read_bounded(file, data::limit::shard_bytes.most);
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

std::pair<studies::MapTask, studies::MapEvaluations> merged(const std::vector<std::string>& files) {
  const PartFile first = opened(files.front());
  studies::MapTask task = task_of(first.description);
  studies::MapEvaluations evaluations(studies::evaluation_count(task));
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
    const PartRows rows = read_rows(file.text, task, file.part, evaluations);
    if (rows.end != file.text.size())
      fail_to_merge(name, fmt::format("is damaged in line {}", rows.count + 3));
    if (const auto count = file.part.numbers(evaluations.size()).size(); rows.count != count)
      fail_to_merge(name, fmt::format("is not finished: it holds {} of {} evaluations", rows.count, count));
  }
  require_all(file_of_part, files.front());
  return {std::move(task), std::move(evaluations)};
}

}  // namespace stickslip::cli
