// SPDX-License-Identifier: MIT
/// Orders of convergence of the mesh, with the constants that theory predicts.

#include <fmt/format.h>

#include <Eigen/Dense>
#include <array>
#include <utility>

#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/analytic/tip_mobility.hpp"
#include "stickslip/solver/beam_model.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/common/convergence.hpp"
#include "studies/verification/frequencies.hpp"
#include "studies/verification/manufactured_solution.hpp"
#include "support/order.hpp"
#include "support/testing.hpp"
#include "support/vibration.hpp"

namespace stickslip::testing {
namespace {

using Complex = std::complex<double>;

const std::vector<int> meshes{8, 12, 16, 24, 32, 48};

// A quantity that the mesh raises by about (beta l)^4/720 of itself has (beta l)^2/40 of that as its next
// term between supports; where the tip is free, u'''' does not vanish and raises it by about 10/(beta L) of
// itself: by 3.3 in the second mode, which is the largest that matters (in the first all of it is small).
double next_term(double wave_number, double length, double margin) {
  return margin * std::pow(wave_number * length, 2) / 40.0;
}

// The order is four with a leading term that is `constant` l^4 but for the share of the axial force in it
// that the constant lacks, the same on all meshes.
::testing::AssertionResult is_of_order_four(const std::vector<OrderLevel>& levels, double constant,
                                            double share) {
  for (const OrderLevel& level : levels) {
    const double leading = constant * std::pow(level.step, 4);
    const auto holds = within(level.error, leading,
                              discretisation(leading * (level.next_term + share) + level.floor, 1.0,
                                             "next terms and the share of the axial force"));
    if (!holds) return holds;
  }
  return order_is(levels, 4.0);
}

// The frequencies of a study whose constants lack z/(beta L)^2 of themselves, z = P L^2/EI.
void expect_order_four(const studies::FrequencyStudy& study, double first_wave_number, double margin,
                       double load_factor = 0.0) {
  EXPECT_FALSE(study.modes.empty());
  for (const auto& mode : study.modes) {
    const double beta_length = first_wave_number + (mode.mode - 1) * std::numbers::pi;
    std::vector<OrderLevel> levels;
    for (std::size_t i = 0; i < study.elements.size(); ++i) {
      const double length = 1.0 / study.elements[i];
      // The eigenvalue solver's round-off is 1e-11 of omega^2 at worst.
      levels.push_back({.step = length,
                        .error = std::abs(mode.relative_error[i]),
                        .next_term = next_term(beta_length, length, margin),
                        .floor = 1e-11});
    }
    // Simpson's rule gives the constant to 1e-8.
    EXPECT_TRUE(is_of_order_four(levels, mode.predicted_error.front() / std::pow(levels.front().step, 4),
                                 load_factor / (beta_length * beta_length) + 1e-8))
        << "mode " << mode.mode;
    // What the report prints is the slope of just these levels.
    EXPECT_TRUE(
        within(mode.observed_order.order, 4.0,
               discretisation(order_bound(levels).slope, 1.0, "what the next terms do to the slope")));
  }
}

STICKSLIP_VERIFIES(StickFrequencyOrder, "F3");
TEST(StickFrequencyOrder, IsFourWithThePredictedConstant) {
  for (const double force : {-5.0, 0.0, 0.12, 10.0}) {
    SCOPED_TRACE(force);
    const double unit = rigidity(paper_beam()) / 4.0;  // EI/L^2
    const auto study = studies::stick_frequency_study(paper_beam_with_axial_force(force * unit), 5, meshes);
    // An axial force of half the buckling load shortens the waves of mode 1, trigonometric ones, by a fifth.
    expect_order_four(study, 1.25 * std::numbers::pi, force > 1.0 ? 3.0 : 1.1);
    for (const auto& mode : study.modes)
      for (const double error : mode.relative_error)
        EXPECT_GT(error, 0.0) << "a Rayleigh quotient is an upper bound";
  }
}

STICKSLIP_VERIFIES(SlipFrequencyOrder, "F3");
TEST(SlipFrequencyOrder, IsFourUnderTheFollowerLoad) {
  // The constant is that of P = 0: at P L^2/EI = 0.12 it is off by 3.4 % in the first mode.
  expect_order_four(studies::slip_frequency_study(paper_beam(), 5, meshes), 0.6 * std::numbers::pi, 4.0,
                    0.12);
}

STICKSLIP_VERIFIES(FlutterLoadOrder, "F3");
TEST(FlutterLoadOrder, IsFourAndTendsToBecksLoad) {
  const auto study = studies::flutter_study(paper_beam(), {4, 6, 8, 12, 16});
  // Where the modes meet, omega = 11.0 sqrt(EI/rho A)/L^2 and beta_bar L = 5.0 (Eq. 23); margin of a free
  // tip. The bisection ends at 1e-9.
  std::vector<double> lengths, errors;
  for (std::size_t i = 0; i < study.elements.size(); ++i) {
    lengths.push_back(1.0 / study.elements[i]);
    errors.push_back(std::abs(study.finite_element[i] - study.closed_form));
  }
  EXPECT_TRUE(order_is(order_levels(
                           lengths, errors, [](double length) { return next_term(5.0, length, 4.0); }, 1e-9),
                       4.0));
  EXPECT_EQ(study.observed_order.order, studies::observed_order(lengths, errors));
  EXPECT_TRUE(within(study.closed_form, 20.05, reference(5e-3, "Beck's load as usually printed")));
  const double extrapolated =
      study.finite_element[4] + (study.finite_element[4] - study.finite_element[2]) / 15.0;
  EXPECT_TRUE(within(
      extrapolated, study.closed_form,
      discretisation((study.finite_element[2] - study.closed_form) / 15.0, 0.2, "extrapolation of order 4")));
}

STICKSLIP_VERIFIES(ReactionOrder, "F4");
// The next term is (beta l)^2/10 with beta L = 3.93 of mode 1, below whose frequency the excitation stays: above it the
// constant passes zero.
TEST(ReactionOrder, IsFourByTheBalanceOfTheTip) {
  for (const double hz : {5.0, 15.0, 20.0}) {
    const data::Case problem = paper_problem(hz, 1.0);
    const double exact =
        std::abs(analytic::StickResponse(problem.beam, problem.excitation, 10, analytic::SteadyPart::exact)
                     .steady_force_amplitude());
    std::vector<OrderLevel> levels;
    for (const int n : {4, 6, 8, 12})
      levels.push_back({.step = 1.0 / n,
                        .error = std::abs(finite_element_steady_force(problem, n) - exact),
                        .next_term = std::pow(3.93 / n, 2) / 10.0,
                        .floor = round_off(1, std::pow(n, 4), exact).value});
    EXPECT_TRUE(order_is(levels, 4.0)) << hz << " Hz";
  }
}

constexpr double rigidity = 2e9 * 1e-4 / 12.0;  // EI, N m^2

/// s e^T (s^2 M + s C + K_slip)^-1 e, e the tip's deflection.
Complex mesh_mobility(const data::Beam& beam, const data::Damping& damping, int elements, Complex s) {
  const solver::BeamModel model(beam, elements);
  const Eigen::MatrixXcd dynamic =
      s * s * Eigen::MatrixXcd(model.mass().cast<Complex>()) +
      s * Eigen::MatrixXcd(solver::damping_matrix(model, damping).cast<Complex>()) +
      Eigen::MatrixXcd(model.slip_stiffness().cast<Complex>());
  const Eigen::VectorXcd force = Eigen::VectorXcd::Unit(model.degrees_of_freedom(), model.tip_deflection());
  return s * dynamic.partialPivLu().solve(force)[model.tip_deflection()];
}

STICKSLIP_VERIFIES(TipMobilityOrder, "A9");
TEST(TipMobilityOrder, IsFourWithThePredictedConstant) {
  // Of MeshError, with the motion under a unit force at the tip as the dual one, which it is at P = 0: D
  // u'''' = -rho A s^2 u, and with the velocity T(x) per unit force
  //
  //     Y_h - Y = -l^4 s^3 (rho A)^2/(720 D) int T^2 dx,
  //
  // of which the next term is l^2 (2 int T T''/42 + 8 int T'^2/105)/int T^2, with (|r| l)^2/8 more. Other
  // forces have another constant; the size of their next term is taken from the same formula.
  constexpr int n = 200;
  for (const double axial_force : {0.0, 500.0, 5e3, -5e3})
    for (const double eta : {0.0, 1e-4})
      for (const Complex s :
           {Complex(100.0), Complex(60.0, 150.0), Complex(0.0, 120.0), Complex(0.0, 400.0)}) {
        const data::Beam beam = paper_beam_with_axial_force(axial_force);
        const data::Damping damping({.kelvin_voigt = eta});
        const analytic::TipMobility mobility(beam, damping);
        const double step = beam.length() / n;
        std::vector<Complex> velocity;
        for (int i = 0; i <= n; ++i) velocity.push_back(mobility.transfer(step * i, s));
        Complex square = 0.0, slope_square = 0.0;
        for (std::size_t i = 0; i <= n; ++i) {
          square += simpson_weight(static_cast<int>(i), n) * step / 3.0 * std::pow(velocity[i], 2);
          if (i > 0) slope_square += std::pow(velocity[i] - velocity[i - 1], 2) / step;
        }
        // int T T'' = T T'(L) - int T'^2.
        const Complex bend = velocity[n] * (velocity[n] - velocity[n - 1]) / step - slope_square;
        const double next =
            (2.0 / 42.0 * std::abs(bend) + 8.0 / 105.0 * std::abs(slope_square)) / std::abs(square);
        const double constant = std::abs(s * s * s * 100.0 / (720.0 * rigidity * (1.0 + eta * s)) * square);
        const double wave = std::abs(s * std::sqrt(10.0 / rigidity));  // |r|^2
        std::vector<OrderLevel> levels;
        for (const int elements : {8, 12, 16, 24}) {
          const double l = beam.length() / elements;
          const Complex error = mesh_mobility(beam, damping, elements, s) - mobility(s);
          levels.push_back({.step = l,
                            .error = std::abs(error),
                            .next_term = next * l * l * (1.0 + wave * l * l / 8.0),
                            .floor = round_off(1, std::pow(elements, 4), std::abs(mobility(s))).value});
        }
        EXPECT_TRUE(order_is(levels, 4.0, axial_force == 0.0 ? std::optional(constant) : std::nullopt))
            << "P = " << axial_force << ", eta = " << eta << ", s = " << s;
      }
}

// --- Manufactured solutions

using studies::ManufacturedTip;
using studies::PredictedErrors;

// Relative, on each level: what the next terms, twice the time steps and anything else may add.
std::vector<double> allowance(const std::vector<double>& next_term, double margin,
                              const std::vector<double>& temporal_share = {}, double other_share = 0.0) {
  std::vector<double> sum;
  for (std::size_t i = 0; i < next_term.size(); ++i)
    sum.push_back(margin * next_term[i] + other_share +
                  (temporal_share.empty() ? 0.0 : 2.0 * temporal_share[i]));
  return sum;
}

std::vector<OrderLevel> levels(const std::vector<double>& steps, const PredictedErrors& errors,
                               const std::vector<double>& next_terms) {
  std::vector<OrderLevel> all;
  for (std::size_t i = 0; i < steps.size(); ++i)
    all.push_back({.step = steps[i],
                   .error = errors.error.at(i),
                   .next_term = next_terms.at(i),
                   .floor = errors.floor.at(i)});
  return all;
}

// On every level the error is the predicted one, to within the relative allowance.
void expect_predicted(const PredictedErrors& errors, const std::vector<double>& allowed,
                      const std::string& what) {
  ASSERT_EQ(errors.predicted.size(), errors.error.size());
  for (std::size_t i = 0; i < errors.error.size(); ++i)
    EXPECT_TRUE(within(errors.error[i] / errors.predicted[i], 1.0,
                       discretisation(allowed[i], 1.0, "terms behind the leading one")))
        << what << ", level " << i;
}

// What the elements add to the interpolant, E, is a difference of a particular and a free part, each a few
// times as large: hence four times the share of the next terms wherever it enters.
void expect_orders_and_constants_in_space(ManufacturedTip tip, double load_factor) {
  const auto study = studies::manufactured_space_errors(paper_beam(), tip, load_factor, {4, 6, 8, 12, 16});
  const double coupling = study.friction_coupling.value_or(0.0);
  const auto deflection = allowance(study.next_term, 4.0, study.temporal_share, 0.25 * coupling);
  EXPECT_TRUE(order_is(levels(study.element_length, study.deflection, deflection), 4.0));
  expect_predicted(study.deflection, deflection, "deflection");

  auto slope = allowance(study.next_term, 4.0);
  expect_predicted(study.slope, slope, "slope");
  for (std::size_t i = 0; i < slope.size(); ++i) slope[i] += study.nodal_share_of_slope[i];
  EXPECT_TRUE(order_is(levels(study.element_length, study.slope, slope), 3.0));

  EXPECT_TRUE(order_is(levels(study.element_length, study.curvature, allowance(study.next_term, 1.0)), 2.0));
  std::vector<double> curvature;
  for (const double next : study.next_term) curvature.push_back(next * next);
  expect_predicted(study.curvature, curvature, "curvature");

  if (tip != ManufacturedTip::stick) {
    const auto tip_deflection = allowance(study.next_term, 4.0, study.temporal_share, coupling);
    EXPECT_TRUE(order_is(levels(study.element_length, study.tip_deflection, tip_deflection), 4.0));
    expect_predicted(study.tip_deflection, tip_deflection, "tip");
  }
  if (tip != ManufacturedTip::slip) {
    const auto force = allowance(study.next_term, 4.0, study.temporal_share_of_force, coupling);
    EXPECT_TRUE(order_is(levels(study.element_length, study.force, force), 4.0));
    if (tip == ManufacturedTip::stick) expect_predicted(study.force, force, "force");
    // The rounding of a third derivative grows with the cube of the number of elements, from 4 to 16 of them; that of the
    // steps, which grows less, is 8.5 % of it or less.
    EXPECT_GT(study.force.floor.back() / study.force.floor.front(), 64.0 * (1.0 - 0.085));
  }
}

constexpr std::array<std::pair<ManufacturedTip, const char*>, 3> tips{
    {{ManufacturedTip::stick, "stick"},
     {ManufacturedTip::slip, "slip"},
     {ManufacturedTip::friction, "friction"}}};

STICKSLIP_VERIFIES(ManufacturedSpace, "F10");
TEST(ManufacturedSpace, ConvergesWithThePredictedOrdersAndConstants) {
  for (const auto& [tip, name] : tips)
    for (const double load_factor : {-10.0, 0.0, 10.0}) {
      SCOPED_TRACE(fmt::format("{} {}", name, load_factor));
      expect_orders_and_constants_in_space(tip, load_factor);
    }
}

// 2 d w h + w T (w h)^2/24 = a h + b h^2 with the same w in a and b.
void expect_next_terms(const std::vector<double>& h, const std::vector<double>& next_term, double radius) {
  const double b = (next_term.front() / h.front() - next_term.back() / h.back()) / (h.front() - h.back());
  const double a = next_term.back() / h.back() - b * h.back(), d = (1.0 - radius) / (1.0 + radius);
  EXPECT_NEAR(radius < 1.0 ? std::pow(0.5 * a / d, 3) * 1000.0 * h.front() / 24.0 : b + a / h.front(), b,
              1e-9 * b);
}

void expect_order_and_constant_in_time(ManufacturedTip tip, double load_factor, double radius) {
  const auto study =
      studies::manufactured_time_errors(paper_beam(), tip, load_factor, radius, {1000, 2000, 4000, 8000});
  const auto& all_modes = study.next_term_of_all_modes;
  expect_next_terms(study.time_step, study.next_term, radius);
  expect_next_terms(study.time_step, all_modes, radius);
  EXPECT_EQ(study.displacement.order.order,
            studies::observed_order(study.time_step, study.displacement.error));
  if (tip == ManufacturedTip::friction) {
    EXPECT_TRUE(order_is(levels(study.time_step, study.displacement, all_modes), 2.0));
    // At a spectral radius of 0 the leading terms of velocity and force nearly vanish here.
    if (radius == 0.0) return;
    EXPECT_TRUE(order_is(levels(study.time_step, study.velocity, all_modes), 2.0));
    EXPECT_TRUE(order_is(levels(study.time_step, study.force, all_modes), 2.0));
    return;
  }
  EXPECT_TRUE(order_is(levels(study.time_step, study.displacement, study.next_term), 2.0));
  expect_predicted(study.displacement, study.next_term, "displacement");
  EXPECT_TRUE(order_is(levels(study.time_step, study.velocity, all_modes), 2.0));
  if (tip != ManufacturedTip::stick) return;
  // All modes count in the force. A mode's leading term has the factor cos(w T) - cos(omega T), which may be
  // small where the slope of cos(w T), by which the phase drifts, is not.
  const auto force = allowance(all_modes, 3.0);
  EXPECT_TRUE(order_is(levels(study.time_step, study.force, force), 2.0));
  expect_predicted(study.force, force, "force");
}

STICKSLIP_VERIFIES(ManufacturedTime, "F10");
TEST(ManufacturedTime, IsOfOrderTwoWithThePredictedConstant) {
  for (const auto& [tip, name] : tips)
    for (const double load_factor : {-10.0, 10.0})
      for (const double radius : {0.0, 0.9, 1.0}) {
        SCOPED_TRACE(fmt::format("{} {} radius {}", name, load_factor, radius));
        expect_order_and_constant_in_time(tip, load_factor, radius);
      }
}

}  // namespace
}  // namespace stickslip::testing
