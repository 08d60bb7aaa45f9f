// SPDX-License-Identifier: MIT
#pragma once

/// The speed of the fast methods compared with plain ones, as recorded by the last run of the benchmarks
/// (verification/benchmarks/results).

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace stickslip::benchmarks {

/// The times of the same work by a plain and by a fast method in one run.
struct SpeedComparison {
  /// The load per step of the fast method, and its fraction of the measured peak performance.
  struct Load {
    double flops_per_step{}, bytes_per_step{};
    double share_of_flops{};  ///< of the peak rate of multiplications and additions in registers
    double share_of_bytes{};  ///< of the bandwidth of the second-level cache
  };
  std::string work;
  std::string plain, fast;  ///< descriptions of the methods
  double plain_seconds{}, fast_seconds{};
  std::optional<Load> load;
  [[nodiscard]] double ratio() const { return plain_seconds / fast_seconds; }
};

/// The content of a record.
struct SpeedRecord {
  std::string processor;
  std::vector<SpeedComparison> comparisons;
  std::vector<int> elements;                  ///< numbers of elements of the plain stick run
  std::vector<double> seconds_per_element{};  ///< time per element and step for each of these numbers
};

/// Reads the record. Throws data::InputError if the file is not a valid record.
[[nodiscard]] SpeedRecord read_speed_record();
[[nodiscard]] SpeedRecord read_speed_record(const std::filesystem::path& file);

/// The text of the record as a TOML file.
[[nodiscard]] std::string text_of(const SpeedRecord& record);

}  // namespace stickslip::benchmarks
