// SPDX-License-Identifier: MIT
/// The beam element and the assembled beam: what a Hermite mesh reproduces exactly, follower term, damping, modes, what a simulation
/// makes of its settings, input errors.

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>

#include "stickslip/solver/base_motion.hpp"
#include "stickslip/solver/beam_element.hpp"
#include "stickslip/solver/beam_model.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "support/integral.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

STICKSLIP_VERIFIES(BeamModel, "F2");
TEST(BeamModel, InterpolatesACubicExactly) {
  const solver::BeamModel model(paper_beam(), 8);
  Eigen::VectorXd q(model.degrees_of_freedom());
  for (int node = 1; node <= 8; ++node)
    q.segment<2>(2 * node - 2) << std::pow(0.25 * node, 3), 3.0 * std::pow(0.25 * node, 2);
  for (const double x : {0.0, 0.37, 1.0, 1.9, 2.0})
    EXPECT_TRUE(within(model.interpolation(x).dot(q), x * x * x, round_off(20, 1, 8.0))) << x;
  EXPECT_THROW((void)model.interpolation(-0.1), std::invalid_argument);
  EXPECT_EQ(error_message_of<std::invalid_argument>([&] { (void)model.interpolation(2.1); }),
            "x is 2.1, but must be on the beam, 0 ... 2 (m)");
}

TEST(BeamModel, RefusesAForceOverTheBucklingLoad) {
  const solver::BeamModel model(paper_beam_with_axial_force(90e3), 8);
  const std::string message = error_message_of<data::InputError>([&] { (void)model.unit_tip_deflection(); });
  EXPECT_TRUE(holds(message, "beam.axial_force is 90000, but must be below"));
  EXPECT_TRUE(holds(message, "buckling load of the stick state, 841"));
  EXPECT_THROW((void)solver::stick_modes(model, 1), data::InputError);
  EXPECT_THROW(solver::BeamModel(paper_beam(), 0), std::invalid_argument);
}

TEST(BeamModel, RefusesABeamWhoseStiffnessOverflows) {
  data::BeamProperties shortest = paper_beam_properties();
  shortest.length = 1e-103;
  const solver::BeamModel model(data::Beam(shortest), 8);
  EXPECT_EQ(error_message_of<data::InputError>([&] { (void)model.unit_tip_deflection(); }),
            "beam.length is 1e-103, but must be so long (m) that the stiffness is finite on 8 elements");
  EXPECT_THROW((void)solver::stick_modes(model, 1), data::InputError);
}

STICKSLIP_VERIFIES(ModalAnalysis, "F2");
TEST(ModalAnalysis, SolvesItsPencil) {
  const solver::BeamModel model(paper_beam(), 10);
  const auto modes = solver::stick_modes(model, 6);
  ASSERT_EQ(modes.size(), 6u);
  for (std::size_t i = 0; i < modes.size(); ++i) {
    EXPECT_EQ(modes[i].shape[model.tip_deflection()], 0.0);
    for (std::size_t j = 0; j < modes.size(); ++j)
      EXPECT_TRUE(within(modes[i].shape.dot(model.mass() * modes[j].shape), i == j ? 1.0 : 0.0,
                         round_off(20, 1e3, 1.0)));
    const double square = std::pow(modes[i].angular_frequency, 2);
    EXPECT_TRUE(within(modes[i].shape.dot(model.stick_stiffness() * modes[i].shape), square,
                       round_off(20, 1e3, square)));
  }
}

// Far beyond flutter two elements have real frequencies again, two of them squares of imaginary ones.
TEST(ModalAnalysis, ModesBeyondFlutterAreRefused) {
  const auto modes_at = [](double factor, int elements, int count) {
    return error_message_if_any<data::InputError>([&] {
      (void)solver::slip_modes(solver::BeamModel(paper_beam_with_load_factor(factor), elements), count);
    });
  };
  EXPECT_FALSE(modes_at(19.6, 8, 2));
  EXPECT_TRUE(modes_at(20.5, 8, 2));
  EXPECT_FALSE(modes_at(300.0, 2, 1));
  EXPECT_TRUE(modes_at(300.0, 2, 2));
  EXPECT_THROW((void)solver::stick_modes(solver::BeamModel(paper_beam(), 2), 4), std::invalid_argument);
}

