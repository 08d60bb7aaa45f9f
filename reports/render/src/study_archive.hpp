#pragma once

/// The results of studies as bytes, so that a report whose studies have not changed need not repeat them.
/// A result is an aggregate of numbers, words, vectors, optionals and further aggregates, written field by
/// field in the order of its declaration, in this machine's representation.

#include <boost/pfr/core.hpp>
#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace stickslip::report {

template <typename T>
concept Scalar = std::is_arithmetic_v<T> || std::is_enum_v<T>;

class ArchiveWriter {
 public:
  template <Scalar T>
  void write(const T& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void write(const std::string& text) {
    write(std::uint64_t{text.size()});
    bytes_ += text;
  }
  template <typename T>
  void write(const std::vector<T>& values) {
    write(std::uint64_t{values.size()});
    for (const T& value : values) write(value);
  }
  template <typename T>
  void write(const std::optional<T>& value) {
    write(value.has_value());
    if (value) write(*value);
  }
  template <typename T>
  requires std::is_aggregate_v<T>
  void write(const T& aggregate) {
    boost::pfr::for_each_field(aggregate, [this](const auto& field) { write(field); });
  }

  [[nodiscard]] const std::string& bytes() const noexcept { return bytes_; }

 private:
  std::string bytes_;
};

/// Reads what ArchiveWriter wrote. Throws std::runtime_error if the bytes end too early.
class ArchiveReader {
 public:
  explicit ArchiveReader(std::string_view bytes) : rest_(bytes) {}

  template <Scalar T>
  void read(T& value) {
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
  }
  void read(std::string& text) { text = take(size()); }
  template <typename T>
  void read(std::vector<T>& values) {
    values.clear();
    for (std::uint64_t left = size(); left > 0; --left) read(values.emplace_back());
  }
  template <typename T>
  void read(std::optional<T>& value) {
    bool present{};
    read(present);
    value.reset();
    if (present) read(value.emplace());
  }
  template <typename T>
  requires std::is_aggregate_v<T>
  void read(T& aggregate) {
    boost::pfr::for_each_field(aggregate, [this](auto& field) { read(field); });
  }

  [[nodiscard]] bool at_end() const noexcept { return rest_.empty(); }

 private:
  std::string_view take(std::uint64_t count) {
    if (count > rest_.size()) throw std::runtime_error("the archive of a study is cut short");
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }
  std::uint64_t size() {
    std::uint64_t value{};
    read(value);
    return value;
  }

  std::string_view rest_;
};

}  // namespace stickslip::report
