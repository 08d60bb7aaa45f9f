// SPDX-License-Identifier: MIT
#include "comparison/diagnosis/wrong_model_recipes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "stickslip/analytic/stick_modes.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::comparison {

namespace {

using data::with_value;
using studies::FrictionRule;
using studies::ModalScheme;
using studies::StickSum;
using enum Quantity;
using Quantities = std::vector<Quantity>;

const Quantities held_force{force_maximum, critical_amplitude, stick_force};
const Quantities held_motion{force_maximum, critical_amplitude, stick_force, stick_displacement};
const Quantities stick_slip{contact_event, tip_displacement, friction_force};

Quantities operator+(Quantities all, const Quantities& further) {
  all.insert(all.end(), further.begin(), further.end());
  return all;
}

const Quantities natural_frequencies{stick_frequency, slip_frequency};
const Quantities everything =
    natural_frequencies + Quantities{participation, quasi_static_shape} + held_motion + stick_slip;

double mass_per_length(const data::Beam& beam) { return beam.density() * beam.area(); }
double rigidity(const data::Beam& beam) { return beam.youngs_modulus() * beam.second_moment_of_area(); }

using Inputs = std::function<std::optional<data::Case>(const data::Case&)>;

// One number of the case times a factor.
Inputs with_multiple(std::string_view parameter, double factor) {
  return [=](const data::Case& problem) {
    return with_value(problem, parameter, factor * value_of(problem, parameter));
  };
}

// The time step times a factor, and another spectral radius, if one is given.
Inputs with_scheme(double factor, std::optional<double> spectral_radius = std::nullopt) {
  return [=](const data::Case& problem) {
    const data::NumericalSettings& given = problem.numerics;
    const double step = factor * given.time_step();
    return with_values(problem,
                       {{"numerics.spectral_radius", spectral_radius.value_or(given.spectral_radius())},
                        {"numerics.time_step", step},
                        {"excitation.duration", std::max(given.duration(), step)}});
  };
}

// C = eta K becomes eta omega_1^2 M, which damps the first stick mode alike.
void damp_the_mass(solver::ContactSystem& system, const solver::BeamModel& mesh) {
  const double eta = system.damping.norm() / mesh.elastic_stiffness().norm();
  const double omega = analytic::stick_modes(mesh.beam(), 1).front().angular_frequency();
  system.damping = eta * omega * omega * system.mass;
}

std::optional<data::Case> if_kelvin_voigt(const data::Case& problem) {
  return problem.damping.kelvin_voigt() > 0.0 ? std::optional(problem) : std::nullopt;
}

// A rectangle of width b and depth d has A = b d and I = b d^3/12. About the other axis d b^3/12 = A^4/(144
// I).
std::optional<data::Case> about_the_other_axis(const data::Case& problem) {
  const double area = problem.beam().area(), own = problem.beam().second_moment_of_area();
  const double other = std::pow(area, 4) / (144.0 * own);
  if (std::abs(other / own - 1.0) < 1e-9) return std::nullopt;
  return with_value(problem, "beam.second_moment_of_area", other);
}

// One coefficient of friction with the value of the other.
Inputs with_coefficient_of(std::string_view changed, std::string_view other) {
  return [=](const data::Case& problem) -> std::optional<data::Case> {
    if (problem.contact.friction.static_coefficient() == problem.contact.friction.kinetic_coefficient())
      return std::nullopt;
    return with_value(problem, changed, value_of(problem, other));
  };
}

// With the printed sign -P/(2EI) in both wave numbers: tan(beta L) = tanh(beta L), which gives the modes of P
// = 0, and k = beta^4 + p beta^2.
void use_one_wave_number(StickSum& sum, const data::Case& problem) {
  const data::Beam& beam = problem.beam();
  const double p = beam.axial_force() / rigidity(beam);
  const data::Case unloaded = with_value(problem, "beam.axial_force", 0.0);
  const int count = static_cast<int>(sum.modes.size());
  sum.modes = studies::stick_sum(unloaded.beam(), count).modes;
  for (StickSum::Mode& mode : sum.modes) {
    const double beta_squared = mode.natural_frequency * std::sqrt(mass_per_length(beam) / rigidity(beam));
    mode.natural_frequency *= std::sqrt(1.0 + p / beta_squared);
    mode.oscillator_frequency = mode.natural_frequency;
  }
}

void keep_the_modes_of_the_case(StickSum& sum, const data::Case& problem) {
  sum.modes.resize(static_cast<std::size_t>(problem.numerics.modes()));
}

void let_the_wall_move_with_the_base(StickSum& sum) {
  sum.force = 0.0;
  sum.displacement = 1.0;
  for (StickSum::Mode& mode : sum.modes) mode.participation = mode.rigid_participation;
}

// Lumped masses after Hinton, Rock and Zienkiewicz: m l (1/2, l^2/78) at each end. The load is that of these
// masses.
void lump_the_mass(solver::ContactSystem& system, const solver::BeamModel& mesh) {
  const double length = mesh.beam().length() / mesh.elements();
  const double mass = mass_per_length(mesh.beam()) * length;
  Eigen::VectorXd lumped(mesh.degrees_of_freedom());
  for (Eigen::Index i = 0; i < lumped.size(); i += 2) {
    const double elements_there = i == mesh.tip_deflection() ? 1.0 : 2.0;
    lumped[i] = elements_there * mass / 2.0;
    lumped[i + 1] = elements_there * mass * length * length / 78.0;
    system.load_shape[i] = -lumped[i];
    system.load_shape[i + 1] = 0.0;
  }
  system.mass = solver::SparseMatrix(Eigen::MatrixXd(lumped.asDiagonal()).sparseView());
}

// EI u''' of the cubic interpolation in the last element.
Eigen::RowVectorXd shear_of_the_last_element(const solver::BeamModel& mesh) {
  const double l = mesh.beam().length() / mesh.elements();
  const Eigen::RowVector4d third_derivative(12.0, 6.0 * l, -12.0, 6.0 * l);
  Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(mesh.degrees_of_freedom());
  const Eigen::Index size = std::min<Eigen::Index>(4, row.size());
  row.tail(size) = rigidity(mesh.beam()) / (l * l * l) * third_derivative.tail(size);
  return row;
}

ModalScheme scheme_of(const solver::GeneralizedAlpha& method, double step) {
  return {.step = step,
          .alpha_m = method.alpha_m(),
          .alpha_f = method.alpha_f(),
          .beta = method.beta(),
          .gamma = method.gamma(),
          .load_delay = method.load_time(0.0, step)};
}

ModalScheme scheme_of_case(const data::Case& problem) {
  return scheme_of(solver::GeneralizedAlpha(problem.numerics.spectral_radius()),
                   problem.numerics.time_step());
}

// Only alpha_f is changed. With alpha_m as the weight of the new state, too, the motion would grow by the
// factor alpha_m/(1 - alpha_m) > 1 in each step, for any step size.
ModalScheme with_alpha_f_of_the_new_state(const data::Case& problem) {
  ModalScheme scheme = scheme_of_case(problem);
  scheme.alpha_f = 1.0 - scheme.alpha_f;
  scheme.load_delay = scheme.step - scheme.load_delay;
  return scheme;
}

ModalScheme with_alphas_interchanged(const data::Case& problem) {
  ModalScheme scheme = scheme_of_case(problem);
  std::swap(scheme.alpha_m, scheme.alpha_f);
  scheme.load_delay = (1.0 - scheme.alpha_f) * scheme.step;
  return scheme;
}

ModalScheme with_the_load_at_the_end(const data::Case& problem) {
  ModalScheme scheme = scheme_of_case(problem);
  scheme.load_delay = scheme.step;
  return scheme;
}

constexpr double added_damping = 0.01;  // fraction of critical damping

ModalScheme with_damping_added(const data::Case& problem) {
  ModalScheme scheme = scheme_of(solver::GeneralizedAlpha(1.0), problem.numerics.time_step());
  scheme.damping_ratio = added_damping;
  return scheme;
}

double sign(double v) { return v < 0.0 ? -1.0 : 1.0; }

// mu_m + (mu_s - mu_m) exp(-alpha v) + beta |v|, the law itself for v >= 0.
double coefficient_at(const data::FrictionLaw& friction, double v) {
  const data::FrictionLaw law = friction.in_slip();
  const double kinetic = law.kinetic_coefficient();
  return kinetic + (law.static_coefficient() - kinetic) * std::exp(-law.decay() * v) +
         law.viscous() * std::abs(v);
}

void take_the_relative_displacement(const data::Case& problem, Quantity quantity,
                                    const std::vector<double>& abscissa, std::vector<double>& values) {
  const bool is_displacement =
      quantity == stick_displacement || quantity == tip_displacement || quantity == midspan_displacement;
  const bool is_velocity =
      quantity == stick_velocity || quantity == tip_velocity || quantity == midspan_velocity;
  if (!is_displacement && !is_velocity) return;
  const solver::PrescribedMotion base = solver::base_motion(problem.motion);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] -= (is_velocity ? base.velocity : base.displacement)(abscissa[i]);
}