TEST(ModalAnalysis, HasModesThatBendUpwards) {
  // Curvature of the first element at x = 0: (6 w_1 - 2 l theta_1)/l^2. A mesh resolves as many modes as it
  // has elements.
  constexpr int elements = 10;
  const solver::BeamModel model(paper_beam(), elements);
  const double l = 2.0 / elements;
  for (const auto& modes : {solver::stick_modes(model, elements), solver::slip_modes(model, elements)})
    for (std::size_t n = 0; n < modes.size(); ++n)
      EXPECT_GT((6.0 * modes[n].shape[0] - 2.0 * l * modes[n].shape[1]) / (l * l), 0.0) << "mode " << n + 1;
}

constexpr double coarse_step = 1e-4;

data::NumericalSettings coarse(double duration = 0.2) {
  return data::NumericalSettings({.elements = 8,
                                  .time_step = coarse_step,
                                  .spectral_radius = 0.5,
                                  .velocity_threshold = 1e-2,
                                  .modes = 10,
                                  .duration = duration});
}

const data::HarmonicExcitation slipping_excitation({25.0, 1e-3});

data::Case coarse_case(const data::HarmonicExcitation& excitation, double duration = 0.2) {
  return with(paper_problem(25.0, 1e-3), excitation, coarse(duration));
}

STICKSLIP_VERIFIES(BeamSimulation, "F7");
TEST(BeamSimulation, HandsOnItsNumerics) {
  solver::BeamSimulation simulation(coarse_case(slipping_excitation),
                                    {.coordinates = solver::Coordinates::nodal});
  const solver::BeamModel model(paper_beam(), 8);
  const data::Case problem = coarse_case(slipping_excitation);
  solver::StickSlipIntegrator integrator(
      solver::beam_contact_system(model, problem),
      {.time_step = 1e-4, .spectral_radius = 0.5, .velocity_threshold = 1e-2});
  integrator.start_stuck(Eigen::VectorXd::Zero(16),
                         -solver::base_motion(problem.motion).velocity(0.0) * model.unit_tip_deflection());
  for (int n = 0; n < 2000; ++n) {
    simulation.integrator().step();
    integrator.step();
    ASSERT_EQ(simulation.integrator().displacement(), integrator.displacement()) << "step " << n;
  }
  // The threshold took part: without one nothing is captured while it still slides.
  const auto& events = integrator.events();
  EXPECT_TRUE(std::any_of(events.begin(), events.end(), [](const data::ContactEvent& event) {
    return event.change == data::ContactChange::capture && std::abs(event.residual_velocity) > 1e-3;
  }));
}

TEST(BeamSimulation, IsInTheFixedFrame) {
  solver::BeamSimulation simulation(coarse_case(slipping_excitation),
                                    {.coordinates = solver::Coordinates::nodal});
  for (int n = 0; n < 100; ++n) simulation.integrator().step();
  // 25 Hz at 10 ms: h = A0 sin(pi/2).
  EXPECT_TRUE(within(simulation.base_displacement(), 1e-3, round_off(4, 1, 1e-3)));
  EXPECT_EQ(simulation.displacement(0.0), simulation.base_displacement());
  EXPECT_EQ(simulation.displacement(1.0), simulation.midspan_displacement());
  EXPECT_EQ(simulation.displacement(2.0), simulation.tip_displacement());
}

TEST(BeamSimulation, IsPressedByCompressionOnly) {
  for (const double axial_force : {-400.0, 0.0, 250.0}) {
    const solver::BeamModel model(paper_beam_with_axial_force(axial_force), 2);
    EXPECT_EQ(solver::beam_contact_system(model, paper_problem(10.0, 1e-3)).normal_force,
              std::max(axial_force, 0.0));
  }
}

TEST(BeamSimulation, StepCountIsTheNearest) {
  EXPECT_EQ(solver::step_count(10.0, 1e-4), 100000);
  // 0.29/1e-4 is a rounding error under 2900, 0.1/3e-4 is 333.3 and 0.2/3e-4 is 666.7.
  ASSERT_LT(0.29 / 1e-4, 2900.0);
  EXPECT_EQ(solver::step_count(0.29, 1e-4), 2900);
  EXPECT_EQ(solver::step_count(0.1, 3e-4), 333);
  EXPECT_EQ(solver::step_count(0.2, 3e-4), 667);
}

