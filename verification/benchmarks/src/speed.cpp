// SPDX-License-Identifier: MIT
/// Times of the fast and of the plain methods, and of the peak performance of the machine. Only ratios
/// between lines of one run are meaningful, not the times themselves.

#include <benchmark/benchmark.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/solver/base_motion.hpp"
#include "stickslip/solver/beam_model.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/generalized_alpha.hpp"
#include "studies/analyses/criterion_map.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::benchmarks {
namespace {

using solver::BeamSimulation;
using solver::Coordinates;
using solver::SparseMatrix;

// The beam of the paper with its friction, settings and excitations.
const data::Beam paper_beam({.length = 2.0,
                             .area = 0.01,
                             .second_moment_of_area = 1e-4 / 12.0,
                             .density = 1000.0,
                             .youngs_modulus = 2e9,
                             .axial_force = 500.0});
const data::FrictionLaw paper_friction({.static_coefficient = 0.6, .kinetic_coefficient = 0.3, .decay = 1.0});
constexpr double ten_seconds = 10.0;

// The excitation with the frequency `hz` (Hz) and the amplitude `amplitude` (m).
data::HarmonicExcitation shaking(double hz, double amplitude) {
  return data::HarmonicExcitation({.frequency_hz = hz, .amplitude = amplitude});
}

// The settings of the paper with another number of elements, another duration (s).
data::NumericalSettings settings(int elements, double duration = ten_seconds) {
  return data::NumericalSettings({.elements = elements,
                                  .time_step = 1e-4,
                                  .spectral_radius = 0.9,
                                  .velocity_threshold = 1e-4,
                                  .modes = 10,
                                  .duration = duration});
}

constexpr double steps = 1e5;

data::Case paper_case(const data::HarmonicExcitation& excitation = shaking(25.0, 1e-3)) {
  return {.name = "paper",
          .structure = paper_beam,
          .motion = excitation,
          .contact = {.friction = paper_friction},
          .numerics = settings(20)};
}

// Sets the counters of operations and bytes per step, for the fractions of the peak performance.
void count(benchmark::State& state, double flops_per_step, double bytes_per_step) {
  state.counters["steps"] = steps;
  state.counters["flops_per_step"] = flops_per_step;
  state.counters["bytes_per_step"] = bytes_per_step;
}

// ---- peak performance of the machine

// Multiplications and additions in registers, with the vector width of the build: in 12 of the 16 registers that every
// processor of this kind has, whose chains do not wait for each other.
void peak_flops(benchmark::State& state) {
  constexpr int lanes = 12 * Eigen::internal::packet_traits<double>::size, rounds = 10000;
  Eigen::Array<double, lanes, 1> x = Eigen::Array<double, lanes, 1>::LinSpaced(0.0, 1.0);
  double factor = 0.999, term = 0.001;
  benchmark::DoNotOptimize(factor);
  benchmark::DoNotOptimize(term);
  for (auto _ : state) {
    for (int round = 0; round < rounds; ++round) x = x * factor + term;
    benchmark::DoNotOptimize(x.data());
  }
  state.counters["flops"] = 2.0 * lanes * rounds;
}
BENCHMARK(peak_flops)->Name("peak/flops")->Unit(benchmark::kMicrosecond);

// a = b + s c over arrays that fit in the second-level cache.
void peak_cache(benchmark::State& state) {
  constexpr Eigen::Index size = 8192;
  Eigen::VectorXd a = Eigen::VectorXd::Zero(size);
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(size), c = Eigen::VectorXd::Ones(size);
  for (auto _ : state) {
    a = b + 0.3 * c;
    benchmark::DoNotOptimize(a.data());
    benchmark::ClobberMemory();
  }
  state.counters["bytes"] = 24.0 * size;
}
BENCHMARK(peak_cache)->Name("peak/cache")->Unit(benchmark::kMicrosecond);

// ---- histories

// A usual implementation of the stick state with Eigen, for comparison. The rows of the tip deflection are
// removed, its prescribed motion is on the right-hand side, the matrix is factorised once, and one loop
// performs the steps of generalised-alpha.
enum class Factorisation { dense_lu, sparse_ldlt };

// The result of the loop and its load per step.
struct EigenLoop {
  double largest_force{};   ///< max |f|, N
  double flops_per_step{};  ///< per step, counted from the matrices
  double bytes_per_step{};  ///< per step, each number read and written once; matrices with their indices
};

// Removes the row and column of the tip deflection, which is the last but one degree of freedom.
SparseMatrix without_tip(const SparseMatrix& matrix) {
  const Eigen::Index tip = matrix.rows() - 2;
  SparseMatrix selection(tip + 2, tip + 1);
  for (Eigen::Index i = 0; i < tip; ++i) selection.insert(i, i) = 1.0;
  selection.insert(tip + 1, tip) = 1.0;
  return (selection.transpose() * matrix * selection).pruned();
}

Eigen::VectorXd without_tip(const Eigen::VectorXd& vector) {
  Eigen::VectorXd rest(vector.size() - 1);
  rest << vector.head(vector.size() - 2), vector[vector.size() - 1];
  return rest;
}

template <class Matrix, class Solver>
EigenLoop loop(const solver::BeamModel& model, const data::HarmonicExcitation& excitation,
               const data::NumericalSettings& numerics, const Matrix& mass, const Matrix& stiffness,
               const Solver& solver) {
  const solver::GeneralizedAlpha method(numerics.spectral_radius());
  const double h = numerics.time_step(), share = 1.0 - method.alpha_f();
  const Eigen::Index tip = model.tip_deflection();
  const auto base = solver::base_motion(excitation);
  const Eigen::VectorXd of_displacement = without_tip(Eigen::VectorXd(model.stick_stiffness().col(tip)));
  const Eigen::VectorXd of_acceleration =
      without_tip(Eigen::VectorXd(model.mass().col(tip) - model.base_load()));
  const Eigen::VectorXd mass_row = without_tip(Eigen::VectorXd(model.mass().col(tip)));
  const Eigen::VectorXd stiffness_row =
      without_tip(Eigen::VectorXd(SparseMatrix(model.slip_stiffness().transpose()).col(tip)));
  const double mass_corner = model.mass().coeff(tip, tip) - model.base_load()[tip];
  const double stiffness_corner = model.slip_stiffness().coeff(tip, tip);

  const Eigen::Index n = mass.rows();
  Eigen::VectorXd q = Eigen::VectorXd::Zero(n), a = q, alpha_q(n), alpha_a(n), new_a(n), residual(n);
  Eigen::VectorXd v = -base.velocity(0.0) * without_tip(model.unit_tip_deflection());
  EigenLoop result;
  const long count = solver::step_count(numerics.duration(), h);
  for (long step = 0; step < count; ++step) {
    const double t = static_cast<double>(step) * h, load_time = t + share * h, end = t + h;
    alpha_q = q + (share * h) * v + (share * h * h * (0.5 - method.beta())) * a;
    alpha_a = method.alpha_m() * a;
    residual =
        base.acceleration(load_time) * of_acceleration + base.displacement(load_time) * of_displacement;
    residual.noalias() -= mass * alpha_a;
    residual.noalias() -= stiffness * alpha_q;
    new_a = solver.solve(residual);
    q += h * v + (h * h * (0.5 - method.beta())) * a + (h * h * method.beta()) * new_a;
    v += (h * (1.0 - method.gamma())) * a + (h * method.gamma()) * new_a;
    a = new_a;
    const double force = -(mass_row.dot(a) + stiffness_row.dot(q)) + mass_corner * base.acceleration(end) +
                         stiffness_corner * base.displacement(end);
    result.largest_force = std::max(result.largest_force, std::abs(force));
  }
  // Operations: 5 n for alpha_q, n for alpha_a, 4 n for the load and its residual, 6 n and 4 n for q and v, 4
  // n for the force.
  const auto size = static_cast<double>(n);
  result.flops_per_step = 24.0 * size;
  result.bytes_per_step = 8.0 * 26.0 * size;
  return result;
}

// Over numerics.duration().
EigenLoop eigen_stick_loop(const data::Beam& beam, const data::HarmonicExcitation& excitation,
                           const data::NumericalSettings& numerics, Factorisation factorisation) {
  const solver::BeamModel model(beam, numerics.elements());
  const solver::GeneralizedAlpha method(numerics.spectral_radius());
  const SparseMatrix mass = without_tip(model.mass()), stiffness = without_tip(model.stick_stiffness());
  const SparseMatrix matrix =
      method.mass_factor() * mass + method.stiffness_factor(numerics.time_step()) * stiffness;
  if (factorisation == Factorisation::dense_lu) {
    const Eigen::MatrixXd dense_mass = mass, dense_stiffness = stiffness;
    const Eigen::PartialPivLU<Eigen::MatrixXd> lu{Eigen::MatrixXd(matrix)};
    EigenLoop result = loop(model, excitation, numerics, dense_mass, dense_stiffness, lu);
    const auto entries = static_cast<double>(dense_mass.size());
    result.flops_per_step += 6.0 * entries;
    result.bytes_per_step += 24.0 * entries;
    return result;
  }
  const Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<int>> ldlt(matrix);
  EigenLoop result = loop(model, excitation, numerics, mass, stiffness, ldlt);
  const auto entries = static_cast<double>(mass.nonZeros() + stiffness.nonZeros());
  const auto factor = static_cast<double>(SparseMatrix(ldlt.matrixL()).nonZeros());
  result.flops_per_step += 2.0 * entries + 4.0 * factor;
  result.bytes_per_step += 12.0 * (entries + 2.0 * factor);
  return result;
}

void eigen_loop(benchmark::State& state, Factorisation factorisation) {
  EigenLoop result;
  for (auto _ : state) {
    result = eigen_stick_loop(paper_beam, shaking(35.0, 0.5e-3), settings(20), factorisation);
    benchmark::DoNotOptimize(result.largest_force);
  }
  count(state, result.flops_per_step, result.bytes_per_step);
}
BENCHMARK_CAPTURE(eigen_loop, dense_lu, Factorisation::dense_lu)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(eigen_loop, sparse_ldlt, Factorisation::sparse_ldlt)->Unit(benchmark::kMillisecond);

void stick_run(benchmark::State& state, Coordinates coordinates) {
  for (auto _ : state)
    benchmark::DoNotOptimize(solver::max_abs_friction_force(paper_case(shaking(35.0, 0.5e-3)), coordinates));
  if (coordinates == Coordinates::nodal) return;
  // One output value is the product of a row with the state of a block, which has three numbers for each of
  // 39 modes and two for the load. A block of 64 steps advances its state with 15 multiplications and
  // additions per mode. The state is written and read once per block, the outputs once. The rows stay in the
  // cache.
  constexpr double modes = 39.0, block = 64.0;
  count(state, 2.0 * (3.0 * modes + 2.0) + 2.0 * 15.0 * modes / block,
        8.0 * (2.0 + 2.0 * (3.0 * modes + 2.0) / block));
}
BENCHMARK_CAPTURE(stick_run, nodal, Coordinates::nodal)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stick_run, modal, Coordinates::modal)->Unit(benchmark::kMillisecond);

