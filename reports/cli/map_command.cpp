// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "case_options.hpp"
#include "commands.hpp"
#include "figure_format.hpp"
#include "long_work.hpp"
#include "map_records.hpp"
#include "output_file.hpp"
#include "range_text.hpp"
#include "render/criterion_map.hpp"
#include "render/interruption.hpp"
#include "render/progress.hpp"
#include "render/report.hpp"

namespace stickslip::cli {

namespace {

struct MapOptions {
  CaseOptions problem;
  ExcitationOptions excitation;
  std::string x = "frequency=1:120:240";
  std::string y = "amplitude=5e-5:1e-3:20";
  std::string method = "closed-form";
  std::optional<double> duration;
  bool states_only{};
  std::optional<MapPart> shard;
  std::vector<std::string> merge;
  std::string output = "-";
  std::string figure;
};

// The table is in place by then.
void write_figure(const studies::CriterionMap& map, const report::CsvTable& table, const MapOptions& options,
                  OutputFile& file) {
  try {
    file.write(report::draw(table, map, figure_format(options.figure)));
    file.commit();
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}; the map itself is in {}", error.what(),
                                         options.output == "-" ? "standard output" : options.output));
  }
}

constexpr std::array states{studies::CellState::stick, studies::CellState::stick_slip,
                            studies::CellState::no_stick_state};

auto cells_in(const studies::CriterionMap& map, studies::CellState state) {
  return std::ranges::count(map.cells, state, &studies::CriterionMap::Cell::state);
}

void print_summary(const studies::CriterionMap& map, const MapOptions& options) {
  std::string counts;
  for (const auto state : states)
    counts +=
        fmt::format("{}{} {}", counts.empty() ? "" : ", ", cells_in(map, state), report::to_string(state));
  fmt::print("{} cells written to {}: {}\n", map.cells.size(), options.output, counts);
  if (!options.figure.empty()) fmt::print("Drawn in {}\n", options.figure);
}

Json to_json(const studies::MapTask& task, const MapOptions& options) {
  return {{"case", task.problem.name},
          {"method", task.method == studies::MapMethod::closed_form ? closed_form_method : "fe"},
          {"x", axis_text(task.x)},
          {"y", axis_text(task.y)},
          {"output", options.output}};
}

Json to_json(const studies::MapTask& task, const studies::CriterionMap& map,
             const std::vector<std::string>& warnings, const MapOptions& options) {
  Json object = to_json(task, options);
  object["figure"] = options.figure.empty() ? Json() : Json(options.figure);
  object["cells"] = map.cells.size();
  for (const auto state : states) object["states"][report::to_string(state)] = cells_in(map, state);
  object["warnings"] = warnings;
  return object;
}

void require_output_file(const MapOptions& options) {
  if (options.output != "-") return;
  if (options.problem.json)
    throw data::InputError("--json and --output - both want standard output, but --json needs --output FILE");
  if (options.shard) throw data::InputError("--output is standard output, but --shard needs --output FILE");
}

// An axis whose ends a case may have.
studies::MapAxis axis_of(const std::string& option, const std::string& text) {
  studies::MapAxis axis = parse_axis(option, text);
  for (const double end : {axis.values.front(), axis.values.back()})
    data::require_magnitude(studies::field_of(axis.parameter), end, option);
  return axis;
}

studies::MapTask task_of(const MapOptions& options) {
  studies::MapTask task{.problem = load_case(options.problem, options.excitation, options.duration),
                        .x = axis_of("--x", options.x),
                        .y = axis_of("--y", options.y),
                        .method = options.method == closed_form_method ? studies::MapMethod::closed_form
                                                                       : studies::MapMethod::finite_elements,
                        .states_only = options.states_only};
  studies::require_resting_wall(task.problem);
  return task;
}

// Nothing is kept of what goes to a pipe or a device.
std::filesystem::path unfinished_file(const MapOptions& options) {
  std::error_code error;
  const auto status = std::filesystem::status(options.output, error);
  const bool is_file =
      options.output != "-" && (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status));
  return is_file ? options.output + ".partial" : "";
}

// The files of one run, put in place when the work is done.
class Run {
 public:
  explicit Run(const MapOptions& options) : options_(options), output_(options.output) {
    if (options.figure.empty()) return;
    (void)figure_format(options.figure);
    (void)report::templates_directory();  // throws now rather than after the map
    figure_.emplace(options.figure);
  }

