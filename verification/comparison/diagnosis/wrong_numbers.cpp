// SPDX-License-Identifier: MIT
#include "comparison/diagnosis/wrong_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <utility>

#include "stickslip/analytic/event_driven.hpp"
#include "studies/common/parallel.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::comparison {

namespace {

using Values = std::vector<double>;

struct Tried {
  double number{}, distance{std::numeric_limits<double>::infinity()};
  Values values{};
};

Tried tried(const ComparedValues& values, const FreeNumber& free, double number) {
  Tried one{.number = number};
  try {
    if (auto result = free.result(number)) {
      one.values = *std::move(result);
      one.distance = distance(values.norm, values.reference, values.theirs, one.values);
    }
  } catch (const data::InputError&) {    // there is no such state,
  } catch (const std::runtime_error&) {  // or the numbers of its motion grow without a limit
  }
  return one;
}

// The step from one number to the least squares, by the slope between it and its neighbour.
double step_of(const ComparedValues& values, const Tried& here, const Tried& beside) {
  const Values scales = scales_of(values.norm, values.reference);
  double product = 0.0, square = 0.0;
  for (std::size_t i = 0; i < here.values.size(); ++i) {
    const double slope = (beside.values[i] - here.values[i]) / (beside.number - here.number) / scales[i];
    product += slope * (values.theirs[i] - here.values[i]) / scales[i];
    square += slope * slope;
  }
  return product / square;
}

// From one of the numbers that were tried on, within its neighbours. The slope is that to a neighbour as far away as the
// last step, so that what jitters over shorter distances, such as the largest force, does not mislead it.
Tried refined(const ComparedValues& values, const FreeNumber& free, Tried best, double enough) {
  constexpr int most = 16;
  const auto start = std::ranges::find(free.tried, best.number);
  const double from = start == free.tried.begin() ? *start : *std::prev(start),
               to = std::next(start) == free.tried.end() ? *start : *std::next(start);
  double width = 0.25 * (to - from);
  for (int runs = 0; runs < most && best.distance > enough; runs += 2) {
    Tried beside = tried(values, free, best.number + width);
    if (!std::isfinite(beside.distance)) {
      width *= -0.25;
      continue;
    }
    Tried next;
    if (const double step = step_of(values, best, beside); std::isfinite(step))
      next = tried(values, free, std::clamp(best.number + step, from, to));
    Tried& nearer = next.distance < beside.distance ? next : beside;
    const double moved = nearer.number - best.number;
    if (nearer.distance < best.distance && moved != 0.0)
      best = std::move(nearer), width = 0.5 * moved;
    else
      width *= -0.25;
  }
  return best;
}

Tried fitted(const ComparedValues& values, double uncertainty, double near, const FreeNumber& free) {
  constexpr double worth_fitting = 0.6, enough = 0.1;
  const double whole = distance(values.norm, values.reference, values.theirs, values.reference);
  std::vector<Tried> starts;
  for (const double number : free.tried) starts.push_back(tried(values, free, number));
  std::ranges::stable_sort(starts, {}, &Tried::distance);
  Tried best;
  for (std::size_t k = 0; k < 2; ++k)
    if (starts[k].distance < worth_fitting * whole && best.distance > near)
      if (Tried one = refined(values, free, starts[k], enough * uncertainty); one.distance < best.distance)
        best = std::move(one);
  return best;
}

// --- masses

using studies::two_pi;

double number(const Numbers& numbers, const std::string& key, double otherwise) {
  const auto found = numbers.find(key);
  return found == numbers.end() ? otherwise : found->second;
}

void start(analytic::EventDriven& run, const analytic::ContactModel& model,
           const std::vector<double>& amplitudes, const std::vector<double>& rates, double position,
           double velocity) {
  if (is_held(model, position, velocity))
    run.start_stuck(amplitudes, rates, position);
  else
    run.start_slipping(amplitudes, rates, position, velocity);
}

// Adds the rows up to `end`, or as many as are seen, of a run that starts at `begin`.
void add_rows(MassRows& rows, analytic::EventDriven& run, const MassRows& seen, double begin, double end) {
  const std::size_t before = rows.times.size(), most = seen.times.size();
  if (seen.changes.front() == "state") {
    for (const double time : seen.times) {
      run.advance_to(time);
      rows.changes.emplace_back("state");
      rows.times.push_back(time);
      rows.positions.push_back(run.contact_position());
    }
    return;
  }
  constexpr int parts = 20;
  for (int part = 1; part <= parts && before + run.events().size() < most; ++part)
    run.advance_to((end - begin) * part / parts);
  for (const data::ContactEvent& event : run.events()) {
    if (rows.times.size() == most) return;
    rows.changes.emplace_back(data::to_string(event.change));
    rows.times.push_back(begin + event.time);
    rows.positions.push_back(event.position);
  }
}

// N |v_s|, the mean from mean_from to mean_to, on a wall with the acceleration a sin(Omega t).
double mean_power(const Numbers& numbers) {
  analytic::ContactModel model = mass_model(numbers);
  const double omega = two_pi * numbers.at("plane_acceleration.frequency_hz");
  model.load_angular_frequency = omega;
  model.wall_amplitude = -numbers.at("amplitude") / (omega * omega);
  analytic::EventDriven run(model, {.tolerance = 1e-10, .keep_energy_balance = true});
  const double from = numbers.at("mean_from"), to = numbers.at("mean_to");
  run.advance_to(from);
  const double before = run.energy_balance().friction_loss;
  run.advance_to(to);
  return (run.energy_balance().friction_loss - before) / (to - from) * numbers.at("normal_force") /
         numbers.at("friction_force");
}

// The captures in a period of the force, with a stiffness and a friction force of 1.
double stops(const Numbers& numbers) {
  const double omega = numbers.at("frequency_ratio"), to = two_pi / omega * numbers.at("period");
  analytic::EventDriven run(mass_model({{"stiffness", 1.0},
                                        {"friction_force", 1.0},
                                        {"force.amplitude", numbers.at("force_ratio")},
                                        {"force.angular_frequency", omega}}));
  run.advance_to(to);
  return static_cast<double>(std::ranges::count_if(run.events(), [&](const data::ContactEvent& event) {
    return event.change == data::ContactChange::capture && event.time > to - two_pi / omega;
  }));
}

}  // namespace

