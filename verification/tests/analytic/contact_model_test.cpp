// SPDX-License-Identifier: MIT
/// The beam as a ContactModel: its closed forms against quadrature, its reaction in the limit.

#include <Eigen/Dense>

#include "analytic/gsl.hpp"
#include "stickslip/analytic/beam_contact_model.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "support/contact_models.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using analytic::BeamContactModel;
using analytic::ContactModel;
using analytic::QuasiStaticShape;
using analytic::StickMode;
using std::numbers::pi;

constexpr double mass_per_length = 10.0;         // rho A, kg/m
constexpr double bending_stiffness = 5e4 / 3.0;  // EI, N m^2
constexpr double length = 2.0;
const data::HarmonicExcitation base({.frequency_hz = 25.0, .amplitude = 1e-3});

BeamContactModel beam_model(int modes, const data::DampingProperties& damping = {},
                            double axial_force = 500.0) {
  return {with(paper_problem(25.0, 1e-3), paper_beam_with_axial_force(axial_force), data::Damping(damping)),
          modes};
}

Eigen::MatrixXd dense(const analytic::Matrix& matrix) {
  Eigen::MatrixXd result(matrix.rows(), matrix.columns());
  for (std::size_t i = 0; i < matrix.rows(); ++i)
    for (std::size_t j = 0; j < matrix.columns(); ++j)
      result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = matrix(i, j);
  return result;
}

Tolerance accuracy_of(const Estimate& integral, double rounding) {
  return discretisation(integral.error + rounding, 1.0, "GSL's estimate and round-off");
}

/// Of the clamped-free beam without axial force, rad/s.
double cantilever_frequency(std::size_t mode) {
  const double b = std::array{1.875104068711961, 4.694091132974175, 7.854757438237613}[mode];
  return b * b * std::sqrt(bending_stiffness / mass_per_length) / (length * length);
}

/// Kinetic energy is x_t . M x_t/2, x = (T, u_L).
Eigen::MatrixXd mass_matrix(const ContactModel& model) {
  const auto m = static_cast<Eigen::Index>(model.modes());
  Eigen::MatrixXd mass = Eigen::MatrixXd::Identity(m + 1, m + 1);
  for (Eigen::Index n = 0; n < m; ++n)
    mass(n, m) = mass(m, n) = model.mass_coupling[static_cast<std::size_t>(n)];
  mass(m, m) = model.contact_mass;
  return mass;
}

/// The second derivatives of shapes(x), from the modes and the static shape they are made of.
class Curvatures {
 public:
  Curvatures(const BeamContactModel& model, int modes)
      : modes_(analytic::stick_modes(paper_beam(), modes)), static_shape_(paper_beam()) {
    for (std::size_t n = 0; n < modes_.size(); ++n)
      scale_.push_back(model.shapes(0.4 * length)[n] / modes_[n].shape(0.4 * length));
  }
  [[nodiscard]] double operator()(std::size_t n, double x) const {
    return n < modes_.size() ? scale_[n] * modes_[n].curvature(x) : -static_shape_.curvature(x);
  }
  [[nodiscard]] double slope(std::size_t n, double x) const {
    return n < modes_.size() ? scale_[n] * modes_[n].slope(x) : -static_shape_.slope(x);
  }

 private:
  std::vector<StickMode> modes_;
  QuasiStaticShape static_shape_;
  std::vector<double> scale_;
};

STICKSLIP_VERIFIES(BeamContactModel, "D2");
TEST(BeamContactModel, MassesAndLoadsAreTheIntegralsOfItsShapes) {
  const BeamContactModel beam = beam_model(8);
  const Eigen::MatrixXd mass = mass_matrix(beam.model());
  const double omega = 50.0 * pi;
  for (std::size_t i = 0; i <= 8; ++i) {
    const auto shape = [&](std::size_t n) { return [&beam, n](double x) { return beam.shapes(x)[n]; }; };
    for (std::size_t j = i; j <= 8; ++j) {
      const auto product = [a = shape(i), b = shape(j)](double x) { return mass_per_length * a(x) * b(x); };
      const Estimate expected = integral(product, 0.0, length, 5.0);
      EXPECT_TRUE(within(mass(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)), expected.value,
                         accuracy_of(expected, 1e-13)))
          << i << " " << j;
    }
    const Estimate load = integral(shape(i), 0.0, length, 1.0);
    const double unit_load = mass_per_length * 1e-3 * omega * omega;
    EXPECT_TRUE(within(beam.model().load[i] / unit_load, load.value, accuracy_of(load, 1e-13))) << i;
  }
}

