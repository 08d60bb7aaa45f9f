// SPDX-License-Identifier: MIT
/// consumer CASE.toml: the critical amplitude of a beam by the closed form, and where the tip's midspan is
/// after one time step of the finite elements.

#include <iostream>

#include "stickslip/analytic/criterion.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/solver/beam_simulation.hpp"

int main(int argc, char** argv) {
  using namespace stickslip;
  if (argc != 2) return 2;
  const data::Case problem = data::read_case(argv[1]);

  const auto criterion = analytic::evaluate_criterion(problem);
  std::cout << "critical amplitude / m: " << data::shortest_text(criterion.critical_amplitude.midpoint())
            << '\n';

  solver::BeamSimulation simulation(problem);
  simulation.integrator().step();
  std::cout << "midspan / m: " << data::shortest_text(simulation.midspan_displacement()) << '\n'
            << "friction force / N: " << data::shortest_text(simulation.friction_force()) << '\n';
}
