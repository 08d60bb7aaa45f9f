// SPDX-License-Identifier: MIT
#include "studies/verification/amplitude_limits.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "stickslip/analytic/damped_reaction.hpp"
#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/analytic/force_maximum.hpp"
#include "stickslip/analytic/held_beam.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/data/key.hpp"
#include "studies/analyses/slip_probability.hpp"
#include "studies/common/parallel.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::studies {

namespace {

constexpr double width = 1e-6;
constexpr const char* all_inputs = "all inputs";

}  // namespace

AmplitudeLimits amplitude_limits(const data::Case& paper, const data::Case& damped,
                                 const std::vector<double>& frequencies_hz) {
  AmplitudeLimits study;
  study.contact_stiffness = 1000.0;
  const data::Beam& beam = paper.beam();
  const int modes = paper.numerics.modes();
  const double friction = friction_limit(paper), duration = paper.numerics.duration();
  const auto reaction = analytic::modal_reaction(beam, modes);
  const auto sheared = analytic::modal_reaction(with_shear(beam), modes);
  const auto fixed = analytic::modal_reaction(with_value(paper, "beam.axial_direction", 1.0).beam(), modes);
  const auto decaying =
      analytic::damped_reaction(analytic::HeldBeam(beam, damped.damping, modes).structure());
  const auto compliant = analytic::compliant_reaction(analytic::HeldBeam(beam, {}, modes).structure(),
                                                      study.contact_stiffness * tip_stiffness(beam));
  study.limits.resize(frequencies_hz.size());
  in_parallel(frequencies_hz.size(), [&](std::size_t i) {
    const data::HarmonicExcitation unit({.frequency_hz = frequencies_hz[i], .amplitude = 1.0});
    const double omega = angular_frequency(unit);
    const auto undamped_limit = [&](const analytic::ModalReaction& of) {
      return friction / analytic::ForceMaximum(of, omega, duration).refined_to(width).midpoint();
    };
    const auto limit = [&](const analytic::DampedReaction& of) {
      return friction / analytic::DampedForce(of, omega, duration).refined_to(width).midpoint();
    };
    const analytic::StickResponse steady(beam, unit, modes, analytic::SteadyPart::exact);
    const analytic::DampedSteadyState damped_steady(beam, unit, damped.damping, analytic::TipSupport::held);
    study.limits[i] = {.frequency_hz = frequencies_hz[i],
                       .start_up = undamped_limit(reaction),
                       .steady = friction / std::abs(steady.steady_force_amplitude()),
                       .damped_start_up = limit(decaying),
                       .damped_steady = friction / std::abs(damped_steady.friction_force()),
                       .shear = undamped_limit(sheared),
                       .fixed_direction = undamped_limit(fixed),
                       .compliant = limit(compliant)};
  });
  return study;
}

std::vector<AmplitudeChange> amplitude_budget(const AmplitudeLimits& limits,
                                              const std::vector<ForceMaximumStudy>& forces,
                                              const data::Case& problem, const data::Uncertainty& uncertainty,
                                              std::size_t samples) {
  std::vector<AmplitudeChange> budget;
  for (const ForceMaximumStudy& force : forces) {
    const double hz = force.frequency_hz;
    const auto add = [&](const std::string& cause, const char* kind, double low, double high) {
      budget.push_back({cause, kind, hz, std::max(0.0, 1.0 - low), std::max(0.0, high - 1.0)});
    };
    const auto add_ratio = [&](const std::string& cause, const char* kind, double ratio) {
      add(cause, kind, ratio, ratio);
    };
    const double exact = force.converged.midpoint();
    add_ratio("finite elements", "numerical", exact / force.finite_element);
    add_ratio("truncation to the modes kept", "numerical", exact / force.truncated.midpoint());

    const data::Case at = with_value(problem, "excitation.frequency_hz", hz);
    const SlipUncertainty inputs = slip_uncertainty(at, uncertainty, {.samples = samples, .is_short = true});
    add(all_inputs, "input", inputs.quantiles.front().margin.value / inputs.nominal_margin,
        inputs.quantiles.back().margin.value / inputs.nominal_margin);
    for (const auto& one : inputs.tornado) {
      const auto [low, high] = std::minmax(one.margin_low.value(), one.margin_high.value());
      const std::string_view label = data::key_named(one.key).axis.label;  // "axial force P / N"
      add(std::string(label.substr(0, label.find(" / "))), "input", low / inputs.nominal_margin,
          high / inputs.nominal_margin);
    }

    const AmplitudeLimit& limit = *std::ranges::find(limits.limits, hz, &AmplitudeLimit::frequency_hz);
    add_ratio("shear and rotary inertia", "model", limit.shear / limit.start_up);
    add_ratio("axial force of fixed direction", "model", limit.fixed_direction / limit.start_up);
    add_ratio("contact that yields", "model", limit.compliant / limit.start_up);
    add_ratio("damping", "model", limit.damped_start_up / limit.start_up);

    double low = 1.0, high = 1.0;
    for (const AmplitudeChange& one : budget)
      if (one.frequency_hz == hz && (one.kind != "input" || one.cause == all_inputs)) {
        low *= 1.0 - one.fall;
        high *= 1.0 + one.rise;
      }
    add("all together", "sum", low, high);
  }
  return budget;
}

}  // namespace stickslip::studies
