// SPDX-License-Identifier: MIT
#include "comparison/diagnosis/wrong_models.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "comparison/diagnosis/wrong_model_recipes.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "studies/common/parallel.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::comparison {

namespace {

using data::with_value;
using studies::in_parallel;
using studies::StickReading;
using studies::StickSum;
using studies::two_pi;
using enum Quantity;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int kept_free_vibrations = 60;
constexpr int fine_elements = 60;
constexpr double closed_form_uncertainty = 1e-9;
// m; the critical amplitude does not depend on the amplitude of the case.
constexpr double unit_amplitude = 1e-3;

// The right model has a recipe without changes.
const WrongModelRecipe& right_model() {
  static const WrongModelRecipe model;
  return model;
}

void require_abscissa(const data::Case& problem, Quantity quantity, const std::vector<double>& abscissa) {
  const auto& properties = properties_of(quantity);
  if (abscissa.empty())
    throw std::invalid_argument(fmt::format("the abscissa of {} is empty", properties.name));
  const auto require = [&](bool allowed, double x, const std::string& what) {
    if (!allowed) throw data::FieldError(fmt::format("an abscissa of {}", properties.name), x, what);
  };
  for (const double x : abscissa) switch (properties.abscissa) {
      case Abscissa::number:
        require(x >= 1.0 && x <= 1000.0 && x == std::floor(x), x, "a whole number from 1 to 1000");
        break;
      case Abscissa::place:
        require(x >= 0.0 && x <= problem.beam().length(), x,
                fmt::format("a position from 0 to {} m", problem.beam().length()));
        break;
      case Abscissa::frequency:
        require(x > 0.0 && std::isfinite(x), x, "a frequency above 0 Hz");
        break;
      case Abscissa::time:
        require(x >= 0.0 && std::isfinite(x), x, "a time from 0 s on");
    }
}

int rounded(double number) { return static_cast<int>(std::lround(number)); }

int highest(const std::vector<double>& abscissa) { return rounded(std::ranges::max(abscissa)); }

// The mesh of a model with its matrices. The friction force is limited by `normal_force`.
struct MeshedBeam {
  solver::BeamModel mesh;
  solver::ContactSystem system;
};
MeshedBeam meshed_beam(const WrongModelRecipe& model, const data::Case& problem, double normal_force) {
  solver::BeamModel mesh(problem.beam(), problem.numerics.elements());
  solver::require_stable_stick_state(mesh);
  solver::ContactSystem system = solver::beam_contact_system(
      mesh, with(problem, data::TangentialContact(), data::Wall()), model.base(problem));
  system.normal_force = normal_force;
  if (model.mesh) model.mesh(system, mesh);
  return {std::move(mesh), std::move(system)};
}

// Whether natural frequencies and the stick state are computed on the mesh.
bool uses_mesh(const WrongModelRecipe& model, Quantity quantity) {
  const Quantity listed = quantity == stick_velocity ? stick_displacement : quantity;
  return (model.mesh || model.force_row) && !model.equations &&
         std::ranges::count(model.wrong_model.changes, listed) > 0;
}

MeshedBeam linear_beam(const WrongModelRecipe& model, const data::Case& problem) {
  const bool as_given = model.depends_on_mesh || model.force_row;
  return meshed_beam(model, as_given ? problem : with_value(problem, "numerics.elements", fine_elements),
                     0.0);
}

// The modal sum of the stick state of a model.
StickSum sum_of(const WrongModelRecipe& model, const data::Case& problem, Quantity quantity) {
  if (uses_mesh(model, quantity)) {
    const MeshedBeam beam = linear_beam(model, problem);
    return studies::stick_sum(beam.mesh, beam.system,
                              model.force_row ? model.force_row(beam.mesh) : Eigen::RowVectorXd());
  }
  StickSum sum = studies::stick_sum(problem.beam(), kept_free_vibrations);
  if (model.equations) model.equations(sum, problem);
  return sum;
}

// f(t) or y(L/2, t) with the tip held, and its largest magnitude up to some time.
struct HeldHistory {
  std::function<double(double)> at;
  std::function<double()> max_abs;
};

HeldHistory held_in_closed_form(const data::Case& problem, StickReading reading, double end) {
  if (!problem.damping.is_none())
    throw data::InputError(
        "the case is damped, but must be undamped for forces and motions of the held beam");
  const auto response = std::make_shared<analytic::StickResponse>(
      problem.beam(), problem.excitation(), kept_free_vibrations, analytic::SteadyPart::exact);
  if (reading == StickReading::displacement)
    return {[response, at = response->absolute_displacement(0.5 * problem.beam().length())](double t) {
              return at(t);
            },
            {}};
  return {[response](double t) { return response->friction_force(t); },
          [response, end] { return response->max_abs_friction_force(end, 1e-6).midpoint(); }};
}

HeldHistory held_by_a_sum(const StickSum& sum, const data::Case& problem, StickReading reading, double end) {
  const auto terms = studies::sinusoids(sum, problem.excitation(), reading);
  if (sum.cosine) {
    const auto at = [terms](double t) {
      double value = 0.0;
      for (const auto& term : terms) value += term.amplitude * std::cos(term.angular_frequency * t);
      return value;
    };
    return {at, [at, end, step = problem.numerics.time_step()] {
              double largest = 0.0;
              for (long n = 0; n <= std::lround(end / step); ++n)
                largest = std::max(largest, std::abs(at(static_cast<double>(n) * step)));
              return largest;
            }};
  }
  return {[terms](double t) { return studies::value_at(terms, t); },
          [terms, end, step = problem.numerics.time_step()] { return studies::max_abs(terms, end, step); }};
}

double interpolated(const std::vector<double>& samples, double step, double t) {
  const double position = std::min(t / step, static_cast<double>(samples.size() - 1));
  const auto before = std::min(static_cast<std::size_t>(position), samples.size() - 2);
  const double share = position - static_cast<double>(before);
  return (1.0 - share) * samples[before] + share * samples[before + 1];
}

HeldHistory held_in_steps(const StickSum& sum, const studies::ModalScheme& scheme, const data::Case& problem,
                          StickReading reading, double end) {
  const long steps = std::max(std::lround(std::ceil(end / scheme.step - 1e-6)), 1L);
  const auto samples = studies::stepped(sum, scheme, problem.excitation(), reading, steps);
  return {[samples, scheme](double t) { return interpolated(samples, scheme.step, t); },
          [samples] {
            double largest = 0.0;
            for (const double sample : samples) largest = std::max(largest, std::abs(sample));
            return largest;
          }};
}

HeldHistory held_history(const WrongModelRecipe& model, const data::Case& problem, Quantity quantity,
                         double end) {
  const auto reading = quantity == stick_displacement || quantity == stick_velocity
                           ? StickReading::displacement
                           : StickReading::force;
  if (model.scheme)
    return held_in_steps(sum_of(model, problem, quantity), model.scheme(problem), problem, reading, end);
  if (model.equations || uses_mesh(model, quantity))
    return held_by_a_sum(sum_of(model, problem, quantity), problem, reading, end);
  return held_in_closed_form(problem, reading, end);
}

using OptionalValues = std::optional<std::vector<double>>;

template <typename Function>
std::vector<double> at_each(const std::vector<double>& abscissa, const Function& function) {
  std::vector<double> values;
  for (const double x : abscissa) values.push_back(function(x));
  return values;
}

// The entries of a list whose numbers, counted from 1, are the abscissas; empty if the list is too short.
OptionalValues numbered(const std::vector<double>& list, const std::vector<double>& abscissa) {
  if (highest(abscissa) > static_cast<int>(list.size())) return std::nullopt;
  return at_each(abscissa, [&](double x) { return list[static_cast<std::size_t>(rounded(x) - 1)]; });
}

// Natural frequencies of K_slip and M, Hz, ascending; empty if one is complex.
std::vector<double> slip_frequencies(const solver::ContactSystem& system) {
  const Eigen::MatrixXd flexibility_times_mass =
      Eigen::MatrixXd(system.slip_stiffness).partialPivLu().solve(Eigen::MatrixXd(system.mass));
  const Eigen::EigenSolver<Eigen::MatrixXd> eigen(flexibility_times_mass, false);
  std::vector<double> hz;
  for (const std::complex<double>& mu : eigen.eigenvalues()) {
    if (mu.imag() != 0.0 || mu.real() <= 0.0) return {};
    hz.push_back(1.0 / (two_pi * std::sqrt(mu.real())));
  }
  std::ranges::sort(hz);
  return hz;
}

OptionalValues modal_values(const WrongModelRecipe& model, const data::Case& problem, Quantity quantity,
                            const std::vector<double>& abscissa) {
  const int count = highest(abscissa);
  const bool by_mesh = uses_mesh(model, quantity);
  std::vector<double> list;
  if (quantity == slip_frequency && by_mesh) {
    list = slip_frequencies(linear_beam(model, problem).system);
  } else if (quantity == slip_frequency) {
    for (const auto& mode : analytic::slip_modes(problem.beam(), count)) list.push_back(mode.frequency_hz());
  } else if (model.equations || by_mesh) {
    for (const StickSum::Mode& mode : sum_of(model, problem, quantity).modes)
      list.push_back(quantity == participation ? mode.participation : mode.natural_frequency / two_pi);
  } else {
    for (const auto& mode : analytic::stick_modes(problem.beam(), count))
      list.push_back(quantity == participation ? mode.participation() : mode.frequency_hz());
  }
  return numbered(list, abscissa);
}

OptionalValues held_values(const WrongModelRecipe& model, const data::Case& problem, double normal_force,
                           Quantity quantity, const std::vector<double>& abscissa) {
  if (quantity == stick_velocity) {  // by a difference
    const double step = model.scheme ? model.scheme(problem).step : 1e-5;
    const auto at = held_history(model, problem, quantity, std::ranges::max(abscissa) + step).at;
    return at_each(abscissa, [&](double t) { return (at(t + step) - at(t - step)) / (2.0 * step); });
  }
  if (quantity == stick_force || quantity == stick_displacement)
    return at_each(abscissa, held_history(model, problem, quantity, std::ranges::max(abscissa)).at);
  const double duration = model.observed_for ? model.observed_for(problem) : problem.numerics.duration();
  const double largest = held_history(model, problem, quantity, duration).max_abs();
  if (quantity == force_maximum) return std::vector{largest};
  return std::vector{problem.contact.friction.static_coefficient() * normal_force / largest};
}

// The steady vibration with the tip held, on the mesh of the case: (K + i W C - W^2 M) u = load, u(L) = -A0.
std::vector<double> steady_values(const WrongModelRecipe& model, const data::Case& problem, Quantity quantity,
                                  const std::vector<double>& frequencies) {
  using Complex = std::complex<double>;
  const MeshedBeam beam = meshed_beam(model, problem, 0.0);
  const solver::ContactSystem& system = beam.system;
  const Eigen::VectorXd at_middle = beam.mesh.interpolation(0.5 * problem.beam().length());
  const Eigen::MatrixXd stiffness(system.slip_stiffness), mass(system.mass), damping(system.damping);
  const double amplitude = problem.excitation().amplitude();
  const double first = analytic::stick_modes(problem.beam(), 1).front().angular_frequency();
  const Eigen::Index c = system.contact;
  return at_each(frequencies, [&](double hz) {
    const double omega = two_pi * hz, loss = model.is_structural ? first : omega;
    Eigen::MatrixXcd whole(stiffness.rows(), stiffness.cols());
    whole.real() = stiffness - omega * omega * mass;
    whole.imag() = loss * damping;
    const Eigen::VectorXcd load = (-omega * omega * amplitude * system.load_shape).cast<Complex>();
    Eigen::MatrixXcd held = whole;
    held.row(c).setZero();
    held(c, c) = 1.0;
    Eigen::VectorXcd prescribed = load;
    prescribed[c] = -amplitude;
    const Eigen::VectorXcd u = held.partialPivLu().solve(prescribed);
    const Complex middle = (model.is_relative ? 0.0 : amplitude) + at_middle.cast<Complex>().dot(u);
    const Complex force = load[c] - (whole.row(c) * u)(0);
    if (quantity == steady_amplitude) return std::abs(middle);
    if (quantity == steady_phase) return std::arg(middle);
    if (quantity == steady_force_amplitude) return std::abs(force);
    if (quantity == steady_force_phase) return std::arg(force);
    return 0.5 * two_pi * loss * u.dot(damping.cast<Complex>() * u).real();
  });
}

const std::vector<double>& history_of(const studies::TipRun& run, Quantity quantity) {
  switch (quantity) {
    case tip_displacement:
      return run.tip_displacement;
    case tip_velocity:
      return run.tip_velocity;
    case midspan_displacement:
      return run.midspan_displacement;
    case midspan_velocity:
      return run.midspan_velocity;
    default:
      return run.friction_force;
  }
}

// The run, which several quantities ask for. The last runs are kept.
std::shared_ptr<const studies::TipRun> kept_run(const WrongModelRecipe& model, const data::Case& problem,
                                                double normal_force, double end, std::size_t events) {
  constexpr std::size_t most = 256;
  static std::mutex mutex;
  static std::map<std::string, std::shared_ptr<const studies::TipRun>> kept;
  std::string key = fmt::format("{} {} {} {}", model.wrong_model.name, normal_force, end, events);
  for (const auto& [path, number] : data::numbers_of(problem)) key += fmt::format(" {}", number);
  {
    const std::scoped_lock lock(mutex);
    if (const auto found = kept.find(key); found != kept.end()) return found->second;
  }
  const MeshedBeam beam = meshed_beam(model, problem, normal_force);
  const auto base = model.base(problem);
  auto run = std::make_shared<const studies::TipRun>(
      model.law ? studies::tip_run(beam.system, base, problem.numerics, *model.law, end, events)
                : studies::tip_run(beam.system, base, problem.numerics, model.start, end, events));
  const std::scoped_lock lock(mutex);
  if (kept.size() >= most) kept.clear();
  return kept[key] = std::move(run);
}

OptionalValues stick_slip_values(const WrongModelRecipe& model, const data::Case& problem,
                                 double normal_force, Quantity quantity,
                                 const std::vector<double>& abscissa) {
  if (!model.knows_stick_slip) return std::nullopt;
  const auto kept =
      quantity == contact_event
          ? kept_run(model, problem, normal_force, problem.numerics.duration(),
                     static_cast<std::size_t>(highest(abscissa)))
          : kept_run(model, problem, normal_force, std::ranges::max(abscissa), studies::every_event);
  const studies::TipRun& run = *kept;
  return at_each(abscissa, [&](double x) {
    if (quantity == contact_event) {
      const auto index = static_cast<std::size_t>(rounded(x) - 1);
      return index < run.events.size() ? run.events[index] : infinity;
    }
    return interpolated(history_of(run, quantity), run.step, x);
  });
}

// The result of a model for the case that it computes instead of the given one.
OptionalValues raw_values(const WrongModelRecipe& model, const data::Case& given, Quantity quantity,
                          const std::vector<double>& abscissa) {
  const std::optional<data::Case> problem = model.inputs ? model.inputs(given) : given;
  if (!problem) return std::nullopt;
  const double normal_force = given.beam().axial_force();
  const State state = properties_of(quantity).state;
  if (quantity == quasi_static_shape) {
    const analytic::QuasiStaticShape shape(problem->beam());
    return at_each(abscissa, [&](double x) { return shape.value(x); });
  }
  if (state == State::modal) return modal_values(model, *problem, quantity, abscissa);
  if (state == State::steady) return steady_values(model, *problem, quantity, abscissa);
  if (state == State::stick_slip) return stick_slip_values(model, *problem, normal_force, quantity, abscissa);
  OptionalValues values = held_values(model, *problem, normal_force, quantity, abscissa);
  // Converts to the given amplitude, which the model may have changed.
  if (quantity == critical_amplitude) values->front() *= given.excitation().amplitude();
  return values;
}

OptionalValues values_of(const WrongModelRecipe& model, const data::Case& problem, Quantity quantity,
                         const std::vector<double>& abscissa) {
  OptionalValues values;
  if (properties_of(quantity).state == State::largest) {
    values.emplace();
    data::Case here = problem;
    if (quantity == critical_amplitude) here = with_value(here, "excitation.amplitude", unit_amplitude);
    for (const double hz : abscissa) {
      const auto one = raw_values(model, with_value(here, "excitation.frequency_hz", hz), quantity, {hz});
      if (!one) return std::nullopt;
      values->push_back(one->front());
    }
  } else {
    values = raw_values(model, problem, quantity, abscissa);
  }
  if (values && model.reading) model.reading(problem, quantity, abscissa, *values);
  return values;
}

// Empty if the model has no such state.
OptionalValues wrong_values(const WrongModelRecipe& model, const data::Case& problem, Quantity quantity,
                            const std::vector<double>& abscissa) {
  try {
    return values_of(model, problem, quantity, abscissa);
  } catch (const data::InputError&) {
    return std::nullopt;
  }
}

data::Case coarser(const data::Case& problem) {
  const data::NumericalSettings& given = problem.numerics;
  return with_values(problem, {{"numerics.elements", std::max(given.elements() / 2, 1)},
                               {"numerics.time_step", 2.0 * given.time_step()},
                               {"excitation.duration", std::max(given.duration(), 2.0 * given.time_step())}});
}

// The results of all wrong models by `values_by`.
template <class Evaluate>
void add_wrong_models(ModelResults& result, const Evaluate& values_by,
                      const std::function<void(double)>& progress) {
  const auto& models = wrong_model_recipes();
  std::vector<OptionalValues> values(models.size());
  in_parallel(
      models.size(), [&](std::size_t i) { values[i] = values_by(models[i]); }, progress);
  for (std::size_t i = 0; i < models.size(); ++i)
    if (values[i])
      result.wrong_models.push_back(
          {.name = models[i].wrong_model.name,
           .values = *values[i],
           .sentence = models[i].wrong_model.mistake,
           .from_reference = distance(result.norm, result.reference, result.reference, *values[i])});
}

std::vector<double> times_up_to(double duration) {
  constexpr int count = 200;
  std::vector<double> times;
  for (int i = 1; i <= count; ++i) times.push_back(duration * i / count);
  return times;
}

const Hypothesis* member_of(const ModelResults& model_results, const std::string& name) {
  const auto member = std::ranges::find(model_results.wrong_models, name, &Hypothesis::name);
  return member == model_results.wrong_models.end() ? nullptr : &*member;
}

// The relative change of the first entry.
std::optional<double> relative_change(const ModelResults& model_results, const std::string& name) {
  const auto* member = member_of(model_results, name);
  return member ? std::optional(member->values.front() / model_results.reference.front() - 1.0)
                : std::nullopt;
}

std::optional<double> distance_of(const ModelResults& model_results, const std::string& name) {
  const auto* member = member_of(model_results, name);
  return member ? std::optional(member->from_reference) : std::nullopt;
}

}  // namespace

