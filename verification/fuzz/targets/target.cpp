// SPDX-License-Identifier: MIT
#include "target.hpp"

#include <sys/mman.h>
#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>

namespace stickslip::fuzz {

std::vector<std::string> split(Bytes bytes) {
  constexpr std::uint8_t separator = 0x1e;
  std::vector<std::string> parts(1);
  for (const std::uint8_t byte : bytes) {
    if (byte == separator)
      parts.emplace_back();
    else
      parts.back() += static_cast<char>(byte);
  }
  return parts;
}

void require_sentence(const std::exception& error) {
  const std::string_view text(error.what());
  if (text.empty()) throw Violation("an error message is empty");
  if (std::ranges::any_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x20U; }))
    throw Violation("an error message is not one line of text: " + std::string(text));
}

MemoryFile::MemoryFile() : descriptor_(::memfd_create("input", MFD_CLOEXEC)) {
  if (descriptor_ < 0) throw std::system_error(errno, std::generic_category(), "memfd_create");
}

MemoryFile::~MemoryFile() { ::close(descriptor_); }

std::filesystem::path MemoryFile::with(std::string_view text) {
  if (::ftruncate(descriptor_, 0) != 0 ||
      ::pwrite(descriptor_, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size()))
    throw std::system_error(errno, std::generic_category(), "the file in memory");
  return "/proc/self/fd/" + std::to_string(descriptor_);
}

}  // namespace stickslip::fuzz