TEST(BeamSimulation, LargestForceIsOneOfEitherSign) {
  // At 70 Hz the peak of the first 10 ms is positive, that of the first 20 ms negative.
  const data::HarmonicExcitation excitation({70.0, 0.5e-3});
  solver::BeamSimulation bonded(coarse_case(excitation),
                                {.is_bonded = true, .coordinates = solver::Coordinates::nodal});
  double highest = 0.0, lowest = 0.0;
  const auto run_until = [&](double end) {
    while (bonded.integrator().time() < end - 0.5e-4) {
      bonded.integrator().step();
      highest = std::max(highest, bonded.friction_force());
      lowest = std::min(lowest, bonded.friction_force());
    }
  };
  const auto largest = [&](double duration) {
    return solver::max_abs_friction_force(coarse_case(excitation, duration), solver::Coordinates::nodal);
  };
  run_until(0.01);
  ASSERT_GT(highest, -lowest);
  EXPECT_EQ(largest(0.01), highest);
  run_until(0.02);
  ASSERT_GT(-lowest, highest);
  EXPECT_EQ(largest(0.02), -lowest);
}

TEST(BeamSimulation, EveryRunTakesItsDamping) {
  const data::Damping damping({.kelvin_voigt = 6.4e-5, .ratio = 0.01});
  const data::Case undamped = coarse_case(slipping_excitation), damped = with(undamped, damping);
  solver::BeamSimulation simulation(damped);
  solver::BeamSimulation bonded(damped, {.is_bonded = true});
  const Eigen::MatrixXd expected = solver::damping_matrix(simulation.model(), damping);
  const solver::BeamSimulation nodal(damped, {.coordinates = solver::Coordinates::nodal});
  EXPECT_EQ(Eigen::MatrixXd(nodal.integrator().system().damping), expected);
  double largest = 0.0;
  for (int n = 0; n < 2000; ++n) {
    simulation.integrator().step();
    bonded.integrator().step();
    largest = std::max(largest, std::abs(bonded.friction_force()));
  }
  EXPECT_EQ(solver::max_abs_friction_force(damped), largest);
  EXPECT_EQ(solver::first_slip(damped), simulation.integrator().events().front().time);
  EXPECT_LT(largest, solver::max_abs_friction_force(undamped));
  // The largest force is that of a tip that is held, whatever the contact and the wall.
  const data::TangentialContact spring({.tangential_stiffness = 1e5});
  for (const data::Case& other : {damped, undamped})
    EXPECT_EQ(solver::max_abs_friction_force(with(other, spring, data::Wall(1.0))),
              solver::max_abs_friction_force(other));
}

TEST(BeamSimulation, FindsASlipInTheLastStep) {
  const auto slip_within = [](double duration) {
    return solver::first_slip(coarse_case(slipping_excitation, duration));
  };
  const auto slip = slip_within(0.2);
  ASSERT_TRUE(slip);
  const double steps = std::floor(*slip / coarse_step);
  EXPECT_EQ(slip_within((steps + 1.0) * coarse_step), slip);
  EXPECT_EQ(slip_within(steps * coarse_step), std::nullopt);
  // A base that hardly moves, beside a wall that takes the tip along.
  const data::Case quiet = coarse_case(shaking(25.0, 1e-6));
  EXPECT_FALSE(solver::first_slip(quiet));
  EXPECT_TRUE(solver::first_slip(with(quiet, data::Wall(1.0))));
}

// --- The element: integrals, no locking

using solver::ElementMatrix;
using solver::ElementVector;

constexpr double length = 0.7;
constexpr double mass_per_length = 3.5;
constexpr double flexural_rigidity = 11.0;

void expect_equal(const Eigen::MatrixXd& computed, const Eigen::MatrixXd& expected, double operations) {
  const double scale = expected.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < expected.rows(); ++i)
    for (Eigen::Index j = 0; j < expected.cols(); ++j)
      EXPECT_TRUE(within(computed(i, j), expected(i, j), round_off(operations, 1, scale))) << i << ", " << j;
}

// int v v^T dx of an element vector v(x/l).
template <class Integrand>
ElementMatrix square(const Integrand& integrand) {
  return integral(
      [&](double x) -> ElementMatrix {
        const ElementVector value = integrand(x / length);
        return value * value.transpose();
      },
      0.0, length, 1);
}

