// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "stickslip/data/general_motion.hpp"

namespace stickslip::data {

/// What a case says of the file of a record.
struct RecordKeys {
  std::string table;                ///< "excitation"
  std::string column;               ///< of the samples
  AmplitudeOf quantity{};           ///< of the samples
  std::optional<std::string> unit;  ///< unless the name of the column says it
  std::optional<double> rate_hz;    ///< unless there is a column of time
};

/// The record with its samples and times, read in parts. The times are equidistant if none is off by more than a hundredth of the
/// step. Throws InputError, naming the file and the row or line, for a column that is missing or twice there, a cell that is
/// no finite number, times that do not increase or have a step beyond 1.5 of the median either way; FieldError for the unit and for
/// a rate besides a column of time.
[[nodiscard]] MotionRecord read_record(const std::filesystem::path& file, const RecordKeys& keys);

}  // namespace stickslip::data
