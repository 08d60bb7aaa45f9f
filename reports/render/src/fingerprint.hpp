#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace stickslip::report {

/// What something was made from, in 64 bits: the FNV-1a hash of all that is added, in its order. Two
/// different sources share one with a probability of 5e-20.
class Fingerprint {
 public:
  /// Each text is ended by its length, so that "ab", "c" differs from "a", "bc".
  Fingerprint& add(std::string_view text);
  /// The contents of a file; an empty text if there is none.
  Fingerprint& add_file(const std::filesystem::path& file);
  /// Every file of a folder and its subfolders, in the order of their names.
  Fingerprint& add_folder(const std::filesystem::path& folder);

  /// Sixteen hexadecimal digits.
  [[nodiscard]] std::string text() const;

 private:
  std::uint64_t hash_{0xcbf29ce484222325U};
};

}  // namespace stickslip::report
