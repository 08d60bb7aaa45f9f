// SPDX-License-Identifier: MIT
/// Every quantity of a mesh is off by a power of the element length times a constant that is derived here.

#include <Eigen/Dense>

#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/timoshenko_modes.hpp"
#include "stickslip/analytic/tip_mobility.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/contact_mobility.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "studies/common/bisection.hpp"
#include "studies/verification/frequencies.hpp"
#include "studies/verification/manufactured_solution.hpp"
#include "support/order.hpp"
#include "support/testing.hpp"
#include "support/vibration.hpp"
#include "support/waves.hpp"

namespace stickslip::testing {
namespace {

using Complex = std::complex<double>;

using Given = BeamProblem::Given;

// --- What Hermite's elements leave of B(v, u) of support/waves.hpp

/// An error of n elements: constant h^order (1 + next h^2) with h = 1/n.
struct MeshError {
  std::string what{};
  Complex constant, next;
  double waves{};     ///< the largest exponent: elements shorter than 1/waves are fine
  double scale{1.0};  ///< of the quantity, for its round-off
  std::function<Complex(int)> on_mesh{};
  int order{4};
  double left_out{};  ///< a share of the constant
};

/// B(v - v_h, u - u_h) of a mesh. Its motions are those of the beam at the nodes, and in between off by e with e'''' = u'''' on
/// an element with held ends: e'' = h^2 u''''/12 (1 - 6 s + 6 s^2) but for terms with u^(5) and u^(6), so that
///
///     int e_v'' e_u'' = h^4/720 [int v4 u4 - h^2 (8/105 int v5 u5 + 1/42 int (v4 u6 + v6 u4))],
///     int e_v' e_u' = h^6/30240 int v4 u4.
MeshError energy_of_errors(const BeamProblem& theory, const BeamWaves& v, const BeamWaves& u) {
  const Complex square = product(v, 4, u, 4);
  const Complex bent = product(v, 5, u, 5) * 8.0 / 105.0 + (product(v, 4, u, 6) + product(v, 6, u, 4)) / 42.0;
  return {.constant = square / 720.0,
          .next = -bent / square - theory.load() / 42.0,
          .waves = u.largest_exponent()};
}

using MeshErrors = std::vector<MeshError>;

/// B_h(v_h, u_h) = 0 at another omega^2: its relative error is B(v - v_h, u - u_h)/(-q int v u).
template <class Modes>
MeshErrors errors_of_frequencies(const char* name, const data::Beam& beam, const Modes& exact,
                                 std::vector<solver::FiniteElementMode> (*on_mesh)(const solver::BeamModel&,
                                                                                   int)) {
  MeshErrors errors;
  for (const auto& mode : exact) {
    const double omega = mode.angular_frequency();
    const BeamProblem theory{beam, {0.0, omega}};
    const BeamWaves u = theory.motion(false, Given::curvature_at_clamp),
                    v = theory.motion(true, Given::curvature_at_clamp);
    MeshError error = energy_of_errors(theory, v, u);
    error.what = fmt::format("{} frequency {}", name, mode.number());
    error.constant /= -theory.inertia() * product(v, 0, u, 0);
    error.on_mesh = [=, number = mode.number()](int n) {
      return std::pow(on_mesh(solver::BeamModel(beam, n), number).back().angular_frequency / omega, 2) - 1.0;
    };
    errors.push_back(error);
  }
  return errors;
}

MeshErrors stick_frequencies(const data::Beam& beam, RandomNumbers& /*numbers*/) {
  return errors_of_frequencies("stick", beam, analytic::stick_modes(beam, 5), solver::stick_modes);
}

/// P from tension to a share of the load at which the slip state loses its stability.
data::Beam sliding(const data::Beam& beam, RandomNumbers& numbers) {
  const double direction = random_direction(numbers);
  const double critical = analytic::slip_critical_load(directed(beam, direction, 0.0));
  return directed(beam, direction, numbers.uniform(-1.0, 0.8) * critical);
}

MeshErrors slip_frequencies(const data::Beam& any, RandomNumbers& numbers) {
  const data::Beam beam = sliding(any, numbers);
  return errors_of_frequencies("slip", beam, analytic::slip_modes(beam, 4), solver::slip_modes);
}

/// The largest P at which no omega^2 of a mesh is complex or negative, by halving to 1e-11 of it.
double slip_critical_load(const data::Beam& beam, int elements, double about) {
  const auto is_stable = [&](double force) {
    const solver::BeamModel mesh(directed(beam, beam.axial_direction(), force), elements);
    return std::ranges::all_of(solver::slip_eigenvalues(mesh, 2),
                               [](Complex square) { return square.imag() == 0.0 && square.real() > 0.0; });
  };
  return studies::bisected(0.9 * about, 1.1 * about, is_stable, 1e-11 * about);
}

/// B_h(v_h, u_h) = 0 at another P: z is off by B(v - v_h, u - u_h)/[int v' u' - (1 - chi) v(1) u'(1)]. In flutter omega is off as
/// well, but int v u is zero where two modes meet.
MeshError error_of_load(const std::string& name, const data::Beam& beam, double load, double omega) {
  const BeamProblem theory{directed(beam, beam.axial_direction(), load), {0.0, omega}};
  const BeamWaves u = theory.motion(false, Given::curvature_at_clamp),
                  v = theory.motion(true, Given::curvature_at_clamp);
  MeshError error = energy_of_errors(theory, v, u);
  error.what = fmt::format("{} at chi = {}", name, beam.axial_direction());
  error.constant /=
      theory.load() * (product(v, 1, u, 1) - (1.0 - beam.axial_direction()) * v(0, 1.0) * u(1, 1.0));
  return error;
}

MeshErrors critical_loads(const data::Beam& beam, RandomNumbers& numbers) {
  const double at_rest = 1e-3 * frequency_unit(beam), buckling = analytic::stick_buckling_load(beam);
  MeshErrors errors{error_of_load("buckling load in stick", beam, buckling, at_rest)};
  errors.front().on_mesh = [=](int n) {
    return solver::stick_buckling_load(solver::BeamModel(beam, n)) / buckling - 1.0;
  };
  for (const double direction :
       {0.0, numbers.uniform(0.0, 0.499), 0.499, 0.501, numbers.uniform(0.501, 1.0), 1.0}) {
    const data::Beam unloaded = directed(beam, direction, 0.0);
    const double load = analytic::slip_critical_load(unloaded);
    double omega = at_rest;
    if (direction < 0.5) {  // two frequencies, as far from where they meet as the square root of what P lacks
      const auto modes = analytic::slip_modes(directed(beam, direction, load * (1.0 - 1e-9)), 2);
      omega = 0.5 * (modes[0].angular_frequency() + modes[1].angular_frequency());
    }
    errors.push_back(error_of_load("critical load in slip", unloaded, load, omega));
    errors.back().on_mesh = [=](int n) { return slip_critical_load(unloaded, n, load) / load - 1.0; };
  }
  return errors;
}

/// J_h - J = -B(v - v_h, u - u_h) of the flexibility J = Y/s, u and v under a force 1 at the tip.
MeshErrors tip_mobility(const data::Beam& any, RandomNumbers& numbers) {
  const data::Beam beam = sliding(any, numbers);
  const double unit = frequency_unit(beam);
  MeshErrors errors;
  for (const double magnitude : {1e-3, numbers.log_uniform(0.1, 3.0), numbers.log_uniform(3.0, 40.0)})
    for (const double eta : {0.0, numbers.log_uniform(1e-4, 0.1) / unit}) {
      const Complex s = std::polar(magnitude * unit, numbers.uniform(0.0, 1.4));
      const BeamProblem theory{beam, s, eta};
      const Complex exact = analytic::TipMobility(beam, kelvin_voigt(eta))(s);
      MeshError error = energy_of_errors(theory, theory.motion(true, Given::force_at_tip),
                                         theory.motion(false, Given::force_at_tip));
      error.what = fmt::format("mobility at {:.3g} exp({:.3g} i), eta = {:.3g}", magnitude, std::arg(s), eta);
      error.constant *= -s * std::pow(beam.length(), 3) / theory.rigidity() / exact;
      error.on_mesh = [=](int n) {
        const solver::BeamModel mesh(beam, n);
        const auto system =
            solver::beam_contact_system(mesh, with(paper_problem(1.0, 1e-3), beam, kelvin_voigt(eta)));
        return solver::ContactMobility(system)(s) / exact - 1.0;
      };
      errors.push_back(error);
    }
  return errors;
}

/// f_h - f = -B(v - v_h, u - u_h) A0 D/L^3 with the tip held, u on a moving base and v with a moving tip.
MeshErrors reaction(const data::Beam& any, RandomNumbers& numbers) {
  const data::Beam beam = directed(any, random_direction(numbers), any.axial_force());
  std::vector<double> natural;
  for (const auto& mode : analytic::stick_modes(beam, 6)) natural.push_back(mode.angular_frequency());
  MeshErrors errors;
  for (const double eta : {0.0, numbers.log_uniform(1e-4, 0.1) / natural.front()}) {
    const double hz = random_frequency_hz(numbers, natural, 0.1), amplitude = 1e-3;
    const data::Case problem = with(paper_problem(hz, amplitude), beam, kelvin_voigt(eta));
    const BeamProblem theory{beam, {0.0, 2.0 * std::numbers::pi * hz}, eta};
    const Complex exact =
        analytic::DampedSteadyState(beam, problem.excitation(), problem.damping, analytic::TipSupport::held)
            .friction_force();
    MeshError error = energy_of_errors(theory, theory.motion(true, Given::position_of_tip),
                                       theory.motion(false, Given::position_of_tip, 0.0, 1.0));
    error.what = fmt::format("reaction at {} Hz, eta = {:.3g}", hz, eta);
    error.constant *= -amplitude * theory.rigidity() / std::pow(beam.length(), 3);
    error.scale = std::abs(exact);
    error.on_mesh = [=](int n) { return finite_element_steady_reaction(problem, n) - exact; };
    errors.push_back(error);
  }
  return errors;
}

/// With shear, q = rho A omega^2 w bends and shears an element whose nodes are held by q^2 l^5/(720 EI) + q^2 l^3/(12 k G A):
/// of second order where it is shorter than the section is high. Rotary inertia, left out, takes (beta r)^2 (1 - k G/E) of it.
MeshErrors shear_frequencies(const data::Beam& any, RandomNumbers& numbers) {
  data::BeamProperties properties = any.properties();
  const double height = std::sqrt(12.0 * properties.second_moment_of_area / properties.area);
  properties.length = height * numbers.uniform(5.0, 15.0);
  properties.shear_stiffness = properties.youngs_modulus * properties.area * numbers.uniform(0.2, 0.5);
  const data::Beam beam(properties);
  const double slenderness = beam.length() / height;
  MeshErrors errors;
  for (const bool is_held : {false, true}) {
    const auto tip = is_held ? analytic::TipSupport::held : analytic::TipSupport::free;
    const double omega = analytic::timoshenko_frequencies(beam, tip, 1).front();
    const double inertia = beam.density() * beam.area() * std::pow(omega * beam.length(), 2);
    const double wave_number_squared = omega / frequency_unit(beam);
    errors.push_back({.what = fmt::format("frequency with shear and the tip {}", is_held ? "held" : "free"),
                      .constant = inertia / (12.0 * beam.shear_stiffness()),
                      .next = beam.shear_stiffness() * std::pow(beam.length(), 2) / rigidity(beam) / 60.0,
                      .waves = 2.0 * slenderness,
                      .on_mesh =
                          [=](int n) {
                            const auto on_mesh = is_held ? solver::stick_modes : solver::slip_modes;
                            const auto mode = on_mesh(solver::BeamModel(beam, n), 1).front();
                            return std::pow(mode.angular_frequency / omega, 2) - 1.0;
                          },
                      .order = 2,
                      .left_out = wave_number_squared / std::pow(slenderness, 2) / 12.0});
  }
  return errors;
}

struct Row {
  const char* name;
  const char* requirement;
  ForceRange force;
  MeshErrors (*errors)(const data::Beam&, RandomNumbers&);
};

class MeshOrder : public ::testing::TestWithParam<Row> {};

STICKSLIP_VERIFIES(MeshOrder, "F3");
TEST_P(MeshOrder, HasTheDerivedConstant) {
  record_requirement(GetParam().requirement);
  on_random_beams(6, GetParam().force, [](const data::Beam& beam, RandomNumbers& numbers) {
    for (const MeshError& error : GetParam().errors(beam, numbers))
      for (const double finer : {1.0, 4.0 / 3.0, 2.0, 8.0 / 3.0}) {
        const int n = static_cast<int>(std::ceil(finer * std::max(error.waves, 3.0)));
        const double h = 1.0 / n, next = std::max(std::abs(error.next), error.waves * error.waves / 20.0);
        const Complex predicted = error.constant * std::pow(h, error.order) * (1.0 + error.next * h * h);
        // Four times the square of the next term, or of (waves h)^2/20, by which most series go on.
        const double behind = (4.0 * std::pow(next * h * h, 2) + error.left_out) * std::abs(predicted);
        EXPECT_TRUE(within(error.on_mesh(n), predicted,
                           discretisation(behind + round_off(1, std::pow(n, 4), error.scale).value, 1.0,
                                          "the terms behind the next one, and round-off")))
            << error.what << " on " << n << " elements";
      }
  });
}

INSTANTIATE_TEST_SUITE_P(Quantities, MeshOrder,
                         ::testing::Values(Row{"StickFrequencies", "F3", any_force, stick_frequencies},
                                           Row{"SlipFrequencies", "X23", no_force, slip_frequencies},
                                           Row{"CriticalLoads", "X23", no_force, critical_loads},
                                           Row{"TipMobility", "A9", no_force, tip_mobility},
                                           Row{"Reaction", "F4", any_force, reaction},
                                           Row{"ShearFrequencies", "X24", no_force, shear_frequencies}),
                         [](const auto& row) { return std::string(row.param.name); });

// --- The studies of the report

STICKSLIP_VERIFIES(FrequencyStudy, "F3");
// The constants in slip are those of P = 0: of a share z/(beta L)^2 too small.
TEST(FrequencyStudy, HasErrorsAndConstantsOfTheMesh) {
  const data::Beam beam = paper_beam();
  const std::vector<int> meshes{24, 32, 48};
  const auto expect = [&](const studies::FrequencyStudy& study, const MeshErrors& errors, double share) {
    ASSERT_EQ(study.modes.size(), errors.size());
    for (std::size_t k = 0; k < errors.size(); ++k) {
      const studies::FrequencyConvergence& mode = study.modes[k];
      const double next = 5.0 * std::abs(errors[k].next) * std::pow(meshes.front(), -2);
      const Tolerance behind = discretisation(share + next, 1.0, "the next term, and the share of P");
      for (std::size_t i = 0; i < meshes.size(); ++i) {
        const double leading = errors[k].constant.real() * std::pow(meshes[i], -4);
        EXPECT_TRUE(
            within(mode.relative_error[i], errors[k].on_mesh(meshes[i]).real(), round_off(4, 1, 1.0)));
        EXPECT_TRUE(within(mode.predicted_error[i] / leading, 1.0,
                           discretisation(share + 1e-8, 1.0, "the share of P, and Simpson's rule")));
      }
      EXPECT_TRUE(within(mode.leading_constant_ratio, 1.0, behind)) << errors[k].what;
      EXPECT_TRUE(within(mode.observed_order.order, 4.0, behind)) << errors[k].what;
    }
  };
  RandomNumbers numbers(1);
  expect(studies::stick_frequency_study(beam, 5, meshes), stick_frequencies(beam, numbers), 0.0);
  const auto modes = analytic::slip_modes(beam, 4);
  expect(studies::slip_frequency_study(beam, 4, meshes),
         errors_of_frequencies("slip", beam, modes, solver::slip_modes), 0.035);

  const MeshError beck = critical_loads(beam, numbers).at(1);
  const studies::FlutterStudy flutter = studies::flutter_study(beam, {8, 12, 16});
  for (std::size_t i = 0; i < flutter.elements.size(); ++i)
    EXPECT_TRUE(within(flutter.relative_error()[i], beck.on_mesh(flutter.elements[i]).real(),
                       reference(2e-10, "the bisection, 1e-9 of 20.05")));
  EXPECT_TRUE(
      within(flutter.observed_order.order, 4.0, discretisation(std::abs(beck.next) / 64.0, 5.0, "next")));

  // So few points that modes have another sign at the second one.
  for (const auto& curve : studies::mode_shape_study(beam, 12, 20, 13).curves) {
    EXPECT_GT(curve.closed_form[1], 0.0) << curve.mode;
    EXPECT_GT(curve.finite_element[1], 0.0) << curve.mode;
  }
}

using studies::ManufacturedTip;
using studies::PredictedErrors;
using Shares = std::vector<double>;

// What the next terms, twice the time steps and anything else may add on each level.
Shares allowance(const Shares& next_term, double margin, const Shares& temporal_share = {},
                 double other_share = 0.0) {
  Shares sum;
  for (std::size_t i = 0; i < next_term.size(); ++i)
    sum.push_back(margin * next_term[i] + other_share +
                  (temporal_share.empty() ? 0.0 : 2.0 * temporal_share[i]));
  return sum;
}

// The errors fall with the order, and are the predicted ones where there are some, to within the shares.
void expect_order(const char* what, const std::vector<double>& steps, const PredictedErrors& errors,
                  double order, const Shares& of_order, const Shares& of_prediction) {
  std::vector<OrderLevel> levels;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    levels.push_back({steps[i], errors.error.at(i), of_order.at(i), errors.floor.at(i)});
    if (errors.predicted.empty()) continue;
    EXPECT_TRUE(within(errors.error[i] / errors.predicted.at(i), 1.0,
                       discretisation(of_prediction.at(i), 1.0, "terms behind the leading one")))
        << what << ", level " << i;
  }
  EXPECT_TRUE(order_is(levels, order)) << what;
  EXPECT_TRUE(within(errors.order.order, order,
                     discretisation(order_bound(levels).slope, 1.0, "what the next terms do to the slope")))
      << what;
}

// What the elements add to the interpolant, E, is a difference of a particular and a free part, each a few
// times as large: hence four times the share of the next terms wherever it enters.
void expect_orders_in_space(ManufacturedTip tip, double load_factor) {
  const auto study = studies::manufactured_space_errors(paper_beam(), tip, load_factor, {4, 6, 8, 12, 16});
  const double coupling = study.friction_coupling.value_or(0.0);
  const auto& lengths = study.element_length;
  const Shares four = allowance(study.next_term, 4.0),
               deflection = allowance(study.next_term, 4.0, study.temporal_share, 0.25 * coupling);
  Shares slope = four, squares;
  for (std::size_t i = 0; i < slope.size(); ++i) {
    slope[i] += study.nodal_share_of_slope[i];
    squares.push_back(study.next_term[i] * study.next_term[i]);
  }
  expect_order("deflection", lengths, study.deflection, 4.0, deflection, deflection);
  expect_order("slope", lengths, study.slope, 3.0, slope, four);
  expect_order("curvature", lengths, study.curvature, 2.0, study.next_term, squares);
  if (tip != ManufacturedTip::stick) {
    const Shares at_tip = allowance(study.next_term, 4.0, study.temporal_share, coupling);
    expect_order("tip", lengths, study.tip_deflection, 4.0, at_tip, at_tip);
  }
  if (tip != ManufacturedTip::slip) {
    const Shares force = allowance(study.next_term, 4.0, study.temporal_share_of_force, coupling);
    expect_order("force", lengths, study.force, 4.0, force, force);
    // The rounding of a third derivative grows with the cube of the number of elements, from 4 to 16 of them; that of the
    // steps, which grows less, is 8.5 % of it or less.
    EXPECT_GT(study.force.floor.back() / study.force.floor.front(), 64.0 * (1.0 - 0.085));
  }
}

STICKSLIP_VERIFIES(ManufacturedSpace, "F10");
TEST(ManufacturedSpace, HasItsOrdersAndConstants) {
  for (const auto tip : {ManufacturedTip::stick, ManufacturedTip::slip, ManufacturedTip::friction})
    for (const double load_factor : {-10.0, 0.0, 10.0}) {
      SCOPED_TRACE(fmt::format("{} {}", to_string(tip), load_factor));
      expect_orders_in_space(tip, load_factor);
    }
}

// 2 d w h + w T (w h)^2/24 = a h + b h^2 with the same w in a and b.
void expect_next_terms(const std::vector<double>& h, const Shares& next_term, double radius) {
  const double b = (next_term.front() / h.front() - next_term.back() / h.back()) / (h.front() - h.back());
  const double a = next_term.back() / h.back() - b * h.back(), d = (1.0 - radius) / (1.0 + radius);
  EXPECT_TRUE(within(radius < 1.0 ? std::pow(0.5 * a / d, 3) * 1000.0 * h.front() / 24.0 : b + a / h.front(),
                     b, round_off(10, h.front() / h.back() * 1e4, b)));
}

void expect_orders_in_time(ManufacturedTip tip, double load_factor, double radius) {
  const auto study =
      studies::manufactured_time_errors(paper_beam(), tip, load_factor, radius, {1000, 2000, 4000, 8000});
  const auto& steps = study.time_step;
  const auto& all_modes = study.next_term_of_all_modes;
  expect_next_terms(steps, study.next_term, radius);
  expect_next_terms(steps, all_modes, radius);
  const bool has_friction = tip == ManufacturedTip::friction;
  expect_order("displacement", steps, study.displacement, 2.0, has_friction ? all_modes : study.next_term,
               study.next_term);
  // At a spectral radius of 0 the leading terms of velocity and force nearly vanish with friction.
  if (has_friction && radius == 0.0) return;
  expect_order("velocity", steps, study.velocity, 2.0, all_modes, {});
  if (tip == ManufacturedTip::slip) return;
  // All modes count in the force. A mode's leading term has the factor cos(w T) - cos(omega T), which may be
  // small where the slope of cos(w T), by which the phase drifts, is not.
  const Shares force = has_friction ? all_modes : allowance(all_modes, 3.0);
  expect_order("force", steps, study.force, 2.0, force, force);
}

STICKSLIP_VERIFIES(ManufacturedTime, "F10");
TEST(ManufacturedTime, IsOfOrderTwoWithItsConstant) {
  for (const auto tip : {ManufacturedTip::stick, ManufacturedTip::slip, ManufacturedTip::friction})
    for (const double load_factor : {-10.0, 10.0})
      for (const double radius : {0.0, 0.9, 1.0}) {
        SCOPED_TRACE(fmt::format("{} {} radius {}", to_string(tip), load_factor, radius));
        expect_orders_in_time(tip, load_factor, radius);
      }
}

}  // namespace
}  // namespace stickslip::testing
