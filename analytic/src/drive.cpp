// SPDX-License-Identifier: MIT
#include "stickslip/analytic/drive.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "stickslip/analytic/contact_model.hpp"

namespace stickslip::analytic {
namespace {

data::GeneralMotion motion_of_base(const data::Case& problem) {
  if (const auto* general = problem.general_motion()) return *general;
  const data::HarmonicExcitation& sine = problem.excitation();
  return {std::vector<data::Sine>{{.frequency_hz = sine.frequency_hz(),
                                   .amplitude = sine.stated(),
                                   .amplitude_of = sine.motion().amplitude_of,
                                   .phase = 0.0}},
          problem.numerics.duration()};
}

// The displacement of a piece as a polynomial of t - begin.
Polynomial displacement_of(const data::MotionPiece& piece, double begin) {
  Polynomial result{piece.displacement, piece.velocity};
  for (std::size_t k = 0; k < piece.acceleration.size(); ++k)
    result.at(k + 2) = piece.acceleration.at(k) / static_cast<double>((k + 1) * (k + 2));
  return begin == piece.begin ? result : shifted(result, piece.begin - begin);
}

}  // namespace

double value(const Polynomial& polynomial, double at) {
  double result = 0.0;
  for (std::size_t k = polynomial.size(); k-- > 0;) result = result * at + polynomial[k];
  return result;
}

Polynomial derivative(const Polynomial& polynomial) {
  Polynomial result{};
  for (std::size_t k = 1; k < polynomial.size(); ++k) result[k - 1] = static_cast<double>(k) * polynomial[k];
  return result;
}

// Horner's scheme, again and again (Taylor shift).
Polynomial shifted(const Polynomial& polynomial, double by) {
  Polynomial result = polynomial;
  for (std::size_t first = 0; first + 1 < result.size(); ++first)
    for (std::size_t k = result.size() - 1; k-- > first;) result[k] -= by * result[k + 1];
  return result;
}

Drive::Drive(const data::Case& problem)
    : base_(motion_of_base(problem)),
      wall_(problem.contact.wall_motion),
      wall_share_(analytic::wall_share(problem)),
      wall_speed_(problem.contact.wall.speed()),
      is_random_(problem.is_random()) {}

Drive::Largest Drive::largest() const {
  Largest result;
  DriveCursor cursor(*this);
  for (double t = 0.0; t < duration(); t = cursor.piece().end) {
    const DrivePiece& piece = cursor.enter(t);
    result.acceleration = std::max(result.acceleration, std::abs(2.0 * piece.base[2]));
    result.wall_velocity = std::max(result.wall_velocity, std::abs(piece.wall[1]));
  }
  return result;
}

double Drive::duration() const {
  return wall_ ? std::min(base_.duration(), wall_->duration()) : base_.duration();
}

double Drive::angular_frequency() const {
  const double base = base_.highest_frequency_hz();
  return 2.0 * std::numbers::pi * (wall_ ? std::max(base, wall_->highest_frequency_hz()) : base);
}

DriveCursor::DriveCursor(const Drive& drive) : drive_(&drive) { enter(0.0); }

void DriveCursor::Place::seek(const data::GeneralMotion& motion, double t) {
  const auto go_to = [&](std::size_t to) {
    piece = to == index + 1 && is_known ? next : motion.piece(to);
    index = to;
    is_known = true;
    is_last = index + 1 == motion.pieces();
    if (!is_last) next = motion.piece(index + 1);
  };
  if (!is_known) go_to(0);
  while (t < piece.begin && index > 0) go_to(index - 1);
  while (!is_last && t >= next.begin) go_to(index + 1);
}

const DrivePiece& DriveCursor::enter(double t) {
  const Drive& drive = *drive_;
  base_.seek(drive.base_, t);
  piece_.begin = base_.piece.begin;
  piece_.end = base_.end();
  piece_.is_last = base_.is_last;
  if (drive.wall_) {
    wall_.seek(*drive.wall_, t);
    piece_.begin = std::max(piece_.begin, wall_.piece.begin);
    piece_.end = std::min(piece_.end, wall_.end());
    piece_.is_last = piece_.is_last && wall_.is_last;
  }
  piece_.base = displacement_of(base_.piece, piece_.begin);
  piece_.wall = drive.wall_ ? displacement_of(wall_.piece, piece_.begin) : Polynomial{};
  for (std::size_t k = 0; k < piece_.wall.size(); ++k) piece_.wall[k] -= drive.wall_share_ * piece_.base[k];
  piece_.wall[0] += drive.wall_speed_ * piece_.begin;
  piece_.wall[1] += drive.wall_speed_;
  return piece_;
}

}  // namespace stickslip::analytic