solver::PrescribedMotion cosine_motion(const data::Case& problem) {
  const auto later =
      [period = 1.0 / problem.excitation().frequency_hz()](const std::function<double(double)>& sine) {
        return [sine, period](double t) { return sine(t + 0.25 * period); };
      };
  const solver::PrescribedMotion sine = solver::base_motion(problem.motion);
  return {later(sine.displacement), later(sine.velocity), later(sine.acceleration)};
}

void change_the_sign_of_forces(const data::Case&, Quantity quantity, const std::vector<double>&,
                               std::vector<double>& values) {
  if (quantity != stick_force && quantity != friction_force) return;
  for (double& value : values) value = -value;
}

// The truncation error of the displacement decreases as n^-5 or faster, that of the force as n^-2.
WrongModelRecipe with_modes(const std::string& name, const std::string& count, std::size_t modes) {
  Quantities changes = held_force;
  if (modes < 3) changes.push_back(stick_displacement);
  return {.wrong_model = {name, "the sum over " + count + " only", "Eq. (21)", changes},
          .equations = [modes](StickSum& sum, const data::Case&) { sum.modes.resize(modes); },
          .knows_stick_slip = false};
}

WrongModelRecipe with_mesh_of(const std::string& name, const std::string& count, int elements) {
  const auto meshed = [elements](const data::Case& problem) {
    return with_value(problem, "numerics.elements", elements);
  };
  return {.wrong_model = {name, "a mesh of " + count + " elements", "Sect. 2",
                          natural_frequencies + held_motion + stick_slip},
          .inputs = meshed,
          .mesh = [](solver::ContactSystem&, const solver::BeamModel&) {},
          .depends_on_mesh = true};
}

