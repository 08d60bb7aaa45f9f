// SPDX-License-Identifier: MIT
/// The damped steady vibration: finite elements, in the frequency domain and by time stepping, against the
/// closed form, amplitude and phase.

#include <Eigen/Dense>

#include "stickslip/analytic/damped_reaction.hpp"
#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "support/order.hpp"
#include "support/testing.hpp"
#include "support/vibration.hpp"

namespace stickslip::testing {
namespace {

using analytic::TipSupport;
using std::numbers::pi;
using Complex = std::complex<double>;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;

constexpr double base_amplitude = Vibration::amplitude;
constexpr Complex imaginary_unit(0.0, 1.0);

Amplitudes exact_amplitudes(const Vibration& v) {
  const analytic::DampedSteadyState solution = v.solution();
  return {solution.displacement(1.0), solution.displacement(2.0), solution.friction_force()};
}

// The semi-discrete equations at one frequency, in the frame of the base, exact in time. A held tip is at rest while the base
// moves, and the row of the slip-state balance that is left out gives f_d.
Amplitudes frequency_domain(const Vibration& v, int elements) {
  const solver::BeamModel model(v.beam(), elements);
  const auto complex = [](const auto& matrix) { return MatrixXcd(Eigen::MatrixXd(matrix).cast<Complex>()); };
  const double omega = v.omega();
  const MatrixXcd dynamic = complex(model.slip_stiffness()) +
                            imaginary_unit * omega * complex(solver::damping_matrix(model, v.damping)) -
                            omega * omega * complex(model.mass());
  const VectorXcd load = omega * omega * base_amplitude * model.base_load().cast<Complex>();
  const Eigen::Index tip = model.tip_deflection();
  MatrixXcd matrix = dynamic;
  VectorXcd right_side = load, q = VectorXcd::Zero(load.size());
  if (v.tip == TipSupport::held) {
    q = -base_amplitude * model.unit_tip_deflection().cast<Complex>();
    matrix.row(tip).setZero();
    matrix.col(tip).setZero();
    matrix(tip, tip) = 1.0;
    right_side -= dynamic * q;
    right_side[tip] = 0.0;
  }
  q += matrix.partialPivLu().solve(right_side);
  const Complex force = v.tip == TipSupport::held ? load[tip] - (dynamic.row(tip) * q)(0) : 0.0;
  const VectorXcd midspan = model.interpolation(1.0).cast<Complex>();
  return {base_amplitude + (midspan.transpose() * q).value(), base_amplitude + q[tip], force};
}

std::vector<Vibration> vibrations() {
  std::vector<Vibration> all;
  for (const TipSupport tip : {TipSupport::held, TipSupport::free})
    for (const double hz : {15.0, 25.0, 70.0})
      for (const double eta : {6.4e-5, 1e-2}) all.push_back({hz, kelvin_voigt(eta), tip});
  return all;
}

// One of the three amplitudes, and what to call it.
struct SteadyQuantity {
  Complex Amplitudes::*member;
  const char* name;
};

std::vector<SteadyQuantity> quantities(TipSupport tip) {
  if (tip == TipSupport::held) return {{&Amplitudes::midspan, "midspan"}, {&Amplitudes::force, "force"}};
  return {{&Amplitudes::midspan, "midspan"}, {&Amplitudes::tip, "tip"}};
}

// The stiffness of n elements is known to n^4 eps; near a resonance an error of it grows with the response.
Tolerance mesh_round_off(int elements, double response, double scale) {
  return round_off(1, std::pow(elements, 4) * (1.0 + response / base_amplitude), scale);
}

STICKSLIP_VERIFIES(DampedFrequencyResponse, "X8");
TEST(DampedFrequencyResponse, HasOrderFourInAmplitudeAndPhase) {
  for (const Vibration& v : vibrations()) {
    const Amplitudes exact = exact_amplitudes(v);
    const MeshError mesh_error(v);
    for (const auto& [member, name] : quantities(v.tip)) {
      std::vector<OrderLevel> levels;
      double constant = 0.0;
      for (const int elements : {8, 12, 16, 24, 32, 48}) {
        const Complex error = frequency_domain(v, elements).*member - exact.*member;
        const auto [leading, next] = mesh_error.predicted(elements);
        const double rounding =
            mesh_round_off(elements, std::abs(exact.midspan), std::abs(exact.*member)).value;
        EXPECT_TRUE(within(
            error, leading.*member,
            discretisation(std::abs(next.*member) + rounding, 1.0, "terms of order l^6, and round-off")))
            << v.name() << ", " << name << ", " << elements << " elements";
        // Round-off grows as n^4: on more than 24 elements it is in the error's way.
        if (elements > 24) continue;
        const double length = 2.0 / elements, size = std::abs(leading.*member);
        constant = size / std::pow(length, 4);
        levels.push_back({length, std::abs(error), std::abs(next.*member) / size, rounding});
      }
      EXPECT_TRUE(order_is(levels, 4.0, constant)) << v.name() << ", " << name;
    }
  }
}

// f(t) of the bonded tip over 0.2 s. A quarter of the step with half the element leaves 1/16 of the error; twice the
// modes leave an eighth.
STICKSLIP_VERIFIES(DampedSteppedResponse, "X8");
TEST(DampedSteppedResponse, StartsAsTheClosedFormSays) {
  const auto stepped = [](const Vibration& v, int level) {
    data::NumericalChoices choices = paper_choices(0.2);
    choices.elements = 20 << level;
    choices.time_step = 1e-4 / (level == 0 ? 1.0 : 4.0);
    solver::BeamSimulation beam(v.beam(), paper_friction(), v.excitation(), data::NumericalSettings(choices),
                                {.contact = solver::TipContact::bonded, .damping = v.damping});
    std::vector<double> forces;
    for (int n = 0; n < 2000; ++n) {
      for (int i = 0; i < (level == 0 ? 1 : 4); ++i) beam.step();
      forces.push_back(beam.friction_force());
    }
    return forces;
  };
  const auto closed_form = [](const Vibration& v, int modes) {
    const analytic::DampedForce force(
        analytic::damped_reaction(v.beam(), v.damping, modes, analytic::SteadyPart::exact), v.omega(), 0.2);
    std::vector<double> forces;
    for (int n = 1; n <= 2000; ++n) forces.push_back(base_amplitude * force.value(1e-4 * n));
    return forces;
  };
  const auto distance = [](const std::vector<double>& a, const std::vector<double>& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = largest_or_nan({largest, std::abs(a[i] - b[i])});
    return largest;
  };
  for (const Vibration& v : {Vibration{15.0, kelvin_voigt(6.4e-5), TipSupport::held},
                             Vibration{25.0, kelvin_voigt(6.4e-5), TipSupport::held},
                             Vibration{70.0, kelvin_voigt(6.4e-5), TipSupport::held},
                             Vibration{25.0, data::Damping({.ratio = 0.02}), TipSupport::held},
                             Vibration{70.0, data::Damping({.ratio = 0.02}), TipSupport::held}}) {
    const auto coarse = stepped(v, 0), fine = stepped(v, 1), exact = closed_form(v, 40);
    const double of_mesh_and_step = distance(coarse, fine) / 15.0;
    const double of_modes = distance(closed_form(v, 20), exact) / 7.0;
    EXPECT_TRUE(
        within(distance(fine, exact), 0.0,
               discretisation(of_mesh_and_step + of_modes, 1.2, "h^2 and l^4, by Richardson, and N^-3")))
        << v.name();
  }
}

}  // namespace
}  // namespace stickslip::testing
