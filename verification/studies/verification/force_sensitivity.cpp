// SPDX-License-Identifier: MIT
#include "studies/verification/force_sensitivity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
#include <iterator>
#include <numbers>

#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/common/convergence.hpp"
#include "studies/common/parallel.hpp"
#include "studies/verification/paper_checks.hpp"

namespace stickslip::studies {

namespace {

constexpr int all_modes = 100;  // with the exact steady part; the omitted modes are bounded
constexpr double relative_width = 1e-13;
constexpr std::size_t frequency_count = std::size(printed_frequencies);

double per_cent(double value, double reference) { return 100.0 * (value / reference - 1.0); }

double true_maximum(const data::Beam& beam, const data::HarmonicExcitation& excitation, int modes,
                    double duration) {
  return analytic::StickResponse(beam, excitation, modes)
      .max_abs_friction_force(duration, relative_width)
      .midpoint();
}

// All modes in continuous time. The bounds include the possible contribution of the omitted free vibrations.
analytic::Bounds problem_bounds(const data::Case& paper, double hz) {
  const analytic::StickResponse response(paper.beam(), printed_excitation(hz), all_modes,
                                         analytic::SteadyPart::exact);
  const analytic::Bounds kept = response.max_abs_friction_force(paper.numerics.duration(), relative_width);
  const double omitted = response.omitted_transient_bound();
  return {kept.lower - omitted, kept.upper + omitted};
}

// A row of the study and the function that computes its force at one excitation.
struct RowPlan {
  ForceRow row;
  std::size_t baseline;  // index of the row without a change
  std::function<double(const data::HarmonicExcitation&)> force;
};

class RowPlans {
 public:
  explicit RowPlans(const data::Case& paper) : paper_(paper) {
    add_closed_form();
    add_finite_elements();
  }

  [[nodiscard]] std::vector<ForceRow> evaluated() && {
    for (RowPlan& plan : plans_) plan.row.force.resize(frequency_count);
    in_parallel(plans_.size() * frequency_count, [this](std::size_t index) {
      RowPlan& plan = plans_[index / frequency_count];
      const std::size_t i = index % frequency_count;
      plan.row.force[i] = plan.force(printed_excitation(printed_frequencies[i]));
    });
    std::vector<ForceRow> rows;
    for (RowPlan& plan : plans_) {
      for (std::size_t i = 0; i < frequency_count; ++i)
        plan.row.change.push_back(per_cent(plan.row.force[i], plans_[plan.baseline].row.force[i]));
      rows.push_back(plan.row);
    }
    return rows;
  }

 private:
  void add(std::string factor, std::string setting,
           std::function<double(const data::HarmonicExcitation&)> force) {
    plans_.push_back(
        {{std::move(factor), std::move(setting), baseline_ == 0, {}, {}}, baseline_, std::move(force)});
  }

  void add_closed_form() {
    const data::Beam& beam = paper_.beam();
    const int modes = paper_.numerics.modes();
    const double duration = paper_.numerics.duration();
    add("closed form", fmt::format("N = {}, continuous time", modes),
        [=](const auto& excitation) { return true_maximum(beam, excitation, modes, duration); });
    for (const int n : {5, 8, 12, 20, 50})
      add("modes", fmt::format("{}", n),
          [=](const auto& excitation) { return true_maximum(beam, excitation, n, duration); });
    add("modes", "all", [this](const auto& excitation) {
      return problem_bounds(paper_, excitation.frequency_hz()).midpoint();
    });
    for (const double step : {1e-4, 1e-3, 5e-3})
      add("sampling step", fmt::format("{:g} s", step), [=](const auto& excitation) {
        return analytic::StickResponse(beam, excitation, modes)
            .sampled_max_abs_friction_force(duration, step)
            .lower;
      });
    for (const double axial_force : {0.0, 499.0, 501.0})
      add("axial force", fmt::format("{:g} N", axial_force), [=](const auto& excitation) {
        return true_maximum(with(beam, &data::BeamProperties::axial_force, axial_force), excitation, modes,
                            duration);
      });
    for (const double other : {5.0, 20.0})
      add("duration", fmt::format("{:g} s", other),
          [=](const auto& excitation) { return true_maximum(beam, excitation, modes, other); });
  }

  void add_finite_elements() {
    const data::NumericalChoices stated = paper_.numerics.choices();
    baseline_ = plans_.size();
    add_run("finite elements",
            fmt::format("{} elements, {:g} s, spectral radius {:g}", stated.elements, stated.time_step,
                        stated.spectral_radius),
            stated);
    for (const int elements : {10, 40, 80}) {
      data::NumericalChoices choices = stated;
      choices.elements = elements;
      add_run("elements", fmt::format("{}", elements), choices);
    }
    for (const double step : {4e-4, 2e-4, 5e-5}) {
      data::NumericalChoices choices = stated;
      choices.time_step = step;
      add_run("time step", fmt::format("{:g} s", step), choices);
    }
    for (const double radius : {0.5, 1.0}) {
      data::NumericalChoices choices = stated;
      choices.spectral_radius = radius;
      add_run("spectral radius", fmt::format("{:g}", radius), choices);
    }
  }