void stick_slip_run(benchmark::State& state, Coordinates coordinates) {
  std::size_t events = 0;
  for (auto _ : state) {
    BeamSimulation run(paper_case(), {.coordinates = coordinates});
    while (run.integrator().steps() < static_cast<long>(steps)) run.integrator().step();
    events = run.integrator().events().size();
    benchmark::DoNotOptimize(run.friction_force());
  }
  state.counters["events"] = static_cast<double>(events);
  // About 35 operations per mode in slip, on 14 arrays, without the additional steps of the search for an
  // event.
  if (coordinates == Coordinates::modal) count(state, 35.0 * 39.0, 8.0 * 14.0 * 39.0);
}
BENCHMARK_CAPTURE(stick_slip_run, nodal, Coordinates::nodal)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stick_slip_run, modal, Coordinates::modal)->Unit(benchmark::kMillisecond);

// A hundredth of a second of the plain stick run. Time and memory are proportional to the number of elements.
void elements(benchmark::State& state) {
  const auto numerics = settings(static_cast<int>(state.range(0)), 0.01);
  BeamSimulation run(with(paper_case(shaking(35.0, 0.5e-3)), numerics),
                     {.is_bonded = true, .coordinates = Coordinates::nodal});
  for (auto _ : state) {
    for (int n = 0; n < 100; ++n) run.integrator().step();
    benchmark::DoNotOptimize(run.friction_force());
  }
  state.SetComplexityN(state.range(0));
}
BENCHMARK(elements)
    ->Arg(20)
    ->Arg(100)
    ->Arg(500)
    ->Arg(2000)
    ->Arg(20000)
    ->Complexity(benchmark::oN)
    ->Unit(benchmark::kMillisecond);

