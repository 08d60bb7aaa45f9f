#include "output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace stickslip::cli {

namespace fs = std::filesystem;

OutputFile::OutputFile(const std::string& path) : path_(path) {
  if (path == "-") {
    stream_ = stdout;
    return;
  }
  std::error_code error;
  const auto status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    open_directly();
    return;
  }
  target_ = fs::weakly_canonical(path, error);
  if (error) throw OutputError(fmt::format("output {} cannot be written: {}", path, error.message()));
  open_temporary();
}

OutputFile::~OutputFile() {
  if (stream_ != nullptr && stream_ != stdout) std::fclose(stream_);
  discard();
}

void OutputFile::open_directly() {
  stream_ = std::fopen(path_.c_str(), "wb");
  if (stream_ == nullptr) fail();
}

void OutputFile::open_temporary() {
  if (::access(target_.c_str(), W_OK) != 0 && errno != ENOENT) fail();
  const fs::path beside =
      target_.parent_path() / fmt::format(".{}.{}", target_.filename().string(), ::getpid());
  const int descriptor = ::open(beside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) fail();
  temporary_ = beside;
  stream_ = ::fdopen(descriptor, "wb");
  if (stream_ == nullptr) fail();
}

void OutputFile::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stream_) != text.size()) fail();
}

void OutputFile::commit() {
  if (std::fflush(stream_) != 0) fail();
  if (stream_ == stdout) return;
  if (!temporary_.empty() && ::fsync(::fileno(stream_)) != 0) fail();
  if (std::fclose(std::exchange(stream_, nullptr)) != 0) fail();
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail();
}

void OutputFile::discard() const noexcept {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());  // once in place it has this name no longer
}

void OutputFile::fail() const {
  const std::string reason = std::generic_category().message(errno);
  throw OutputError(
      fmt::format("output {} cannot be written: {}", path_ == "-" ? "to standard output" : path_, reason));
}

}  // namespace stickslip::cli