const QuantityProperties& properties_of(Quantity quantity) {
  return *std::ranges::find(quantities, quantity, &QuantityProperties::quantity);
}

const std::vector<WrongModel>& wrong_models() {
  static const std::vector<WrongModel> all = [] {
    std::vector<WrongModel> list;
    for (const WrongModelRecipe& model : wrong_model_recipes()) list.push_back(model.wrong_model);
    return list;
  }();
  return all;
}

std::vector<double> reference_result(const data::Case& problem, Quantity quantity,
                                     const std::vector<double>& abscissa) {
  require_abscissa(problem, quantity, abscissa);
  std::vector<double> values = values_of(right_model(), problem, quantity, abscissa).value();
  if (const auto none = std::ranges::find(values, infinity); none != values.end())
    throw data::FieldError("an abscissa of contact event", *std::ranges::max_element(abscissa),
                           fmt::format("at most {}, the changes of contact within excitation.duration",
                                       std::ranges::count_if(values, [](double t) { return t < infinity; })));
  return values;
}

std::optional<std::vector<double>> wrong_result(const data::Case& problem, std::string_view wrong_model,
                                                Quantity quantity, const std::vector<double>& abscissa) {
  require_abscissa(problem, quantity, abscissa);
  return wrong_values(recipe_of(wrong_model), problem, quantity, abscissa);
}

