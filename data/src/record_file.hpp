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

/// A spectrum without points in this unit of its density, as "g^2/Hz" or "(m/s^2)^2/Hz". Throws FieldError, naming the key of `table`.
[[nodiscard]] PowerSpectrum read_spectrum_unit(const std::string& table, const std::string& unit);

/// Adds the points of a file: a column f or frequency, Hz unless it says another unit, and the column that is named or the only other
/// one. Throws InputError or FieldError as read_record().
void read_spectrum(const std::filesystem::path& file, const std::string& table,
                   const std::optional<std::string>& column, PowerSpectrum& spectrum);

}  // namespace stickslip::data
