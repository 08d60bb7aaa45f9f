// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
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
#include "stickslip/data/input_text.hpp"
#include "studies/criterion/map_estimate.hpp"

namespace stickslip::cli {

namespace {

constexpr const char* verdict = "verdict";
constexpr double usual_tolerance = 0.05;

struct MapOptions {
  CaseOptions problem;
  ExcitationOptions excitation;
  std::string x = "frequency=1:120:240";
  std::string y = "amplitude=5e-5:1e-3:20";
  std::optional<std::string> method;
  std::optional<double> duration;
  bool states_only{};
  std::string quantity = verdict;
  std::optional<double> transient;
  std::optional<double> tolerance;
  bool dry_run{};
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

auto cells_in(const studies::CriterionMap& map, studies::CellState state) {
  return std::ranges::count(map.cells, state, &studies::CriterionMap::Cell::state);
}

// Cells with a value of each quantity.
std::ptrdiff_t converged_cells(const studies::CriterionMap& map) {
  return std::ranges::count_if(map.cells, [&](const studies::CriterionMap::Cell& cell) {
    return !cell.response.empty() &&
           std::ranges::all_of(cell.response, [&](const studies::ResponseValue& value) {
             return value.change <= map.tolerance;
           });
  });
}

void print_summary(const studies::CriterionMap& map, const MapOptions& options) {
  std::string counts;
  for (const auto state : all_states)
    counts +=
        fmt::format("{}{} {}", counts.empty() ? "" : ", ", cells_in(map, state), report::to_string(state));
  if (!map.quantities.empty()) counts += fmt::format("; {} converged", converged_cells(map));
  fmt::print("{} cells written to {}: {}\n", map.cells.size(), options.output, counts);
  if (!options.figure.empty()) fmt::print("Drawn in {}\n", options.figure);
}

Json to_json(const studies::MapTask& task, const MapOptions& options) {
  Json object{{"case", task.problem.name}};
  if (task.quantities.empty()) {
    object["method"] = task.method == studies::MapMethod::closed_form ? closed_form_method : "fe";
  } else {
    for (const auto quantity : task.quantities) object["quantities"].push_back(report::to_string(quantity));
    object["transient_s"] = task.transient;
    object["tolerance"] = task.tolerance;
  }
  object["x"] = axis_text(task.x);
  object["y"] = axis_text(task.y);
  object["output"] = options.output;
  return object;
}

Json to_json(const studies::MapTask& task, const studies::CriterionMap& map,
             const std::vector<std::string>& warnings, const MapOptions& options) {
  Json object = to_json(task, options);
  object["figure"] = options.figure.empty() ? Json() : Json(options.figure);
  object["cells"] = map.cells.size();
  for (const auto state : all_states) object["states"][report::to_string(state)] = cells_in(map, state);
  if (!map.quantities.empty()) object["converged"] = converged_cells(map);
  object["warnings"] = warnings;
  return object;
}

void require_output_files(const MapOptions& options) {
  require_json_alone(options.problem.json, "--output", options.output);
  if (options.shard && options.output == "-")
    throw data::InputError("--output is standard output, but --shard needs --output FILE");
  require_different_files({{"--output", options.output}, {"--figure", options.figure}});
}

// An axis whose ends a case may have.
studies::MapAxis axis_of(const std::string& option, const std::string& text) {
  studies::MapAxis axis = parse_axis(option, text);
  for (const double end : {axis.values.front(), axis.values.back()})
    data::require_magnitude(studies::field_of(axis.parameter), end, option);
  return axis;
}

std::vector<std::string> quantity_names() {
  std::vector<std::string> names{verdict};
  for (const auto quantity : studies::all_motion_quantities) names.push_back(report::to_string(quantity));
  return names;
}

// NAME or NAME,NAME...; none for the verdict.
std::vector<studies::MotionQuantity> quantities_of(const std::string& text) {
  if (text == verdict) return {};
  const auto known = quantity_names();
  std::vector<std::string> names;
  for (const std::string_view name : split(text, ',')) {
    names.emplace_back(name);
    if (names.back() == verdict || std::ranges::find(known, names.back()) == known.end())
      throw data::FieldError(
          "--quantity", fmt::format("'{}'", data::printable(names.back())),
          fmt::format("one of {}, or some of those after the first with commas between them{}",
                      data::joined(known), data::suggestion(names.back(), known)));
  }
  return quantities_named(names);
}

// What a map of quantities rules out, or what it needs.
void require_consistent(const MapOptions& options, bool has_quantities) {
  if (has_quantities && options.states_only)
    throw data::InputError("--states-only is an option of the verdict, but --quantity is " +
                           options.quantity);
  if (has_quantities && options.method)
    throw data::InputError("--method is an option of the verdict, but --quantity is " + options.quantity);
  if (!has_quantities && (options.transient || options.tolerance))
    throw data::InputError(fmt::format("{} needs a --quantity of the motion, but it is verdict",
                                       options.transient ? "--transient" : "--tolerance"));
  if (options.tolerance && !(*options.tolerance > 0.0 && *options.tolerance < 1.0))
    throw data::FieldError("--tolerance", *options.tolerance, "above 0 and below 1");
}

studies::MapTask task_of(const MapOptions& options) {
  const auto quantities = quantities_of(options.quantity);
  require_consistent(options, !quantities.empty());
  studies::MapTask task{.problem = load_case(options.problem, options.excitation, options.duration),
                        .x = axis_of("--x", options.x),
                        .y = axis_of("--y", options.y),
                        .method = options.method == finite_element_method
                                      ? studies::MapMethod::finite_elements
                                      : studies::MapMethod::closed_form,
                        .states_only = options.states_only,
                        .quantities = quantities,
                        .tolerance = options.tolerance.value_or(usual_tolerance)};
  for (const auto& [axis, option] : {std::pair(&task.x, "--x"), std::pair(&task.y, "--y")}) {
    require_no_fixed_value(options.excitation, axis->parameter, option);
    if (axis->parameter == studies::Parameter::frequency)
      task.problem.numerics =
          numerics_up_to(axis->values.back(), options.problem, options.excitation, options.duration);
  }
  task.transient = options.transient.value_or(0.5 * task.problem.numerics.duration());
  data::require_rigid(task.problem.contact, "a map, whose tip is held or slides; respond takes it");
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
    open_figure(figure_, options.figure);
  }

