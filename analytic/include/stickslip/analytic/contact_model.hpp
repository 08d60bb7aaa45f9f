// SPDX-License-Identifier: MIT
#pragma once

/// A linear structure with one frictional contact, in the modes that it has while the contact is held.
///
/// Coordinates: the amplitudes T_n of the mass-normalised modes of the held contact (kg^(1/2) m), and the
/// displacement u_c of the contact, which carries the static shape σ along:
///
///     u = σ u_c + Σ_n U_n T_n,
///
/// with σ the deflection of the unloaded structure at u_c = 1. (Craig & Bampton, AIAA J. 6, 1313-1319, 1968.)
/// The same coordinates and equations serve stick and slip:
///
///     T_n_tt + a_n u_c_tt + (C x_t)_n + ω_n² T_n                          = b_n s(t)
///     a . T_tt + m_c u_c_tt + (C x_t)_c + k_c u_c + (l . T + l_c u_c)          = b_c s(t) + F_c + f_d
///
/// with x = (T, u_c), s(t) = sin(Ω t), a constant force F_c on the contact (one on the rest shifts T and u_c and
/// leaves its part on the contact), the wall's motion w(t) = W sin(Ω t) + V t, and the nonconservative
/// (follower) force l . T + l_c u_c, which acts on the contact alone. Stick: u_c - w is constant and the last
/// row yields f_d. Slip: f_d = -sgn(v_s) μ(|v_s|) N, v_s = u_c_t - w_t.

#include <cstddef>
#include <vector>

#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

/// A dense matrix, row by row.
class Matrix {
 public:
  Matrix() = default;
  Matrix(std::size_t rows, std::size_t columns) : columns_(columns), values_(rows * columns) {}

  [[nodiscard]] double& operator()(std::size_t row, std::size_t column) {
    return values_[row * columns_ + column];
  }
  [[nodiscard]] const double& operator()(std::size_t row, std::size_t column) const {
    return values_[row * columns_ + column];
  }
  [[nodiscard]] bool empty() const noexcept { return values_.empty(); }
  [[nodiscard]] std::size_t rows() const noexcept { return empty() ? 0 : values_.size() / columns_; }
  [[nodiscard]] std::size_t columns() const noexcept { return columns_; }
  [[nodiscard]] const std::vector<double>& values() const noexcept { return values_; }

 private:
  std::size_t columns_{};
  std::vector<double> values_;
};

/// The structure above, without what moves it and what it rubs against; m modes, none at all for a single mass.
struct HeldStructure {
  std::vector<double> angular_frequency;  ///< ω_n > 0 of the held contact, rad/s; m
  std::vector<double> mass_coupling;      ///< a_n, kg^(1/2); m
  double contact_mass{};                  ///< m_c, kg; m_c - a . a > 0
  double contact_stiffness{};             ///< k_c, N/m
  std::vector<double> follower;           ///< l_n, kg^(1/2)/s²; m
  double contact_follower{};              ///< l_c, N/m
  Matrix damping;                         ///< C, (m + 1) x (m + 1), the contact last; empty if there is none
  /// p, m + 1, the contact last: the load of a base that moves by h(t) is b s(t) = -p h_tt; kg^(1/2), the last one kg
  std::vector<double> participation;

  [[nodiscard]] std::size_t modes() const noexcept { return angular_frequency.size(); }
};

/// The whole model above.
struct ContactModel : HeldStructure {
  std::vector<double> load;         ///< b, m + 1, the contact last
  double contact_force{};           ///< F_c, N
  double load_angular_frequency{};  ///< Ω > 0, rad/s
  double wall_amplitude{};          ///< W, m
  double wall_speed{};              ///< V, m/s
  double normal_force{};            ///< N ≥ 0, newton
  data::FrictionLaw friction{{}};
};

/// Throws std::invalid_argument, naming the part, its size or value and what is allowed.
void require_consistent(const ContactModel& model);

/// The structure of a case in its first `modes` held modes. Throws what HeldBeam throws.
[[nodiscard]] HeldStructure held_structure(const data::Case& problem, int modes);

/// A structure in the frame of a base that moves by h(t) = A0 sin(Ω t): b = A0 Ω² p, and the wall moves by -h. It has no friction.
[[nodiscard]] ContactModel contact_model(HeldStructure structure, const data::HarmonicExcitation& base);
/// A structure under the motion, the friction and the wall of a case.
[[nodiscard]] ContactModel contact_model(HeldStructure structure, const data::Case& problem);
/// That of held_structure(problem, modes).
[[nodiscard]] ContactModel contact_model(const data::Case& problem, int modes);

}  // namespace stickslip::analytic
