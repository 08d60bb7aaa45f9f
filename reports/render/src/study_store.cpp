#include "study_store.hpp"

#include "stickslip/report/text_file.hpp"

namespace stickslip::report {

namespace fs = std::filesystem;

std::optional<std::string> StudyStore::load_bytes(const std::string& name) const {
  if (folder_.empty()) return std::nullopt;
  std::string bytes = read_text(folder_ / name);
  if (!bytes.starts_with(fingerprint_)) return std::nullopt;
  return bytes.substr(fingerprint_.size());
}

void StudyStore::save_bytes(const std::string& name, std::string_view bytes) const {
  if (folder_.empty()) return;
  fs::create_directories(folder_);
  replace_text(folder_ / name, fingerprint_ + std::string(bytes));
}

}  // namespace stickslip::report
