// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdio>
#include <functional>
#include <span>

#include "map_part.hpp"

namespace stickslip::cli {

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

  /// Removes the file.
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

}  // namespace stickslip::cli
