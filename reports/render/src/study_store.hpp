#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "study_archive.hpp"

namespace stickslip::report {

/// Keeps the results of studies on disk for the next report. A result is found again only under the
/// fingerprint of what made it (the code of the studies and the data that they read); anything else counts as
/// missing.
class StudyStore {
 public:
  /// An empty folder name keeps nothing.
  StudyStore(std::filesystem::path folder, std::string fingerprint)
      : folder_(std::move(folder)), fingerprint_(std::move(fingerprint)) {}

  template <typename Result>
  [[nodiscard]] std::optional<Result> load(const std::string& name) const {
    const std::optional<std::string> bytes = load_bytes(name);
    if (!bytes) return std::nullopt;
    try {
      ArchiveReader reader(*bytes);
      std::optional<Result> result(std::in_place);
      reader.read(*result);
      return reader.at_end() ? result : std::nullopt;
    } catch (const std::runtime_error&) {  // cut short: to be computed anew
      return std::nullopt;
    }
  }

  /// Throws std::runtime_error if the file cannot be written.
  template <typename Result>
  void save(const std::string& name, const Result& result) const {
    ArchiveWriter writer;
    writer.write(result);
    save_bytes(name, writer.bytes());
  }

 private:
  [[nodiscard]] std::optional<std::string> load_bytes(const std::string& name) const;
  void save_bytes(const std::string& name, std::string_view bytes) const;

  std::filesystem::path folder_;
  std::string fingerprint_;
};

}  // namespace stickslip::report
