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
///     T_n_tt + a_n u_c_tt + (C x_t)_n + ω_n² T_n                          = b_n(t)
///     a . T_tt + m_c u_c_tt + (C x_t)_c + k_c u_c + (l . T + l_c u_c)          = b_c(t) + F_c + f_d
///
/// with x = (T, u_c), loads b(t) with sin(Ω t) and cos(Ω t), or with h_tt, h_t and h of a Drive, a constant force F_c on the contact (one on the rest shifts T and
/// u_c and leaves its part on the contact), the wall's motion w(t) = W sin(Ω t) + V t, and the nonconservative
/// (follower) force l . T + l_c u_c, which acts on the contact alone. Stick: u_c - w is constant and the last
/// row yields f_d. Slip: f_d = -sgn(v_s) μ(|v_s|) N, v_s = u_c_t - w_t.

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

#include "stickslip/analytic/drive.hpp"
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

/// What the base must apply, as a balance of momentum (N) or of its moment about the clamp of a beam (N m): the terms in which a damping
/// between structure and base cancels,
///
///     acceleration · x_tt + drag · x_t + stiffness u_c + s . (h_tt, h_t, h) + lever (l . T + l_c u_c - F_c - f_d),
///
/// where h_tt is -F/(1 kg) under a force F. In a ContactModel s belongs to the LoadFactors.
struct BaseBalance {
  std::vector<double> acceleration, drag;  ///< m + 1, the contact last; the drag empty if there is none
  double stiffness{};                      ///< N/m (or N)
  std::array<double, 3> base{};            ///< s
  double lever{1.0};                       ///< 1, or the length of the beam, m
};

/// The structure above, without what moves it and what it rubs against; m modes, none at all for a single mass.
struct HeldStructure {
  std::vector<double> angular_frequency;  ///< ω_n > 0 of the held contact, rad/s; m
  std::vector<double> mass_coupling;      ///< a_n, kg^(1/2); m
  double contact_mass{};                  ///< m_c, kg; m_c - a . a ≥ 0
  double contact_stiffness{};             ///< k_c, N/m
  std::vector<double> follower;           ///< l_n, kg^(1/2)/s²; m
  double contact_follower{};              ///< l_c, N/m
  Matrix damping;                         ///< C, (m + 1) x (m + 1), the contact last; empty if there is none
  /// p, m + 1, the contact last; kg^(1/2), the last one kg. The load of a base that moves by h(t) is
  ///
  ///     b(t) = -p h_tt - d h_t - e_c h,
  ///
  /// where e_c acts on the contact alone: only there can the base pull a structure that follows it at rest.
  std::vector<double> participation;
  std::vector<double>
      drag;  ///< d, m + 1, the contact last; kg^(1/2)/s, the last one kg/s; empty if there is none
  double base_stiffness{};  ///< e_c, N/m
  double wall_share{
      1.0};  ///< κ: relative to the base the wall moves by V t - κ h(t); 0 for a wall that moves with it
  double moved_mass{};                       ///< rᵀ M r, kg: of what follows base and contact, moved alike
  std::vector<BaseBalance> base_balances{};  ///< of the force, and of the moment of a beam
  /// What other held modes would change; by default there are none.
  struct Omitted {
    double angular_frequency{std::numeric_limits<double>::infinity()};  ///< of the lowest of them, rad/s
    double contact{};                                                   ///< Σ a_n² over them, kg, or more
    double load{};  ///< Σ (L_n/ω_n)² over them, L_n = p_n - κ a_n, kg s², or more
  } omitted{};

  [[nodiscard]] std::size_t modes() const noexcept { return angular_frequency.size(); }
  /// m_c - a . a, what a force on the contact accelerates at once, kg. 0 where it is rounding of m_c: such a contact can stick, but
  /// the equations here do not say how it slips.
  [[nodiscard]] double free_mass() const noexcept;
  /// Whether damping couples no mode with another.
  [[nodiscard]] bool is_uncoupled() const noexcept;
};

/// The whole model above.
struct ContactModel : HeldStructure {
  std::vector<double> load;           ///< of b(t) with sin(Ω t), m + 1, the contact last
  std::vector<double> load_cosine{};  ///< with cos(Ω t), m + 1; empty if there is none
  double contact_force{};             ///< F_c, N
  double load_angular_frequency{};    ///< Ω > 0, rad/s
  double base_amplitude{};            ///< A0, m: u is relative to a base that moves by A0 sin(Ω t)
  double wall_amplitude{};            ///< W, m
  double wall_speed{};                ///< V, m/s
  double normal_force{};              ///< N ≥ 0, newton
  data::FrictionLaw friction{{}};
  /// Of a general motion: b(t) = load h_tt + load_cosine h_t + base_load h, the last on the contact alone; w(t) is that of the drive,
  /// and Ω its highest frequency. W, A0 and V are 0.
  std::shared_ptr<const Drive> drive{};
  double base_load{};  ///< N/m
};

/// Throws std::invalid_argument, naming the part, its size or value and what is allowed.
void require_consistent(const ContactModel& model);
/// Throws data::FieldError, naming model.mass_matrix, for a contact without mass of its own (HeldStructure::free_mass()).
void require_free_mass(const HeldStructure& structure);

/// κ of a case, of one sine or of a general motion.
[[nodiscard]] double wall_share(const data::Case& problem);

/// The structure of a case in its first `modes` held modes. Throws what HeldBeam and held_model() throw.
[[nodiscard]] HeldStructure held_structure(const data::Case& problem, int modes);

/// A structure in the frame of a base that moves by h(t) = A0 sin(Ω t), without friction. A force is that of data::HarmonicExcitation, with
/// a base that rests.
[[nodiscard]] ContactModel contact_model(HeldStructure structure, const data::HarmonicExcitation& base);
/// A structure under the motion, the constant force, the friction and the wall of a case.
[[nodiscard]] ContactModel contact_model(HeldStructure structure, const data::Case& problem);
/// That of held_structure(problem, modes).
[[nodiscard]] ContactModel contact_model(const data::Case& problem, int modes);

}  // namespace stickslip::analytic
