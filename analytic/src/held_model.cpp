// SPDX-License-Identifier: MIT
#include "stickslip/analytic/held_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <list>
#include <mutex>
#include <numeric>
#include <utility>

#include "inverse_modes.hpp"

namespace stickslip::analytic {
namespace {

using Entries = std::vector<data::MatrixEntry>;
using Vector = std::vector<double>;

std::size_t at(int row) { return static_cast<std::size_t>(row); }

double dot(const Vector& a, const Vector& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

Vector product(const Entries& matrix, const Vector& x) {
  Vector result(x.size());
  for (const auto& [row, column, value] : matrix) result[at(row)] += value * x[at(column)];
  return result;
}

/// The coordinates u_c, in the place of the contact's row of largest weight, and the other rows, each free one in units that make its
/// stiffness 1 N/m.
class Coordinates {
 public:
  explicit Coordinates(const data::StructureMatrices& matrices)
      : matrices_(matrices),
        contact_(*std::ranges::max_element(matrices.contact, {},
                                           [](const auto& share) { return std::abs(share.weight); })),
        number_(at(matrices.rows)),
        unit_(at(matrices.rows), 1.0) {
    for (const auto* held : {&matrices.base, &matrices.fixed})
      for (const int row : *held) number_[at(row)] = -1;
    number_[at(contact_.row)] = -1;
    for (int row = 0; row < matrices.rows; ++row)
      if (number_[at(row)] == 0) {
        number_[at(row)] = static_cast<int>(free_.size());
        free_.push_back(row);
      }
    const Vector stiffness = diagonal(transformed(matrices.stiffness));
    for (const int row : free_) {
      if (!(stiffness[at(row)] > 0.0))
        throw data::FieldError(
            "model.stiffness_matrix",
            data::shortest_text(stiffness[at(row)]) + " on the diagonal in row " + std::to_string(row + 1),
            "above 0 on the diagonal of each row that is free");
      unit_[at(row)] = 1.0 / std::sqrt(stiffness[at(row)]);
    }
  }

  [[nodiscard]] std::size_t contact() const { return at(contact_.row); }
  [[nodiscard]] const std::vector<int>& free() const { return free_; }
  [[nodiscard]] int free_rows() const { return static_cast<int>(free_.size()); }

  /// Of a transformed matrix, by rows.
  [[nodiscard]] Vector diagonal(const Entries& matrix) const {
    Vector result(unit_.size());
    for (const auto& [row, column, value] : matrix)
      if (row == column) result[at(row)] += value;
    return result;
  }

  [[nodiscard]] Entries transformed(const Entries& matrix) const {
    Entries result;
    result.reserve(matrix.size());
    for (const auto& [row, column, value] : matrix)
      for_each_share(row, [&, j = column, a = value](int i, double left) {
        for_each_share(j, [&](int k, double right) { result.push_back({i, k, left * a * right}); });
      });
    return result;
  }
  [[nodiscard]] Vector transformed(const std::vector<data::WeightedRow>& load) const {
    Vector result(unit_.size());
    for (const auto& [row, weight] : load)
      for_each_share(row, [&, g = weight](int i, double share) { result[at(i)] += share * g; });
    return result;
  }

  /// The part of the free rows, numbered from 0 on.
  [[nodiscard]] Entries free_part(Entries matrix) const {
    std::erase_if(matrix, [&](const auto& entry) {
      return number_[at(entry.row)] < 0 || number_[at(entry.column)] < 0;
    });
    for (auto& [row, column, value] : matrix) {
      row = number_[at(row)];
      column = number_[at(column)];
    }
    return matrix;
  }
  [[nodiscard]] Vector free_part(const Vector& x) const {
    Vector result;
    for (const int row : free_) result.push_back(x[at(row)]);
    return result;
  }
  void add_to_free(Vector& x, std::span<const double> part) const {
    for (std::size_t i = 0; i < free_.size(); ++i) x[at(free_[i])] += part[i];
  }

 private:
  // q_row as a sum over the coordinates.
  template <class Function>
  void for_each_share(int row, const Function& share) const {
    if (row != contact_.row) return share(row, unit_[at(row)]);
    for (const auto& [other, weight] : matrices_.contact)
      share(other, other == row ? 1.0 / contact_.weight : -weight / contact_.weight * unit_[at(other)]);
  }

  const data::StructureMatrices& matrices_;
  data::WeightedRow contact_;
  std::vector<int> number_;  // among the free rows; -1 for the others
  std::vector<int> free_;
  Vector unit_;
};

/// What neither excitation nor [damping] changes, in so many modes or in all there are.
struct Basis {
  Vector angular_frequency;
  Vector base, wall, force;  // M r, M σ and the load on (U_n, σ)
  Vector drag;               // C r on (U_n, σ)
  Matrix damping;            // C
  double contact_stiffness{}, base_stiffness{}, moved_mass{};
  double base_drag{}, support{}, moved_load{};  // rᵀ C r, rᵀ K r and the load on r
  bool is_complete{};
  // xᵀ K x' of the other modes, of M r with itself, of M r with M σ, of M σ and of the load
  double base_rest{}, mixed_rest{}, wall_rest{}, force_rest{};
};

class BasisMaker {
 public:
  BasisMaker(const data::StructureMatrices& matrices, std::size_t count)
      : rows_(matrices),
        mass_(rows_.transformed(matrices.mass)),
        stiffness_(rows_.transformed(matrices.stiffness)),
        base_(at(matrices.rows)) {
    for (const int row : matrices.base) base_[at(row)] = 1.0;
    wall_.resize(base_.size());
    base_[rows_.contact()] = wall_[rows_.contact()] = 1.0;
    if (rows_.free_rows() > 0) find_modes(count);
    const Vector pull = product(stiffness_, base_);
    basis_.contact_stiffness = dot(wall_, product(stiffness_, wall_));
    basis_.base_stiffness = pull[rows_.contact()];
    basis_.support = dot(base_, pull);
    basis_.moved_load = dot(base_, rows_.transformed(matrices.load));
    const Vector momentum = product(mass_, base_);
    basis_.moved_mass = dot(base_, momentum);
    basis_.base = on_basis(momentum);
    basis_.wall = on_basis(product(mass_, wall_));
    basis_.force = on_basis(rows_.transformed(matrices.load));
    if (rows_.free_rows() > 0 && !basis_.is_complete) find_rests(rows_.transformed(matrices.load));
    basis_.is_complete = basis_.is_complete || rows_.free_rows() == 0;
    add_damping(rows_.transformed(matrices.damping));
  }

  [[nodiscard]] Basis take() { return std::move(basis_); }

 private:
  void find_modes(std::size_t count) {
    const int rows = rows_.free_rows();
    free_stiffness_ = std::make_unique<SparseMatrix>(rows, rows_.free_part(stiffness_));
    factors_ = std::make_unique<SparseCholesky>(*free_stiffness_);
    constexpr double rounding = 1e-13;
    if (!factors_->is_positive_definite() || factors_->least_pivot() < rounding)
      throw data::FieldError("model.stiffness_matrix",
                             "not positive definite where base, fixed rows and contact are held",
                             "so: each row must be held by the base or by rows in model.fixed");
    for (Vector* shape : {&base_, &wall_}) {
      Vector load = rows_.free_part(product(stiffness_, *shape));
      for (double& value : load) value = -value;
      rows_.add_to_free(*shape, factors_->solve(load));
    }
    Entries free_mass = rows_.free_part(mass_);
    InverseModes modes = inverse_modes(SparseMatrix(rows, free_mass), *factors_, count);
    basis_.angular_frequency = std::move(modes.angular_frequency);
    basis_.is_complete = modes.are_all;
    shapes_ = std::move(modes.shapes);
    if (rows > most_dense_rows) require_semidefinite(std::move(free_mass));
  }

  /// M + τ K is positive definite only if no ω⁻² is below -τ.
  void require_semidefinite(Entries mass) const {
    const double shift = 100.0 * least_inverse_square * std::pow(basis_.angular_frequency.front(), -2);
    for (auto [row, column, value] : rows_.free_part(stiffness_))
      mass.push_back({row, column, shift * value});
    if (!SparseCholesky(SparseMatrix(rows_.free_rows(), mass)).is_positive_definite())
      throw indefinite_mass();
  }

  [[nodiscard]] std::span<const double> shape(std::size_t n) const {
    const auto rows = at(rows_.free_rows());
    return {shapes_.data() + n * rows, rows};
  }

  // (U_n, σ)ᵀ F.
  [[nodiscard]] Vector on_basis(const Vector& force) const {
    const Vector part = rows_.free_part(force);
    Vector result;
    for (std::size_t n = 0; n < basis_.angular_frequency.size(); ++n)
      result.push_back(std::inner_product(part.begin(), part.end(), shape(n).begin(), 0.0));
    result.push_back(dot(wall_, force));
    return result;
  }

  // x = K⁻¹ F - Σ U_n (U_n . F)/ω_n²
  [[nodiscard]] Vector rest_of(const Vector& force, const Vector& shares) const {
    Vector x = factors_->solve(rows_.free_part(force));
    for (std::size_t n = 0; n < basis_.angular_frequency.size(); ++n) {
      const double share = shares[n] / std::pow(basis_.angular_frequency[n], 2);
      std::ranges::transform(x, shape(n), x.begin(), [&](double a, double b) { return a - share * b; });
    }
    return x;
  }

  void find_rests(const Vector& load) {
    const Vector base = rest_of(product(mass_, base_), basis_.base),
                 wall = rest_of(product(mass_, wall_), basis_.wall), force = rest_of(load, basis_.force);
    const auto energy = [&](const Vector& a, const Vector& b) { return dot(a, *free_stiffness_ * b); };
    basis_.base_rest = energy(base, base);
    basis_.mixed_rest = energy(base, wall);
    basis_.wall_rest = energy(wall, wall);
    basis_.force_rest = energy(force, force);
  }

  void add_damping(const Entries& damping) {
    if (std::ranges::none_of(damping, [](const auto& entry) { return entry.value != 0.0; })) return;
    const Vector dampers = rows_.diagonal(damping), masses = rows_.diagonal(mass_);
    for (const int row : rows_.free())
      if (dampers[at(row)] > 0.0 && masses[at(row)] == 0.0)
        throw data::FieldError(
            "model.damping_matrix",
            "above 0 on the diagonal in row " + std::to_string(row + 1) + ", which has no mass",
            "0 there for the held modes; respond --method fe follows it");
    const std::size_t size = basis_.angular_frequency.size() + 1;
    const Vector drag = product(damping, base_);
    basis_.drag = on_basis(drag);
    basis_.base_drag = dot(base_, drag);
    basis_.damping = Matrix(size, size);
    for (std::size_t n = 0; n < size; ++n) {
      Vector velocity(base_.size());
      if (n + 1 < size) rows_.add_to_free(velocity, shape(n));
      const Vector column = on_basis(product(damping, n + 1 < size ? velocity : wall_));
      for (std::size_t i = 0; i < size; ++i) basis_.damping(i, n) = column[i];
    }
  }

  Coordinates rows_;
  Entries mass_, stiffness_;
  Vector base_, wall_;  // r and σ
  std::unique_ptr<SparseMatrix> free_stiffness_;
  std::unique_ptr<SparseCholesky> factors_;
  Vector shapes_;
  Basis basis_;
};

/// With at least one mode more than that many, where there are so many. ARPACK has static variables: one at a time.
std::shared_ptr<const Basis> basis_of(const std::shared_ptr<const data::StructureMatrices>& matrices,
                                      std::size_t modes) {
  struct Kept {
    std::weak_ptr<const data::StructureMatrices> matrices;
    std::size_t count{};
    std::shared_ptr<const Basis> basis;
  };
  static std::mutex mutex;
  static std::list<Kept> all;
  std::size_t count = 60;  // few different ones, so that few are computed
  while (count < modes) count *= 2;
  const std::lock_guard lock(mutex);
  std::erase_if(all, [](const Kept& kept) { return kept.matrices.expired(); });
  const auto found = std::ranges::find_if(all, [&](const Kept& kept) {
    return kept.matrices.lock() == matrices && (kept.count == count || kept.basis->is_complete);
  });
  if (found != all.end()) return found->basis;
  constexpr std::size_t most = 8;
  all.push_front({matrices, count, std::make_shared<const Basis>(BasisMaker(*matrices, count + 1).take())});
  if (all.size() > most) all.pop_back();
  return all.front().basis;
}

Vector first(const Vector& values, std::size_t modes) {
  return {values.begin(), values.begin() + static_cast<std::ptrdiff_t>(modes)};
}
// Of (U_n, σ), those of the first modes and of σ.
Vector shortened(const Vector& values, std::size_t modes) {
  Vector result = first(values, modes);
  result.push_back(values.back());
  return result;
}

void add_damping(HeldStructure& structure, const data::Damping& damping, const Matrix& given) {
  const std::size_t m = structure.modes();
  if (damping.is_none() && given.empty()) return;
  structure.damping = Matrix(m + 1, m + 1);
  for (std::size_t i = 0; i <= m; ++i)
    for (std::size_t j = 0; j <= m; ++j)
      if (!given.empty())
        structure.damping(i, j) = given(i < m ? i : given.rows() - 1, j < m ? j : given.rows() - 1);
  for (std::size_t n = 0; n < m; ++n) {
    structure.damping(n, n) +=
        2.0 * structure.angular_frequency[n] * damping.ratio_at(structure.angular_frequency[n], n + 1);
    const double coupled = damping.mass_proportional() * structure.mass_coupling[n];
    structure.damping(n, m) += coupled;
    structure.damping(m, n) += coupled;
  }
  structure.damping(m, m) += damping.mass_proportional() * structure.contact_mass +
                             damping.kelvin_voigt() * structure.contact_stiffness;
}

BaseBalance base_balance(const Basis& basis, std::size_t modes, bool is_force) {
  BaseBalance force{.acceleration = shortened(basis.base, modes),
                    .drag = {},
                    .stiffness = basis.base_stiffness,
                    .base = {basis.moved_mass, basis.base_drag, basis.support}};
  if (!basis.drag.empty()) force.drag = shortened(basis.drag, modes);
  if (is_force) force.base = {basis.moved_load};
  return force;
}

// Of the modes that the basis has beyond those of the structure, and of all others.
HeldStructure::Omitted omitted(const HeldStructure& structure, const Basis& basis, bool is_force) {
  const std::size_t m = structure.modes(), known = basis.angular_frequency.size();
  if (m == known && basis.is_complete) return {};
  const double share = structure.wall_share;
  HeldStructure::Omitted rest{.angular_frequency = basis.angular_frequency[m]};
  if (!basis.is_complete) {
    rest.contact = basis.wall.back();
    for (std::size_t n = 0; n < known; ++n) rest.contact -= std::pow(basis.wall[n], 2);
    const double base = basis.base_rest + share * (share * basis.wall_rest - 2.0 * basis.mixed_rest);
    rest.load = std::max(is_force ? basis.force_rest : base, 0.0);
  }
  for (std::size_t n = m; n < known; ++n) {
    const double load = is_force ? basis.force[n] : basis.base[n] - share * basis.wall[n];
    rest.contact += std::pow(basis.wall[n], 2);
    rest.load += std::pow(load / basis.angular_frequency[n], 2);
  }
  return rest;
}

}  // namespace

HeldStructure held_model(const data::Case& problem, int modes) {
  const auto basis = basis_of(problem.model()->shared_matrices(), at(modes));
  const std::size_t known = basis->angular_frequency.size(),
                    m = std::min(at(modes), basis->is_complete ? known : known - 1);
  const bool is_force = problem.is_force();
  HeldStructure structure;
  structure.angular_frequency = first(basis->angular_frequency, m);
  structure.mass_coupling = first(basis->wall, m);
  structure.contact_mass = basis->wall.back();
  structure.contact_stiffness = basis->contact_stiffness;
  structure.moved_mass = basis->moved_mass;
  structure.follower.resize(m);
  structure.wall_share = wall_share(problem);
  structure.participation = shortened(is_force ? basis->force : basis->base, m);
  if (!is_force) {
    structure.base_stiffness = basis->base_stiffness;
    if (!basis->drag.empty()) structure.drag = shortened(basis->drag, m);
  }
  // A contact without mass of its own, whose inertia is that of all modes.
  constexpr double rounding = 1e-9;
  if (m == known && basis->is_complete && structure.free_mass() <= rounding * structure.contact_mass)
    structure.contact_mass = dot(structure.mass_coupling, structure.mass_coupling);
  structure.base_balances = {base_balance(*basis, m, is_force)};
  structure.omitted = omitted(structure, *basis, is_force);
  add_damping(structure, problem.damping, basis->damping);
  return structure;
}

}  // namespace stickslip::analytic