// N' of the cubic shape functions, which central differences of two steps give exactly but for round-off.
ElementVector slopes(double s, double g) {
  const auto difference = [&](double step) -> ElementVector {
    return (solver::shape_functions(s + step, length, g) - solver::shape_functions(s - step, length, g)) /
           (2.0 * step * length);
  };
  return (4.0 * difference(1.0) - difference(2.0)) / 3.0;
}

STICKSLIP_VERIFIES(BeamElement, "F1");
TEST(BeamElement, HasTheIntegralsOfItsShapes) {
  for (const double g : {0.0, 0.01, 1.0, 30.0}) {
    SCOPED_TRACE(g);
    // N' - theta, constant over the element: in equilibrium -EI theta''/(k G A), with the third derivatives
    // (12, 6 l, -12, 6 l)/l^3 of Hermite's functions over 1 + g.
    const ElementVector strain = ElementVector(-1.0 / length, -0.5, 1.0 / length, -0.5) * g / (1.0 + g);
    const auto theta = [&](double s) -> ElementVector { return slopes(s, g) - strain; };
    const auto curvature = [&](double s) -> ElementVector {  // theta is a parabola
      return (theta(s + 0.25) - theta(s - 0.25)) / (0.5 * length);
    };
    expect_equal(solver::consistent_mass(mass_per_length, length, g),
                 mass_per_length * square([&](double s) { return solver::shape_functions(s, length, g); }),
                 20);
    expect_equal(solver::rotary_mass(0.3, length, g), 0.3 * square(theta), 20);
    expect_equal(solver::geometric_stiffness(length, g), square([&](double s) { return slopes(s, g); }), 20);
    ElementMatrix stiffness = flexural_rigidity * square(curvature);
    if (g > 0.0)
      stiffness += 12.0 * flexural_rigidity / (g * length * length) * square([&](double) { return strain; });
    expect_equal(solver::bending_stiffness(flexural_rigidity, length, g), stiffness, 20);

    // Each shape function has its own value or rotation 1 at its own node, and 0 otherwise.
    ElementMatrix at_nodes;
    at_nodes << solver::shape_functions(0.0, length, g), theta(0.0), solver::shape_functions(1.0, length, g),
        theta(1.0);
    expect_equal(at_nodes, ElementMatrix::Identity(), 20);
  }
}

STICKSLIP_VERIFIES(ShearElement, "F12");
data::Beam square_beam(double beam_length, double shear_stiffness) {
  return data::Beam({.length = beam_length,
                     .area = 0.01,
                     .second_moment_of_area = 1e-4 / 12.0,
                     .density = 1000.0,
                     .youngs_modulus = 2e9,
                     .axial_force = 0.0,
                     .shear_stiffness = shear_stiffness});
}

TEST(ShearElement, WithoutShearIsHermitesToTheBit) {
  const solver::BeamModel rigid(square_beam(2.0, 0.0), 3), stiff(square_beam(2.0, 1e30), 3);
  EXPECT_EQ(Eigen::MatrixXd(rigid.elastic_stiffness() - stiff.elastic_stiffness()).cwiseAbs().maxCoeff(),
            0.0);
}

// A force F and a moment T at the free tip: w = F (x^2 (3 L - x)/(6 EI) + x/(k G A)) + T x^2/(2 EI), whatever the mesh, and
// however slender or stout the beam: nothing locks.
TEST(ShearElement, IsExactAtTheNodes) {
  const double bending = 2e9 * 1e-4 / 12.0, shear = 0.01 * 2e9 / 3.12;
  for (const double end : {0.05, 0.5, 5.0, 500.0})
    for (const int elements : {1, 3}) {
      const solver::BeamModel model(square_beam(end, shear), elements);
      Eigen::VectorXd load = Eigen::VectorXd::Zero(model.degrees_of_freedom());
      load[model.tip_deflection()] = 2.0;
      load[model.tip_rotation()] = 0.3 * end;
      const Eigen::VectorXd q = Eigen::MatrixXd(model.elastic_stiffness()).ldlt().solve(load);
      for (int node = 1; node <= elements; ++node) {
        const double x = end * node / elements;
        const double w = 2.0 * (x * x * (3.0 * end - x) / (6.0 * bending) + x / shear) +
                         0.3 * end * x * x / (2.0 * bending);
        // A tip force meets the stiffness of the clamp 12 elements^3 times more compliant.
        EXPECT_TRUE(within(q[2 * node - 2], w, round_off(20, 12.0 * std::pow(elements, 3), w)))
            << end << " m, " << elements << " elements";
      }
    }
}

