// SPDX-License-Identifier: MIT
#include "damped_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include "beam_constants.hpp"
#include "stickslip/analytic/held_beam.hpp"

namespace stickslip::analytic {
namespace {

using Values = ChebyshevTable::Values;

constexpr std::size_t apart = 3, by_pair = 6;  // s, inertia, r; by pair p, q, a_u, b_u, a_v, b_v

// Which one, or none if there are several.
enum class Kind { ratio, kelvin_voigt, mass_proportional, several };
Kind kind_of(const data::Damping& damping) {
  const auto& [kelvin_voigt, ratio, mass_proportional, ratios] = damping.properties();
  if (!ratios.empty() || (kelvin_voigt > 0.0) + (ratio > 0.0) + (mass_proportional > 0.0) != 1)
    return Kind::several;
  if (ratio > 0.0) return Kind::ratio;
  return kelvin_voigt > 0.0 ? Kind::kelvin_voigt : Kind::mass_proportional;
}

// Of the beam with L = EI = ρ A = 1.
data::Damping dimensionless(const data::Damping& damping, double q) {
  data::DampingProperties properties = damping.properties();
  switch (kind_of(damping)) {
    case Kind::ratio:
      properties.ratio = q;
      break;
    case Kind::kelvin_voigt:
      properties.kelvin_voigt = q;
      break;
    case Kind::mass_proportional:
      properties.mass_proportional = q;
      break;
    case Kind::several:
      properties.kelvin_voigt *= q, properties.mass_proportional /= q;
  }
  return data::Damping(properties);
}

// With the eigenvalues λ and λ' of a pair, of which a complex one has its conjugate,
//
//     u/(s - λ) + u'/(s - λ') = (a s + b)/(s² + p s + q).
using Pair = std::array<double, by_pair>;
Pair pair_of(const ModalShare& one, const ModalShare& other) {
  const auto &x = one.eigenvalue, &y = other.eigenvalue;
  return {-(x + y).real(),
          (x * y).real(),
          (one.sine + other.sine).real(),
          -(one.sine * y + other.sine * x).real(),
          (one.cosine + other.cosine).real(),
          -(one.cosine * y + other.cosine * x).real()};
}

// Of the real eigenvalues the slowest and the fastest are a pair, and so on inwards: the two that meet in critical damping are one.
std::optional<Values> values_of(const DampedReaction& reaction) {
  std::vector<ModalShare> real;
  std::vector<Pair> pairs;
  for (const ModalShare& share : reaction.shares) {
    if (share.eigenvalue.imag() == 0.0) {
      real.push_back(share);
      continue;
    }
    // Re z is half the sum of z and its conjugate.
    pairs.push_back(
        pair_of({share.eigenvalue, 0.5 * share.sine, 0.5 * share.cosine},
                {std::conj(share.eigenvalue), 0.5 * std::conj(share.sine), 0.5 * std::conj(share.cosine)}));
  }
  if (real.size() % 2 != 0) return std::nullopt;
  std::ranges::sort(real, {}, [](const ModalShare& share) { return share.eigenvalue.real(); });
  for (std::size_t i = 0; i < real.size() / 2; ++i)
    pairs.push_back(pair_of(real[i], real[real.size() - 1 - i]));
  std::ranges::sort(pairs, {}, [](const Pair& pair) { return pair[1]; });
  Values values{reaction.quasi_static, reaction.inertia, reaction.rate};
  for (const Pair& pair : pairs) values.insert(values.end(), pair.begin(), pair.end());
  return values;
}

void add_shares(std::vector<ModalShare>& shares, std::span<const double> pair) {
  const double q = pair[1], middle = -0.5 * pair[0];
  // Next to critical damping kept so far apart that the shares are finite; λ² changes by a few roundings of q.
  constexpr double least = 1e-14;
  const double apart_squared = middle * middle - q;
  const double distance = std::sqrt(std::max(std::abs(apart_squared), least * q));
  if (apart_squared > 0.0) {
    const double fast = middle - distance, slow = q / fast;
    const auto share = [&](double x, double y) -> ModalShare {
      return {x, (pair[2] * x + pair[3]) / (x - y), (pair[4] * x + pair[5]) / (x - y), {}};
    };
    shares.push_back(share(slow, fast));
    shares.push_back(share(fast, slow));
    return;
  }
  const auto share = [&](double a, double b) { return std::complex(a, -(b + a * middle) / distance); };
  shares.push_back({{middle, distance}, share(pair[2], pair[3]), share(pair[4], pair[5]), {}});
}

// From the largest magnitudes of the values.
Values allowed(const Values& largest) {
  constexpr double rounding = 16.0 * std::numeric_limits<double>::epsilon();
  double fastest = 0.0, slowest = std::numeric_limits<double>::infinity(), weight = 0.0;
  for (std::size_t f = apart; f < largest.size(); f += by_pair) {
    const double p = largest[f], q = largest[f + 1];
    fastest = std::max({fastest, p, std::sqrt(q)});
    slowest = std::min({slowest, std::sqrt(q), q / p});
    weight = std::max(weight, largest[f + 3] / q);
  }
  const double of_vectors = rounding * fastest / slowest, u = weight * slowest;
  Values result{of_vectors * largest[0], of_vectors, of_vectors * u};
  for (std::size_t f = apart; f < largest.size(); f += by_pair) {
    const double rate = std::sqrt(largest[f + 1]), sine = of_vectors * u, cosine = sine * slowest;
    result.insert(result.end(),
                  {rounding * fastest, rounding * fastest * rate, sine, sine * rate, cosine, cosine * rate});
  }
  return result;
}

}  // namespace

bool are_alike(const data::Case& one, const data::Case& other) {
  const Kind kind = kind_of(one.damping);
  return one.model() == nullptr && other.model() == nullptr && wall_share(one) == wall_share(other) &&
         one.beam().axial_direction() == other.beam().axial_direction() &&
         one.beam().shear_stiffness() == 0.0 && other.beam().shear_stiffness() == 0.0 &&
         kind == kind_of(other.damping) && (kind != Kind::several || one.damping == other.damping);
}

DampedNumbers damped_numbers(const data::Case& problem) {
  const double nu = frequency_unit(problem.beam());
  const data::DampingProperties& damping = problem.damping.properties();
  DampedNumbers numbers{.load_factor = axial_load_factor(problem.beam()), .damping = nu};
  if (kind_of(problem.damping) != Kind::several)  // two of them are 0
    numbers.damping = damping.ratio + damping.kelvin_voigt * nu + damping.mass_proportional / nu;
  return numbers;
}

DampedReactionTable::DampedReactionTable(const data::Case& first, ChebyshevTable table)
    : first_(first), table_(std::move(table)) {}

std::optional<DampedReactionTable> DampedReactionTable::of(const data::Case& first, const Bounds& load_factor,
                                                           const Bounds& damping, int modes, SteadyPart part,
                                                           std::size_t most_points) {
  const auto at = [&](double z, double q) -> std::optional<Values> {
    const data::Beam beam = dimensionless_beam(z, first.beam().axial_direction());
    HeldStructure structure = HeldBeam(beam, dimensionless(first.damping, q), modes).structure();
    structure.wall_share = wall_share(first);
    try {
      return values_of(damped_reaction(structure, part));
    } catch (const std::runtime_error&) {  // next to critical damping
      return std::nullopt;
    }
  };
  auto table = ChebyshevTable::of(at, load_factor, damping, allowed, most_points);
  if (!table) return std::nullopt;
  return DampedReactionTable(first, std::move(*table));
}

bool DampedReactionTable::holds(const data::Case& problem) const {
  if (!are_alike(problem, first_)) return false;
  const auto [z, q] = damped_numbers(problem);
  return table_.holds(z, q);
}

DampedReaction DampedReactionTable::at(const data::Case& problem) const {
  const data::Beam& beam = problem.beam();
  const double nu = frequency_unit(beam), mass = mass_per_length(beam) * beam.length();
  const auto [z, q] = damped_numbers(problem);
  const Values values = table_.at(z, q);
  DampedReaction reaction{.quasi_static = mass * nu * nu * values[0],
                          .inertia = mass * values[1],
                          .rate = mass * nu * values[2],
                          .shares = {}};
  for (std::size_t f = apart; f < values.size(); f += by_pair)
    add_shares(reaction.shares, std::span(values).subspan(f, by_pair));
  for (ModalShare& share : reaction.shares) {
    share.eigenvalue *= nu;
    share.sine *= mass * nu;
    share.cosine *= mass * nu * nu;
  }
  return reaction;
}

}  // namespace stickslip::analytic
