#include "fingerprint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "stickslip/report/text_file.hpp"

namespace stickslip::report {

namespace fs = std::filesystem;

Fingerprint& Fingerprint::add(std::string_view text) {
  const auto mix = [this](std::uint64_t byte) { hash_ = (hash_ ^ byte) * 0x100000001b3U; };
  for (const char c : text) mix(static_cast<unsigned char>(c));
  for (std::size_t size = text.size(), i = 0; i < sizeof size; ++i, size >>= 8U) mix(size & 0xffU);
  return *this;
}

Fingerprint& Fingerprint::add_file(const fs::path& file) { return add(read_text(file)); }

Fingerprint& Fingerprint::add_folder(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::ranges::sort(files);
  for (const fs::path& file : files) add(file.lexically_relative(folder).string()).add_file(file);
  return *this;
}

std::string Fingerprint::text() const { return fmt::format("{:016x}", hash_); }

}  // namespace stickslip::report
