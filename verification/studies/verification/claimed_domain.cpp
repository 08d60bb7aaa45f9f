// SPDX-License-Identifier: MIT
#include "studies/verification/claimed_domain.hpp"

#include <fmt/format.h>
#include <gsl/gsl_qrng.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <stdexcept>
#include <string_view>
#include <type_traits>

#include "stickslip/analytic/damped_reaction.hpp"
#include "stickslip/analytic/held_beam.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/data/csv_text.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/analyses/criterion_answer.hpp"
#include "studies/common/parallel.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::studies {

namespace {

constexpr double amplitude_width = 1e-6;

// Calls see(name, number) for each column of the file, the members in their order.
void for_each_column(const DomainCase& one, const std::function<void(std::string_view, double)>& see) {
  visit_members(std::type_identity<DomainCase>{},
                [&](std::string_view name, std::string_view, auto number) { see(name, number(one)); });
}

DomainCase sobol_point(int index) {
  const auto& groups = domain_groups();
  const std::unique_ptr<gsl_qrng, decltype(&gsl_qrng_free)> points(
      gsl_qrng_alloc(gsl_qrng_sobol, static_cast<unsigned>(groups.size())), gsl_qrng_free);
  std::array<double, std::tuple_size_v<std::remove_cvref_t<decltype(groups)>>> x{};
  const bool inside = index > domain_cases;
  for (int i = inside ? domain_cases : 0; i < index; ++i) gsl_qrng_get(points.get(), x.data());
  DomainCase point{.index = static_cast<double>(index)};
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const double least = inside ? groups[i].margin_least : groups[i].least,
                 greatest = inside ? groups[i].margin_greatest : groups[i].greatest;
    point.*groups[i].value =
        groups[i].is_log ? least * std::pow(greatest / least, x[i]) : least + (greatest - least) * x[i];
  }
  return point;
}

// Corner 0, 1, ... of the domain of the margin: bit 0 chooses the load, bit 1 the duration, the others the frequency: the least, and the
// edges of the bands about the first two natural frequencies. All else is where the other models differ most.
DomainCase corner_point(const data::Beam& beam, int corner) {
  DomainCase point{.index = static_cast<double>(2 * domain_cases + 1 + corner)};
  for (const DomainGroup& group : domain_groups())
    point.*group.value =
        group.value == &DomainCase::slenderness || group.value == &DomainCase::contact_stiffness
            ? group.margin_least
            : group.margin_greatest;
  const auto& groups = domain_groups();
  if ((corner & 1) != 0) point.load = groups[0].margin_least;
  if ((corner & 2) != 0) point.periods = groups[2].margin_least;
  data::BeamProperties loaded = beam.properties();
  loaded.axial_force = point.load * analytic::stick_buckling_load(beam);
  const double second = stick_hz(data::Beam(loaded), 2) / stick_hz(data::Beam(loaded), 1);
  constexpr double below = 1.0 - resonance_distance - 1e-9, above = 1.0 + resonance_distance + 1e-9;
  point.frequency = std::array{groups[1].margin_least, below, above, below * second}.at(
      static_cast<std::size_t>(corner / 4));
  return point;
}

// The beam of the paper, with another area at the same mass per length.
data::Case problem_of(const data::Case& paper, const DomainCase& point) {
  data::BeamProperties beam = paper.beam().properties();
  const double mass = beam.density * beam.area;
  beam.area = beam.second_moment_of_area * std::pow(point.slenderness / beam.length, 2);
  beam.density = mass / beam.area;
  beam.axial_force = point.load * analytic::stick_buckling_load(data::Beam(beam));
  data::Case problem = with(paper, data::Beam(beam));
  const double first = stick_hz(problem.beam(), 1);
  problem =
      with(problem,
           data::FrictionLaw({.static_coefficient = point.friction, .kinetic_coefficient = point.friction}));
  problem = with_value(with_value(problem, "excitation.frequency_hz", point.frequency * first),
                       "excitation.duration", point.periods / first);
  return with_value(problem, "excitation.amplitude", 1e-3);
}

double critical_amplitude(const data::Case& problem) {
  return analytic::evaluate_criterion(problem, amplitude_width).critical_amplitude.midpoint();
}

