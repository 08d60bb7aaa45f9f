// SPDX-License-Identifier: MIT
/// Times of the basic operations. Only ratios between lines of one run are meaningful, not the times
/// themselves.

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "paper_problem.hpp"
#include "stickslip/analytic/band_maximum.hpp"
#include "stickslip/analytic/beam_contact_model.hpp"
#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/solver/beam_simulation.hpp"

namespace stickslip::benchmarks {
namespace {

const data::HarmonicExcitation excitation_with_slip({.frequency_hz = 25.0, .amplitude = 1e-3});
const data::Damping light_damping({.kelvin_voigt = 6.4e-5});
constexpr double half_a_second = 0.5;

// Half a second of damped stick-slip at 25 Hz and 1 mm by the event-driven method, over the number of modes.
void event_driven_run(benchmark::State& state) {
  const analytic::BeamContactModel model(paper_beam, paper_friction, excitation_with_slip, light_damping,
                                         static_cast<int>(state.range(0)));
  std::size_t events = 0;
  for (auto _ : state) {
    analytic::EventDriven run(model.model());
    run.advance_to(half_a_second);
    events = run.events().size();
    benchmark::DoNotOptimize(run.contact_displacement());
  }
  state.counters["events"] = static_cast<double>(events);
}
BENCHMARK(event_driven_run)->Arg(10)->Arg(20)->Unit(benchmark::kMillisecond);

// The same by time integration with ten elements, over the number of steps.
void time_stepper_run(benchmark::State& state) {
  const solver::BeamModel mesh(paper_beam, 10);
  const solver::PrescribedMotion base = solver::harmonic_motion(excitation_with_slip);
  solver::ContactSystem system = solver::beam_contact_system(mesh, paper_friction, base);
  system.damping = light_damping.kelvin_voigt() * mesh.elastic_stiffness();
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(mesh.degrees_of_freedom());
  const Eigen::VectorXd velocity = -base.velocity(0.0) * mesh.unit_tip_deflection();
  std::size_t events = 0;
  for (auto _ : state) {
    solver::StickSlipIntegrator run(
        system, {.time_step = half_a_second / static_cast<double>(state.range(0)), .spectral_radius = 0.9});
    run.start_stuck(rest, velocity);
    while (run.steps() < state.range(0)) run.step();
    events = run.events().size();
    benchmark::DoNotOptimize(run.displacement().data());
  }
  state.counters["events"] = static_cast<double>(events);
}
BENCHMARK(time_stepper_run)->Arg(5000)->Arg(50000)->Unit(benchmark::kMillisecond);

// Frequencies, shapes and integrals of the stick state.
void stick_modes(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(analytic::stick_modes(paper_beam, static_cast<int>(state.range(0))));
}
BENCHMARK(stick_modes)->Arg(10)->Arg(200)->Unit(benchmark::kMicrosecond);

// Whether a beam slips in a band of 10 Hz, over beams that differ by 1 % and limits that differ by 30 %: the whole
// search against a decision.
enum class BandVerdict { search, decision };
void band_verdict(benchmark::State& state, BandVerdict way) {
  int sample = 0;
  const auto share = [&](double ratio) { return std::fmod(ratio * sample, 1.0); };
  for (auto _ : state) {
    ++sample;
    auto properties = paper_beam.properties();
    properties.youngs_modulus *= 0.995 + 0.01 * share(std::numbers::phi);
    analytic::BandMaximum band(data::Beam(properties), {30.0, 40.0}, 10.0, 10);
    const double limit = 6.8e5 * (0.85 + 0.3 * share(std::numbers::sqrt2));
    benchmark::DoNotOptimize(way == BandVerdict::decision ? band.exceeds(limit)
                                                          : band.refined_against(limit, 1e-7).lower > limit);
  }
}
BENCHMARK_CAPTURE(band_verdict, search, BandVerdict::search)->Unit(benchmark::kMicrosecond)->Iterations(2000);
BENCHMARK_CAPTURE(band_verdict, decision, BandVerdict::decision)
    ->Unit(benchmark::kMicrosecond)
    ->Iterations(2000);

}  // namespace
}  // namespace stickslip::benchmarks
