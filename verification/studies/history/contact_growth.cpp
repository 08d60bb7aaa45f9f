// SPDX-License-Identifier: MIT
#include "studies/history/contact_growth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

#include "stickslip/analytic/tip_mobility.hpp"

namespace stickslip::studies {

namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

constexpr int values_between = 16;  // number of values between neighbouring frequencies
constexpr double near = 2.0;        // times κ: local minima below this value are refined

// Minimises by golden-section search.
template <class Function>
double minimum(const Function& function, double low, double high) {
  constexpr double share = std::numbers::phi - 1.0;
  double left = high - share * (high - low), right = low + share * (high - low);
  double at_left = function(left), at_right = function(right);
  for (int i = 0; i < 16; ++i) {
    if (at_left < at_right) {
      high = right, right = left, at_right = at_left;
      left = high - share * (high - low), at_left = function(left);
    } else {
      low = left, left = right, at_left = at_right;
      right = low + share * (high - low), at_right = function(right);
    }
  }
  return 0.5 * (low + high);
}

// Searches for a frequency at which Re Z(σ + i ω) < κ. `worst` is the frequency that the previous search
// found; it is tried first.
bool grows_at_most(const LinearContact& contact, double kappa, double sigma, double& worst) {
  if (contact.limiting_mass * sigma + contact.limiting_damping < kappa * (1.0 - 1e-12)) return false;
  const auto resistance = [&](double omega) { return (1.0 / contact.mobility({sigma, omega})).real(); };
  const auto is_below = [&](double omega) {
    if (resistance(omega) >= kappa) return false;
    worst = omega;
    return true;
  };
  if (is_below(worst)) return false;
  std::array<double, 3> omega{}, value{};
  value.fill(resistance(0.0));
  for (std::size_t i = 1; i < contact.frequencies.size(); ++i) {
    const double from = contact.frequencies[i - 1], width = contact.frequencies[i] - from;
    for (int j = 1; j <= values_between; ++j) {
      std::rotate(omega.begin(), omega.begin() + 1, omega.end());
      std::rotate(value.begin(), value.begin() + 1, value.end());
      omega[2] = from + width * 0.5 * (1.0 - std::cos(pi * j / values_between));
      value[2] = resistance(omega[2]);
      if (value[2] < kappa) return !is_below(omega[2]);
      if (value[1] > value[0] || value[1] > value[2] || value[1] > near * kappa) continue;
      if (is_below(minimum(resistance, omega[0], omega[2]))) return false;
    }
  }
  return true;
}

void add_frequencies_of_the_beam(const data::Beam& beam, double highest, std::vector<double>& frequencies) {
  const double scale =
      std::sqrt(beam.youngs_modulus() * beam.second_moment_of_area() / (beam.density() * beam.area()));
  for (int mode = 1;; ++mode) {
    // Accurate from mode 2 on at P = 0.
    const double omega = scale * std::pow((mode - 0.5) * pi / beam.length(), 2);
    if (omega >= highest) return;
    frequencies.push_back(omega);
  }
}

analytic::Mobility in_steps(std::function<Complex(Complex)> discrete, double time_step) {
  return
      [discrete = std::move(discrete), time_step](Complex s) { return discrete(std::exp(-s * time_step)); };
}

}  // namespace

double weakening(const data::FrictionLaw& friction, double normal_force) {
  const data::FrictionLaw law = friction.in_slip();
  return (law.static_coefficient() - law.kinetic_coefficient()) * law.decay() * normal_force;
}

bool grows_at_most(const LinearContact& contact, double kappa, double sigma) {
  double worst = 0.0;
  return grows_at_most(contact, kappa, sigma, worst);
}

double growth_bound(const LinearContact& contact, double kappa) {
  double worst = 0.0;
  const double lowest = *std::ranges::find_if(contact.frequencies, [](double omega) { return omega > 0.0; });
  double low = 1e-6 * lowest, high = low;
  while (!grows_at_most(contact, kappa, high, worst)) {
    low = high;
    high *= 4.0;
    if (high > 1e3 * contact.frequencies.back()) return std::numeric_limits<double>::infinity();
  }
  if (high == low) return 0.0;
  while (high > (1.0 + 1e-4) * low) {
    const double middle = std::sqrt(low * high);
    (grows_at_most(contact, kappa, middle, worst) ? high : low) = middle;
  }
  return high;
}

LinearContact continuous_contact(const data::Case& problem) {
  const data::Beam& beam = problem.beam();
  LinearContact contact{.mobility = analytic::TipMobility(beam, problem.damping), .frequencies = {0.0}};
  const double mass_per_length = beam.density() * beam.area();
  const double scale = std::sqrt(beam.youngs_modulus() * beam.second_moment_of_area() / mass_per_length);
  constexpr int highest_mode = 40;
  add_frequencies_of_the_beam(beam, scale * std::pow(highest_mode * pi / beam.length(), 2),
                              contact.frequencies);
  if (!problem.has(data::Feature::kelvin_voigt))
    contact.limiting_mass = mass_per_length * beam.length() / 4.0;
  return contact;
}