  /// Makes the evaluations of a part that an earlier run has not left, and hands all of them to `write`.
  void work(const studies::MapTask& task, const MapPart& part, const auto& write) {
    evaluations_.resize(studies::evaluation_count(task));
    const auto numbers = part.numbers(evaluations_.size());
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
    const std::size_t count = part.numbers(evaluations_.size()).size();
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

void print_estimate(const studies::MapTask& task, const MapOptions& options) {
  const auto numbers = options.shard.value_or(MapPart()).numbers(studies::evaluation_count(task));
  if (numbers.empty())
    throw data::FieldError(
        "--shard", fmt::format("{}/{}", options.shard->part, options.shard->parts),
        fmt::format("of at most {} parts, the evaluations of this map", studies::evaluation_count(task)));
  const report::Interruption interruption([] { return std::string("interrupted; nothing is written"); });
  const studies::MapEstimate estimate = studies::map_estimate(task, numbers);
  const std::size_t cells = task.x.values.size() * task.y.values.size();
  if (options.problem.json)
    return print_json({{"cells", cells},
                       {"evaluations", estimate.evaluations},
                       {"sample", estimate.sample},
                       {"milliseconds_each", 1e3 * estimate.seconds_each},
                       {"core_hours", estimate.core_hours()},
                       {"threads", estimate.threads},
                       {"speedup", estimate.speedup},
                       {"hours", estimate.hours()}});
  fmt::print("{} cells, {} evaluations, of which {} were timed\n", cells, estimate.evaluations,
             estimate.sample);
  fmt::print("one thread   {:.3g} ms for each, {:.3g} core hours in all\n", 1e3 * estimate.seconds_each,
             estimate.core_hours());
  if (estimate.threads > 1)
    fmt::print("{} threads    {:.2f} times as fast, {:.3g} hours in all\n", estimate.threads,
               estimate.speedup, estimate.hours());
}

void run(const MapOptions& options) {
  if (options.dry_run) return print_estimate(task_of(options), options);
  require_output_files(options);
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
    for (const std::string name :
         {"CASE", "--set", "--hz", "--amplitude", "--x", "--y", "--method", "--duration", "--states-only",
          "--quantity", "--transient", "--tolerance", "--dry-run", "--shard"})
      if (option->check_name(name)) merge->excludes(option);
}

void add_motion_options(CLI::App& command, MapOptions& options) {
  command
      .add_option(
          "--quantity", options.quantity,
          "What to map: the verdict of the criterion, or of the motion slip-share (of the time), peak-speed "
          "and rms-speed (of sliding, m/s), travel (m) and work (of friction, J) in a period of the base, "
          "largest-force (N), sticks (in a period) or period (of the motion, in periods of the base; 0 if "
          "none up to 16); some with commas between them give a column each")
      ->type_name("NAME")
      ->capture_default_str();
  command
      .add_option(
          "--transient", options.transient,
          "What a quantity of the motion leaves out from the start, s (default: half of the duration)")
      ->check(time());
  command
      .add_option(
          "--tolerance", options.tolerance,
          "Largest relative change of a quantity, with twice the time step and between the halves of the "
          "record, with which it counts as converged (default: 0.05)")
      ->check(number());
}

}  // namespace

void add_map_command(CLI::App& app) {
  auto* command =
      app.add_subcommand("map", "The criterion or the motion over two parameters, as CSV and as a figure");
  auto options = std::make_shared<MapOptions>();
  add_case_options(*command, options->problem);
  add_excitation_options(*command, options->excitation);
  const std::string axis =
      "PARAMETER=FROM:TO:COUNT, in equal steps, or PARAMETER=FROM:TO:COUNT:log, in equal ratios; PARAMETER "
      "is frequency (Hz), amplitude (m), length (m), force (P, N), stiffness (Young's modulus, Pa), friction "
      "(static coefficient), kinetic (coefficient), decay (s/m), damping (ratio), kelvin-voigt (s) or "
      "direction (of P, chi)";
  command->add_option("--x", options->x, axis)->type_name("AXIS")->capture_default_str();
  command->add_option("--y", options->y, "As --x, another parameter")
      ->type_name("AXIS")
      ->capture_default_str();
  command
      ->add_option("--method", options->method,
                   "Closed form, or one linear finite-element run with the tip held for each evaluation "
                   "(default: closed-form)")
      ->check(one_of({"closed-form", "fe"}));
  command->add_option("--duration", options->duration, "Duration, s (else that of the case)")
      ->check(number());
  command->add_flag("--states-only", options->states_only,
                    "Leave out the force ratio: only whether each cell sticks or slips");
  add_motion_options(*command, *options);
  command->add_flag("--dry-run", options->dry_run,
                    "Write no map, but time some evaluations and print what the map will take");
  command
      ->add_option("--output", options->output,
                   "CSV file, '-' for standard output; what is finished of a long map is kept in "
                   "FILE.partial, from which "
                   "the same command goes on")
      ->check(file_name())
      ->capture_default_str();
  add_figure_option(*command, options->figure);
  add_shard_options(*command, *options);
  add_threads_option(*command);
  add_examples(*command,
               {"stickslip map paper --x frequency=10:40:31 --y amplitude=1e-4:1e-3:10:log "
                "--output map.csv --figure map.svg",
                "stickslip map damped --set numerics.time_step=1e-4 --duration 2 --x frequency=20:30:6 "
                "--y damping=0.002:0.02:3 --quantity work,period --output motion.csv"});
  command->callback([options] { run(*options); });
}

}  // namespace stickslip::cli