using Recipes = std::vector<WrongModelRecipe>;

// The section and the axial force.
Recipes beam_mistakes() {
  return {
      {.wrong_model = {"second-moment-as-printed", "I is the printed value, 1/100 of the correct one (E1)",
                       "Sect. 3, parameters", everything},
       .inputs = with_multiple("beam.second_moment_of_area", 0.01)},
      {.wrong_model = {"second-moment-of-other-axis", "I is taken about the other axis of the rectangle",
                       "Sect. 3, parameters", everything},
       .inputs = about_the_other_axis},
      {.wrong_model = {"stiffness-doubled", "EI is twice the right one", "Sect. 3, parameters", everything},
       .inputs = with_multiple("beam.youngs_modulus", 2.0)},
      {.wrong_model = {"stiffness-halved", "EI is half the right one", "Sect. 3, parameters", everything},
       .inputs = with_multiple("beam.youngs_modulus", 0.5)},
      {.wrong_model = {"tension", "P is tensile instead of compressive", "Eq. (1)", everything},
       .inputs = with_multiple("beam.axial_force", -1.0)},
      {.wrong_model = {"axial-force-left-out", "P presses the tip to the wall but does not bend the beam",
                       "Eq. (1)", everything},
       .inputs = [](const data::Case& problem) { return with_value(problem, "beam.axial_force", 0.0); }},
      {.wrong_model = {"one-wave-number", "both wave numbers have the printed sign of P/(2EI) (E2)",
                       "Eq. (23)", Quantities{stick_frequency, participation} + held_motion},
       .equations = use_one_wave_number,
       .knows_stick_slip = false},
      {.wrong_model = {"dead-load", "P keeps its direction instead of following the tip", "Eq. (9)",
                       Quantities{slip_frequency} + held_force + stick_slip},
       .inputs = [](const data::Case& problem) -> std::optional<data::Case> {
         if (problem.beam().axial_direction() == 1.0) return std::nullopt;
         return with_value(problem, "beam.axial_direction", 1.0);
       }},
      {.wrong_model = {"follower-term-sign", "the term P u'(L) at the tip has the wrong sign", "Eq. (9)",
                       Quantities{slip_frequency} + held_force + stick_slip},
       .mesh =
           [](solver::ContactSystem& system, const solver::BeamModel& mesh) {
             system.slip_stiffness = 2.0 * mesh.stick_stiffness() - mesh.slip_stiffness();
           }},
  };
}