  /// Makes the evaluations of a part that an earlier run has not left, and hands all of them to `write`.
  void work(const studies::MapTask& task, const MapPart& part, const auto& write) {
    evaluations_.resize(studies::evaluation_count(task));
    const auto numbers = studies::share_of(evaluations_.size(), part.part, part.parts);
    UnfinishedMap& unfinished = unfinished_.emplace(unfinished_file(options_), task, part, evaluations_);
    report::Progress& progress = progress_.emplace("stickslip map", progress_surroundings(), numbers.size());
    interruption_.emplace([this, &unfinished, &progress, count = numbers.size()] {
      progress.finish();
      discard();
      return last_words(unfinished, count);
    });
    evaluate(task, numbers, progress);
    progress.finish();
    write(evaluations_);
  }

  void merge(const MergedMap& map) {
    interruption_.emplace([this] {
      discard();
      return is_in_place_ ? map_is_written() : "interrupted; the map is not written";
    });
    finish(map.task, map.evaluations);
  }

  void finish(const studies::MapTask& task, const studies::MapEvaluations& evaluations) {
    const studies::CriterionMap map = studies::criterion_map(task, evaluations);
    const report::CsvTable table = report::table_of(task.problem, map);
    put_in_place(table.text());
    if (figure_) {
      const auto undisturbed = interruption_->hold();
      write_figure(map, table, options_, *figure_);
    }
    const auto warnings =
        sentences_of(studies::warnings_common_to(task.problem, {task.x.parameter, task.y.parameter}));
    print_warnings(warnings);
    if (options_.problem.json)
      print_json(to_json(task, map, warnings, options_));
    else if (options_.output != "-")
      print_summary(map, options_);
  }

  /// Whether an earlier run has finished the shard, and says so.
  [[nodiscard]] bool finds_shard(const studies::MapTask& task, const MapPart& part) {
    if (!holds_shard(options_.output, task, part)) return false;
    evaluations_.resize(studies::evaluation_count(task));
    if (const auto file = unfinished_file(options_); std::filesystem::exists(file))  // killed as it ended
      UnfinishedMap(file, task, part, evaluations_).remove();
    print_shard(task, part, true);
    return true;
  }

  void finish_shard(const studies::MapTask& task, const MapPart& part,
                    const studies::MapEvaluations& evaluations) {
    put_in_place(shard_text(task, part, evaluations));
    print_shard(task, part, false);
  }

  /// Removes what is not in place yet, for a program that ends here.
  void discard() const {
    output_.discard();
    if (figure_) figure_->discard();
  }

 private:
  void evaluate(const studies::MapTask& task, std::vector<std::size_t> numbers, report::Progress& progress) {
    const auto count = static_cast<double>(numbers.size());
    std::size_t done = unfinished_->found();
    if (done > 0) {
      if (!is_quiet())
        fmt::print(stderr, "stickslip map: going on from {}, which holds {} of {} evaluations\n",
                   unfinished_->file().string(), done, numbers.size());
      progress.start_at(static_cast<double>(done) / count);
      std::erase_if(numbers, [&](std::size_t number) { return evaluations_[number].has_value(); });
    }
    unfinished_->remove_if_impossible([&] {
      studies::evaluate(task, numbers, evaluations_, [&](std::span<const std::size_t> settled) {
        unfinished_->keep(settled);
        done += settled.size();
        progress(static_cast<double>(done) / count);
      });
    });
  }

  void print_shard(const studies::MapTask& task, const MapPart& part, bool found) const {
    const std::size_t count = studies::share_of(evaluations_.size(), part.part, part.parts).size();
    if (!options_.problem.json) {
      fmt::print("Shard {} of {}, {} of {} evaluations, {} {}\n", part.part, part.parts, count,
                 evaluations_.size(), found ? "is complete already in" : "written to", options_.output);
      return;
    }
    Json object = to_json(task, options_);
    object["shard"] = part.part;
    object["shards"] = part.parts;
    object["evaluations"] = count;
    object["complete_already"] = found;
    print_json(object);
  }

  void put_in_place(std::string_view text) {
    output_.write(text);
    const auto undisturbed = interruption_->hold();
    output_.commit();
    is_in_place_ = true;
    if (unfinished_) unfinished_->remove();
  }