std::optional<Hypothesis> wrong_number(const ComparedValues& values, double uncertainty,
                                       const std::vector<FreeNumber>& numbers) {
  constexpr double least_ratio = 100.0;
  const double whole = distance(values.norm, values.reference, values.theirs, values.reference);
  const double nearest = std::max(2.0 * uncertainty, whole / least_ratio);
  if (!(whole > uncertainty)) return std::nullopt;  // nothing is to be explained
  const double ratio = required_ratio(values.theirs.size(), 1, static_cast<int>(numbers.size()));
  std::vector<Hypothesis> found(numbers.size(), {.distance = std::numeric_limits<double>::infinity()});
  studies::in_parallel(numbers.size(), [&](std::size_t i) {
    const Tried best = fitted(values, uncertainty, nearest, numbers[i]);
    if (best.distance <= std::min(nearest, whole / ratio))
      found[i] = {.name = "wrong-number",
                  .values = best.values,
                  .free = 1,
                  .sentence = numbers[i].sentence(best.number),
                  .distance = best.distance,
                  .from_reference = distance(values.norm, values.reference, best.values, values.reference)};
  });
  std::erase_if(found, [](const Hypothesis& one) { return !std::isfinite(one.distance); });
  std::ranges::sort(found, {}, &Hypothesis::distance);
  if (found.empty()) return std::nullopt;
  Hypothesis best = found.front();
  for (std::size_t i = 1; i < found.size(); ++i)
    if (distance(values.norm, values.reference, found[i].values, best.values) <= nearest)
      best.sentence += ", or" + found[i].sentence.substr(4);
  return best;
}