// The friction force and the place where the tip is held.
Recipes contact_force_mistakes() {
  return {
      {.wrong_model = {"reaction-without-follower-term",
                       "f is the reaction of the support, EI u''' + P u', instead of EI u'''", "Eq. (4)",
                       held_force},
       .equations =
           [](StickSum& sum, const data::Case&) {
             sum.force += sum.follower_force;
             for (StickSum::Mode& mode : sum.modes) mode.force += mode.follower_force;
           },
       .knows_stick_slip = false},
      {.wrong_model = {"force-from-shape-functions",
                       "f is EI u''' of the cubic in the last element, not taken from the balance", "Eq. (4)",
                       held_force},
       .force_row = shear_of_the_last_element,
       .knows_stick_slip = false},
      {.wrong_model = {"force-sign",
                       "f is the force on the beam and has the opposite sign",
                       "Eq. (28)",
                       {stick_force, friction_force}},
       .reading = change_the_sign_of_forces},
      {.wrong_model = {"relative-displacement",
                       "u is reported instead of y = h + u",
                       "Fig. 1",
                       {stick_displacement, tip_displacement}},
       .reading = take_the_relative_displacement,
       .is_relative = true},
      {.wrong_model = {"wall-moves-with-base", "the tip sticks to the base: v_s is u_t instead of y_t",
                       "Eq. (3)", Quantities{participation} + held_motion + stick_slip},
       .equations = [](StickSum& sum, const data::Case&) { let_the_wall_move_with_the_base(sum); },
       .mesh = [](solver::ContactSystem& system, const solver::BeamModel&) { system.wall = {}; }},
      {.wrong_model = {"tip-clamped-in-stick", "the wall also prevents the rotation of the tip", "Eq. (3)",
                       Quantities{stick_frequency} + held_motion},
       .mesh =
           [](solver::ContactSystem& system, const solver::BeamModel& mesh) {
             const double clamp = 1e8 * rigidity(mesh.beam()) / mesh.beam().length();
             system.stick_stiffness.coeffRef(mesh.tip_rotation(), mesh.tip_rotation()) += clamp;
           },
       .knows_stick_slip = false},
  };
}