TEST(BeamContactModel, StiffnessesAreTheEnergiesOfItsShapes) {
  // U_i . K U_j = omega_i^2 delta_ij, sigma . K U_n = 0, sigma . K sigma = k_c, where
  // f . K g = EI int f'' g'' dx - P int f' g' dx.
  const double axial_force = paper_beam().axial_force();
  const BeamContactModel beam = beam_model(6);
  const Curvatures curvature(beam, 6);
  for (std::size_t i = 0; i <= 6; ++i) {
    for (std::size_t j = i; j <= 6; ++j) {
      const auto energy = [&](double x) {
        return bending_stiffness * curvature(i, x) * curvature(j, x) -
               axial_force * curvature.slope(i, x) * curvature.slope(j, x);
      };
      const auto stiffness = [&](std::size_t n) {
        return n < 6 ? std::pow(beam.model().angular_frequency[n], 2) : beam.model().contact_stiffness;
      };
      const double scale = std::sqrt(stiffness(i) * stiffness(j));
      const Estimate expected = integral(energy, 0.0, length, scale);
      EXPECT_TRUE(within(i == j ? stiffness(i) : 0.0, expected.value, accuracy_of(expected, 1e-12 * scale)))
          << i << " " << j;
    }
    // l_n = P U_n'(L), l_c = P sigma'(L).
    const double follower = i < 6 ? beam.model().follower[i] : beam.model().contact_follower;
    const double slope = curvature.slope(i, length);
    EXPECT_TRUE(within(follower, axial_force * slope, round_off(10, 10, axial_force * slope))) << i;
  }
}

TEST(BeamContactModel, HoldingForceErrorIsThatOfOmittedModes) {
  // Undamped modes are apart in stick: what N of them leave out of f_d is the sum of a_n T_tt + l_n T with T
  // = steady (sin(Omega t) - Omega/omega_n sin(omega_n t)), less than the sum of the amplitudes. The free
  // vibrations set it: n^-4 a term, N^-3 all of them.
  const double duration = 0.05, omega = 50.0 * pi;
  const int all = 160;
  const analytic::StickResponse exact(paper_beam(), base, all, analytic::SteadyPart::exact);
  const ContactModel full = beam_model(all).model();
  std::vector<double> inverse, errors;
  for (const int modes : {5, 10, 20, 40, 80}) {
    double bound = 0.0;
    for (auto n = static_cast<std::size_t>(modes); n < full.modes(); ++n) {
      const double own = full.angular_frequency[n], coupling = full.mass_coupling[n];
      const double load = std::abs(full.load[n] + coupling * omega * omega * full.wall_amplitude);
      const double steady = load / (own * own - omega * omega);
      bound += steady * (std::abs(coupling) * omega * (omega + own) +
                         std::abs(full.follower[n]) * (1.0 + omega / own));
    }
    // The terms beyond `all`, and the free vibrations beyond them that StickResponse leaves out.
    bound += 2.0 * exact.omitted_transient_bound();
    ContactModel model = beam_model(modes).model();
    model.friction = data::FrictionLaw({.static_coefficient = 1e9, .kinetic_coefficient = 1e9, .decay = 0.0});
    analytic::EventDriven held(model);
    double error = 0.0;
    for (int k = 1; k <= 500; ++k) {
      held.advance_to(duration * k / 500.0);
      error = largest_or_nan({error, std::abs(held.friction_force() + exact.friction_force(held.time()))});
    }
    EXPECT_TRUE(within(error, 0.0, discretisation(bound, 1.0, "sum of the omitted amplitudes"))) << modes;
    EXPECT_GT(error, 0.02 * bound) << "a bound that loose proves nothing at " << modes;
    inverse.push_back(1.0 / modes);
    errors.push_back(error);
  }
  // 0.2 for omega_n, which is proportional to (n + 1/4)^2 and not to n^2.
  EXPECT_GT(observed_order(inverse, errors), 2.8);
}

