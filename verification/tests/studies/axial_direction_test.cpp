// SPDX-License-Identifier: MIT
/// The direction of the axial force, chi, in both implementations.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <numbers>
#include <vector>

#include "stickslip/analytic/beam_contact_model.hpp"
#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/modal_reaction_table.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/tip_mobility.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/contact_mobility.hpp"
#include "stickslip/solver/energy_balance.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "studies/criterion/model_form.hpp"
#include "studies/stick/frequencies.hpp"
#include "studies/stick_slip/converged_history.hpp"
#include "studies/stick_slip/damped_benchmark.hpp"
#include "studies/stick_slip/energy_audit.hpp"
#include "support/beams.hpp"
#include "support/order.hpp"
#include "support/parameter_name.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

using std::numbers::pi;

double rigidity_of(const data::Beam& beam) { return beam.youngs_modulus() * beam.second_moment_of_area(); }

// P = factor EI/L^2.
data::Beam beam_with(double axial_direction, double factor) {
  data::BeamProperties properties = paper_beam_properties();
  properties.axial_force = factor * rigidity_of(paper_beam()) / (properties.length * properties.length);
  properties.axial_direction = axial_direction;
  return data::Beam(properties);
}

double critical_factor(double axial_direction) {
  const data::Beam beam = beam_with(axial_direction, 0.0);
  return analytic::slip_critical_load(beam) * beam.length() * beam.length() / rigidity_of(beam);
}

bool is_stable(const data::Beam& beam, int elements) {
  const auto squares = solver::slip_eigenvalues(solver::BeamModel(beam, elements), 2);
  return std::ranges::all_of(squares, [](auto square) { return square.imag() == 0.0 && square.real() > 0.0; });
}

// The load factor of the mesh below which the slip state is stable, to 1e-9.
double critical_factor_of_the_mesh(double axial_direction, int elements) {
  double low = 0.0, high = 0.25;
  while (is_stable(beam_with(axial_direction, high), elements)) low = high, high += 0.25;
  while (high - low > 1e-9) {
    const double middle = 0.5 * (low + high);
    (is_stable(beam_with(axial_direction, middle), elements) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

TEST(Explore, Numbers) {
  for (const double chi : {0.0, 0.2, 0.4, 0.49, 0.5, 0.501, 0.6, 0.8, 1.0}) {
    std::printf("chi %g closed %.12g", chi, critical_factor(chi));
    for (const int n : {4, 6, 8, 12, 16}) std::printf("  %.6e", critical_factor_of_the_mesh(chi, n) / critical_factor(chi) - 1.0);
    std::printf("\n");
  }
  const auto form = studies::model_form(data::load_case("paper"), data::load_case("paper-half-stiffness"),
                                        data::load_case("paper-figure14"), 81);
  for (const auto& f : form.forces) std::printf("%g Hz %.6f\n", f.frequency_hz, f.ratio);
  for (const auto& p : form.planes)
    std::printf("%s: cells %zu flipped %zu ratio %.4f .. %.4f buckled %zu load %.6g\n", p.figures.c_str(), p.cells, p.flipped,
                p.lowest_ratio, p.highest_ratio, p.buckled, p.slip_buckling_load);
}

}  // namespace
}  // namespace stickslip::testing