// By a reaction with the exact steady part.
double critical_amplitude(const data::Case& problem, const analytic::DampedReaction& reaction) {
  return friction_limit(problem) /
         analytic::DampedForce(reaction, angular_frequency(problem.excitation()), problem.numerics.duration())
             .refined_to(amplitude_width)
             .midpoint();
}

// a of a = 1 - q a², with q P the fall of P at the amplitude of the constant force.
double with_draw_back(double q) { return 2.0 / (1.0 + std::sqrt(1.0 + 4.0 * q)); }

}  // namespace

const std::vector<std::pair<std::string, double DomainCase::*>>& domain_models() {
  static const std::vector<std::pair<std::string, double DomainCase::*>> models{
      {"finite elements", &DomainCase::finite_elements},
      {"shear and rotary inertia", &DomainCase::shear},
      {"contact that yields", &DomainCase::contact_change},
      {"draw-back of the tip", &DomainCase::draw_back},
      {"axial force of another direction", &DomainCase::direction_change},
      {"damping", &DomainCase::damping_change}};
  return models;
}

const std::array<DomainGroup, 9>& domain_groups() {
  static const std::array<DomainGroup, 9> groups{{
      {"P/P_{cr}", &DomainCase::load, 0.02, 0.8, false, 0.02, 0.5},
      {"\\Omega/\\omega_1", &DomainCase::frequency, 0.1, 6.0, true, 0.1, 4.0},
      {"\\omega_1T/2\\pi", &DomainCase::periods, 3.0, 300.0, true, 3.0, 300.0},
      {"\\mu_s", &DomainCase::friction, 0.1, 0.8, false, 0.1, 0.8},
      {"L/r", &DomainCase::slenderness, 20.0, 1000.0, true, 69.0, 1000.0},
      {"\\zeta", &DomainCase::damping, 1e-4, 0.05, true, 1e-4, 0.05},
      {"\\chi", &DomainCase::direction, 0.0, 1.0, false, 0.0, 1.0},
      {"k_tL^3/3EI", &DomainCase::contact_stiffness, 10.0, 1e5, true, 1e3, 1e5},
      {"k_PL^3/3EI", &DomainCase::spring, 1e-4, 1.0, true, 1e-4, 0.1},
  }};
  return groups;
}

DomainCase domain_case(const data::Case& paper, int index) {
  DomainCase one = index <= 2 * domain_cases ? sobol_point(index)
                                             : corner_point(paper.beam(), index - 2 * domain_cases - 1);
  const data::Case problem = problem_of(paper, one);
  const data::Beam& beam = problem.beam();
  const int modes = problem.numerics.modes();
  one.distance = 1.0;
  for (const auto& mode : analytic::stick_modes(beam, modes))
    one.distance =
        std::min(one.distance, std::abs(problem.excitation().frequency_hz() / mode.frequency_hz() - 1.0));
  const double limit = critical_amplitude(problem);
  one.amplitude = limit / beam.length();
  one.finite_elements = problem.excitation().amplitude() * friction_limit(problem) /
                            solver::max_abs_friction_force(problem) / limit -
                        1.0;
  one.shear = critical_amplitude(with(problem, with_shear(beam))) / limit - 1.0;
  one.direction_change =
      critical_amplitude(with_value(problem, "beam.axial_direction", one.direction)) / limit - 1.0;
  one.damping_change = critical_amplitude(with_value(problem, "damping.ratio", one.damping)) / limit - 1.0;
  const analytic::HeldBeam held(beam, {}, modes);
  one.contact_change =
      critical_amplitude(problem, analytic::compliant_reaction(held.structure(),
                                                               one.contact_stiffness * tip_stiffness(beam))) /
          critical_amplitude(problem,
                             analytic::damped_reaction(held.structure(), analytic::SteadyPart::exact)) -
      1.0;
  const double draw_back =
      held_bending(problem).value().draw_back * std::pow(limit / problem.excitation().amplitude(), 2);
  one.draw_back = with_draw_back(one.spring * tip_stiffness(beam) * draw_back / beam.axial_force()) - 1.0;
  return one;
}

bool is_in_margin(const DomainCase& one) {
  return one.distance >= resonance_distance &&
         std::ranges::all_of(domain_groups(), [&](const DomainGroup& group) {
           return one.*group.value >= group.margin_least && one.*group.value <= group.margin_greatest;
         });
}