// ---- closed form

void force_maximum(benchmark::State& state) {
  const analytic::StickResponse response(paper_beam, shaking(35.0, 0.5e-3), static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(response.max_abs_friction_force(ten_seconds));
}
BENCHMARK(force_maximum)->Name("force_maximum/search")->Arg(10)->Arg(40)->Unit(benchmark::kMillisecond);

// ---- maps

void map_of(benchmark::State& state, const studies::MapTask& task) {
  for (auto _ : state) benchmark::DoNotOptimize(studies::criterion_map(task).cells.data());
}

// Figs. 10 to 12 as a map of a million cells.
void frequency_amplitude(benchmark::State& state) {
  map_of(state, {.problem = paper_case(),
                 .x = studies::map_axis("excitation.frequency_hz", 0.1, 120.0, 1200, false),
                 .y = studies::map_axis("excitation.amplitude", 1e-6, 1e-3, 1000, false)});
}
BENCHMARK(frequency_amplitude)
    ->Name("criterion_map/frequency_amplitude")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

// The cross section of Fig. 14: 0.2 m by 0.02 m.
data::Case flat_case() {
  data::Case flat = paper_case();
  auto properties = paper_beam.properties();
  properties.area = 0.004;
  properties.second_moment_of_area = 0.2 * 0.02 * 0.02 * 0.02 / 12.0;
  properties.length = 0.4;
  properties.axial_force = 5.0;
  flat.structure = data::Beam(properties);
  return flat;
}

void length_force(benchmark::State& state) {
  map_of(state, {.problem = flat_case(),
                 .x = studies::map_axis("beam.length", 0.4, 2.0, 1000, false),
                 .y = studies::map_axis("beam.axial_force", 5.0, 33000.0, 1000, true),
                 .states_only = true});
}
BENCHMARK(length_force)->Name("criterion_map/length_force")->Unit(benchmark::kMillisecond)->UseRealTime();

// ---- Fig. 6

enum class Procedure { raised, linear, modal };

void critical_amplitude(benchmark::State& state, Procedure procedure) {
  constexpr double increment = 1e-5;
  const double limit = paper_friction.static_coefficient() * paper_beam.axial_force();
  double found = 0.0;
  for (auto _ : state) {
    if (procedure == Procedure::raised) {
      int runs = 1;
      while (!solver::first_slip(paper_case(shaking(35.0, runs * increment)), Coordinates::nodal)) ++runs;
      found = runs * increment;
    } else {
      const auto coordinates = procedure == Procedure::modal ? Coordinates::modal : Coordinates::nodal;
      const double force = solver::max_abs_friction_force(paper_case(shaking(35.0, increment)), coordinates);
      found = (std::floor(limit / force) + 1.0) * increment;
    }
  }
  state.counters["amplitude_mm"] = 1e3 * found;
}
BENCHMARK_CAPTURE(critical_amplitude, raised, Procedure::raised)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(critical_amplitude, linear, Procedure::linear)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(critical_amplitude, modal, Procedure::modal)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace stickslip::benchmarks