// --- The damping matrix

data::Damping of_critical(double ratio) { return data::Damping({.ratio = ratio}); }

STICKSLIP_VERIFIES(DampingMatrix, "F9");
TEST(DampingMatrix, OfARatioIgnoresTheAxialForce) {
  const Eigen::MatrixXd loaded =
      solver::damping_matrix(solver::BeamModel(paper_beam_with_axial_force(4e4), 5), of_critical(0.02));
  const Eigen::MatrixXd unloaded =
      solver::damping_matrix(solver::BeamModel(paper_beam_with_axial_force(0.0), 5), of_critical(0.02));
  EXPECT_EQ((loaded - unloaded).cwiseAbs().maxCoeff(), 0.0);
  EXPECT_LE((loaded - loaded.transpose()).cwiseAbs().maxCoeff(),
            round_off(20, 1, loaded.cwiseAbs().maxCoeff()).value);
}

// Round-off: the matrix is accurate to eps omega_max for every mode. The modes, from an unsymmetric eigenproblem for
// 1/omega^2, are accurate to eps omega_n^2/omega_1^2.
TEST(DampingMatrix, HasTheRatioInEveryFreeMode) {
  constexpr double zeta = 0.02;
  const solver::BeamModel model(paper_beam_with_axial_force(0.0), 10);
  const Eigen::MatrixXd damping = solver::damping_matrix(model, of_critical(zeta));
  const auto modes = solver::slip_modes(model, 20);
  const double lowest = modes.front().angular_frequency, highest = modes.back().angular_frequency;
  for (std::size_t i = 0; i < 12; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      const double omega = modes[i].angular_frequency;
      EXPECT_TRUE(within(modes[i].shape.dot(damping * modes[j].shape), i == j ? 2.0 * zeta * omega : 0.0,
                         round_off(20, 1, 2.0 * zeta * (highest + omega * std::pow(omega / lowest, 2)))))
          << "modes " << i + 1 << ", " << j + 1;
    }
}

TEST(DampingMatrix, OfARatioKeepsTheLowestMode) {
  // Round-off of singular values is relative to omega_max/omega_1 = 26 n^2, here 2.7e5; an eigenproblem of
  // squares would lose its square, 7e10. The frequency of the model itself is known to eps/l^4.
  constexpr double zeta = 0.05;
  const solver::BeamModel model(paper_beam_with_axial_force(0.0), 100);
  const auto mode = solver::slip_modes(model, 1).front();
  const Eigen::VectorXd force = solver::damping_matrix(model, of_critical(zeta)) * mode.shape;
  EXPECT_TRUE(within(mode.shape.dot(force), 2.0 * zeta * mode.angular_frequency,
                     round_off(1, std::pow(100.0, 4), 2.0 * zeta * mode.angular_frequency)));
}

TEST(DampingMatrix, IsTheSumOfBothKindsOrEmpty) {
  const solver::BeamModel model(paper_beam(), 5);
  const Eigen::MatrixXd sum =
      solver::damping_matrix(model, data::Damping({.kelvin_voigt = 6.4e-5, .ratio = 0.02}));
  const Eigen::MatrixXd parts = Eigen::MatrixXd(solver::damping_matrix(model, kelvin_voigt(6.4e-5))) +
                                Eigen::MatrixXd(solver::damping_matrix(model, of_critical(0.02)));
  EXPECT_EQ((sum - parts).cwiseAbs().maxCoeff(), 0.0);
  EXPECT_EQ(solver::damping_matrix(model, {}).nonZeros(), 0);
}

TEST(DampingMatrix, OfARatioRefuses501Elements) {
  EXPECT_NO_THROW((void)solver::damping_matrix(solver::BeamModel(paper_beam(), 501), kelvin_voigt(1e-5)));
  EXPECT_EQ(
      error_message_of<std::invalid_argument>(
          [] { (void)solver::damping_matrix(solver::BeamModel(paper_beam(), 501), of_critical(0.01)); }),
      "numerics.elements is 501, but must be at most 500 with a damping.ratio above 0, whose matrix is full");
}

}  // namespace
}  // namespace stickslip::testing
