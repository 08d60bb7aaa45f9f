// SPDX-License-Identifier: MIT
#include "render/text_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <system_error>

namespace stickslip::report {

std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void write_text(const std::filesystem::path& file, std::string_view text) {
  const auto fail = [&file] {
    throw std::runtime_error(
        fmt::format("{} cannot be written: {}", file.string(), std::generic_category().message(errno)));
  };
  const auto close = [](std::FILE* stream) { std::fclose(stream); };
  std::unique_ptr<std::FILE, decltype(close)> stream(std::fopen(file.c_str(), "wb"), close);
  if (!stream) fail();
  if (std::fwrite(text.data(), 1, text.size(), stream.get()) != text.size()) fail();
  if (std::fflush(stream.get()) != 0 || ::fsync(::fileno(stream.get())) != 0) fail();
}

void replace_text(const std::filesystem::path& file, std::string_view text) {
  const std::filesystem::path unfinished = file.string() + ".unfinished";
  try {
    write_text(unfinished, text);
    std::filesystem::rename(unfinished, file);
  } catch (const std::runtime_error&) {
    std::error_code ignored;  // it may not even be there
    std::filesystem::remove(unfinished, ignored);
    throw;
  }
}

}  // namespace stickslip::report