TEST(BeamContactModel, KelvinVoigtDampingFollowsTheBendingEnergy) {
  const double eta = 6.4e-5;
  const BeamContactModel beam = beam_model(6, {.kelvin_voigt = eta});
  const Curvatures curvature(beam, 6);
  const Eigen::MatrixXd damping = dense(beam.model().damping);
  ASSERT_EQ(damping.rows(), 7);
  for (std::size_t i = 0; i <= 6; ++i)
    for (std::size_t j = 0; j <= 6; ++j) {
      const auto power = [&](double x) {
        return eta * bending_stiffness * curvature(i, x) * curvature(j, x);
      };
      const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
      const double scale = std::sqrt(damping(row, row) * damping(column, column));
      const Estimate expected = integral(power, 0.0, length, scale);
      EXPECT_TRUE(within(damping(row, column), expected.value, accuracy_of(expected, 1e-12 * scale)))
          << i << " " << j;
    }
}

TEST(BeamContactModel, ModalDampingGivesEveryFreeModeItsRatio) {
  // C = sum 2 zeta omega (M x)(M x)^T over x . M x = 1, K x = omega^2 M x is the one symmetric positive
  // matrix with C M^-1 C = 4 zeta^2 K, K the bending stiffness alone.
  const double ratio = 0.02;
  const int modes = 8;
  const ContactModel model = beam_model(modes, {.ratio = ratio}).model();
  const Eigen::MatrixXd damping = dense(model.damping), mass = mass_matrix(model);
  const Eigen::MatrixXd bending = dense(beam_model(modes, {.kelvin_voigt = 1.0}).model().damping);
  const Eigen::MatrixXd error = damping * mass.llt().solve(damping) - 4.0 * ratio * ratio * bending;
  // M has the condition number 1/(m_c - a . a) ~ 1e2.
  for (Eigen::Index i = 0; i <= modes; ++i)
    for (Eigen::Index j = 0; j <= modes; ++j)
      EXPECT_TRUE(
          within(error(i, j), 0.0, round_off(9, 100, 4.0 * ratio * ratio * bending.diagonal().maxCoeff())));
  EXPECT_LT((damping - damping.transpose()).cwiseAbs().maxCoeff(),
            round_off(9, 1, damping.cwiseAbs().maxCoeff()).value);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(damping, mass);
  EXPECT_GT(eigen.eigenvalues().minCoeff(), 0.0);
  // The Galerkin frequencies are too high, by a relative error that falls as N^-5 (or, since sigma is the
  // static shape at P and not at 0, as P N^-3 with P L^2/EI = 0.12).
  for (std::size_t i = 0; i < 3; ++i) {
    const double expected = 2.0 * ratio * cantilever_frequency(i);
    EXPECT_TRUE(within(eigen.eigenvalues()[static_cast<Eigen::Index>(i)], expected,
                       discretisation(expected * 0.12 / 512.0, 1.0, "P L^2/EI N^-3")));
  }
}

TEST(BeamContactModel, BothKindsOfDampingAdd) {
  const auto damping = [](const data::DampingProperties& properties) {
    return dense(beam_model(5, properties).model().damping);
  };
  const Eigen::MatrixXd both = damping({.kelvin_voigt = 1e-4, .ratio = 0.01});
  const Eigen::MatrixXd sum = damping({.kelvin_voigt = 1e-4}) + damping({.ratio = 0.01});
  EXPECT_LT((both - sum).cwiseAbs().maxCoeff(), round_off(4, 1, sum.cwiseAbs().maxCoeff()).value);
  EXPECT_TRUE(beam_model(5).model().damping.empty());
}

TEST(BeamContactModel, RefusesABeamWithoutContactOrPastBuckling) {
  for (const double axial_force : {-100.0, 0.0, 85e3}) {
    SCOPED_TRACE(axial_force);
    expect_error_message<data::InputError>([&] { (void)beam_model(5, {}, axial_force); },
                                           {"beam.axial_force"});
  }
  EXPECT_THROW(beam_model(0), std::invalid_argument);
}

}  // namespace
}  // namespace stickslip::testing
