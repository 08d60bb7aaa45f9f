// SPDX-License-Identifier: MIT
/// The damped steady vibration: finite elements, in the frequency domain and by time stepping, against the
/// closed form, amplitude and phase.

#include <Eigen/Dense>

#include "stickslip/analytic/beam_contact_model.hpp"
#include "stickslip/analytic/damped_reaction.hpp"
#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/energy_balance.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "studies/common/simpson.hpp"
#include "support/beams.hpp"
#include "support/mesh.hpp"
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

constexpr double amplitude = Vibration::amplitude;
constexpr Complex imaginary_unit(0.0, 1.0);

data::Damping kelvin_voigt(double eta) { return data::Damping({.kelvin_voigt = eta}); }

Amplitudes exact_amplitudes(const Vibration& v) {
  const analytic::DampedSteadyState solution = v.solution();
  return {solution.displacement(1.0), solution.displacement(2.0), solution.friction_force()};
}

// The semi-discrete equations at one frequency, in the frame of the base.
class FrequencyDomain {
 public:
  FrequencyDomain(const Vibration& v, int elements)
      : v_(v),
        model_(v.beam(), elements),
        mass_(Eigen::MatrixXd(model_.mass()).cast<Complex>()),
        damping_(Eigen::MatrixXd(solver::damping_matrix(model_, v.damping)).cast<Complex>()),
        load_(v.omega() * v.omega() * amplitude * model_.base_load().cast<Complex>()) {}

  // Exact in time.
  [[nodiscard]] Amplitudes semi_discrete() const {
    const double omega = v_.omega();
    const MatrixXcd dynamic = stiffness() + imaginary_unit * omega * damping_ - omega * omega * mass_;
    VectorXcd q = static_shape();
    q += solve(dynamic, load_ - dynamic * q);
    return amplitudes(q, imaginary_unit * omega * q);
  }

  // What generalised-alpha makes of it with a step of length h (Chung & Hulbert 1993): with E = exp(i Omega
  // h), q_n = Q E^n and so on, V (E - 1) = h A (1 - gamma + gamma E), Q (E - 1) = h V + h^2 A (1/2 - beta +
  // beta E), the balance at the alpha levels, the load at t_n + (1 - alpha_f) h. With the tip held, of the
  // deviation from the static shape.
  [[nodiscard]] Amplitudes stepped(double h, double radius) const {
    const double omega = v_.omega();
    const double alpha_m = (2.0 * radius - 1.0) / (radius + 1.0), alpha_f = radius / (radius + 1.0);
    const double gamma = 0.5 - alpha_m + alpha_f, beta = 0.25 * std::pow(1.0 - alpha_m + alpha_f, 2);
    const Complex e = std::exp(imaginary_unit * omega * h);
    const Complex velocity = h * (1.0 - gamma + gamma * e) / (e - 1.0);
    const Complex displacement = (h * velocity + h * h * (0.5 - beta + beta * e)) / (e - 1.0);
    const Complex level_m = alpha_m + (1.0 - alpha_m) * e, level_f = alpha_f + (1.0 - alpha_f) * e;
    const MatrixXcd balance = level_m * mass_ + level_f * (velocity * damping_ + displacement * stiffness());
    const VectorXcd shape = static_shape();
    const VectorXcd load = load_ + omega * omega * mass_ * shape - imaginary_unit * omega * damping_ * shape;
    const VectorXcd a = solve(balance, std::exp(imaginary_unit * omega * h * (1.0 - alpha_f)) * load);
    return amplitudes(displacement * a + shape, velocity * a + imaginary_unit * omega * shape);
  }

 private:
  [[nodiscard]] bool held() const { return v_.tip == TipSupport::held; }
  [[nodiscard]] Eigen::Index contact() const { return model_.tip_deflection(); }
  // With the tip held: it stays at rest while the base moves.
  [[nodiscard]] VectorXcd static_shape() const {
    if (!held()) return VectorXcd::Zero(load_.size());
    return -amplitude * model_.unit_tip_deflection().cast<Complex>();
  }
  [[nodiscard]] MatrixXcd stiffness() const {
    return Eigen::MatrixXd(held() ? model_.stick_stiffness() : model_.slip_stiffness()).cast<Complex>();
  }