// The load by the moving base.
Recipes excitation_mistakes() {
  return {
      {.wrong_model = {"base-load-sign", "the load is +rho A h_tt", "Eq. (1)",
                       Quantities{participation} + held_motion + stick_slip},
       .equations =
           [](StickSum& sum, const data::Case&) {
             for (StickSum::Mode& mode : sum.modes) mode.participation -= 2.0 * mode.rigid_participation;
           },
       .mesh = [](solver::ContactSystem& system,
                  const solver::BeamModel&) { system.load_shape = -system.load_shape; }},
      {.wrong_model = {"base-load-left-out", "the base moves the end of the beam without an inertia load",
                       "Eq. (1)", Quantities{participation} + held_motion + stick_slip},
       .equations =
           [](StickSum& sum, const data::Case&) {
             for (StickSum::Mode& mode : sum.modes) mode.participation -= mode.rigid_participation;
           },
       .mesh = [](solver::ContactSystem& system, const solver::BeamModel&) { system.load_shape.setZero(); }},
      {.wrong_model = {"hertz-as-radians", "the excitation frequency in Hz is used as if in rad/s",
                       "Sect. 3, excitation", held_motion + stick_slip},
       .inputs =
           [](const data::Case& problem) {
             return with_value(problem, "excitation.frequency_hz",
                               problem.excitation().frequency_hz() / (2.0 * std::numbers::pi));
           }},
      {.wrong_model = {"cosine-for-sine", "the base moves by A0 cos(Omega t), a quarter of a period earlier",
                       "Sect. 3, excitation", held_motion + stick_slip},
       .equations = [](StickSum& sum, const data::Case&) { sum.cosine = true; },
       .base = cosine_motion},
      {.wrong_model = {"peak-to-peak-amplitude", "the amplitude is used as the peak-to-peak travel",
                       "Sect. 3, excitation", held_motion + stick_slip},
       .inputs = with_multiple("excitation.amplitude", 0.5)},
  };
}

// The modal equations and the sum over the modes.
Recipes modal_equation_mistakes() {
  return {
      {.wrong_model = {"frequency-for-its-square", "omega_n T_n in the modal equation, as printed (E3)",
                       "Eq. (24)", held_motion},
       .equations =
           [](StickSum& sum, const data::Case&) {
             for (StickSum::Mode& mode : sum.modes)
               mode.oscillator_frequency = std::sqrt(mode.natural_frequency);
           },
       .knows_stick_slip = false},
      {.wrong_model = {"participation-without-shape", "C_n is computed with 1 instead of 1 + S", "Eq. (25)",
                       Quantities{participation} + held_motion},
       .equations =
           [](StickSum& sum, const data::Case&) {
             for (StickSum::Mode& mode : sum.modes) mode.participation = mode.rigid_participation;
           },
       .knows_stick_slip = false},
      {.wrong_model = {"quasi-static-part-left-out", "the sum over the modes without S h(t)",
                       "Eqs. (12), (27)", held_motion},
       .equations = [](StickSum& sum, const data::Case&) { sum.force = 0.0, sum.displacement = 1.0; },
       .knows_stick_slip = false},
  };
}

// The initial conditions, the steady part and the time over which the largest force is searched.
Recipes response_mistakes() {
  return {
      {.wrong_model = {"zero-initial-velocity", "u_t(x,0) = 0 instead of S(x) h_t(0) (E4)",
                       "Sect. 3, initial conditions", held_motion + stick_slip},
       .equations =
           [](StickSum& sum, const data::Case& problem) {
             keep_the_modes_of_the_case(sum, problem);
             for (StickSum::Mode& mode : sum.modes)
               mode.initial_rate = mode.participation - mode.rigid_participation;
           },
       .start = studies::Start::with_the_base},
      {.wrong_model = {"start-from-rest", "y_t(x,0) = 0, with the whole beam at rest while the base moves",
                       "Sect. 3, initial conditions", held_motion + stick_slip},
       .equations =
           [](StickSum& sum, const data::Case& problem) {
             keep_the_modes_of_the_case(sum, problem);
             for (StickSum::Mode& mode : sum.modes) mode.initial_rate = mode.participation;
           },
       .start = studies::Start::at_rest},
      with_modes("one-mode", "one mode", 1),
      with_modes("two-modes", "two modes", 2),
      with_modes("three-modes", "three modes", 3),
      with_modes("five-modes", "five modes", 5),
      {.wrong_model = {"steady-state-only", "the free vibrations from the start are left out", "Eq. (26)",
                       held_motion},
       .equations = [](StickSum& sum, const data::Case&) { sum.free_vibrations = false; },
       .knows_stick_slip = false},
      {.wrong_model = {"one-period-maximum",
                       "|f_max| is searched in the first period of the excitation only",
                       "Sect. 5",
                       {force_maximum, critical_amplitude}},
       .observed_for = [](const data::Case& problem) { return 1.0 / problem.excitation().frequency_hz(); }},
      with_mesh_of("two-elements", "two", 2),
      with_mesh_of("four-elements", "four", 4),
  };
}

