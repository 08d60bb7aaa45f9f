// SPDX-License-Identifier: MIT
#include "studies/verification/energy_audit.hpp"

#include <algorithm>
#include <utility>

#include "stickslip/analytic/held_beam.hpp"
#include "studies/history/history.hpp"

namespace stickslip::studies {

namespace {

solver::EnergyBalance stepped_balance(const data::Case& problem, double duration, int elements,
                                      double time_step) {
  solver::BeamSimulation simulation(refined(problem, elements, time_step, duration, 1.0),
                                    {.coordinates = solver::Coordinates::nodal});
  solver::EnergyRecorder recorder(simulation.integrator());
  simulation.integrator().observe(
      [&recorder](const solver::StickSlipIntegrator& now) { recorder.record(now); });
  for (long n = solver::step_count(duration, time_step); n > 0; --n) simulation.integrator().step();
  return recorder.balance();
}

using data::ContactEvent;
using solver::ContactScheme;

constexpr double last_plateau = 0.2;  // s, latest start of a plateau

// In the frame of the base, which the solver uses, the wall moves by -h. The position of the contact on the
// wall is therefore y(L).
std::vector<Plateau> plateaus_of(const std::vector<ContactEvent>& events, double end_time) {
  std::vector<Plateau> plateaus;
  for (std::size_t i = 0; i < events.size() && events[i].time <= last_plateau; ++i) {
    if (events[i].change != data::ContactChange::capture) continue;
    const double end = i + 1 < events.size() ? events[i + 1].time : end_time;
    if (end - events[i].time >= SchemeRun::shortest_plateau)
      plateaus.push_back({events[i].time, end, events[i].position});
  }
  return plateaus;
}

}  // namespace

std::vector<double> EnergyAudit::Mesh::residual() const {
  std::vector<double> values;
  for (const auto& balance : stepped) values.push_back(balance.residual());
  return values;
}

std::vector<double> EnergyAudit::Mesh::base_work() const {
  std::vector<double> values;
  for (const auto& balance : stepped) values.push_back(balance.base_work);
  return values;
}

double EnergyAudit::Mesh::largest_unexplained() const {
  double largest = 0.0;
  for (const auto& balance : stepped)
    largest = largest_or_nan({largest, std::abs(balance.residual() / balance.base_work)});
  return largest;
}

EnergyAudit energy_audit(const data::Case& problem, double duration, const std::vector<int>& elements,
                         int modes, const std::vector<double>& time_steps) {
  const analytic::HeldBeam beam(problem.beam(), problem.damping, modes);
  analytic::EventDriven run(analytic::contact_model(beam.structure(), problem),
                            {.keep_energy_balance = true});
  const double initial = run.energy_balance().kinetic + run.energy_balance().potential;
  run.advance_to(duration);
  EnergyAudit audit{.kelvin_voigt = problem.damping.kelvin_voigt(),
                    .duration = duration,
                    .modes = modes,
                    .event_driven = run.energy_balance(),
                    .event_driven_initial = initial,
                    .time_step = time_steps,
                    .meshes = {}};
  for (const int count : elements) {
    EnergyAudit::Mesh mesh{.elements = count, .stepped = {}, .observed_order = {}};
    std::vector<double> residuals;
    for (const double time_step : time_steps) {
      mesh.stepped.push_back(stepped_balance(problem, duration, count, time_step));
      residuals.push_back(std::abs(mesh.stepped.back().residual()));
    }
    mesh.observed_order = order_estimate(time_steps, residuals);
    audit.meshes.push_back(std::move(mesh));
  }
  return audit;
}

double SchemeRun::relative_residual() const { return energy.residual() / energy.base_work; }

std::vector<SchemeRun> compare_schemes(const data::Case& problem) {
  std::vector<SchemeRun> runs;
  for (const auto scheme : {ContactScheme::located, ContactScheme::end_of_step, ContactScheme::paper}) {
    solver::BeamSimulation simulation(problem, {.scheme = scheme, .coordinates = solver::Coordinates::nodal});
    solver::EnergyRecorder recorder(simulation.integrator());
    simulation.integrator().observe(
        [&recorder](const solver::StickSlipIntegrator& now) { recorder.record(now); });
    SchemeRun run;
    const long steps = solver::step_count(problem.numerics.duration(), problem.numerics.time_step());
    for (long n = 0; n < steps; ++n) {
      simulation.integrator().step();
      run.largest_tip_displacement =
          std::max(run.largest_tip_displacement, std::abs(simulation.tip_displacement()));
    }
    const auto& events = simulation.integrator().events();
    if (!events.empty()) run.first_slip = events.front().time;
    run.events = events.size();
    run.plateaus = plateaus_of(events, simulation.integrator().time());
    run.energy = recorder.balance();
    runs.push_back(run);
  }
  return runs;
}

}  // namespace stickslip::studies
