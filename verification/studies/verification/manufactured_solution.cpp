// SPDX-License-Identifier: MIT
#include "studies/verification/manufactured_solution.hpp"

#include <gsl/gsl_integration.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <limits>
#include <memory>
#include <numbers>

#include "stickslip/solver/beam_element.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "studies/common/discretisation.hpp"

namespace stickslip::studies {

namespace {

using Complex = std::complex<double>;
using solver::ElementVector;

constexpr double wave_amplitude = 1e-4;  // A, m
constexpr double shape_a = 1.3, shape_b = 0.7;
constexpr double frequency_factor = 7.5;    // of ω and λ, in √(EI/ρ A)/L²
constexpr double kelvin_voigt = 6.4e-5;     // η with friction, s
constexpr double friction_decay = 1.0;      // α, s/m
constexpr double static_coefficient = 0.6;  // μ_s; μ_m = 0
constexpr double slowest_sliding = 0.5;     // v_s at t = 0, m/s
constexpr double far_wall_speed = 1e3;      // m/s, faster than the tip
constexpr double space_spectral_radius = 0.9;

// Re(sum weight exp(exponent x)) and its derivatives.
struct ExponentialSum {
  struct Term {
    Complex weight, exponent;
  };
  std::vector<Term> terms;

  [[nodiscard]] Complex complex_derivative(int order, double x) const {
    Complex sum = 0.0;
    for (const auto& [weight, exponent] : terms)
      sum += weight * std::pow(exponent, order) * std::exp(exponent * x);
    return sum;
  }
  [[nodiscard]] double operator()(int order, double x) const { return complex_derivative(order, x).real(); }
};

// One manufactured problem: the beam, the prescribed motion, and the load and tip forces that it requires.
struct Problem {
  ManufacturedTip tip;
  data::Beam beam;
  double length, mass_per_length, rigidity, axial_force;
  double rate;  // ω or λ, 1/s
  double eta;   // s
  ExponentialSum phi;

  [[nodiscard]] bool decays() const { return tip == ManufacturedTip::friction; }
  // The derivative of g(t) of the given order.
  [[nodiscard]] double history(int order, double t) const {
    if (decays()) return std::pow(-rate, order) * std::exp(-rate * t);
    return std::pow(rate, order) * std::cos(rate * t + order * std::numbers::pi / 2.0);
  }
  // s = g_tt/g, 1/s².
  [[nodiscard]] double history_ratio() const { return decays() ? rate * rate : -rate * rate; }
  // D (1 + η d/dt) for this time function, N m².
  [[nodiscard]] double effective_rigidity() const { return rigidity * (1.0 - (decays() ? eta * rate : 0.0)); }
  [[nodiscard]] double duration() const { return (decays() ? 1.0 : std::numbers::pi) / rate; }