ModelResults model_results(const data::Case& problem, Quantity quantity, const std::vector<double>& abscissa,
                           const std::function<void(double)>& progress) {
  ModelResults result{.norm = properties_of(quantity).norm,
                      .reference = reference_result(problem, quantity, abscissa),
                      .reference_uncertainty = closed_form_uncertainty,
                      .wrong_models = {}};
  if (std::ranges::all_of(result.reference, [](double value) { return value == 0.0; }))
    throw data::InputError(
        fmt::format("the reference of {} is 0 at every abscissa, but must have a value to compare with",
                    properties_of(quantity).name));
  if (properties_of(quantity).state == State::stick_slip)
    result.reference_uncertainty =
        distance(result.norm, result.reference, result.reference,
                 values_of(right_model(), coarser(problem), quantity, abscissa).value());
  add_wrong_models(
      result, [&](const auto& model) { return wrong_values(model, problem, quantity, abscissa); }, progress);
  return result;
}

ModelResults model_results(const std::vector<data::Case>& cases, Quantity quantity,
                           const std::vector<double>& abscissa, const std::function<void(double)>& progress) {
  const auto values_by = [&](const WrongModelRecipe& model) {
    OptionalValues all(std::in_place);
    for (std::size_t i = 0; all && i < cases.size(); ++i) {
      const auto one = wrong_values(model, cases[i], quantity, {abscissa[i]});
      if (one)
        all->push_back(one->front());
      else
        all.reset();
    }
    return all;
  };
  ModelResults result{.norm = properties_of(quantity).norm,
                      .reference = {},
                      .reference_uncertainty = closed_form_uncertainty,
                      .wrong_models = {}};
  for (std::size_t i = 0; i < cases.size(); ++i)
    result.reference.push_back(reference_result(cases[i], quantity, {abscissa[i]}).front());
  add_wrong_models(result, values_by, progress);
  return result;
}