  void add_run(std::string factor, std::string setting, const data::NumericalChoices& choices) {
    const data::NumericalSettings numerics(choices);
    add(std::move(factor), std::move(setting), [this, numerics](const auto& excitation) {
      return solver::max_abs_friction_force(with(paper_, excitation, numerics));
    });
  }

  const data::Case& paper_;
  std::size_t baseline_ = 0;
  std::vector<RowPlan> plans_;
};

ForceRange force_range(const analytic::Bounds& force, const data::PrintedNumber& printed) {
  return {
      force, common_digits(force),
      force.lower <= printed.value + printed.half_digit && force.upper >= printed.value - printed.half_digit};
}

std::vector<ForceDigits> force_digits(const data::Case& paper) {
  std::vector<ForceDigits> digits;
  for (const double hz : printed_frequencies) {
    const data::PrintedNumber printed = printed_force(hz);
    const SampledForces sampled = sampled_forces(paper, hz);
    digits.push_back({hz, printed.value, printed.half_digit, force_range(sampled.range, printed),
                      sampled.printed_step, force_range(problem_bounds(paper, hz), printed)});
  }
  return digits;
}

// Largest |f| on a grid of times for N = 1 ... modes at once. The steady part with N modes and their free
// vibrations are each advanced by one complex multiplication per step.
std::vector<double> sampled_maxima(const data::Case& paper, double hz, int modes, double step) {
  using Complex = std::complex<double>;
  const data::HarmonicExcitation excitation = printed_excitation(hz);
  struct Phasor {
    Complex value, factor;  // the sinusoid is the imaginary part of value
  };
  const auto phasor = [step](double amplitude, double angular_frequency) {
    return Phasor{amplitude, std::polar(1.0, angular_frequency * step)};
  };
  std::vector<double> steady;
  std::vector<Phasor> free;
  for (int n = 1; n <= modes; ++n) {
    const analytic::StickResponse response(paper.beam(), excitation, n);
    steady.push_back(response.steady_force_amplitude());
    const analytic::Sinusoid last = response.transient_force().back();
    free.push_back(phasor(last.amplitude, last.angular_frequency));
  }
  Phasor forced = phasor(1.0, 2.0 * std::numbers::pi * hz);
  std::vector<double> largest(steady.size());
  for (long i = std::lround(paper.numerics.duration() / step); i >= 0; --i) {
    double vibrations = 0.0;
    for (std::size_t n = 0; n < steady.size(); ++n) {
      vibrations += free[n].value.imag();
      largest[n] = std::max(largest[n], std::abs(steady[n] * forced.value.imag() + vibrations));
      free[n].value *= free[n].factor;
    }
    forced.value *= forced.factor;
  }
  return largest;
}

SamplingSearch sampling_search(const data::Case& paper) {
  SamplingSearch search;
  search.most_modes = 30;
  search.sampling_steps = {1e-5, 2e-5,    2.5e-5, 5e-5,   1e-4, 2e-4, 2.5e-4, 5e-4,
                           1e-3, 1.25e-3, 2e-3,   2.5e-3, 4e-3, 5e-3, 1e-2};
  // Another usual choice is a number of points that is a power of ten, with both ends included.
  for (const double points : {1e3, 1e4, 1e5})
    search.sampling_steps.push_back(paper.numerics.duration() / (points - 1.0));
  const std::size_t steps = search.sampling_steps.size();
  std::vector<std::vector<double>> maxima(steps * frequency_count);
  in_parallel(maxima.size(), [&](std::size_t index) {
    maxima[index] = sampled_maxima(paper, printed_frequencies[index % frequency_count], search.most_modes,
                                   search.sampling_steps[index / frequency_count]);
  });
  const auto closer = [](const SamplingTrial& a, const SamplingTrial& b) {
    return b.force.empty() || a.largest_difference < b.largest_difference;
  };
  for (std::size_t k = 0; k < steps; ++k) {
    for (int modes = 1; modes <= search.most_modes; ++modes) {
      SamplingTrial trial{.modes = modes, .sampling_step = search.sampling_steps[k], .force = {}};
      for (std::size_t i = 0; i < frequency_count; ++i) {
        const data::PrintedNumber printed = printed_force(printed_frequencies[i]);
        trial.force.push_back(maxima[k * frequency_count + i][static_cast<std::size_t>(modes - 1)]);
        const double difference = std::abs(trial.force.back() - printed.value) / printed.half_digit;
        trial.largest_difference = largest_or_nan({trial.largest_difference, difference});
        if (difference <= 1.0) ++trial.returned;
      }
      if (trial.returned == static_cast<int>(frequency_count)) ++search.returning_all;
      if (closer(trial, search.closest)) search.closest = trial;
      if (trial.returned > search.most_returned.returned ||
          (trial.returned == search.most_returned.returned && closer(trial, search.most_returned)))
        search.most_returned = trial;
    }
  }
  return search;
}

}  // namespace

ForceSensitivity force_sensitivity(const data::Case& paper) {
  ForceSensitivity study;
  study.frequency_hz.assign(std::begin(printed_frequencies), std::end(printed_frequencies));
  study.rows = RowPlans(paper).evaluated();
  study.digits = force_digits(paper);
  study.search = sampling_search(paper);
  return study;
}

}  // namespace stickslip::studies