Numbers numbers_of_mass(const data::Resource& resource, const std::string& group) {
  Numbers numbers;
  if (!resource.stated.beam.empty() || resource.field("beam") != nullptr) return numbers;
  const auto is = group.find(" = ");
  const std::string prefix = is == std::string::npos ? "" : group.substr(is + 3) + ".";
  for (const auto& [key, value] : resource.stated.numbers)
    if (key.starts_with(prefix)) numbers[key.substr(prefix.size())] = value;
  if (numbers.contains("friction_force") && !prefix.empty()) numbers["mu_s/mu_k"] = 1.0;
  return numbers;
}

analytic::ContactModel mass_model(const Numbers& numbers, double pull) {
  const auto of = [&](const char* key, double otherwise) { return number(numbers, key, otherwise); };
  const double mass = of("mass", 1.0), gravity = of("gravity", 0.0), slope = of("slope", 0.0);
  const double weight = mass * gravity / std::hypot(1.0, slope);
  analytic::ContactModel model;
  model.contact_mass = mass;
  model.contact_stiffness = of("stiffness", 0.0);
  model.load = {of("force.amplitude", 0.0)};
  model.load_angular_frequency = of("force.angular_frequency", 1.0);
  model.contact_force = slope * weight + pull;
  const double kinetic = of("kinetic_coefficient", 1.0);
  data::FrictionCoefficients friction{
      .static_coefficient = std::max(of("static_coefficient", kinetic * of("mu_s/mu_k", 1.0)), kinetic),
      .kinetic_coefficient = kinetic};
  if (friction.static_coefficient != friction.kinetic_coefficient)
    friction.decay = std::numeric_limits<double>::infinity();
  model.friction = data::FrictionLaw(friction);
  model.normal_force = gravity > 0.0 ? weight : of("friction_force", of("normal_force", 0.0));
  if (numbers.contains("other_mass")) {
    const double other = of("other_mass", mass);
    model.angular_frequency = {std::sqrt(of("coupling", 0.0) / other)};
    model.mass_coupling = {std::sqrt(other)};
    model.contact_mass = mass + other;
    model.follower = {0.0};
    model.load = {0.0, model.load[0]};
  }
  return model;
}

bool is_held(const analytic::ContactModel& model, double position, double velocity) {
  return velocity == 0.0 && std::abs(model.contact_stiffness * position - model.contact_force) <=
                                model.friction.static_coefficient() * model.normal_force;
}

std::optional<MassRows> mass_rows(const Numbers& numbers, const MassRows& seen) {
  const double pull = number(numbers, "pull.force", 0.0), until = number(numbers, "pull.until", 0.0);
  if (seen.times.empty() || until < 0.0) return std::nullopt;
  const double end = std::max(until, 2.0 * seen.times.back());
  const analytic::ContactModel model = mass_model(numbers, pull);
  MassRows rows;
  analytic::EventDriven run(model);
  const double position = number(numbers, "position", 0.0), velocity = number(numbers, "velocity", 0.0);
  if (!numbers.contains("other_mass")) {
    start(run, model, {}, {}, position, velocity);
    add_rows(rows, run, seen, 0.0, end);
  } else {
    const double stretch = pull / numbers.at("coupling") * std::sqrt(numbers.at("other_mass"));
    start(run, model, {-stretch}, {0.0}, position, velocity);
    add_rows(rows, run, seen, 0.0, until);
    run.advance_to(until);
    const analytic::ContactModel free = mass_model(numbers);
    analytic::EventDriven on(free);
    start(on, free, {run.amplitudes()[0] + stretch}, run.rates(), run.contact_position(),
          run.contact_velocity());
    add_rows(rows, on, seen, until, end);
  }
  return rows.changes == seen.changes ? std::optional(rows) : std::nullopt;
}

std::optional<double> mass_value(const Numbers& numbers, const std::string& name) {
  const double from = number(numbers, "mean_from", -1.0), to = number(numbers, "mean_to", 0.0);
  if (name == "power" && 0.0 <= from && from < to) return mean_power(numbers);
  if (name == "stops" && number(numbers, "period", -1.0) >= 0.0) return stops(numbers);
  return std::nullopt;
}

}  // namespace stickslip::comparison