std::vector<WrongModelEffect> wrong_model_effects(const data::Case& problem, double stick_duration,
                                                  double contact_duration) {
  const double hz = problem.excitation().frequency_hz();
  const data::Case held = with_value(with(problem, data::Damping()), "excitation.duration", stick_duration),
                   sliding = with_value(problem, "excitation.duration", contact_duration);
  const ModelResults stick = model_results(held, stick_frequency, {1.0}),
                     slip = model_results(held, slip_frequency, {1.0}),
                     largest = model_results(held, force_maximum, {hz}),
                     force = model_results(held, stick_force, times_up_to(stick_duration)),
                     displacement = model_results(held, stick_displacement, times_up_to(stick_duration)),
                     first_slip = model_results(sliding, contact_event, {1.0}),
                     tip = model_results(sliding, tip_displacement, times_up_to(contact_duration));
  std::vector<WrongModelEffect> effects;
  for (const WrongModel& wrong_model : wrong_models())
    effects.push_back({.wrong_model = wrong_model,
                       .stick_frequency = relative_change(stick, wrong_model.name),
                       .slip_frequency = relative_change(slip, wrong_model.name),
                       .force_maximum = relative_change(largest, wrong_model.name),
                       .stick_force = distance_of(force, wrong_model.name),
                       .stick_displacement = distance_of(displacement, wrong_model.name),
                       .first_slip = relative_change(first_slip, wrong_model.name),
                       .tip_displacement = distance_of(tip, wrong_model.name)});
  return effects;
}

}  // namespace stickslip::comparison