  // With the tip held: x_c = 0, and the row of c is left out.
  [[nodiscard]] VectorXcd solve(MatrixXcd matrix, VectorXcd right_side) const {
    if (held()) {
      matrix.row(contact()).setZero();
      matrix.col(contact()).setZero();
      matrix(contact(), contact()) = 1.0;
      right_side[contact()] = 0.0;
    }
    return matrix.partialPivLu().solve(right_side);
  }

  // f_d by the row of c of the slip-state balance, the acceleration by the other rows; with a free tip it is
  // zero.
  [[nodiscard]] Amplitudes amplitudes(const VectorXcd& q, const VectorXcd& v) const {
    const double omega = v_.omega();
    Complex force = 0.0;
    if (held()) {
      VectorXcd a = VectorXcd::Zero(q.size());
      a[contact()] = omega * omega * amplitude;
      a += solve(mass_, load_ - damping_ * v - stiffness() * q - mass_ * a);
      const MatrixXcd slip = Eigen::MatrixXd(model_.slip_stiffness()).cast<Complex>();
      force = -(mass_ * a + damping_ * v + slip * q - load_)[contact()];
    }
    const VectorXcd midspan = model_.interpolation(1.0).cast<Complex>();
    return {amplitude + (midspan.transpose() * q).value(), amplitude + q[contact()], force};
  }

  Vibration v_;
  solver::BeamModel model_;
  MatrixXcd mass_, damping_;
  VectorXcd load_;
};

std::vector<Vibration> vibrations() {
  std::vector<Vibration> all;
  for (const TipSupport tip : {TipSupport::held, TipSupport::free})
    for (const double hz : {15.0, 25.0, 70.0})
      for (const double eta : {6.4e-5, 2e-3, 1e-2}) all.push_back({hz, kelvin_voigt(eta), tip});
  return all;
}

// One of the three amplitudes, and what to call it.
struct Quantity {
  Complex Amplitudes::*member;
  const char* name;
};

std::vector<Quantity> quantities(TipSupport tip) {
  if (tip == TipSupport::held) return {{&Amplitudes::midspan, "midspan"}, {&Amplitudes::force, "force"}};
  return {{&Amplitudes::midspan, "midspan"}, {&Amplitudes::tip, "tip"}};
}

// The stiffness of n elements is known to n^4 eps; near a resonance an error of it grows with the response.
Tolerance mesh_round_off(int elements, double response, double scale) {
  return round_off(1, std::pow(elements, 4) * (1.0 + response / amplitude), scale);
}

