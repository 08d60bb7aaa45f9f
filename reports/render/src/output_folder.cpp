#include "stickslip/report/output_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <system_error>

#include "stickslip/data/case_file.hpp"

namespace stickslip::report {

namespace fs = std::filesystem;

namespace {

std::string reason_of(int error) { return std::generic_category().message(error); }

[[noreturn]] void fail(const fs::path& file, const std::string& reason) {
  throw std::runtime_error(fmt::format("{} cannot be written: {}", file.string(), reason));
}

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

}  // namespace

OutputFolder::OutputFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error) folder_ = fs::canonical(folder, error);
  if (error) throw data::InputError(fmt::format("output folder {}: {}", folder.string(), error.message()));
  lock_ = lock_folder(folder_);
  scratch_ = folder_ / ".unfinished";
  fs::remove_all(scratch_, error);  // what an interrupted run has left
  if (!error) fs::create_directory(scratch_, error);
  if (!error) return;
  ::close(lock_);
  throw data::InputError(fmt::format("output folder {}: {}", folder.string(), error.message()));
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;  // nothing is left to be done about a scratch folder that cannot be removed
  fs::remove_all(scratch_, ignored);
  ::close(lock_);
}

void OutputFolder::write(const std::string& name, std::string_view text) {
  write_text(scratch_ / name, text);
  publish(scratch_ / name);
}

void OutputFolder::publish(const fs::path& file) {
  const fs::path target = folder_ / file.filename();
  std::error_code error;
  fs::rename(file, target, error);
  if (error) fail(target, error.message());
}

void write_text(const fs::path& file, std::string_view text) {
  const auto close = [](std::FILE* stream) { std::fclose(stream); };
  std::unique_ptr<std::FILE, decltype(close)> stream(std::fopen(file.c_str(), "wb"), close);
  if (!stream) fail(file, reason_of(errno));
  if (std::fwrite(text.data(), 1, text.size(), stream.get()) != text.size()) fail(file, reason_of(errno));
  if (std::fflush(stream.get()) != 0 || ::fsync(::fileno(stream.get())) != 0) fail(file, reason_of(errno));
}

}  // namespace stickslip::report
