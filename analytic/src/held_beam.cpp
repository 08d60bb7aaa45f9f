// SPDX-License-Identifier: MIT
#include "stickslip/analytic/held_beam.hpp"

#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>

#include "beam_constants.hpp"
#include "gsl_handles.hpp"

namespace stickslip::analytic {
namespace {

/// int of the outer product f fᵀ over 0 ... length, f a vector of functions with at most `half_waves` of them, by panels of about half a
/// wave: of a product a whole one, which 16 points integrate to 1e-28.
Matrix integral_of_products(const std::function<std::vector<double>(double)>& functions, double length,
                            std::size_t half_waves) {
  Matrix result;
  for_each_gauss_point(0.0, length, half_waves + 2, [&](double x, double weight) {
    const std::vector<double> f = functions(x);
    if (result.empty()) result = Matrix(f.size(), f.size());
    for (std::size_t row = 0; row < f.size(); ++row)
      for (std::size_t column = 0; column <= row; ++column)
        result(row, column) += weight * f[row] * f[column];
  });
  for (std::size_t row = 0; row < result.rows(); ++row)
    for (std::size_t column = row + 1; column < result.columns(); ++column)
      result(row, column) = result(column, row);
  return result;
}

/// C = sum 2 ζ_n ω_n (M x_n)(M x_n)ᵀ over the modes (K - ω_n² M) x_n = 0, x_nᵀ M x_n = 1.
Matrix modal_damping(const Matrix& mass, const Matrix& stiffness, const data::Damping& ratios) {
  const StatusInsteadOfAbort guard;
  const std::size_t size = mass.rows();
  const auto k = gsl_copy_of(stiffness), m = gsl_copy_of(mass);
  const auto vectors = owned(gsl_matrix_alloc(size, size));
  const auto values = owned(gsl_vector_alloc(size));
  const auto workspace = owned(gsl_eigen_gensymmv_alloc(size));
  require_success(gsl_eigen_gensymmv(k.get(), m.get(), values.get(), vectors.get(), workspace.get()),
                  "modes of the free beam");
  gsl_eigen_gensymmv_sort(values.get(), vectors.get(), GSL_EIGEN_SORT_VAL_ASC);
  Matrix damping(size, size);
  for (std::size_t mode = 0; mode < size; ++mode) {
    std::vector<double> momentum(size);
    double modal_mass = 0.0;
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; j < size; ++j)
        momentum[i] += mass(i, j) * gsl_matrix_get(vectors.get(), j, mode);
      modal_mass += momentum[i] * gsl_matrix_get(vectors.get(), i, mode);
    }
    const double factor =
        2.0 * ratios.ratio_of(mode + 1) * std::sqrt(gsl_vector_get(values.get(), mode)) / modal_mass;
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < size; ++j) damping(i, j) += factor * momentum[i] * momentum[j];
  }
  return damping;
}

}  // namespace

HeldBeam::HeldBeam(const data::Beam& beam, const data::Damping& damping, int modes)
    : modes_(stick_modes(beam, modes)), static_shape_(beam) {
  require_compression(beam);
  const double length = beam.length(), follower = follower_force(beam);
  const double density = mass_per_length(beam);
  const std::size_t m = modes_.size();
  for (const StickMode& mode : modes_) {
    scale_.push_back(1.0 / std::sqrt(density * mode.norm_squared()));
    structure_.angular_frequency.push_back(mode.angular_frequency());
    structure_.follower.push_back(follower * scale_.back() * mode.slope(length));
  }
  // Masses with the functions 1, whose products are the load of the base, and x.
  const auto shapes_and_motions = [this](double x) {
    std::vector<double> values = shapes(x);
    values.insert(values.end(), {1.0, x});
    return values;
  };
  const Matrix products = integral_of_products(shapes_and_motions, length, m);
  BaseBalance force{.acceleration = {}, .drag = {}, .base = {density * length}},
      moment{.acceleration = {},
             .drag = {},
             .stiffness = -beam.axial_force(),
             .base = {0.5 * density * length * length},
             .lever = length};
  Matrix mass(m + 1, m + 1);
  for (std::size_t n = 0; n <= m; ++n) {
    mass(n, n) = n < m ? 1.0 : density * products(m, m);
    structure_.participation.push_back(density * products(n, m + 1));
    moment.acceleration.push_back(density * products(n, m + 2));
    if (n == m) break;
    mass(n, m) = mass(m, n) = density * products(n, m);
    structure_.mass_coupling.push_back(mass(n, m));
  }
  force.acceleration = structure_.participation;
  structure_.base_balances = {force, moment};
  structure_.contact_mass = mass(m, m);
  structure_.contact_follower = -follower * static_shape_.slope(length);
  structure_.contact_stiffness = bending_stiffness(beam) * static_shape_.third_derivative(length) +
                                 beam.axial_force() * static_shape_.slope(length);
  if (!damping.is_none()) add_damping(beam, damping, mass);
}

void HeldBeam::add_damping(const data::Beam& beam, const data::Damping& damping, const Matrix& mass) {
  const std::size_t m = modes_.size();
  const auto slopes = [this](double x) {
    std::vector<double> values;
    for (std::size_t n = 0; n < modes_.size(); ++n) values.push_back(scale_[n] * modes_[n].slope(x));
    values.push_back(-static_shape_.slope(x));
    return values;
  };
  Matrix bending = integral_of_products(slopes, beam.length(), m);
  for (std::size_t row = 0; row <= m; ++row)
    for (std::size_t column = 0; column <= m; ++column) bending(row, column) *= beam.axial_force();
  for (std::size_t n = 0; n < m; ++n) bending(n, n) += std::pow(structure_.angular_frequency[n], 2);
  bending(m, m) += structure_.contact_stiffness;
  structure_.damping = damping.has_ratio() ? modal_damping(mass, bending, damping) : Matrix(m + 1, m + 1);
  for (std::size_t row = 0; row <= m; ++row)
    for (std::size_t column = 0; column <= m; ++column)
      structure_.damping(row, column) +=
          damping.kelvin_voigt() * bending(row, column) + damping.mass_proportional() * mass(row, column);
}

std::vector<double> HeldBeam::shapes(double x) const {
  std::vector<double> values;
  values.reserve(modes_.size() + 1);
  for (std::size_t n = 0; n < modes_.size(); ++n) values.push_back(scale_[n] * modes_[n].shape(x));
  values.push_back(-static_shape_.value(x));
  return values;
}

double absolute_displacement(const std::vector<double>& shapes, const EventDriven& run) {
  return std::inner_product(run.amplitudes().begin(), run.amplitudes().end(), shapes.begin(),
                            shapes.back() * run.contact_displacement() + run.base_displacement());
}

}  // namespace stickslip::analytic