// The mesh and the time steps.
Recipes discretisation_mistakes() {
  return {
      {.wrong_model = {"lumped-mass", "masses are lumped at the nodes", "Eq. (8)",
                       natural_frequencies + held_motion + stick_slip},
       .mesh = lump_the_mass,
       .depends_on_mesh = true},
      {.wrong_model = {"load-without-moments", "the load on the mesh has forces but no moments", "Eq. (8)",
                       held_motion + stick_slip},
       .mesh = [](solver::ContactSystem& system,
                  const solver::BeamModel& mesh) { system.load_shape[mesh.tip_rotation()] = 0.0; },
       .depends_on_mesh = true},
      {.wrong_model = {"alpha-convention-swapped",
                       "alpha_f is the weight of the new state instead of the old one, so the motion grows",
                       "Sect. 3, [24]", held_motion},
       .equations = keep_the_modes_of_the_case,
       .scheme = with_alpha_f_of_the_new_state,
       .knows_stick_slip = false},
      {.wrong_model = {"alphas-interchanged", "alpha_m and alpha_f are interchanged", "Sect. 3, [24]",
                       held_motion},
       .scheme = with_alphas_interchanged,
       .knows_stick_slip = false},
      {.wrong_model = {"load-at-end-of-step", "the load is taken at the end of the step", "Sect. 3, [24]",
                       held_motion},
       .scheme = with_the_load_at_the_end,
       .knows_stick_slip = false},
      {.wrong_model = {"time-step-of-the-case",
                       "the time step of the case, with which the free vibrations come late", "Sect. 3, [24]",
                       held_motion},
       .scheme = scheme_of_case,
       .knows_stick_slip = false},
      {.wrong_model = {"ten-times-the-step", "the time step is ten times that of the case", "Sect. 3, [24]",
                       held_motion},
       .inputs = with_scheme(10.0),
       .scheme = scheme_of_case,
       .knows_stick_slip = false},
      {.wrong_model = {"spectral-radius-zero", "spectral radius 0 with the time step of the case",
                       "Sect. 3, [24]", held_motion + stick_slip},
       .inputs = with_scheme(1.0, 0.0),
       .scheme = scheme_of_case},
      {.wrong_model = {"strong-algorithmic-damping", "spectral radius 0 with ten times the step",
                       "Sect. 3, [24]", held_motion},
       .inputs = with_scheme(10.0, 0.0),
       .scheme = scheme_of_case,
       .knows_stick_slip = false},
  };
}

Recipes damping_mistakes() {
  return {
      {.wrong_model = {"damping-added", "1 % of critical damping that the problem does not have", "Eq. (1)",
                       held_motion + stick_slip},
       .inputs = [](const data::Case& problem) -> std::optional<data::Case> {
         if (problem.damping.ratio() > 0.0) return std::nullopt;
         return with_value(problem, "damping.ratio", added_damping);
       },
       .scheme = with_damping_added},
      {.wrong_model = {"damping-left-out", "the damping of the problem is left out", "Eq. (1)", stick_slip},
       .inputs = [](const data::Case& problem) -> std::optional<data::Case> {
         if (problem.damping.is_none()) return std::nullopt;
         return with(problem, data::Damping());
       }},
      {.wrong_model =
           {"structural-damping",
            "the loss in a period does not depend on the frequency, and is right in the first mode",
            "Eq. (1)",
            {heat}},
       .inputs = if_kelvin_voigt,
       .is_structural = true,
       .knows_stick_slip = false},
      {.wrong_model = {"mass-proportional-damping",
                       "damping goes with the mass, with the right ratio in the first mode", "Eq. (1)",
                       stick_slip},
       .inputs = if_kelvin_voigt,
       .mesh = damp_the_mass},
      {.wrong_model = {"same-damping-ratio", "all modes have the damping ratio of the first", "Eq. (1)",
                       stick_slip},
       .inputs = [](const data::Case& problem) -> std::optional<data::Case> {
         if (problem.damping.kelvin_voigt() == 0.0) return std::nullopt;
         const double omega = analytic::stick_modes(problem.beam(), 1).front().angular_frequency();
         return with(problem, data::Damping({.ratio = 0.5 * problem.damping.kelvin_voigt() * omega}));
       }},
  };
}

