// SPDX-License-Identifier: MIT
#pragma once

/// What `map` does: a whole map, a part of one, the map that parts make, or what a map costs.
///
/// Parts of the evaluations of a map are CSV files: the output of --shard, and what is kept of an unfinished map.
///
/// The first line is a comment with a JSON object: which map it is (the case, the axes, the method, the program) and which
/// part of it. Then come the names of the columns, and a row for each evaluation: its number, the bounds of |f_max| per metre
/// of amplitude or the state of its cell, and the value and change of each quantity.

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "answer.hpp"
#include "command.hpp"
#include "studies/analyses/criterion_map.hpp"

namespace stickslip::cli {

inline constexpr std::size_t most_parts = 1'000'000;

inline constexpr std::array<studies::CellState, 3> all_states{analytic::Verdict::stick,
                                                              analytic::Verdict::stick_slip, std::nullopt};

/// Part 1 ... `parts` of the evaluations of a map (studies::share_of).
struct MapPart {
  std::size_t part = 1, parts = 1;

  [[nodiscard]] bool exists() const { return 1 <= part && part <= parts && parts <= most_parts; }

  /// The numbers of its evaluations, of so many in all.
  [[nodiscard]] std::vector<std::size_t> numbers(std::size_t evaluations) const {
    return studies::share_of(evaluations, part, parts);
  }
};

/// "K/M". Throws data::InputError, naming the option --shard, unless 1 <= K <= M <= 1000000.
[[nodiscard]] MapPart parse_part(std::string_view text);

/// The quantities with these names, each once. Throws std::invalid_argument for another name.
[[nodiscard]] std::vector<const studies::MotionQuantity*> quantities_named(
    const std::vector<std::string_view>& names);

[[nodiscard]] std::string names_of(const std::vector<const studies::MotionQuantity*>& quantities);

/// The text of a file with all evaluations of a part.
[[nodiscard]] std::string part_text(const studies::MapTask& task, const MapPart& part,
                                    const studies::MapEvaluations& evaluations);

/// Its first two lines, and one of its rows.
[[nodiscard]] std::string part_header(const studies::MapTask& task, const MapPart& part);
[[nodiscard]] std::string part_row(const studies::MapTask& task, std::size_t number,
                                   const studies::MapEvaluation& evaluation);

/// Which map and which part a text says it holds, if it does, and the map itself.
[[nodiscard]] std::optional<Json> description_in(std::string_view text);
[[nodiscard]] studies::MapTask task_of(const Json& description);

/// Which entry of two descriptions differs, whichever part they are of.
[[nodiscard]] std::optional<std::string> difference(Json found, Json wanted);

/// Takes the rows behind the header, up to the first that is torn, unreadable, double or of another part.
struct PartRows {
  std::size_t count{}, end{};  ///< the end is a position in the text
};
[[nodiscard]] PartRows read_rows(std::string_view text, const studies::MapTask& task, const MapPart& part,
                                 studies::MapEvaluations& evaluations);

/// Whether a file holds all evaluations of this part of this map, made by this program.
[[nodiscard]] bool holds_part(const std::filesystem::path& file, const studies::MapTask& task,
                              const MapPart& part);

/// The map that the files of all its parts make, with all its evaluations. Throws data::InputError, naming the file and what is wrong
/// with it, unless they belong to one map made by this program and no evaluation is missing, double or unreadable.
[[nodiscard]] std::pair<studies::MapTask, studies::MapEvaluations> merged(
    const std::vector<std::string>& files);

/// What is finished of a part, beside its output: added to as the work goes on, whatever ends it, and read
/// by the next run of the same work.
class UnfinishedMap {
 public:
  /// An empty path keeps nothing. Throws data::InputError, naming the file, if it belongs to other work or
  /// to a run that goes on; data::OutputError if it cannot be written.
  UnfinishedMap(std::filesystem::path file, const studies::MapTask& task, const MapPart& part,
                studies::MapEvaluations& evaluations);
  ~UnfinishedMap();
  UnfinishedMap(const UnfinishedMap&) = delete;
  UnfinishedMap& operator=(const UnfinishedMap&) = delete;

  [[nodiscard]] const std::filesystem::path& file() const noexcept { return file_; }
  [[nodiscard]] std::size_t found() const noexcept { return found_; }  ///< evaluations of earlier runs
  [[nodiscard]] std::size_t kept() const noexcept { return kept_; }    ///< and of this one; 0 without a file

  /// Throws data::OutputError.
  void keep(std::span<const std::size_t> numbers);

  /// Does the work that keeps evaluations here. Removes the file if that throws data::InputError, since this
  /// map cannot be finished then; any other exception leaves it for the next run.
  void remove_if_impossible(const std::function<void()>& work);

  void remove();

 private:
  void open();
  void append(std::string_view text);
  [[noreturn]] void fail() const;

  std::filesystem::path file_;
  const studies::MapTask& task_;
  const studies::MapEvaluations& evaluations_;
  std::size_t found_{};
  std::atomic<std::size_t> kept_{};  // read by the thread that an interruption wakes
  std::FILE* stream_{};
};

/// Makes the evaluations that no earlier run has left, and writes the map to the open files of --output and --figure.
[[nodiscard]] Answer whole_map(const studies::MapTask& task, Outputs& outputs);

/// The same of one part, which is written as the evaluations that it is; one that is complete already is left alone.
[[nodiscard]] Answer part_of_map(const studies::MapTask& task, const MapPart& part, Outputs& outputs);

/// Writes the map that the files of all parts make.
[[nodiscard]] Answer merged_map(const std::vector<std::string>& parts, Outputs& outputs);

/// Times some evaluations of a part and tells what all of them take. Writes nothing.
[[nodiscard]] Answer cost_of_map(const studies::MapTask& task, const MapPart& part, Outputs& outputs);

}  // namespace stickslip::cli
