// SPDX-License-Identifier: MIT
#pragma once

/// General motions of base and wall as polynomials, piece by piece, as the exact propagation of a held structure takes them.

#include <array>
#include <cstddef>
#include <optional>

#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

/// Σ c_k τ^k.
using Polynomial = std::array<double, 10>;

[[nodiscard]] double value(const Polynomial& polynomial, double at);
[[nodiscard]] Polynomial derivative(const Polynomial& polynomial);
/// q(τ) = p(τ - by).
[[nodiscard]] Polynomial shifted(const Polynomial& polynomial, double by);

/// h and w on one interval, as polynomials of τ = t - begin.
struct DrivePiece {
  double begin{}, end{};  ///< s
  bool is_last{};
  Polynomial base{};  ///< h, m; of a force F on the load of a data::Model its h_tt is -F per kg
  Polynomial wall{};  ///< w, the wall relative to the base, m
};

/// What moves a structure where base or wall have a data::GeneralMotion. A sine beside it is a sum of one sine.
class Drive {
 public:
  /// Throws what data::GeneralMotion throws.
  explicit Drive(const data::Case& problem);

  [[nodiscard]] double duration() const;
  /// Of the highest frequency, rad/s.
  [[nodiscard]] double angular_frequency() const;
  /// Spectra alone move base and wall.
  [[nodiscard]] bool is_random() const { return is_random_; }
  [[nodiscard]] bool base_moves() const { return !base_.is_force(); }
  /// κ: w = (motion of the wall) + V t - κ h.
  [[nodiscard]] double wall_share() const { return wall_share_; }
  /// The largest at the begins of the pieces. It takes a look at each.
  struct Largest {
    double acceleration{}, wall_velocity{};  ///< |h_tt|, m/s²; |w_t|, m/s
  };
  [[nodiscard]] Largest largest() const;

 private:
  friend class DriveCursor;
  data::GeneralMotion base_;
  std::optional<data::GeneralMotion> wall_;
  double wall_share_, wall_speed_;
  bool is_random_;
};

/// Where a run is in a drive.
class DriveCursor {
 public:
  explicit DriveCursor(const Drive& drive);

  /// Moves to the piece with begin ≤ t < end, the last one for later times.
  const DrivePiece& enter(double t);
  [[nodiscard]] const DrivePiece& piece() const noexcept { return piece_; }

 private:
  struct Place {
    std::size_t index{};
    data::MotionPiece piece{}, next{};
    bool is_known{}, is_last{};
    [[nodiscard]] double end() const { return is_last ? piece.begin + piece.length : next.begin; }
    void seek(const data::GeneralMotion& motion, double t);
  };

  const Drive* drive_;
  Place base_, wall_;
  DrivePiece piece_;
};

}  // namespace stickslip::analytic
