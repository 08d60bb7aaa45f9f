// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "stickslip/analytic/beam_contact_model.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/data/problem.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "target.hpp"

namespace stickslip::fuzz {

namespace {

// Converts bytes to numbers; zeros after the last byte.
class Choices {
 public:
  explicit Choices(Bytes bytes) : bytes_(bytes) {}

  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const std::uint8_t first = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return first;
  }

  // `usual` itself, a value up to five decades above or below it in 25 steps per decade, or a value that is
  // not allowed (0, -1).
  double near(double usual) {
    constexpr std::array odd{0.0, -1.0};
    const int choice = byte();
    if (choice < 254) return usual * std::pow(10.0, (choice <= 125 ? choice : 125 - choice) / 25.0);
    return odd[static_cast<std::size_t>(choice - 254)];
  }

  int between(int lowest, int highest) { return lowest + byte() % (highest - lowest + 1); }

 private:
  Bytes bytes_;
};

data::Case case_of(Choices& choices) {
  const data::Beam beam({.length = choices.near(1.0),
                         .area = choices.near(5e-4),
                         .second_moment_of_area = choices.near(4e-9),
                         .density = choices.near(1000.0),
                         .youngs_modulus = choices.near(2e9),
                         .axial_force = choices.near(20.0)});
  const double static_coefficient = choices.near(0.5);
  const data::FrictionLaw friction({.static_coefficient = static_coefficient,
                                    .kinetic_coefficient = static_coefficient * choices.between(0, 4) / 4.0,
                                    .decay = choices.near(1.0)});
  const data::HarmonicExcitation excitation(
      {.frequency_hz = choices.near(25.0), .amplitude = choices.near(1e-3)});
  const double time_step = choices.near(1e-3);
  const data::NumericalSettings numerics({.elements = choices.between(1, 8),
                                          .time_step = time_step,
                                          .spectral_radius = choices.between(0, 4) / 4.0,
                                          .velocity_threshold = choices.near(1e-4),
                                          .modes = choices.between(1, 6),
                                          .duration = time_step * choices.between(1, 200)});
  return {.name = "fuzz",
          .beam = beam,
          .friction = friction,
          .excitation = excitation,
          .numerics = numerics,
          .damping = data::Damping({.kelvin_voigt = choices.byte() % 2 == 0 ? 0.0 : choices.near(1e-5),
                                    .ratio = choices.byte() % 2 == 0 ? 0.0 : choices.near(1e-2)})};
}

void require_finite(double time, std::initializer_list<double> values) {
  for (const double value : values)
    if (!std::isfinite(value))
      throw Violation("a number that is not finite at t = " + data::shortest_text(time) + " s");
}

void follow_by_finite_elements(const data::Case& problem, solver::ContactScheme scheme) {
  solver::BeamSimulation run(problem.beam, problem.friction, problem.excitation, problem.numerics,
                             {.damping = problem.damping, .scheme = scheme});
  const long steps = solver::step_count(problem.numerics.duration(), problem.numerics.time_step());
  for (long n = 0; n <= steps; ++n) {
    if (n > 0) run.step();
    require_finite(run.time(), {run.base_displacement(), run.tip_displacement(), run.midspan_displacement(),
                                run.sliding_velocity(), run.friction_force()});
  }
}

// The cost of an event-driven run: the angle (rad) of its fastest motion plus the number of time constants of
// the friction law.
double cost_of(const analytic::ContactModel& model, const data::Case& problem) {
  const double fastest = std::max(model.load_angular_frequency, std::ranges::max(model.angular_frequency));
  const double slope = model.friction.decay() * model.normal_force * model.friction.static_coefficient();
  double free_mass = model.contact_mass;
  for (const double coupling : model.mass_coupling) free_mass -= coupling * coupling;
  return problem.numerics.duration() * (fastest + slope / free_mass);
}

void follow_event_by_event(const data::Case& problem) {
  const analytic::BeamContactModel beam(problem.beam, problem.friction, problem.excitation, problem.damping,
                                        problem.numerics.modes(), problem.wall);
  constexpr double most = 300.0;  // runs above this cost would only take time
  if (cost_of(beam.model(), problem) > most) return;
  analytic::EventDriven run(beam.model());
  const std::vector<double> midspan = beam.shapes(problem.beam.length() / 2.0);
  const long steps = solver::step_count(problem.numerics.duration(), problem.numerics.time_step());
  for (long n = 0; n <= steps; ++n) {
    run.advance_to(static_cast<double>(n) * problem.numerics.time_step());
    require_finite(run.time(), {run.wall_displacement(), run.contact_position(),
                                analytic::absolute_displacement(midspan, run), run.sliding_velocity(),
                                run.friction_force()});
  }
}

}  // namespace

void respond(Bytes bytes) {
  Choices choices(bytes);
  const bool by_finite_elements = choices.byte() % 2 == 0;
  const auto scheme = static_cast<solver::ContactScheme>(choices.between(0, 2));
  // Invalid input and failed runs, as the command line distinguishes them from internal errors.
  try {
    const data::Case problem = case_of(choices);
    if (by_finite_elements)
      follow_by_finite_elements(problem, scheme);
    else
      follow_event_by_event(problem);
  } catch (const std::invalid_argument& error) {
    require_sentence(error);
  } catch (const std::runtime_error& failure) {
    require_sentence(failure);
  }
}

}  // namespace stickslip::fuzz