double beam_growth_bound(const data::Case& problem) {
  return growth_bound(continuous_contact(problem),
                      weakening(problem.contact.friction, problem.normal_force()));
}

LinearContact continuous_contact(const solver::ContactMobility& mobility) {
  LinearContact contact{.mobility = mobility,
                        .frequencies = {0.0},
                        .limiting_mass = mobility.contact_mass(),
                        .limiting_damping = mobility.contact_damping()};
  const auto& modes = mobility.angular_frequencies();
  std::ranges::copy_if(modes, std::back_inserter(contact.frequencies),
                       [](double omega) { return omega > 0.0; });
  contact.frequencies.push_back(3.0 * std::max(modes[modes.size() - 1], 1.0));
  return contact;
}

LinearContact stepped_contact(const solver::ContactMobility& mobility, double time_step,
                              double spectral_radius) {
  LinearContact contact{
      .mobility = in_steps([mobility, time_step, spectral_radius](
                               Complex zeta) { return mobility.discrete(zeta, time_step, spectral_radius); },
                           time_step),
      .frequencies = {0.0}};
  for (const double omega : mobility.angular_frequencies())  // as the trapezoidal rule changes them
    if (omega > 0.0) contact.frequencies.push_back(2.0 * std::atan(0.5 * omega * time_step) / time_step);
  contact.frequencies.push_back(pi / time_step);
  return contact;
}

LinearContact stepped_contact(const data::Beam& beam, double time_step, int stages) {
  LinearContact contact{.mobility = in_steps(
                            [mobility = analytic::TipMobility(beam), time_step, stages](Complex zeta) {
                              return analytic::discrete_mobility(mobility, time_step, stages, zeta);
                            },
                            time_step),
                        .frequencies = {0.0}};
  add_frequencies_of_the_beam(beam, pi / time_step, contact.frequencies);
  contact.frequencies.push_back(pi / time_step);
  return contact;
}

solver::ContactSystem contact_system(const analytic::ContactModel& model) {
  const auto modes = static_cast<Eigen::Index>(model.modes());
  Eigen::MatrixXd mass = Eigen::MatrixXd::Identity(modes + 1, modes + 1);
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(modes + 1, modes + 1), damping = stiffness;
  mass(modes, modes) = model.contact_mass;
  stiffness(modes, modes) = model.contact_stiffness;
  Eigen::MatrixXd follower = Eigen::MatrixXd::Zero(modes + 1, modes + 1);
  follower(modes, modes) = model.contact_follower;
  for (Eigen::Index n = 0; n < modes; ++n) {
    const auto index = static_cast<std::size_t>(n);
    mass(n, modes) = mass(modes, n) = model.mass_coupling[index];
    stiffness(n, n) = std::pow(model.angular_frequency[index], 2);
    follower(modes, n) = model.follower[index];
  }
  if (!model.damping.empty())
    for (Eigen::Index i = 0; i <= modes; ++i)
      for (Eigen::Index j = 0; j <= modes; ++j)
        damping(i, j) = model.damping(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
  return {.mass = mass.sparseView(),
          .damping = damping.sparseView(),
          .stick_stiffness = stiffness.sparseView(),
          .slip_stiffness = (stiffness + follower).sparseView(),
          .load_shape = Eigen::VectorXd::Zero(modes + 1),
          .load_history = [](double) { return 0.0; },
          .contact = modes,
          .normal_force = model.normal_force,
          .friction = model.friction};
}

solver::ContactSystem with_radiating_contact(const solver::ContactSystem& system, double mass,
                                             double dashpot) {
  const Eigen::Index size = system.mass.rows(), c = system.contact;
  const auto extended = [size](const solver::SparseMatrix& matrix) {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(size + 1, size + 1);
    result.topLeftCorner(size, size) = matrix;
    return result;
  };
  Eigen::MatrixXd masses = extended(system.mass), damping = extended(system.damping);
  masses(c, c) -= mass;
  masses(size, size) = mass;
  for (const Eigen::Index i : {c, size})
    for (const Eigen::Index j : {c, size}) damping(i, j) += i == j ? dashpot : -dashpot;
  // Only the dashpot is connected to the additional mass. A system must have a non-singular stiffness, so a
  // very small one is added.
  const auto stiffness = [&](const solver::SparseMatrix& matrix) {
    Eigen::MatrixXd result = extended(matrix);
    result(size, size) = 1e-12 * result.diagonal().maxCoeff();
    return solver::SparseMatrix(result.sparseView());
  };
  solver::ContactSystem result = system;
  result.mass = masses.sparseView();
  result.damping = damping.sparseView();
  result.stick_stiffness = stiffness(system.stick_stiffness);
  result.slip_stiffness = stiffness(system.slip_stiffness);
  result.load_shape.conservativeResize(size + 1);
  result.load_shape[size] = mass;
  result.load_shape[c] -= mass;
  return result;
}

LinearContact continuous_contact(const analytic::ContactModel& model) {
  return continuous_contact(solver::ContactMobility(contact_system(model)));
}

}  // namespace stickslip::studies
