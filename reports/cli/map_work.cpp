// SPDX-License-Identifier: MIT
#include "map_work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "case_options.hpp"
#include "map_file.hpp"
#include "range_text.hpp"
#include "render/criterion_map.hpp"

namespace stickslip::cli {

namespace {

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
  object.update({{"x", axis_text(task.x)},
                 {"y", axis_text(task.y)},
                 {"shard", task.part.part},
                 {"shards", task.part.parts},
                 {"output", outputs.path("--output")}});
  return object;
}

void add_cells(const studies::CriterionMap& map, const std::string& place, Outputs& outputs, Answer& answer) {
  const std::string figure = outputs.path("--figure");
  Json object{{"figure", figure.empty() ? Json() : Json(figure)}, {"cells", map.cells.size()}};
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
  answer.add_line(fmt::format("{} cells {}: {}", map.cells.size(), place, counts));
  if (!figure.empty())
    answer.add_line(fmt::format("Drawn in {}{}", figure,
                                map.quantities.size() > 1
                                    ? fmt::format(": {}, the first quantity", map.quantities.front()->name)
                                    : ""));
  answer.add_members(object);
}

}  // namespace

Answer made_map(const studies::MapTask& task, Outputs& outputs) {
  outputs.set_case(task.problem);
  report::Progress& progress = outputs.progress("", studies::evaluation_count(task));
  const studies::CriterionMap map = studies::criterion_map(task, [&](double share) { progress(share); });
  const report::CsvTable table = report::table_of(task.problem, map);
  if (task.part.part == 1)
    outputs.write_table("--output", [&] { return table.text(); });
  else
    outputs.write("--output", [&] { return std::string(table.rows()); });
  outputs.draw(task.problem.name,
               [&](const report::Look& look) { return report::draw(table.text(), map, look); });
  Answer answer;
  answer.add_members(to_json(task, outputs));
  add_cells(map, "written to " + outputs.path("--output"), outputs, answer);
  answer.warnings = sentences_of(studies::map_warnings(task));
  return answer;
}

Answer drawn_map(const std::string& file, const std::string& figure, Outputs& outputs) {
  const MapFile read = read_map(file);
  outputs.open({{"--figure", figure}});
  outputs.draw(read.case_name,
               [&](const report::Look& look) { return report::draw(read.table, read.map, look); });
  Answer answer;
  add_cells(read.map, "in " + file, outputs, answer);
  return answer;
}

Answer cost_of_map(const studies::MapTask& task, Outputs& outputs) {
  const std::size_t all = task.x.values.size() * task.y.values.size();
  const auto [first, last] = task.part.of(all);
  const std::size_t cells = last - first;
  if (cells == 0)
    throw data::FieldError("--shard", fmt::format("{}/{}", task.part.part, task.part.parts),
                           fmt::format("of at most {} parts, the cells of this map", all));
  outputs.set_case(task.problem);
  outputs.open({});
  const studies::MapEstimate estimate = studies::map_estimate(task);
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