  [[nodiscard]] double load(double x) const {
    return effective_rigidity() * phi(4, x) + axial_force * phi(2, x) +
           mass_per_length * history_ratio() * phi(0, x);
  }
  // Force (N) and moment (N m) on the tip of the beam at g = 1.
  [[nodiscard]] double tip_force() const { return -effective_rigidity() * phi(3, length); }
  [[nodiscard]] double tip_moment() const { return effective_rigidity() * phi(2, length); }
};

Problem manufactured_problem(const data::Beam& beam, ManufacturedTip tip, double load_factor) {
  const double length = beam.length();
  const double rigidity = beam.youngs_modulus() * beam.second_moment_of_area();
  const double mass_per_length = beam.density() * beam.area();
  data::BeamProperties properties = beam.properties();
  properties.axial_force = load_factor * rigidity / (length * length);
  const Complex slow = shape_b / length, fast = Complex(shape_b, 2.0 * shape_a) / length;
  return {.tip = tip,
          .beam = data::Beam(properties),
          .length = length,
          .mass_per_length = mass_per_length,
          .rigidity = rigidity,
          .axial_force = properties.axial_force,
          .rate = frequency_factor * std::sqrt(rigidity / mass_per_length) / (length * length),
          .eta = tip == ManufacturedTip::friction ? kelvin_voigt : 0.0,
          .phi = {{{0.5 * wave_amplitude, slow}, {-0.5 * wave_amplitude, fast}}}};
}

// E of the header: a particular solution for each term of φ, plus four homogeneous solutions whose weights
// satisfy the boundary conditions.
ExponentialSum leading_nodal_error(const Problem& problem) {
  const double rigidity = problem.effective_rigidity(), force = problem.axial_force, length = problem.length;
  const double inertia = problem.mass_per_length * problem.history_ratio();
  ExponentialSum shape;
  for (const auto& [weight, r] : problem.phi.terms) {
    const Complex r2 = r * r, mean = weight * r2 * r2;
    shape.terms.push_back({mean * (force * r2 + inertia) / (rigidity * r2 * r2 + force * r2 + inertia), r});
  }
  std::array<Complex, 4> roots;
  const Complex discriminant = std::sqrt(Complex(force * force - 4.0 * rigidity * inertia));
  for (int i = 0; i < 2; ++i) {
    const auto at = static_cast<std::size_t>(2 * i);
    roots[at] = std::sqrt((-force + (i == 0 ? 1.0 : -1.0) * discriminant) / (2.0 * rigidity));
    roots[at + 1] = -roots[at];
  }
  const bool held = problem.tip == ManufacturedTip::stick;
  const auto load = [&](int order) {
    return force / rigidity * problem.phi.complex_derivative(order, length);
  };
  struct Condition {
    int order;
    double x;
    Complex value;
  };
  const std::array<Condition, 4> conditions{{{0, 0.0, 0.0},
                                             {1, 0.0, 0.0},
                                             {2, length, load(4)},
                                             {held ? 0 : 3, length, held ? Complex(0.0) : load(5)}}};
  Eigen::Matrix4cd matrix;
  Eigen::Vector4cd missing;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [order, x, value] = conditions[i];
    const auto row = static_cast<Eigen::Index>(i);
    for (std::size_t j = 0; j < 4; ++j)
      matrix(row, static_cast<Eigen::Index>(j)) = std::pow(roots[j], order) * std::exp(roots[j] * x);
    missing[row] = value - shape.complex_derivative(order, x);
  }
  const Eigen::Vector4cd weights = matrix.partialPivLu().solve(missing);
  for (std::size_t j = 0; j < 4; ++j)
    shape.terms.push_back({weights[static_cast<Eigen::Index>(j)], roots[j]});
  return shape;
}

// Eight-point Gauss rule on each of `intervals` equal parts of [0, length], exact for polynomials up to
// degree 15.
template <class Function>
double integral(double length, int intervals, const Function& function) {
  const std::unique_ptr<gsl_integration_glfixed_table, decltype(&gsl_integration_glfixed_table_free)> table(
      gsl_integration_glfixed_table_alloc(8), &gsl_integration_glfixed_table_free);
  double sum = 0.0;
  for (int interval = 0; interval < intervals; ++interval)
    for (std::size_t i = 0; i < table->n; ++i) {
      double s = 0.0, weight = 0.0;
      gsl_integration_glfixed_point(0.0, 1.0, i, &s, &weight, table.get());
      sum += weight * length / intervals * function(interval, s);
    }
  return sum;
}

constexpr int smooth_intervals = 16;  // for integrals of φ and E

// N, N' or N'' at s. The derivatives are written here and not taken from the solver.
ElementVector shape_functions(int order, double s, double l) {
  if (order == 0) return solver::shape_functions(s, l);
  if (order == 1)
    return ElementVector(6.0 * s * s - 6.0 * s, l * (1.0 - 4.0 * s + 3.0 * s * s), 6.0 * s - 6.0 * s * s,
                         l * (3.0 * s * s - 2.0 * s)) /
           l;
  return ElementVector(12.0 * s - 6.0, l * (6.0 * s - 4.0), 6.0 - 12.0 * s, l * (6.0 * s - 2.0)) / (l * l);
}

// The four degrees of freedom of an element; those at the clamp are zero.
ElementVector element_values(const Eigen::VectorXd& q, int element) {
  ElementVector values = ElementVector::Zero();
  if (element == 0) {
    values.tail<2>() = q.head<2>();
  } else {
    values = q.segment<4>(2 * (Eigen::Index{element} - 1));
  }
  return values;
}

Eigen::VectorXd nodal_values(const ExponentialSum& shape, const solver::BeamModel& model) {
  Eigen::VectorXd values(model.degrees_of_freedom());
  for (Eigen::Index node = 1; node <= model.elements(); ++node) {
    const double x = model.beam().length() * static_cast<double>(node) / model.elements();
    values[2 * node - 2] = shape(0, x);
    values[2 * node - 1] = shape(1, x);
  }
  return values;
}

// ∫ N q dx, plus the moment at the tip and, in slip, the force at the tip.
Eigen::VectorXd implied_load(const Problem& problem, const solver::BeamModel& model) {
  const int elements = model.elements();
  const double l = problem.length / elements;
  Eigen::VectorXd load(model.degrees_of_freedom());
  for (Eigen::Index row = 0; row < load.size(); ++row) {
    const Eigen::VectorXd unit = Eigen::VectorXd::Unit(load.size(), row);
    load[row] = integral(problem.length, elements, [&](int element, double s) {
      return element_values(unit, element).dot(shape_functions(0, s, l)) * problem.load(l * (element + s));
    });
  }
  load[model.tip_rotation()] += problem.tip_moment();
  if (problem.tip == ManufacturedTip::slip) load[model.tip_deflection()] += problem.tip_force();
  return load;
}

// The L2 norm of u_h - φ g or of one of its derivatives.
double difference(const Problem& problem, const solver::BeamModel& model, const Eigen::VectorXd& q, double g,
                  int order) {
  const double l = problem.length / model.elements();
  return std::sqrt(integral(problem.length, model.elements(), [&](int element, double s) {
    const double computed = element_values(q, element).dot(shape_functions(order, s, l));
    return std::pow(computed - problem.phi(order, l * (element + s)) * g, 2);
  }));
}

// The finite-element system under the load p g(t) with the wall of the problem. With friction, the law μ =
// μ_s exp(-α v_s) must give the force tip_force() exp(-λ t). The normal force N is chosen so that
// this holds at v_s = v_0, and the wall moves relative to the tip such that v_s = -(v_0 + λ t/α) or
// the opposite sign.
solver::ContactSystem contact_system(const Problem& problem, const solver::BeamModel& model,
                                     const Eigen::VectorXd& load) {
  const double tip = problem.phi(0, problem.length), force = problem.tip_force();
  solver::ContactSystem system{
      .mass = model.mass(),
      .damping = solver::damping_matrix(model, data::Damping({.kelvin_voigt = problem.eta})),
      .stick_stiffness = model.stick_stiffness(),
      .slip_stiffness = model.slip_stiffness(),
      .load_shape = load,
      .load_history = [problem](double t) { return problem.history(0, t); },
      .contact = model.tip_deflection(),
      .friction = data::FrictionLaw(
          {.static_coefficient = static_coefficient, .kinetic_coefficient = 0.0, .decay = friction_decay})};
  const double direction = problem.tip == ManufacturedTip::friction && force > 0.0 ? 1.0 : -1.0;
  double speed = 0.0, acceleration = 0.0;  // of the wall relative to the tip
  if (problem.tip == ManufacturedTip::slip) speed = far_wall_speed;
  if (problem.tip == ManufacturedTip::friction) {
    speed = slowest_sliding;
    acceleration = problem.rate / friction_decay;
    system.normal_force = std::abs(force) * std::exp(friction_decay * slowest_sliding) / static_coefficient;
  }
  system.wall = {
      .displacement =
          [=](double t) {
            return tip * problem.history(0, t) + direction * (speed + 0.5 * acceleration * t) * t;
          },
      .velocity =
          [=](double t) { return tip * problem.history(1, t) + direction * (speed + acceleration * t); },
      .acceleration = [=](double t) { return tip * problem.history(2, t) + direction * acceleration; }};
  return system;
}

struct EndOfRun {
  Eigen::VectorXd displacement, velocity;
  double friction_force;
};

EndOfRun run(const Problem& problem, const solver::BeamModel& model, const Eigen::VectorXd& load,
             const Eigen::VectorXd& shape, double spectral_radius, int steps) {
  solver::ContactSystem system = contact_system(problem, model, load);
  if (problem.tip == ManufacturedTip::stick) system.normal_force = solver::bonding_force;
  solver::StickSlipIntegrator integrator(
      system, {.time_step = problem.duration() / steps, .spectral_radius = spectral_radius});
  const Eigen::VectorXd displacement = problem.history(0, 0.0) * shape,
                        velocity = problem.history(1, 0.0) * shape;
  if (problem.tip == ManufacturedTip::stick) {
    integrator.start_stuck(displacement, velocity);
  } else {
    integrator.start_slipping(displacement, velocity);
  }
  for (int n = 0; n < steps; ++n) integrator.step();
  return {integrator.displacement(), integrator.velocity(), integrator.friction_force()};
}

// K + s M of the state. The damping is included, because d/dt is -λ for the decaying motion.
Eigen::MatrixXd dynamic_stiffness(const Problem& problem, const solver::BeamModel& model) {
  const double damped = problem.effective_rigidity() / problem.rigidity - 1.0;
  return Eigen::MatrixXd(model.slip_stiffness()) + damped * Eigen::MatrixXd(model.elastic_stiffness()) +
         problem.history_ratio() * Eigen::MatrixXd(model.mass());
}

// The amplitude Q of the semi-discrete solution Q g(t).
Eigen::VectorXd semi_discrete_shape(const Problem& problem, const solver::BeamModel& model,
                                    const Eigen::VectorXd& load) {
  Eigen::MatrixXd matrix = dynamic_stiffness(problem, model);
  Eigen::VectorXd right_side = load;
  const Eigen::Index tip = model.tip_deflection();
  if (problem.tip == ManufacturedTip::stick) {
    matrix.row(tip).setZero();
    matrix(tip, tip) = 1.0;
    right_side[tip] = problem.phi(0, problem.length);
  }
  if (problem.tip == ManufacturedTip::friction) right_side[tip] += problem.tip_force();
  return matrix.partialPivLu().solve(right_side);
}

// The matrix with the row and the column of the tip deflection replaced by those of the identity matrix.
Eigen::MatrixXd tip_held(const solver::BeamModel& model, const solver::SparseMatrix& sparse) {
  const Eigen::Index tip = model.tip_deflection();
  Eigen::MatrixXd matrix = sparse;
  matrix.row(tip).setZero();
  matrix.col(tip).setZero();
  matrix(tip, tip) = 1.0;
  return matrix;
}

// Squared natural frequencies and mode shapes of the mesh. In stick there is one additional pair for the held
// tip.
Eigen::EigenSolver<Eigen::MatrixXd> free_vibrations(const Problem& problem, const solver::BeamModel& model) {
  const bool held = problem.tip == ManufacturedTip::stick;
  const Eigen::MatrixXd mass = held ? tip_held(model, model.mass()) : Eigen::MatrixXd(model.mass());
  const Eigen::MatrixXd stiffness =
      held ? tip_held(model, model.stick_stiffness()) : Eigen::MatrixXd(model.slip_stiffness());
  return Eigen::EigenSolver<Eigen::MatrixXd>(Eigen::MatrixXd(mass.llt().solve(stiffness)));
}

// The leading time-integration error of a motion Q cos(ω t) that starts at rest.
Eigen::VectorXd leading_time_error(const Problem& problem, const solver::BeamModel& model,
                                   const Eigen::VectorXd& shape, double spectral_radius, double h) {
  const AlphaParameters method(spectral_radius);
  const double square = problem.rate * problem.rate;
  const double m = 1.0 - method.alpha_m, f = 1.0 - method.alpha_f;
  const double k_a = 0.5 * m - m * f + 0.5 * f * f - 1.0 / 6.0 + 0.5 * method.gamma - method.beta;
  const double k_b = 0.5 * f * (1.0 - f);
  // In stick only the deviation from the static shape is integrated. This deviation is zero at the tip.
  Eigen::VectorXd moving = shape;
  if (problem.tip == ManufacturedTip::stick)
    moving -= shape[model.tip_deflection()] * model.unit_tip_deflection();
  const Eigen::EigenSolver<Eigen::MatrixXd> modes = free_vibrations(problem, model);
  const Eigen::MatrixXcd vectors = modes.eigenvectors();
  Eigen::VectorXcd shares = vectors.partialPivLu().solve(moving.cast<Complex>());
  const double t = problem.duration();
  for (Eigen::Index n = 0; n < shares.size(); ++n) {
    const Complex natural = modes.eigenvalues()[n];
    shares[n] *= (k_a * square - k_b * natural) * square * h * h / (natural - square) *
                 (std::cos(std::sqrt(natural) * t) - std::cos(problem.rate * t));
  }
  return (vectors * shares).real();
}

// The row r of f_d = r . q + (terms without q) in stick: the tip's row of K_slip, and the contribution of the
// inertia of the free degrees of freedom.
Eigen::VectorXd holding_row(const solver::BeamModel& model) {
  const Eigen::Index tip = model.tip_deflection();
  Eigen::VectorXd coupling = model.mass().col(tip);
  coupling[tip] = 0.0;
  return Eigen::MatrixXd(model.slip_stiffness()).row(tip).transpose() -
         model.stick_stiffness().transpose() * tip_held(model, model.mass()).llt().solve(coupling);
}

// The estimate described at PredictedErrors::floor.
double round_off_floor(int steps, int elements, int order, double exact) {
  return std::numeric_limits<double>::epsilon() * (std::sqrt(steps) + 12.0 * std::pow(elements, order)) *
         std::abs(exact);
}

double l2_norm(const solver::BeamModel& model, const Eigen::VectorXd& q) {
  return std::sqrt(q.dot(model.mass() * q) / (model.beam().density() * model.beam().area()));
}

// Integrals over the beam that the predicted errors in space consist of.
struct SpaceErrorTerms {
  ExponentialSum nodal_error;
  std::array<double, 7> square{};  ///< of the derivatives of φ, by order
  // Squares of the contribution of the nodal error to each norm, in units of (l⁴/720)². The mixed terms
  // with u - Iu are included.
  double nodal_deflection{}, nodal_slope{}, nodal_curvature{};
  double second_curvature_term{};
};

SpaceErrorTerms space_error_terms(const Problem& problem) {
  const auto& phi = problem.phi;
  const auto product = [&](const ExponentialSum& a, int i, const ExponentialSum& b, int j) {
    return integral(problem.length, smooth_intervals, [&](int interval, double s) {
      const double x = problem.length * (interval + s) / smooth_intervals;
      return a(i, x) * b(j, x);
    });
  };
  SpaceErrorTerms terms{.nodal_error = leading_nodal_error(problem)};
  const auto& nodal_error = terms.nodal_error;
  for (int order = 0; order < 7; ++order)
    terms.square[static_cast<std::size_t>(order)] = product(phi, order, phi, order);
  terms.nodal_deflection = product(nodal_error, 0, nodal_error, 0) - 2.0 * product(nodal_error, 0, phi, 4);
  terms.nodal_slope = product(nodal_error, 1, nodal_error, 1) + 2.0 * product(nodal_error, 2, phi, 4);
  terms.nodal_curvature = product(nodal_error, 2, nodal_error, 2);
  terms.second_curvature_term =
      (1.0 / 28.0 - 1.0 / 12.0) * product(phi, 4, phi, 6) + (1.0 / 140.0 - 1.0 / 12.0) * terms.square[5];
  return terms;
}

// Adds the errors that are predicted for elements of length l at the end of the run.
void add_predictions(ManufacturedSpaceErrors& study, const Problem& problem, const SpaceErrorTerms& terms,
                     double l) {
  const auto& square = terms.square;
  const double l4 = l * l * l * l, nodal = l4 * l4 / (720.0 * 720.0), length = problem.length;
  const double size = std::abs(problem.history(0, problem.duration()));
  study.next_term.push_back(l * l / 24.0 * (std::sqrt(square[6] / square[4]) + square[5] / square[4]));
  study.deflection.predicted.push_back(
      size * std::sqrt(l4 * l4 / 362880.0 * square[4] + nodal * terms.nodal_deflection));
  const double slope_of_interpolation = l * l * l * std::sqrt(square[4] / 30240.0);
  const double slope = std::sqrt(slope_of_interpolation * slope_of_interpolation + nodal * terms.nodal_slope);
  study.slope.predicted.push_back(size * slope);
  study.nodal_share_of_slope.push_back(1.0 - slope_of_interpolation / slope);
  study.curvature.predicted.push_back(
      size * std::sqrt(l4 / 720.0 * (square[4] + l * l * terms.second_curvature_term) +
                       nodal * terms.nodal_curvature));
  if (study.tip != ManufacturedTip::stick)
    study.tip_deflection.predicted.push_back(size * l4 / 720.0 * std::abs(terms.nodal_error(0, length)));
  else
    study.force.predicted.push_back(size * l4 / 720.0 *
                                    std::abs(problem.axial_force * problem.phi(5, length) -
                                             problem.rigidity * terms.nodal_error(3, length)));
}

// Adds the measured errors of a run on n elements, their round-off floors and the temporal shares.
void add_run(ManufacturedSpaceErrors& study, const Problem& problem, const SpaceErrorTerms& terms, int n) {
  const double length = problem.length, g = problem.history(0, problem.duration());
  const solver::BeamModel model(problem.beam, n);
  const Eigen::VectorXd load = implied_load(problem, model);
  const Eigen::VectorXd shape = semi_discrete_shape(problem, model, load);
  // The steps are short enough for a temporal share of about 1e-3. The force contains more of the high modes.
  const int steps = (study.tip == ManufacturedTip::stick ? 320 : 160) * n * n;
  const EndOfRun end = run(problem, model, load, shape, space_spectral_radius, steps);
  const auto floor = [&](int order, double exact) { return round_off_floor(steps, n, order, g * exact); };
  int order = 0;
  for (PredictedErrors* errors : {&study.deflection, &study.slope, &study.curvature}) {
    errors->error.push_back(difference(problem, model, end.displacement, g, order));
    errors->floor.push_back(floor(order, std::sqrt(terms.square[static_cast<std::size_t>(order)])));
    ++order;
  }
  if (study.tip != ManufacturedTip::stick) {
    study.tip_deflection.error.push_back(
        std::abs(end.displacement[model.tip_deflection()] - g * problem.phi(0, length)));
    study.tip_deflection.floor.push_back(floor(0, problem.phi(0, length)));
  }
  if (study.tip != ManufacturedTip::slip) {
    study.force.error.push_back(std::abs(end.friction_force - g * problem.tip_force()));
    study.force.floor.push_back(floor(3, problem.tip_force()));
  }
  if (study.tip == ManufacturedTip::friction) return;
  const Eigen::VectorXd temporal =
      leading_time_error(problem, model, shape, space_spectral_radius, problem.duration() / steps);
  study.temporal_share.push_back(l2_norm(model, temporal) / study.deflection.predicted.back());
  if (study.tip == ManufacturedTip::stick)
    study.temporal_share_of_force.push_back(std::abs(holding_row(model).dot(temporal)) /
                                            study.force.predicted.back());
}

}  // namespace

