// SPDX-License-Identifier: MIT
#pragma once

/// Evaluations of a map in files: what a part of the map hands in, and what is kept of an unfinished one.
///
/// The first line is a JSON object that says which map it is (the case, the axes, the method, the program)
/// and which part of it; each further line is an evaluation: its number and the bounds of |f_max| per metre
/// of amplitude, with the digits that read back exactly, or its state and each quantity
/// with its change. Every line ends with a check of itself
/// and of the first line, 16 hexadecimal digits.

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "studies/criterion/criterion_map.hpp"

namespace stickslip::cli {

/// How the methods of a map are called on the command line and in files.
inline constexpr std::string_view closed_form_method = "closed-form", finite_element_method = "fe";

inline constexpr std::array all_states{studies::CellState::stick, studies::CellState::stick_slip,
                                       studies::CellState::no_stick_state};

/// Part 1 ... `parts` of the evaluations of a map (studies::share_of).
struct MapPart {
  std::size_t part = 1, parts = 1;

  /// The numbers of its evaluations, of so many in all.
  [[nodiscard]] std::vector<std::size_t> numbers(std::size_t evaluations) const {
    return studies::share_of(evaluations, part, parts);
  }
};

/// "K/M". Throws data::InputError, naming the option --shard, unless 1 <= K <= M <= 1000000.
[[nodiscard]] MapPart parse_part(std::string_view text);

/// The quantities with these names (report::to_string), each once. Throws std::invalid_argument for another name.
[[nodiscard]] std::vector<const studies::MotionQuantity*> quantities_named(
    const std::vector<std::string>& names);

/// The text of a file with all evaluations of a part.
[[nodiscard]] std::string shard_text(const studies::MapTask& task, const MapPart& part,
                                     const studies::MapEvaluations& evaluations);

/// Whether a file holds all evaluations of this part of this map, made by this program, undamaged.
[[nodiscard]] bool holds_shard(const std::filesystem::path& file, const studies::MapTask& task,
                               const MapPart& part);

struct MergedMap {
  studies::MapTask task;
  studies::MapEvaluations evaluations;
};

/// The map that the files of all its parts make. Throws data::InputError, naming the file and what is wrong
/// with it, unless they belong to one map made by this program and none is missing, double or damaged.
[[nodiscard]] MergedMap merged(const std::vector<std::string>& files);

/// What is finished of a part, beside its output: added to as the work goes on, whatever ends it, and read
/// by the next run of the same work.
class UnfinishedMap {
 public:
  /// An empty path keeps nothing. Throws data::InputError, naming the file, if it belongs to other work or
  /// to a run that goes on; OutputError if it cannot be written.
  UnfinishedMap(std::filesystem::path file, const studies::MapTask& task, const MapPart& part,
                studies::MapEvaluations& evaluations);
  ~UnfinishedMap();
  UnfinishedMap(const UnfinishedMap&) = delete;
  UnfinishedMap& operator=(const UnfinishedMap&) = delete;

  [[nodiscard]] const std::filesystem::path& file() const noexcept { return file_; }
  [[nodiscard]] std::size_t found() const noexcept { return found_; }  ///< evaluations of earlier runs
  [[nodiscard]] std::size_t kept() const;                              ///< and of this one; 0 without a file

  /// Throws OutputError.
  void keep(std::span<const std::size_t> numbers);

  /// Does the work that keeps evaluations here. Removes the file if that throws data::InputError, since this
  /// map cannot be finished then; any other exception leaves it for the next run.
  void remove_if_impossible(const std::function<void()>& work);

  /// Removes the file.
  void remove();

 private:
  void open();
  void append(const std::string& text);
  [[noreturn]] void fail() const;

  std::filesystem::path file_;
  std::string header_;
  const studies::MapEvaluations& evaluations_;
  std::size_t found_{}, kept_{};
  int descriptor_{-1};
  mutable std::mutex guard_;
};

}  // namespace stickslip::cli
