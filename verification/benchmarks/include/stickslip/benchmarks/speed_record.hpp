#pragma once

/// How fast the fast ways are, as the last run of the benchmarks recorded it
/// (verification/benchmarks/results).

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace stickslip::benchmarks {

/// Some work done by the plain way and by the fast one in one run.
struct SpeedComparison {
  /// What the fast way does in a step, and its share of what the machine was measured to do.
  struct Load {
    double flops_per_step{}, bytes_per_step{};
    double share_of_flops{};  ///< of multiplications and additions in registers
    double share_of_bytes{};  ///< of the bandwidth of the second-level cache
  };
  std::string work;
  std::string plain, fast;  ///< the ways, in words
  double plain_seconds{}, fast_seconds{};
  std::optional<Load> load;
};

struct SpeedRecord {
  std::string processor;
  std::vector<SpeedComparison> comparisons;
  std::vector<int> elements;                  ///< of the plain stick run
  std::vector<double> seconds_per_element{};  ///< and step, of as many elements
};

/// Throws data::InputError for a record that cannot be used.
[[nodiscard]] SpeedRecord read_speed_record();
[[nodiscard]] SpeedRecord read_speed_record(const std::filesystem::path& file);

/// The record as a TOML file.
[[nodiscard]] std::string text_of(const SpeedRecord& record);

}  // namespace stickslip::benchmarks