  [[nodiscard]] std::string map_is_written() const {
    return fmt::format("interrupted; {} is written",
                       options_.output == "-" ? "standard output" : options_.output);
  }

  [[nodiscard]] std::string last_words(UnfinishedMap& unfinished, std::size_t count) const {
    if (is_in_place_) return map_is_written();
    if (unfinished.kept() > 0)
      return fmt::format(
          "interrupted; {} of {} evaluations are kept in {}, from which the same command goes on",
          unfinished.kept(), count, unfinished.file().string());
    unfinished.remove();
    return "interrupted; no evaluation is kept";
  }

  const MapOptions& options_;
  OutputFile output_;
  std::optional<OutputFile> figure_;
  studies::MapEvaluations evaluations_;
  std::optional<UnfinishedMap> unfinished_;
  bool is_in_place_{};
  std::optional<report::Progress> progress_;
  std::optional<report::Interruption> interruption_;
};

void run(const MapOptions& options) {
  require_output_file(options);
  if (!options.merge.empty()) {
    const MergedMap map = merged(options.merge);
    Run run(options);
    return run.merge(map);
  }
  const studies::MapTask task = task_of(options);
  const MapPart part = options.shard.value_or(MapPart());
  Run run(options);
  if (options.shard && run.finds_shard(task, part)) return;
  run.work(task, part, [&](const studies::MapEvaluations& evaluations) {
    if (options.shard)
      run.finish_shard(task, part, evaluations);
    else
      run.finish(task, evaluations);
  });
}

// --merge takes from the shards what the other options say.
void add_shard_options(CLI::App& command, MapOptions& options) {
  auto* shard = command
                    .add_option_function<std::string>(
                        "--shard", [&options](const std::string& text) { options.shard = parse_part(text); },
                        "Make only part K of M of the evaluations and write them to the output, for "
                        "--merge; M runs with one K each make the map")
                    ->type_name("K/M");
  auto* merge = command
                    .add_option("--merge", options.merge,
                                "Make no evaluation, but the map from these files, the outputs of all shards")
                    ->check(file_name())
                    ->type_name("FILE...");
  shard->excludes(command.get_option("--figure"));
  for (CLI::Option* option : command.get_options())
    for (const std::string name : {"CASE", "--set", "--hz", "--amplitude", "--x", "--y", "--method",
                                   "--duration", "--states-only", "--shard"})
      if (option->check_name(name)) merge->excludes(option);
}

}  // namespace

void add_map_command(CLI::App& app) {
  auto* command = app.add_subcommand("map", "The criterion over two parameters, as CSV and as a figure");
  auto options = std::make_shared<MapOptions>();
  add_case_options(*command, options->problem);
  add_excitation_options(*command, options->excitation);
  const std::string axis =
      "PARAMETER=FROM:TO:COUNT, in equal steps, or PARAMETER=FROM:TO:COUNT:log, in equal ratios; PARAMETER "
      "is "
      "frequency (Hz), amplitude (m), length (m), force (P, N), stiffness (Young's modulus, Pa), friction "
      "(static coefficient) or direction (of P, chi)";
  command->add_option("--x", options->x, axis)->type_name("AXIS")->capture_default_str();
  command->add_option("--y", options->y, "As --x, another parameter")
      ->type_name("AXIS")
      ->capture_default_str();
  command
      ->add_option("--method", options->method,
                   "Closed form, or one linear finite-element run with the tip held for each evaluation")
      ->check(one_of({"closed-form", "fe"}))
      ->capture_default_str();
  command->add_option("--duration", options->duration, "Duration, s (else that of the case)")
      ->check(number());
  command->add_flag("--states-only", options->states_only,
                    "Leave out the force ratio: only whether each cell sticks or slips");
  command
      ->add_option("--output", options->output,
                   "CSV file, '-' for standard output; what is finished of a long map is kept in "
                   "FILE.partial, from which "
                   "the same command goes on")
      ->check(file_name())
      ->capture_default_str();
  command
      ->add_option("--figure", options->figure, "Figure to draw, a .png, .pdf or .svg file (needs gnuplot)")
      ->check(file_name());
  add_shard_options(*command, *options);
  add_threads_option(*command);
  add_examples(*command, {"stickslip map paper --x frequency=10:40:31 --y amplitude=1e-4:1e-3:10:log "
                          "--output map.csv --figure map.svg"});
  command->callback([options] { run(*options); });
}

}  // namespace stickslip::cli
