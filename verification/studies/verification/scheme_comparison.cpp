// SPDX-License-Identifier: MIT
#include "studies/verification/scheme_comparison.hpp"

#include <algorithm>
#include <cmath>

namespace stickslip::studies {

namespace {

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

double SchemeRun::relative_residual() const { return energy.residual() / energy.base_work; }

std::vector<SchemeRun> compare_schemes(const data::Beam& beam, const data::FrictionLaw& friction,
                                       const data::HarmonicExcitation& excitation,
                                       const data::NumericalSettings& numerics,
                                       const data::Damping& damping) {
  std::vector<SchemeRun> runs;
  for (const auto scheme : {ContactScheme::located, ContactScheme::end_of_step, ContactScheme::paper}) {
    solver::BeamSimulation simulation(beam, friction, excitation, numerics,
                                      {.damping = damping, .scheme = scheme});
    solver::EnergyRecorder recorder(simulation.integrator());
    simulation.observe([&recorder](const solver::StickSlipIntegrator& now) { recorder.record(now); });
    SchemeRun run;
    for (long n = solver::step_count(numerics.duration(), numerics.time_step()); n > 0; --n) {
      simulation.step();
      run.largest_tip_displacement =
          std::max(run.largest_tip_displacement, std::abs(simulation.tip_displacement()));
    }
    const auto& events = simulation.integrator().events();
    if (!events.empty()) run.first_slip = events.front().time;
    run.events = events.size();
    run.plateaus = plateaus_of(events, simulation.time());
    run.energy = recorder.balance();
    runs.push_back(run);
  }
  return runs;
}

}  // namespace stickslip::studies