std::string domain_text(const std::vector<DomainCase>& cases) {
  std::string text;
  const auto add = [&text](std::string_view cell) {
    text += fmt::format("{}{}", text.empty() || text.back() == '\n' ? "" : ",", cell);
  };
  for_each_column({}, [&](std::string_view name, double) { add(name); });
  text += "\n";
  for (const DomainCase& one : cases) {
    for_each_column(one, [&](std::string_view, double number) { add(fmt::format("{:.6g}", number)); });
    text += "\n";
  }
  return text;
}

std::filesystem::path domain_file() {
  return data::find_case("paper").parent_path().parent_path().parent_path() / "verification" / "studies" /
         "claimed-domain.csv";
}

std::vector<DomainCase> read_domain(const std::filesystem::path& file) {
  const std::string text = data::read_table_text(file);
  data::CsvReader reader(file, text);
  std::vector<DomainCase> cases;
  while (const auto row = reader.next_row()) {
    std::array<double, sizeof(DomainCase) / sizeof(double)> numbers{};  // members are numbers alone
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = reader.number(row->at(i)).value();
    cases.push_back(std::bit_cast<DomainCase>(numbers));
  }
  return cases;
}

void require_same(const DomainCase& kept, const DomainCase& computed) {
  std::vector<double> expected;
  for_each_column(computed, [&](std::string_view, double number) { expected.push_back(number); });
  std::size_t column = 0;
  for_each_column(kept, [&](std::string_view name, double number) {
    const double value = expected[column++];
    if (std::abs(number - value) > std::max(1e-5, 1e-4 * std::abs(value)))
      throw std::runtime_error(
          fmt::format("claimed-domain.csv: {} of case {} is {:.6g}, but {:.6g} is computed; the slow test "
                      "ClaimedDomain makes the file again",
                      name, kept.index, number, value));
  });
}

std::vector<DomainCase> drawn_rows(std::vector<DomainCase> cases, std::size_t count, std::string_view text) {
  std::seed_seq seed(text.begin(), text.end());
  std::mt19937 random(seed);
  std::ranges::shuffle(cases, random);
  cases.resize(std::min(count, cases.size()));
  return cases;
}

namespace {

ModelDeviation deviation(std::string model, const std::vector<DomainCase>& cases,
                         const std::function<double(const DomainCase&)>& change) {
  ModelDeviation result;
  result.model = std::move(model);
  std::vector<double> changes;
  for (const DomainCase& one : cases) {
    const double by = change(one);
    if (one.index <= 2 * domain_cases) changes.push_back(by);
    if (-by > result.worst) {
      result.worst = -by;
      result.place = one;
    }
  }
  result.cases = changes.size();
  result.bias = gsl_stats_mean(changes.data(), 1, changes.size());
  result.spread = gsl_stats_sd(changes.data(), 1, changes.size());
  result.unsafe_share =
      static_cast<double>(std::ranges::count_if(changes, [](double by) { return by < -1e-4; })) /
      static_cast<double>(changes.size());
  return result;
}

std::vector<ModelDeviation> domain_deviations(const std::vector<DomainCase>& cases) {
  std::vector<ModelDeviation> result;
  for (const auto& [name, change] : domain_models())
    result.push_back(
        deviation(name, cases, [change = change](const DomainCase& one) { return one.*change; }));
  result.push_back(deviation("all together", cases, [](const DomainCase& one) {
    double factor = 1.0;
    for (const auto& [name, change] : domain_models()) factor *= 1.0 + std::min(0.0, one.*change);
    return factor - 1.0;
  }));
  return result;
}

}  // namespace

ClaimedDomain claimed_domain(const data::Case& paper, std::size_t count, std::string_view text) {
  ClaimedDomain result;
  result.cases = read_domain(domain_file());
  const std::vector<DomainCase> drawn = drawn_rows(result.cases, count, text);
  in_parallel(drawn.size(), [&](std::size_t i) {
    require_same(drawn[i], domain_case(paper, static_cast<int>(drawn[i].index)));
  });
  result.recomputed = drawn.size();
  result.groups.assign(domain_groups().begin(), domain_groups().end());
  std::vector<DomainCase> box, inside;
  for (const DomainCase& one : result.cases)
    if (one.index <= domain_cases)
      box.push_back(one);
    else if (is_in_margin(one))
      inside.push_back(one);
  result.box = domain_deviations(box);
  result.margin = domain_deviations(inside);
  return result;
}

}  // namespace stickslip::studies
