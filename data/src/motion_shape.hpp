// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <charconv>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "stickslip/data/general_motion.hpp"

namespace stickslip::data {

struct MotionState {
  double displacement{}, velocity{}, acceleration{};
};

/// At a time of the piece.
[[nodiscard]] MotionState state_in(const MotionPiece& piece, double t);

/// The motion of a statement with the scale 1.
class MotionShape {
 public:
  MotionShape(GeneralMotion::Statement stated, double duration, std::string_view table)
      : statement(std::move(stated)), lasts(duration), table_name(table) {}
  MotionShape(const MotionShape&) = delete;
  MotionShape& operator=(const MotionShape&) = delete;
  virtual ~MotionShape() = default;

  [[nodiscard]] virtual MotionState at(double t) const = 0;
  [[nodiscard]] virtual std::size_t pieces() const = 0;
  [[nodiscard]] virtual MotionPiece piece(std::size_t index) const = 0;

  GeneralMotion::Statement statement;
  double lasts;  // s
  std::string table_name;
  double piece_error{}, interpolation_error{}, highest_hz{};
};

/// "excitation.sweep"
[[nodiscard]] inline std::string key_in(std::string_view table, std::string_view name) {
  return std::string(table) + "." + std::string(name);
}

/// With four digits.
[[nodiscard]] inline std::string short_text(double value) {
  std::array<char, 32> text{};
  return {text.data(),
          std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 4).ptr};
}

/// Throws FieldError.
[[nodiscard]] std::unique_ptr<MotionShape> recorded_motion(MotionRecord record, std::string_view table);
[[nodiscard]] std::unique_ptr<MotionShape> random_motion(PowerSpectrum spectrum, double duration,
                                                         std::string_view table);

}  // namespace stickslip::data