// The law times tanh(v_s/width), width in m/s.
WrongModelRecipe smoothed_over(WrongModel wrong_model, double width) {
  return {.wrong_model = std::move(wrong_model),
          .law = FrictionRule{[width](const data::FrictionLaw& law, double v) {
                                return coefficient_at(law, std::abs(v)) * std::tanh(v / width);
                              },
                              false}};
}

Recipes friction_law_mistakes() {
  return {
      {.wrong_model = {"kinetic-coefficient-as-limit", "mu_m limits the static friction force", "Eq. (4)",
                       Quantities{critical_amplitude} + stick_slip},
       .inputs = with_coefficient_of("friction.static_coefficient", "friction.kinetic_coefficient")},
      {.wrong_model = {"one-friction-coefficient", "friction does not fall with the sliding velocity",
                       "Eq. (7)", stick_slip},
       .inputs = with_coefficient_of("friction.kinetic_coefficient", "friction.static_coefficient")},
      {.wrong_model = {"kinetic-friction-at-once", "friction falls to mu_m P with the first slip", "Eq. (7)",
                       stick_slip},
       .law = FrictionRule{[](const data::FrictionLaw& law, double v) {
         return sign(v) * (law.kinetic_coefficient() + law.viscous() * std::abs(v));
       }}},
      {.wrong_model = {"velocity-in-millimetres", "the sliding velocity enters the friction law in mm/s",
                       "Eq. (7)", stick_slip},
       .law = FrictionRule{[](const data::FrictionLaw& law, double v) {
         return sign(v) * coefficient_at(law, 1e3 * std::abs(v));
       }}},
      {.wrong_model = {"decay-without-magnitude", "exp(-alpha v) instead of exp(-alpha |v|)", "Eq. (7)",
                       stick_slip},
       .law = FrictionRule{[](const data::FrictionLaw& law, double v) {
         return sign(v) * coefficient_at(law, v);
       }}},
      smoothed_over(
          {"regularised-friction",
           "the jump at v_s = 0 is smoothed over 10 mm/s, so that the tip creeps instead of sticking",
           "Eq. (6)", stick_slip},
          0.01),
      smoothed_over(
          {"widely-regularised-friction",
           "the jump at v_s = 0 is smoothed over 100 mm/s, so that the tip creeps instead of sticking",
           "Eq. (6)", stick_slip},
          0.1),
  };
}

Recipes all_recipes() {
  Recipes all;
  for (const Recipes& group :
       {beam_mistakes(), contact_force_mistakes(), excitation_mistakes(), modal_equation_mistakes(),
        response_mistakes(), discretisation_mistakes(), damping_mistakes(), friction_law_mistakes()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

}  // namespace

const std::vector<WrongModelRecipe>& wrong_model_recipes() {
  static const std::vector<WrongModelRecipe> models = all_recipes();
  return models;
}

const WrongModelRecipe& recipe_of(std::string_view wrong_model) {
  for (const WrongModelRecipe& model : wrong_model_recipes())
    if (model.wrong_model.name == wrong_model) return model;
  throw std::invalid_argument(fmt::format("there is no wrong model {}", wrong_model));
}

}  // namespace stickslip::comparison
