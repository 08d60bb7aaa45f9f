// SPDX-License-Identifier: MIT
#include "stickslip/data/atomic_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "stickslip/data/input_text.hpp"

namespace stickslip::data {

namespace fs = std::filesystem;

namespace {

std::string prefix_of_temporaries(const fs::path& target) {
  return std::string(".").append(target.filename().string()).append(".stickslip-");
}

// Where a path leads to in the end, also by links to what does not exist yet.
fs::path followed(fs::path path, std::error_code& error) {
  constexpr int most_links = 40;
  for (int links = 0; links < most_links && fs::is_symlink(fs::symlink_status(path, error)); ++links)
    path = path.parent_path() / fs::read_symlink(path, error);
  return fs::weakly_canonical(fs::absolute(path, error), error);
}

// Temporary files of the target, made by this user, that no process holds any more.
void remove_abandoned(const fs::path& target) {
  const std::string prefix = prefix_of_temporaries(target);
  std::error_code error;  // what cannot be listed or removed is in nobody's way
  for (const auto& entry : fs::directory_iterator(target.parent_path() / ".", error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(prefix) || name.size() == prefix.size() ||
        name.find_first_not_of("0123456789", prefix.size()) != std::string::npos)
      continue;
    const int descriptor = ::open(entry.path().c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC);
    if (descriptor < 0) continue;
    struct stat status {};
    const bool is_own =
        ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == ::geteuid();
    if (is_own && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0) ::unlink(entry.path().c_str());
    ::close(descriptor);
  }
}

// A new file that stays locked while it is open, or -1. Somebody else's remove_abandoned() may come between
// the two.
int create_locked(const fs::path& file) {
  for (;;) {
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) return -1;
    ::flock(descriptor, LOCK_EX);
    struct stat status {};
    if (::fstat(descriptor, &status) == 0 && status.st_nlink > 0) return descriptor;
    ::close(descriptor);
  }
}

}  // namespace

AtomicFile::AtomicFile(const std::string& path) : path_(path) {
  if (path == "-") {
    stream_ = stdout;
    return;
  }
  if (is_no_regular_file(path)) {
    open_directly();
    return;
  }
  std::error_code error;
  target_ = followed(path, error);
  if (error) throw OutputError("output " + path + " cannot be written: " + error.message());
  open_temporary();
}

AtomicFile::~AtomicFile() {
  if (stream_ != nullptr && stream_ != stdout) std::fclose(stream_);
  discard();
}

void AtomicFile::open_directly() {
  stream_ = std::fopen(path_.c_str(), "wb");
  if (stream_ == nullptr) fail();
}

void AtomicFile::open_temporary() {
  require_no_input(target_);
  if (::access(target_.c_str(), W_OK) != 0 && errno != ENOENT) fail();
  remove_abandoned(target_);
  const fs::path beside =
      target_.parent_path() / (prefix_of_temporaries(target_) + std::to_string(::getpid()));
  const int descriptor = create_locked(beside);
  if (descriptor < 0) fail();
  temporary_ = beside;
  constexpr mode_t permissions = 0777;
  if (struct stat old{}; ::stat(target_.c_str(), &old) == 0) ::fchmod(descriptor, old.st_mode & permissions);
  stream_ = ::fdopen(descriptor, "wb");
  if (stream_ == nullptr) fail();
}

void AtomicFile::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stream_) != text.size()) fail();
}

void AtomicFile::commit() {
  if (std::fflush(stream_) != 0) fail();
  if (stream_ == stdout) return;
  if (!temporary_.empty() && ::fsync(::fileno(stream_)) != 0) fail();
  if (std::fclose(std::exchange(stream_, nullptr)) != 0) fail();
  if (temporary_.empty()) return;
  require_no_input(target_);
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail();
}

void AtomicFile::discard() const noexcept {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());  // once in place it has this name no longer
}

void AtomicFile::fail() const {
  const std::string reason = std::generic_category().message(errno);
  throw OutputError("output " + (path_ == "-" ? "to standard output" : path_) +
                    " cannot be written: " + reason);
}

bool is_no_regular_file(const fs::path& output) {
  std::error_code error;
  const auto status = fs::status(output, error);
  return fs::exists(status) && !fs::is_regular_file(status);
}

bool are_one_file(const fs::path& one, const fs::path& other) {
  std::error_code error;
  return one == other || followed(one, error) == followed(other, error) || fs::equivalent(one, other, error);
}

TemporaryFolder::TemporaryFolder() {
  const char* const chosen = std::getenv("TMPDIR");
  const bool is_chosen = chosen != nullptr && *chosen != '\0';
  std::string name = std::string(is_chosen ? chosen : "/tmp") + "/stickslip-XXXXXX";
  if (::mkdtemp(name.data()) == nullptr)
    throw std::system_error(errno, std::generic_category(),
                            "the temporary folder " + name + " cannot be made");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;  // nothing is left to be done about a folder that cannot be removed
  if (fs::remove_all(path_, ignored); ignored) ::rmdir(path_.c_str());  // needs no descriptor if it is empty
}

void write_text(const std::filesystem::path& file, std::string_view text) {
  AtomicFile output(file.string());
  output.write(text);
  output.commit();
}

std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace stickslip::data