ManufacturedSpaceErrors manufactured_space_errors(const data::Beam& beam, ManufacturedTip tip,
                                                  double load_factor, const std::vector<int>& elements) {
  const Problem problem = manufactured_problem(beam, tip, load_factor);
  const SpaceErrorTerms terms = space_error_terms(problem);
  ManufacturedSpaceErrors study;
  study.tip = tip;
  study.load_factor = load_factor;
  study.elements = elements;
  if (tip == ManufacturedTip::friction)
    study.friction_coupling = friction_decay * problem.rate * std::abs(problem.tip_force()) *
                              std::pow(problem.length, 3) / (3.0 * problem.rigidity);
  for (const int n : elements) {
    study.element_length.push_back(problem.length / n);
    add_predictions(study, problem, terms, problem.length / n);
    add_run(study, problem, terms, n);
  }
  for (PredictedErrors* errors :
       {&study.deflection, &study.slope, &study.curvature, &study.tip_deflection, &study.force})
    if (!errors->error.empty()) errors->order = order_estimate(study.element_length, errors->error);
  return study;
}

ManufacturedTimeErrors manufactured_time_errors(const data::Beam& beam, ManufacturedTip tip,
                                                double load_factor, double spectral_radius,
                                                const std::vector<int>& steps) {
  const Problem problem = manufactured_problem(beam, tip, load_factor);
  constexpr int elements = 2;
  const solver::BeamModel model(problem.beam, elements);
  const Eigen::VectorXd shape = nodal_values(problem.phi, model);
  Eigen::VectorXd load = dynamic_stiffness(problem, model) * shape;
  const double force = tip == ManufacturedTip::slip ? 0.0 : problem.tip_force();
  load[model.tip_deflection()] -= force;
  const double t = problem.duration();
  const double dissipation = (1.0 - spectral_radius) / (1.0 + spectral_radius);
  const bool held = tip == ManufacturedTip::stick;
  const int modes = static_cast<int>(model.degrees_of_freedom()) - (held ? 1 : 0);
  const auto natural = held ? solver::stick_modes(model, modes) : solver::slip_modes(model, modes);
  const auto next_term = [&](double natural_frequency, double h) {
    const double phase = natural_frequency * h;
    return 2.0 * dissipation * phase + natural_frequency * t * phase * phase / 24.0;
  };
  ManufacturedTimeErrors study;
  study.tip = tip;
  study.load_factor = load_factor;
  study.spectral_radius = spectral_radius;
  for (const int n : steps) {
    const double h = t / n;
    const EndOfRun end = run(problem, model, load, shape, spectral_radius, n);
    study.time_step.push_back(h);
    study.next_term.push_back(next_term(natural[1].angular_frequency, h));
    study.next_term_of_all_modes.push_back(next_term(natural.back().angular_frequency, h));
    study.displacement.error.push_back(l2_norm(model, end.displacement - problem.history(0, t) * shape));
    study.velocity.error.push_back(l2_norm(model, end.velocity - problem.history(1, t) * shape));
    const auto floor = [&](int order, double exact) { return round_off_floor(n, elements, order, exact); };
    const double motion = l2_norm(model, shape);
    study.displacement.floor.push_back(floor(0, motion));
    study.velocity.floor.push_back(floor(0, problem.rate * motion));
    if (tip != ManufacturedTip::slip) {
      study.force.error.push_back(std::abs(end.friction_force - problem.history(0, t) * force));
      study.force.floor.push_back(floor(3, force));
    }
    if (tip == ManufacturedTip::friction) continue;
    const Eigen::VectorXd predicted = leading_time_error(problem, model, shape, spectral_radius, h);
    study.displacement.predicted.push_back(l2_norm(model, predicted));
    if (tip == ManufacturedTip::stick)
      study.force.predicted.push_back(std::abs(holding_row(model).dot(predicted)));
  }
  for (PredictedErrors* errors : {&study.displacement, &study.velocity, &study.force})
    if (!errors->error.empty()) errors->order = order_estimate(study.time_step, errors->error);
  return study;
}

ManufacturedSolutionStudy manufactured_solution_study(const data::Beam& beam) {
  constexpr std::array tips{ManufacturedTip::stick, ManufacturedTip::slip, ManufacturedTip::friction};
  ManufacturedSolutionStudy study;
  for (const ManufacturedTip tip : tips)
    for (const double load_factor : {-10.0, 0.0, 10.0}) {
      study.space.push_back(manufactured_space_errors(beam, tip, load_factor, {4, 6, 8, 12, 16}));
    }
  for (const ManufacturedTip tip : tips)
    for (const double radius : {0.0, 0.5, 0.9, 1.0})
      study.time.push_back(manufactured_time_errors(beam, tip, 10.0, radius, {1000, 2000, 4000, 8000}));
  return study;
}

}  // namespace stickslip::studies