STICKSLIP_VERIFIES(DampedFrequencyResponse, "X8");
TEST(DampedFrequencyResponse, HasOrderFourInAmplitudeAndPhase) {
  std::vector<std::string> without_order;
  for (const Vibration& v : vibrations()) {
    const Amplitudes exact = exact_amplitudes(v);
    const MeshError mesh_error(v);
    for (const auto& [member, name] : quantities(v.tip)) {
      std::vector<OrderLevel> levels;
      double constant = 0.0;
      for (const int elements : {8, 12, 16, 24, 32, 48}) {
        const Complex error = FrequencyDomain(v, elements).semi_discrete().*member - exact.*member;
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
      if (levels.front().next_term > largest_next_term)
        without_order.push_back(v.name() + ", " + name);
      else
        EXPECT_TRUE(order_is(levels, 4.0, constant)) << v.name() << ", " << name;
    }
  }
  // Here the leading term nearly vanishes: no power of l describes the error, though its prediction holds as
  // well.
  EXPECT_EQ(without_order,
            std::vector<std::string>{
                "P = 500.000000 N, 70.000000 Hz, eta = 0.002000 s, zeta = 0.000000, held, midspan"});
}

// Complex amplitude of y_n = Im[Y exp(2 pi i n/N)] from one period.
Complex amplitude_of(const std::vector<double>& period) {
  Complex sum = 0.0;
  const auto count = static_cast<double>(period.size());
  for (std::size_t n = 0; n < period.size(); ++n)
    sum += period[n] * std::exp(-2.0 * pi * imaginary_unit * static_cast<double>(n) / count);
  return 2.0 * imaginary_unit / count * sum;
}

// Of the runs by time steps.
constexpr int few_elements = 8, steps_per_period = 60;

double time_step(const Vibration& v) { return 1.0 / (v.hz * steps_per_period); }

// Whole periods after which exp(-rate t) is below 1e-14, rate the least of the decay rates: zeta omega + eta
// omega^2/2 of the lowest mode, or 1/eta of the stiffest, which creep.
long settling_periods(const Vibration& v) {
  const double lowest = 2.0 * pi * (v.tip == TipSupport::held ? 24.9 : 5.7);  // rad/s, rounded down
  const double eta = v.damping.kelvin_voigt();
  double rate = 0.75 * v.damping.ratio() * lowest + 0.5 * eta * lowest * lowest;
  if (eta > 0.0) rate = std::min(rate, 0.5 / eta);
  return std::lround(std::ceil(std::log(1e14) / rate * v.hz));
}

// The bonded or the free tip, stepped from the start until it is steady, with the last period observed.
Amplitudes stepped_amplitudes(const Vibration& v, double spectral_radius) {
  const bool held = v.tip == TipSupport::held;
  const solver::BeamModel model(v.beam(), few_elements);
  const auto base = solver::harmonic_motion(v.excitation());
  solver::ContactSystem system = held ? solver::beam_contact_system(model, paper_friction(), base, v.damping)
                                      : free_tip_system(model, base, v.damping);
  if (held) system.normal_force = solver::bonding_force;
  solver::StickSlipIntegrator integrator(system,
                                         {.time_step = time_step(v), .spectral_radius = spectral_radius});
  const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(model.degrees_of_freedom());
  if (held)
    integrator.start_stuck(at_rest, -base.velocity(0.0) * model.unit_tip_deflection());
  else
    integrator.start_slipping(at_rest, at_rest);
  for (long n = settling_periods(v) * steps_per_period; n > 0; --n) integrator.step();
  const Eigen::VectorXd midspan = model.interpolation(1.0);
  std::vector<double> midspans, tips, forces;
  for (int n = 0; n < steps_per_period; ++n) {
    const double h = base.displacement(integrator.time());
    midspans.push_back(h + midspan.dot(integrator.displacement()));
    tips.push_back(h + integrator.displacement()[model.tip_deflection()]);
    forces.push_back(-integrator.friction_force());
    integrator.step();
  }
  EXPECT_TRUE(integrator.events().empty());
  return {amplitude_of(midspans), amplitude_of(tips), held ? amplitude_of(forces) : 0.0};
}

// A step solves for accelerations, of which a displacement is the double sum: eps/(Omega h)^2; and M a in the
// balance is small against the K q of single rows.
Tolerance step_round_off(double response, double scale) {
  constexpr double theta = 2.0 * pi / steps_per_period;
  return {
      mesh_round_off(few_elements, response, scale).value + round_off(10, 1.0 / (theta * theta), scale).value,
      "round-off", "eps n^4 of the mesh, eps/(Omega h)^2 of the double sum"};
}

class DampedSteppedResponse : public ::testing::TestWithParam<double> {};

STICKSLIP_VERIFIES(DampedSteppedResponse, "X8");
// What remains to the closed form is the error of the mesh (DampedFrequencyResponse) and of the scheme.
TEST_P(DampedSteppedResponse, IsThatOfTheSchemeInTheFrequencyDomain) {
  for (const Vibration& v :
       {Vibration{25.0, kelvin_voigt(2e-3), TipSupport::held},
        Vibration{70.0, kelvin_voigt(5e-3), TipSupport::held},
        Vibration{25.0, data::Damping({.ratio = 0.2}), TipSupport::held},
        Vibration{25.0, kelvin_voigt(2e-2), TipSupport::free},
        Vibration{25.0, data::Damping({.kelvin_voigt = 2e-3, .ratio = 0.3}), TipSupport::free}}) {
    const Amplitudes computed = stepped_amplitudes(v, GetParam());
    const Amplitudes expected = FrequencyDomain(v, few_elements).stepped(time_step(v), GetParam());
    for (const auto& [member, name] : quantities(v.tip))
      EXPECT_TRUE(within(computed.*member, expected.*member,
                         step_round_off(std::abs(expected.midspan), std::abs(expected.*member))))
          << v.name() << ", " << name;
  }
}

INSTANTIATE_TEST_SUITE_P(SpectralRadius, DampedSteppedResponse, ::testing::Values(0.9, 1.0), NameOfDouble());

STICKSLIP_VERIFIES(ModalDamping, "X8");
// P = 0. Analytic free modes of unit tip deflection have int W^2 dx = L/4 and int W dx = (-1)^(n+1)
// sigma/beta with sigma = (cosh b + cos b)/(sinh b + sin b), b = beta L.
TEST(ModalDamping, OfTheFreeTipIsTheSumOverItsModesToFourthOrder) {
  for (const double hz : {5.0, 25.0, 70.0})
    for (const double zeta : {0.005, 0.2}) {
      const Vibration v{hz, data::Damping({.ratio = zeta}), TipSupport::free, 0.0};
      const double omega = v.omega();
      Complex exact = amplitude;
      for (const auto& mode : analytic::slip_modes(v.beam(), 200)) {
        const double b = 2.0 * mode.trigonometric_wave_number(), natural = mode.angular_frequency();
        const double sigma = (1.0 + std::cos(b) / std::cosh(b)) / (std::tanh(b) + std::sin(b) / std::cosh(b));
        exact += amplitude * (mode.number() % 2 == 1 ? 4.0 : -4.0) * sigma / b * omega * omega /
                 (natural * natural - omega * omega + 2.0 * imaginary_unit * zeta * natural * omega);
      }
      // The next term is (beta l)^2/40 of the first and, since u'''' does not vanish at a free tip, 10/(beta
      // L) of itself more.
      const double beta = std::sqrt(omega) * std::pow(10.0 / 16666.666666666668, 0.25);
      std::vector<OrderLevel> levels;
      for (const int elements : {8, 12, 16, 24}) {
        const double length = 2.0 / elements;
        levels.push_back({length, std::abs(FrequencyDomain(v, elements).semi_discrete().tip - exact),
                          std::pow(beta * length, 2) / 40.0 * (1.0 + 5.0 / beta),
                          mesh_round_off(elements, std::abs(exact), std::abs(exact)).value});
      }
      EXPECT_TRUE(order_is(levels, 4.0)) << v.name();
    }
}

// Weights |int rho A W_n U dx|^2 of the free modes in a stick mode, which add up to 1 and fall as n^-8. On
// the mesh every frequency is (beta l)^4/1440 too high.
TEST(ModalDamping, OfAStickModeIsTheMeanOverTheFreeModesItHolds) {
  constexpr double zeta = 0.02;
  constexpr int elements = 40;
  const data::Beam beam = paper_beam_with_axial_force(0.0);
  const auto free = analytic::slip_modes(beam, 40);
  const solver::BeamModel model(beam, elements);
  const Eigen::MatrixXd damping = solver::damping_matrix(model, data::Damping({.ratio = zeta}));
  const auto frequency_error = [](const auto& mode) {
    return std::pow(mode.trigonometric_wave_number() * 2.0 / elements, 4) / 1440.0;
  };
  const auto computed = solver::stick_modes(model, 3);
  for (const auto& stick : analytic::stick_modes(beam, 3)) {
    const double omega = stick.angular_frequency();
    double mean = 0.0, total = 0.0, mean_error = 0.0;
    for (const auto& mode : free) {
      const double overlap = studies::simpson_integral(
          [&](double x) { return stick.shape(x) * mode.shape(x); }, beam.length(), mode);
      const double weight = overlap * overlap / (stick.norm_squared() * 0.5);
      total += weight;
      mean += weight * mode.angular_frequency() / omega;
      mean_error += weight * mode.angular_frequency() / omega * frequency_error(mode);
    }
    const auto& shape = computed[static_cast<std::size_t>(stick.number() - 1)];
    const double ratio = shape.shape.dot(damping * shape.shape) / (2.0 * shape.angular_frequency);
    const double left_out = (1.0 - total) * free.back().angular_frequency() / omega;
    EXPECT_TRUE(within(ratio, zeta * mean,
                       discretisation(zeta * (mean_error + mean * frequency_error(stick) + left_out), 2.0,
                                      "(beta l)^4/1440 of both frequencies, the weights alike")))
        << "mode " << stick.number();
    const double documented[] = {0.78, 0.86, 0.90};
    EXPECT_TRUE(within(mean, documented[stick.number() - 1], reference(0.005, "two digits")));
  }
}

TEST(ModalDamping, OfTheModalModelIsThatOfFiniteElements) {
  // Next to resonance, where half the damping is twice the motion: midspan of the held beam over ten periods.
  const data::Damping damping({.ratio = 0.05});
  const data::HarmonicExcitation excitation({.frequency_hz = 25.0, .amplitude = 1e-5});
  const analytic::BeamContactModel modal(paper_beam(), paper_friction(), excitation, damping, 12);
  analytic::EventDriven exact(modal.model());
  solver::BeamSimulation stepped(paper_beam(), paper_friction(), excitation,
                                 data::NumericalSettings(paper_choices(0.4)), {.damping = damping});
  double difference = 0.0, largest = 0.0;
  for (int n = 1; n <= 400; ++n) {
    for (int i = 0; i < 10; ++i) stepped.step();
    exact.advance_to(1e-3 * n);
    const double expected = absolute_displacement(modal.shapes(1.0), exact);
    difference = largest_or_nan({difference, std::abs(stepped.midspan_displacement() - expected)});
    largest = std::max(largest, std::abs(expected));
  }
  EXPECT_TRUE(exact.events().empty());
  // Of second order in the step: (omega h)^2/12 of the frequency, over 63 rad.
  EXPECT_TRUE(within(difference, 0.0, discretisation(1.3e-3 * largest, 2.0, "(omega h)^2/12 omega t")));
}

// f(t) of the bonded tip over 0.2 s. A quarter of the step with half the element leaves 1/16 of the error; twice the
// modes leave an eighth.
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
    for (int n = 1; n <= 2000; ++n) forces.push_back(amplitude * force.value(1e-4 * n));
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

TEST(DampedSteppedResponse, DissipatesInEachPeriodWhatTheClosedFormSays) {
  // So much damping that what the start leaves has decayed by exp(-25) after 0.4 s.
  const Vibration v{.hz = 25.0, .damping = kelvin_voigt(5e-3), .tip = TipSupport::held};
  const auto loss = [&v](int steps) {
    data::NumericalChoices choices = paper_choices(0.44);
    choices.elements = 40;
    choices.time_step = 1.0 / (v.hz * steps);
    solver::BeamSimulation beam(v.beam(), paper_friction(), v.excitation(), data::NumericalSettings(choices),
                                {.contact = solver::TipContact::bonded, .damping = v.damping});
    for (int n = 0; n < 10 * steps; ++n) beam.step();
    solver::EnergyRecorder recorder(beam.integrator());
    for (int n = 0; n < steps; ++n) {
      beam.step();
      recorder.record(beam.integrator());
    }
    return recorder.balance().damping_loss;
  };
  const double coarse = loss(200), fine = loss(400), exact = v.solution().dissipated_energy();
  // Of second order in the step, that of the rule for the power included; the mesh is off by
  // (3.93/40)^4/720 = 1e-7.
  EXPECT_TRUE(within(fine, exact, discretisation(std::abs(coarse - fine) / 3.0, 1.3, "Richardson")));
}

}  // namespace
}  // namespace stickslip::testing
