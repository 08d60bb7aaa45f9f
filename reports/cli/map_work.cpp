// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <system_error>

#include "case_options.hpp"
#include "map_part.hpp"
#include "range_text.hpp"
#include "render/criterion_map.hpp"
#include "studies/analyses/criterion_map.hpp"

namespace stickslip::cli {

namespace {

namespace fs = std::filesystem;

// Cells with a value of each quantity.
std::vector<std::ptrdiff_t> converged_cells(const studies::CriterionMap& map) {
  std::vector<std::ptrdiff_t> counts(map.quantities.size());
  for (const auto& cell : map.cells)
    for (std::size_t i = 0; i < cell.response.size(); ++i)
      counts[i] += cell.response[i].change <= map.tolerance ? 1 : 0;
  return counts;
}

Json to_json(const studies::MapTask& task, Outputs& outputs) {
  Json object;
  if (task.quantities.empty()) {
    object["method"] = task.method->name;
  } else {
    for (const auto* quantity : task.quantities) object["quantities"].push_back(quantity->name);
    object["transient_s"] = task.transient;
    object["tolerance"] = task.tolerance;
  }
  object.update({{"x", axis_text(task.x)}, {"y", axis_text(task.y)}, {"output", outputs.path("--output")}});
  return object;
}

Answer answer_of(const studies::MapTask& task, const studies::CriterionMap& map, Outputs& outputs) {
  Answer answer;
  const std::string figure = outputs.path("--figure");
  Json object = to_json(task, outputs);
  object.update({{"figure", figure.empty() ? Json() : Json(figure)}, {"cells", map.cells.size()}});
  std::string counts;
  for (const auto& state : all_states) {
    const auto count = std::ranges::count(map.cells, state, &studies::CriterionMap::Cell::state);
    object["states"][studies::name_of(state)] = count;
    counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", count, studies::name_of(state));
  }
  if (!map.quantities.empty()) {
    const auto converged = converged_cells(map);
    counts += "; converged:";
    for (std::size_t i = 0; i < converged.size(); ++i) {
      object["converged"][std::string(map.quantities[i]->name)] = converged[i];
      counts += fmt::format("{} {} {}", i > 0 ? "," : "", converged[i], map.quantities[i]->name);
    }
  }
  answer.add_line(
      fmt::format("{} cells written to {}: {}", map.cells.size(), outputs.path("--output"), counts));
  if (!figure.empty())
    answer.add_line(fmt::format("Drawn in {}{}", figure,
                                map.quantities.size() > 1
                                    ? fmt::format(": {}, the first quantity", map.quantities.front()->name)
                                    : ""));
  answer.add_members(object);
  answer.warnings = sentences_of(studies::map_warnings(task));
  return answer;
}

Answer answer_of(const studies::MapTask& task, const MapPart& part, bool found, Outputs& outputs) {
  const std::size_t all = studies::evaluation_count(task), count = part.numbers(all).size();
  Answer answer;
  answer.add_line(fmt::format("Shard {} of {}, {} of {} evaluations, {} {}", part.part, part.parts, count,
                              all, found ? "is complete already in" : "written to",
                              outputs.path("--output")));
  answer.add_members(to_json(task, outputs));
  answer.add_members(
      {{"shard", part.part}, {"shards", part.parts}, {"evaluations", count}, {"complete_already", found}});
  return answer;
}

Answer finish(const studies::MapTask& task, const studies::MapEvaluations& evaluations, Outputs& outputs,
              UnfinishedMap* unfinished = nullptr) {
  const studies::CriterionMap map = studies::criterion_map(task, evaluations);
  const report::CsvTable table = report::table_of(task.problem, map);
  outputs.write_table("--output", [&] { return table.text(); });
  if (unfinished != nullptr) unfinished->remove();
  outputs.draw(task.problem.name, [&](const report::Look& look) { return report::draw(table, map, look); });
  return answer_of(task, map, outputs);
}

// Nothing is kept of what goes to a pipe or a device.
fs::path unfinished_file(const std::string& output) {
  std::error_code error;
  const auto status = fs::status(output, error);
  return output != "-" && (!fs::exists(status) || fs::is_regular_file(status)) ? output + ".partial" : "";
}

// Makes the evaluations of a part that an earlier run has not left.
std::shared_ptr<UnfinishedMap> evaluate(const studies::MapTask& task, const MapPart& part,
                                        studies::MapEvaluations& evaluations, Outputs& outputs) {
  auto numbers = part.numbers(evaluations.size());
  const std::size_t count = numbers.size();
  const auto unfinished =
      std::make_shared<UnfinishedMap>(unfinished_file(outputs.path("--output")), task, part, evaluations);
  report::Progress& progress = outputs.progress("", count);
  outputs.on_interrupt([unfinished, count] {
    if (unfinished->kept() > 0)
      return fmt::format(
          "interrupted; {} of {} evaluations are kept in {}, from which the same command goes on",
          unfinished->kept(), count, unfinished->file().string());
    unfinished->remove();
    return std::string("interrupted; no evaluation is kept");
  });
  std::size_t done = unfinished->found();
  const auto share = [&] { return static_cast<double>(done) / static_cast<double>(count); };
  if (done > 0 && !outputs.is_quiet())
    report::tell("stickslip map", fmt::format("going on from {}, which holds {} of {} evaluations",
                                              unfinished->file().string(), done, count));
  progress.start_at(done > 0 ? share() : 0.0);  // a part may have no evaluation
  std::erase_if(numbers, [&](std::size_t number) { return evaluations[number].has_value(); });
  unfinished->remove_if_impossible([&] {
    studies::evaluate(task, numbers, evaluations, [&](std::span<const std::size_t> settled) {
      unfinished->keep(settled);
      done += settled.size();
      progress(share());
    });
  });
  return unfinished;
}

}  // namespace

Answer whole_map(const studies::MapTask& task, Outputs& outputs) {
  outputs.about(task.problem);
  studies::MapEvaluations evaluations(studies::evaluation_count(task));
  const auto unfinished = evaluate(task, MapPart(), evaluations, outputs);
  return finish(task, evaluations, outputs, unfinished.get());
}

Answer part_of_map(const studies::MapTask& task, const MapPart& part, Outputs& outputs) {
  outputs.about(task.problem);
  const std::string output = outputs.path("--output");
  const bool found = holds_part(output, task, part);
  studies::MapEvaluations evaluations(studies::evaluation_count(task));
  if (found) {
    if (const auto file = unfinished_file(output); fs::exists(file))  // killed as it ended
      UnfinishedMap(file, task, part, evaluations).remove();
  } else {
    const auto unfinished = evaluate(task, part, evaluations, outputs);
    outputs.write("--output", [&] { return part_text(task, part, evaluations); });
    unfinished->remove();
  }
  return answer_of(task, part, found, outputs);
}

Answer merged_map(const std::vector<std::string>& parts, Outputs& outputs) {
  const auto [task, evaluations] = merged(parts);
  outputs.about(task.problem);
  return finish(task, evaluations, outputs);
}

Answer cost_of_map(const studies::MapTask& task, const MapPart& part, Outputs& outputs) {
  const std::size_t all = studies::evaluation_count(task),
                    cells = task.x.values.size() * task.y.values.size();
  const auto numbers = part.numbers(all);
  if (numbers.empty())
    throw data::FieldError("--shard", fmt::format("{}/{}", part.part, part.parts),
                           fmt::format("of at most {} parts, the evaluations of this map", all));
  outputs.about(task.problem);
  outputs.open({});
  const studies::MapEstimate estimate = studies::map_estimate(task, numbers);
  Answer answer;
  answer.add_line(fmt::format("{} cells, {} evaluations, of which {} were timed", cells, estimate.evaluations,
                              estimate.sample));
  answer.add_line(fmt::format("one thread   {:.3g} ms for each, {:.3g} core hours in all",
                              1e3 * estimate.seconds_each, estimate.core_hours()));
  if (estimate.threads > 1)
    answer.add_line(fmt::format("{} threads    {:.2f} times as fast, {:.3g} hours in all", estimate.threads,
                                estimate.speedup, estimate.hours()));
  answer.add_members({{"cells", cells},
                      {"evaluations", estimate.evaluations},
                      {"sample", estimate.sample},
                      {"milliseconds_each", 1e3 * estimate.seconds_each},
                      {"core_hours", estimate.core_hours()},
                      {"threads", estimate.threads},
                      {"speedup", estimate.speedup},
                      {"hours", estimate.hours()}});
  return answer;
}

}  // namespace stickslip::cli
