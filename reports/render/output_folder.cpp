// SPDX-License-Identifier: MIT
#include "render/output_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>

#include "stickslip/data/atomic_file.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/data/input_text.hpp"

namespace stickslip::report {

namespace fs = std::filesystem;

namespace {

std::string reason_of(int error) { return std::generic_category().message(error); }

// Held until the process ends or the descriptor is closed.
int lock_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0)
    throw data::InputError(fmt::format("output folder {}: {}", folder.string(), reason_of(errno)));
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  ::close(descriptor);
  throw data::InputError(
      fmt::format("output folder {} is being written by another report; wait for it or name another folder",
                  folder.string()));
}

void move(const fs::path& file, const fs::path& target) {
  data::require_no_input(target);
  std::error_code error;
  if (const auto old = fs::status(target, error); fs::is_regular_file(old))
    fs::permissions(file, old.permissions(), error);
  fs::rename(file, target, error);
  if (error)
    throw std::runtime_error(fmt::format("{} cannot be written: {}", target.string(), error.message()));
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& folder) {
  std::error_code error;
  is_new_ = fs::create_directories(folder, error);
  if (!error) folder_ = fs::canonical(folder, error);
  if (error) throw data::InputError(fmt::format("output folder {}: {}", folder.string(), error.message()));
  lock_ = lock_folder(folder_);
  scratch_ = folder_ / ".stickslip-unfinished";
  fs::remove_all(scratch_, error);  // what an interrupted run has left
  if (!error) fs::create_directory(scratch_, error);
  if (!error) return;
  ::close(lock_);
  throw data::InputError(fmt::format("output folder {}: {}", folder.string(), error.message()));
}

OutputFolder::~OutputFolder() {
  clear_scratch();
  ::close(lock_);
}

void OutputFolder::clear_scratch() const noexcept {
  std::error_code ignored;
  fs::remove_all(scratch_, ignored);
  if (is_new_) fs::remove(folder_, ignored);  // only where it is empty
}

void OutputFolder::write(const std::string& name, std::string_view text) {
  if (std::error_code error; fs::exists(folder_ / name, error) && data::read_text(folder_ / name) == text)
    return;
  data::write_text(scratch_ / name, text);
  publish(scratch_ / name);
}

void OutputFolder::publish(const fs::path& file) { move(file, folder_ / file.filename()); }

}  // namespace stickslip::report
