// SPDX-License-Identifier: MIT
#include "studies/verification/further_uses.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>

#include "stickslip/data/case_file.hpp"
#include "stickslip/data/uncertainty.hpp"
#include "studies/analyses/slip_probability.hpp"
#include "studies/analyses/slip_readouts.hpp"
#include "studies/analyses/squeal.hpp"
#include "studies/history/method.hpp"

namespace stickslip::studies {

namespace {

constexpr const char *by_steps = "finite elements or matrices in time steps",
                     *by_events = "modes, event-driven";

FurtherUse compared(FurtherUse use, double first, double second) {
  use.value = second;
  use.difference = std::abs(first / second - 1.0);
  return use;
}

SlipReadouts readouts_by(const Method& method, const data::Case& problem) {
  const SlipReadouts readouts =
      slip_readouts(problem, method.run(problem, {.every = readout_row_step(problem, {})}, {}, {}), {});
  if (readouts.slips == 0) throw std::runtime_error("a case of the further uses does not slip");
  return readouts;
}

FurtherUse travel(const char* name, const char* file, const std::vector<data::Override>& overrides) {
  const data::Case problem = data::load_case(file, overrides);
  return compared({name, file, "distance slid", by_steps, by_events, {}, "m"},
                  readouts_by(finite_elements(), problem).travel,
                  readouts_by(event_driven(), problem).travel);
}

// The largest difference over the modes that the mesh resolves, in parts of the modulus of the root.
FurtherUse growth() {
  FurtherUse use{"squeal",
                 "reed",
                 "growth rate in steady sliding",
                 "eigenvalue of the mesh",
                 "root of the characteristic equation",
                 {},
                 "1/s"};
  const Squeal squeal = squeal_of(data::load_case("reed"), 4);
  for (const SquealMode& mode : squeal.modes)
    if (mode.root && mode.finite_element_root)
      use.difference =
          std::max(use.difference, std::abs(*mode.finite_element_root - *mode.root) / std::abs(*mode.root));
  use.value = squeal.modes.at(0).root.value().real();
  return use;
}

FurtherUse period() {
  const data::Case problem = data::load_case("squeak-stand");
  return compared({"periodic", "squeak-stand", "period", "slips in time steps", "shooting", {}, "s"},
                  readouts_by(finite_elements(), problem).spacing,
                  limit_cycle_of(problem, 60).search.motion.value().period);
}

// With an uncertain static coefficient alone the tip slips below its critical value, a quantile of the normal distribution.
FurtherUse probability() {
  const data::Case problem = data::load_case("uncertain", {{"excitation.amplitude", "0.6 mm", "the report"}});
  data::Uncertainty uncertainty = data::read_uncertainty(data::find_case("uncertain"));
  std::erase_if(uncertainty.keys, [](const auto& one) { return one.key != "friction.static_coefficient"; });
  uncertainty.correlation = {1.0};
  const auto sampled = slip_uncertainty(problem, uncertainty, {.samples = 200000, .is_short = true});
  const double coefficient = problem.contact.friction.static_coefficient();
  FurtherUse use{"probability",
                 "uncertain",
                 "probability of slip, coefficient alone",
                 "200 000 samples",
                 "quantile of the normal distribution",
                 {},
                 "1"};
  use.value = gsl_cdf_gaussian_P(coefficient / sampled.nominal_margin - 0.6, 0.05);
  use.difference = std::abs(sampled.probability_of_slip.value - use.value);
  return use;
}

}  // namespace

std::vector<FurtherUse> further_uses() {
  return {
      growth(),
      period(),
      probability(),
      travel("structures", "solid-cantilever",
             {{"excitation.amplitude", "2 mm", "the report"}, {"excitation.duration", "2 s", "the report"}}),
      travel("records", "recorded-mass", {}),
      travel("spectra", "rough-road",
             {{"friction.static_coefficient", "0.2", "the report"},
              {"friction.kinetic_coefficient", "0.15", "the report"},
              {"excitation.duration", "2 s", "the report"}})};
}

}  // namespace stickslip::studies
