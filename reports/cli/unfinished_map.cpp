// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "map_part.hpp"
#include "stickslip/data/atomic_file.hpp"

namespace stickslip::cli {

namespace fs = std::filesystem;

UnfinishedMap::UnfinishedMap(fs::path file, const studies::MapTask& task, const MapPart& part,
                             studies::MapEvaluations& evaluations)
    : file_(std::move(file)), task_(task), evaluations_(evaluations) {
  if (file_.empty()) return;
  open();
  const std::string text = data::read_text(file_), wanted = part_header(task, part);
  PartRows rows;
  if (text.starts_with(wanted)) {
    rows = read_rows(text, task, part, evaluations);
  } else if (!wanted.starts_with(text)) {
    std::fclose(stream_);
    const auto found = description_in(text);
    const std::string why =
        !found ? "it is no beginning of a map"
               : difference(*found, description_in(wanted).value())  // as read: infinity is null
                     .value_or(fmt::format("its part is {}, but must be {}",
                                           found->value("part", Json()).dump(), part.part));
    throw data::InputError(
        fmt::format("{} belongs to other work: {}; remove it or name another --output", file_.string(), why));
  }
  if (::ftruncate(::fileno(stream_), static_cast<off_t>(rows.end)) != 0) fail();
  if (rows.end == 0) append(wanted);
  found_ = kept_ = rows.count;
}

UnfinishedMap::~UnfinishedMap() {
  if (stream_ != nullptr) std::fclose(stream_);
}

void UnfinishedMap::keep(std::span<const std::size_t> numbers) {
  if (file_.empty()) return;
  std::string text;
  for (const std::size_t number : numbers) text += part_row(task_, number, *evaluations_[number]);
  append(text);
  kept_ += numbers.size();
}

void UnfinishedMap::remove_if_impossible(const std::function<void()>& work) {
  try {
    work();
  } catch (const data::InputError&) {
    remove();
    throw;
  }
}

void UnfinishedMap::remove() {
  std::error_code ignored;  // nothing is left to be done about a file that cannot be removed
  if (!file_.empty()) fs::remove(file_, ignored);
}

void UnfinishedMap::open() {
  stream_ = std::fopen(file_.c_str(), "abe");
  if (stream_ == nullptr) fail();
  if (::flock(::fileno(stream_), LOCK_EX | LOCK_NB) == 0) return;
  std::fclose(stream_);
  throw data::InputError(fmt::format(
      "{} is being written by another run; wait for it or name another --output", file_.string()));
}

void UnfinishedMap::append(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stream_) != text.size() || std::fflush(stream_) != 0) fail();
}

void UnfinishedMap::fail() const {
  throw data::OutputError(
      fmt::format("{} cannot be written: {}", file_.string(), std::generic_category().message(errno)));
}

}  // namespace stickslip::cli
