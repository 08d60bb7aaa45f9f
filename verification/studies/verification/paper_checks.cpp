// SPDX-License-Identifier: MIT
#include "studies/verification/paper_checks.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "studies/analyses/criterion_answer.hpp"
#include "studies/analyses/length_force_map.hpp"
#include "studies/common/discretisation.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/verification/frequencies.hpp"

namespace stickslip::studies {

namespace {

PrintedCheck check_to_last_digit(const std::string& id, double computed, const std::string& method,
                                 const std::optional<analytic::Bounds>& left_open = std::nullopt) {
  const data::PrintedNumber printed = data::printed_number(id);
  return {printed, computed, method, printed.half_digit, "half a unit of the last digit", left_open};
}

// The frequencies of Fig. 6 that are not below `first`.
std::vector<double> figure6_frequencies_from(double first) {
  std::vector<double> frequencies = figure6_frequencies();
  std::erase_if(frequencies, [first](double hz) { return hz < first; });
  return frequencies;
}

// The frequency with the smallest critical amplitude, which has the largest |f_max|.
template <typename ForceMaximum>
double frequency_of_smallest_critical_amplitude(const std::vector<double>& frequencies,
                                                ForceMaximum&& force_maximum) {
  return *std::max_element(frequencies.begin(), frequencies.end(),
                           [&](double a, double b) { return force_maximum(a) < force_maximum(b); });
}

double closed_form_force(const data::Case& paper, double hz) {
  const data::HarmonicExcitation unit({.frequency_hz = hz, .amplitude = 1e-3});
  return analytic::StickResponse(paper.beam(), unit, paper.numerics.modes())
      .max_abs_friction_force(paper.numerics.duration(), 1e-6)
      .midpoint();
}

double finite_element_force(const data::Case& paper, double hz) {
  const data::HarmonicExcitation unit({.frequency_hz = hz, .amplitude = 1e-3});
  return solver::max_abs_friction_force(with(paper, unit));
}

double sampled_force(const data::Case& paper, double hz, std::optional<double> step = std::nullopt) {
  return analytic::StickResponse(paper.beam(), printed_excitation(hz), paper.numerics.modes())
      .sampled_max_abs_friction_force(paper.numerics.duration(), step.value_or(paper.numerics.time_step()))
      .lower;
}

// Sampled |f_max| of N modes for the initial condition u_t(x,0) = 0: Eq. (28) plus the free vibration with
// the initial velocity -S h_t(0), which cancels that of the quasi-static shape.
double force_from_rest(const data::Case& paper, double hz, int modes) {
  const data::HarmonicExcitation excitation = printed_excitation(hz);
  const analytic::StickResponse response(paper.beam(), excitation, modes);
  const double length = paper.beam().length();
  const double stiffness = paper.beam().youngs_modulus() * paper.beam().second_moment_of_area();
  const double base_velocity = two_pi * hz * excitation.amplitude();
  std::vector<analytic::Sinusoid> initial_vibrations;
  for (const analytic::StickMode& mode : response.modes()) {
    const double plain_integral = simpson_integral([&mode](double x) { return mode.shape(x); }, length, mode);
    const double shape_integral = mode.load_integral() - plain_integral;  // ∫ U S dx
    const double rate = -base_velocity * shape_integral / mode.norm_squared();
    initial_vibrations.push_back({stiffness * mode.third_derivative(length) * rate / mode.angular_frequency(),
                                  mode.angular_frequency()});
  }
  double largest = 0.0;
  const long steps = solver::step_count(paper.numerics.duration(), paper.numerics.time_step());
  for (long n = 0; n <= steps; ++n) {
    const double t = static_cast<double>(n) * paper.numerics.time_step();
    double force = response.friction_force(t);
    for (const analytic::Sinusoid& s : initial_vibrations)
      force += s.amplitude * std::sin(s.angular_frequency * t);
    largest = std::max(largest, std::abs(force));
  }
  return largest;
}

// The lowest dead load, in units of EI/L², at which K - P K_G with a free tip is singular.
double dead_load_buckling(const data::Beam& beam, int elements) {
  const solver::BeamModel model(beam, elements);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigenvalues(
      Eigen::MatrixXd(model.geometric_stiffness()), Eigen::MatrixXd(model.elastic_stiffness()),
      Eigen::EigenvaluesOnly);
  const double load = 1.0 / eigenvalues.eigenvalues().tail(1)[0];
  return load * beam.length() * beam.length() / (beam.youngs_modulus() * beam.second_moment_of_area());
}

// Richardson extrapolation of a frequency with errors of fourth order, from a mesh and one with half its
// element length.
double extrapolated_stick_hz(const data::Beam& beam, int mode, int elements) {
  const auto hz = [&](int n) {
    return solver::stick_modes(solver::BeamModel(beam, n), mode).back().angular_frequency / two_pi;
  };
  const double coarse = hz(elements), fine = hz(2 * elements);
  return fine + (fine - coarse) / 15.0;
}

void add_frequency_checks(const data::Case& paper, std::vector<PrintedCheck>& checks) {
  const auto add = [&](const std::string& id, const data::Beam& beam, int mode) {
    checks.push_back(check_to_last_digit(id, stick_hz(beam, mode), "closed form"));
  };
  for (int mode = 1; mode <= 3; ++mode) {
    const std::string id = fmt::format("frequency.stick.{}", mode);
    add(id, paper.beam(), mode);
    add(id + ".half_stiffness", half_stiff(paper.beam()), mode);
    if (mode < 3) add(id + ".figure7", paper.beam(), mode);
  }
}

void add_force_checks(const data::Case& paper, std::vector<PrintedCheck>& checks) {
  checks.push_back(check_to_last_digit("friction_limit", friction_limit(paper), "mu_s P"));
  for (const double hz : printed_frequencies)
    checks.push_back(check_to_last_digit(printed_force(hz).id, sampled_force(paper, hz),
                                         "closed form, N = 10, sampled", sampled_forces(paper, hz).range));
}

std::string figure14_length_id(int mode) { return fmt::format("figure14.length.{}", mode); }

// The length at which the natural frequency of a mode is 25 Hz.
double figure14_length(int mode, double axial_force) {
  const data::Beam section = data::load_case("paper-figure14").beam();
  return resonance_length(with(section, &data::BeamProperties::axial_force, axial_force), mode, 25.0).value();
}

void add_figure_checks(const data::Case& paper, std::vector<PrintedCheck>& checks) {
  const double printed_axial_force = data::printed_number("parameter.axial_force").value;
  for (int mode = 1; mode <= 2; ++mode)
    checks.push_back(check_to_last_digit(
        figure14_length_id(mode), figure14_length(mode, printed_axial_force), "closed form, P = 500 N",
        analytic::Bounds{figure14_length(mode, 1000.0), figure14_length(mode, 0.0)}));
  const auto force = [&](double hz) { return closed_form_force(paper, hz); };
  const auto add = [&](const std::string& id, double first) {
    const std::vector<double> frequencies = figure6_frequencies_from(first);
    checks.push_back({data::printed_number(id), frequency_of_smallest_critical_amplitude(frequencies, force),
                      fmt::format("closed form, N = 10, {} to {} Hz by 5 Hz", std::lround(first),
                                  std::lround(frequencies.back())),
                      0.0, "a frequency of the grid", std::nullopt});
  };
  add("figure6.minimum.frequency", 5.0);
  add("figure6.valley.frequency", 50.0);
}

void add_section_errata(const data::Case& paper, std::vector<ErratumEvidence>& evidence) {
  const double printed_inertia = data::printed_number("parameter.second_moment_of_area").value;
  const data::Beam as_printed =
      with(paper.beam(), &data::BeamProperties::second_moment_of_area, printed_inertia);
  for (int mode = 1; mode <= 2; ++mode) {
    const data::PrintedNumber printed = data::printed_number(fmt::format("frequency.stick.{}", mode));
    evidence.push_back({"E1", fmt::format("stick frequency {}", mode), "Hz", stick_hz(as_printed, mode),
                        stick_hz(paper.beam(), mode), printed.value, printed.half_digit});
  }
  const analytic::StickMode first = analytic::stick_modes(paper.beam(), 1).front();
  const double p =
      paper.beam().axial_force() / (paper.beam().youngs_modulus() * paper.beam().second_moment_of_area());
  const double k = std::pow(first.hyperbolic_wave_number() * first.trigonometric_wave_number(), 2);
  const double root = std::sqrt(0.25 * p * p + k);
  const auto residual = [&](double squared) { return (squared * squared - p * squared - k) / k; };
  evidence.push_back({"E2", "residual of cos(betabar x) in Eq. (1), mode 1", "1", residual(-0.5 * p - root),
                      residual(0.5 * p + root), 0.0, 1e-14});
  const data::PrintedNumber printed = data::printed_number("frequency.stick.1");
  evidence.push_back({"E3", "frequency of Eq. (24), mode 1", "Hz",
                      std::sqrt(first.angular_frequency()) / two_pi, first.frequency_hz(), printed.value,
                      printed.half_digit});
}

void add_force_errata(const data::Case& paper, std::vector<ErratumEvidence>& evidence) {
  const double printed = data::printed_number("force_max.15").value;
  for (const int modes : {10, 20})
    evidence.push_back({"E4", fmt::format("|f_max| at 15 Hz from u_t = 0, N = {}", modes), "N",
                        force_from_rest(paper, 15.0, modes), sampled_force(paper, 15.0), printed,
                        0.01 * printed});
  evidence.push_back({"E5", "stick frequency 3 (corrected: extrapolated from 16 and 32 elements)", "Hz",
                      data::printed_number("frequency.stick.3").value,
                      extrapolated_stick_hz(paper.beam(), 3, 16), stick_hz(paper.beam(), 3), 1e-3});
}

void add_figure_errata(const data::Case& paper, std::vector<ErratumEvidence>& evidence) {
  const FlutterStudy flutter = flutter_study(paper.beam(), {8, 16});
  evidence.push_back(
      {"E8",
       "critical load of the slip state over EI/L^2 (printed, read as a dead load; corrected: follower)", "1",
       dead_load_buckling(paper.beam(), 16), flutter.finite_element.back(), flutter.closed_form, 1e-3});
  for (int mode = 1; mode <= 2; ++mode) {
    const data::PrintedNumber printed = data::printed_number(figure14_length_id(mode));
    evidence.push_back({"E9", fmt::format("L{} (as printed: without P, corrected: P = 500 N)", mode), "m",
                        figure14_length(mode, 0.0), figure14_length(mode, 500.0), printed.value,
                        printed.half_digit});
  }
  const std::vector<double> upper = figure6_frequencies_from(50.0);
  evidence.push_back({"E10", "frequency of the valley in Fig. 6 (reference: finite elements)", "Hz",
                      data::printed_number("figure6.valley.frequency").value,
                      frequency_of_smallest_critical_amplitude(
                          upper, [&](double hz) { return closed_form_force(paper, hz); }),
                      frequency_of_smallest_critical_amplitude(
                          upper, [&](double hz) { return finite_element_force(paper, hz); }),
                      0.0});
}

void add_sign_and_scaling_errata(const data::Case& paper, std::vector<ErratumEvidence>& evidence) {
  const data::Case half = with(paper, half_stiff(paper.beam()));
  // Tolerance 1 %: the modes above the tenth contribute 0.3 % of f for either beam (E6), and the error of the
  // mesh is about as large.
  const double closed_form = closed_form_force(half, 15.0) / closed_form_force(paper, 15.0);
  const double finite_element = finite_element_force(half, 15.0) / finite_element_force(paper, 15.0);
  evidence.push_back({"E11",
                      "|f_max| at 15 Hz with half of E I over that with E I (reference: finite elements)",
                      "1", 0.5, closed_form, finite_element, 0.01 * finite_element});
  // Per metre of base displacement with the tip held: u = S h.
  const double shear = paper.beam().youngs_modulus() * paper.beam().second_moment_of_area() *
                       analytic::QuasiStaticShape(paper.beam()).third_derivative(paper.beam().length());
  const solver::BeamModel model(paper.beam(), paper.numerics.elements());
  const double row = -(model.slip_stiffness() * model.unit_tip_deflection())[model.tip_deflection()];
  evidence.push_back(
      {"E13", "force of Eq. (9), static, tip held (as printed: f of Eq. 28, reference: finite elements)",
       "N/m", shear, -shear, row, 1e-6 * std::abs(row)});
}

}  // namespace

data::ClaimVerdict verdict_on(double printed, const analytic::Bounds& found, double allowed) {
  const double below = printed - found.lower, above = found.upper - printed;
  if (std::max(below, above) <= allowed) return data::ClaimVerdict::holds;
  return std::min(below, above) >= -allowed ? data::ClaimVerdict::not_determined
                                            : data::ClaimVerdict::does_not_hold;
}

SampledForces sampled_forces(const data::Case& paper, double hz) {
  const data::PrintedNumber printed = printed_force(hz);
  const double any_time =
      analytic::StickResponse(paper.beam(), printed_excitation(hz), paper.numerics.modes())
          .max_abs_friction_force(paper.numerics.duration(), 1e-13)
          .midpoint();
  SampledForces forces{.range = {any_time, any_time}, .printed_step = {}};
  for (int multiple = 1; multiple <= 100; ++multiple) {
    const double step = multiple * 1e-4, force = sampled_force(paper, hz, step);
    forces.range.lower = std::min(forces.range.lower, force);
    if (!forces.printed_step && std::abs(force - printed.value) <= printed.half_digit)
      forces.printed_step = step;
  }
  return forces;
}

std::vector<PrintedCheck> printed_checks(const data::Case& paper) {
  std::vector<PrintedCheck> checks;
  add_frequency_checks(paper, checks);
  add_force_checks(paper, checks);
  add_figure_checks(paper, checks);
  return checks;
}

std::vector<ErratumEvidence> errata_evidence(const data::Case& paper) {
  std::vector<ErratumEvidence> evidence;
  add_section_errata(paper, evidence);
  add_force_errata(paper, evidence);
  add_figure_errata(paper, evidence);
  add_sign_and_scaling_errata(paper, evidence);
  return evidence;
}

}  // namespace stickslip::studies
