// SPDX-License-Identifier: MIT
#pragma once

/// Structures that are given by their matrices: the beam of a case on Hermite elements, and random ones.

#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "support/random_cases.hpp"

namespace stickslip::testing {

/// The case with these matrices in place of its structure, and the same normal force. Its damping stays.
inline data::Case with_matrices(data::Case problem, data::StructureMatrices matrices) {
  if (!problem.is_force()) matrices.load.clear();
  problem.structure = data::Model(problem.normal_force(),
                                  std::make_shared<const data::StructureMatrices>(std::move(matrices)));
  problem.section = {};
  return problem;
}

/// M, K - P K_G of the beam on equal Hermite elements, all degrees of freedom included: (w_0, θ_0, ..., w_n, θ_n), with w_0
/// moved by the base, θ_0 fixed, the contact at w_n; C = η K. P keeps its direction, χ = 1.
inline data::StructureMatrices beam_matrices(const data::Beam& beam, int elements,
                                             double kelvin_voigt = 0.0) {
  const double l = beam.length() / elements, bending = rigidity(beam) / (l * l * l),
               mass = beam.density() * beam.area() * l / 420.0, force = beam.axial_force() / (30.0 * l);
  const std::array<std::array<double, 4>, 4> stiffness{{{12.0, 6.0 * l, -12.0, 6.0 * l},
                                                        {6.0 * l, 4.0 * l * l, -6.0 * l, 2.0 * l * l},
                                                        {-12.0, -6.0 * l, 12.0, -6.0 * l},
                                                        {6.0 * l, 2.0 * l * l, -6.0 * l, 4.0 * l * l}}},
      inertia{{{156.0, 22.0 * l, 54.0, -13.0 * l},
               {22.0 * l, 4.0 * l * l, 13.0 * l, -3.0 * l * l},
               {54.0, 13.0 * l, 156.0, -22.0 * l},
               {-13.0 * l, -3.0 * l * l, -22.0 * l, 4.0 * l * l}}},
      geometric{{{36.0, 3.0 * l, -36.0, 3.0 * l},
                 {3.0 * l, 4.0 * l * l, -3.0 * l, -l * l},
                 {-36.0, -3.0 * l, 36.0, -3.0 * l},
                 {3.0 * l, -l * l, -3.0 * l, 4.0 * l * l}}};
  data::StructureMatrices matrices{.rows = 2 * (elements + 1),
                                   .mass = {},
                                   .stiffness = {},
                                   .damping = {},
                                   .base = {0},
                                   .fixed = {1},
                                   .contact = {{2 * elements}},
                                   .load = {},
                                   .files = {}};
  for (int element = 0; element < elements; ++element)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
        const int row = 2 * element + i, column = 2 * element + j;
        matrices.mass.push_back({row, column, mass * inertia[a][b]});
        matrices.stiffness.push_back({row, column, bending * stiffness[a][b] - force * geometric[a][b]});
        if (kelvin_voigt > 0.0)
          matrices.damping.push_back({row, column, kelvin_voigt * bending * stiffness[a][b]});
      }
  return matrices;
}

/// What a random structure may have.
struct StructureRange {
  int fewest_rows{2}, most_rows{60};
  bool massless_contact{};
  double damping{};  ///< of critical, about, at the excitation; 0: none
};

/// Masses of about 1 kg in a chain with random further springs, some of them to a fixed row, and dampers beside the springs. Row 0 is the
/// base, row 1 fixed. A third of the structures has rows without mass, which no damper acts on, a third a contact of two rows, and a third twins: two equal
/// oscillators on one row, whose frequencies are next to each other.
inline data::StructureMatrices random_matrices(RandomNumbers& numbers, const StructureRange& range) {
  const int rows = numbers.whole(std::max(range.fewest_rows, 1), range.most_rows) + 2;
  data::StructureMatrices matrices{.rows = rows,
                                   .mass = {},
                                   .stiffness = {},
                                   .damping = {},
                                   .base = {0},
                                   .fixed = {1},
                                   .contact = {{rows - 1}},
                                   .load = {{numbers.whole(2, rows - 1), numbers.uniform(0.5, 2.0)}},
                                   .files = {}};
  const auto link = [&](int a, int b, double stiffness) {
    const double damper = 2e-3 * range.damping * stiffness * numbers.uniform(0.5, 2.0);
    for (const auto& [row, column, sign] : {std::tuple{a, a, 1.0}, {b, b, 1.0}, {a, b, -1.0}, {b, a, -1.0}}) {
      matrices.stiffness.push_back({row, column, sign * stiffness});
      if (damper > 0.0) matrices.damping.push_back({row, column, sign * damper});
    }
  };
  std::set<int> massless;
  const bool has_massless = numbers.whole(0, 2) == 0, has_twins = numbers.whole(0, 2) == 0;
  for (int row = 2; row < rows; ++row) {
    link(row == 2 ? 0 : row - 1, row, numbers.log_uniform(3e3, 3e5));
    if (numbers.whole(0, 3) == 0) link(numbers.whole(0, 1), row, numbers.log_uniform(1e2, 1e4));
    if (row > 3 && numbers.whole(0, 2) == 0)
      link(numbers.whole(2, row - 2), row, numbers.log_uniform(1e3, 1e5));
    const bool is_massless =
        row == rows - 1 ? range.massless_contact : has_massless && numbers.whole(0, 3) == 0;
    if (!is_massless) matrices.mass.push_back({row, row, numbers.uniform(0.5, 2.0)});
    if (is_massless && row < rows - 1) massless.insert(row);
  }
  std::erase_if(matrices.damping, [&](const auto& entry) {
    return massless.contains(entry.row) || massless.contains(entry.column);
  });
  if (has_twins) {
    const int first = matrices.rows;
    matrices.rows += 2;
    for (const int twin : {first, first + 1}) {
      link(2, twin, 1e4 * (1.0 + 1e-7 * (twin - first)));
      matrices.mass.push_back({twin, twin, 1.0});
    }
  }
  if (rows > 4 && numbers.whole(0, 2) == 0) {
    const double weight = numbers.uniform(0.2, 0.8);
    matrices.contact = {{rows - 1, weight}, {rows - 2, 1.0 - weight}};
  }
  return matrices;
}

/// As Matrix Market, with entries that add.
inline void write_matrix(const std::filesystem::path& file, int rows,
                         const std::vector<data::MatrixEntry>& entries) {
  std::ofstream stream(file);
  stream << "%%MatrixMarket matrix coordinate real general\n"
         << rows << " " << rows << " " << entries.size() << "\n";
  for (const auto& [row, column, value] : entries)
    stream << row + 1 << " " << column + 1 << " " << data::shortest_text(value) << "\n";
}

/// A random case with a model: one mass, or matrices in files of the folder. Half of them has damping, a third of the others a shaker.
inline CaseText random_model(RandomNumbers& numbers, const std::filesystem::path& folder) {
  CaseText text;
  const bool is_damped = numbers.whole(0, 1) == 0;
  const double mu = numbers.uniform(0.2, 0.8);
  text.set("model.normal_force", numbers.log_uniform(1.0, 100.0));
  text.set("friction.static_coefficient", mu);
  text.set("excitation.frequency_hz", numbers.log_uniform(1.0, 20.0));
  text.set("excitation.duration", numbers.uniform(0.2, 1.0));
  text.set("excitation.amplitude", numbers.log_uniform(1e-5, 1e-3));
  if (numbers.whole(0, 2) == 0) {
    text.set("model.mass", numbers.log_uniform(0.1, 10.0));
    text.set("model.stiffness", numbers.log_uniform(1e3, 1e5));
    if (is_damped) text.set("model.damping", numbers.log_uniform(1.0, 100.0));
    return text;
  }
  const data::StructureMatrices matrices =
      random_matrices(numbers, {.most_rows = 24, .damping = is_damped ? 1.0 : 0.0});
  const auto list = [](const std::vector<data::WeightedRow>& rows) {
    std::string numbers_of_rows, weights;
    for (const auto& [row, weight] : rows) {
      numbers_of_rows += (numbers_of_rows.empty() ? "" : ", ") + std::to_string(row + 1);
      weights += (weights.empty() ? "" : ", ") + data::shortest_text(weight);
    }
    return "{ rows = [" + numbers_of_rows + "], weights = [" + weights + "] }";
  };
  write_matrix(folder / "m.mtx", matrices.rows, matrices.mass);
  write_matrix(folder / "k.mtx", matrices.rows, matrices.stiffness);
  text.set("model.mass_matrix", "\"m.mtx\"");
  text.set("model.stiffness_matrix", "\"k.mtx\"");
  if (is_damped) {
    write_matrix(folder / "c.mtx", matrices.rows, matrices.damping);
    text.set("model.damping_matrix", "\"c.mtx\"");
  }
  text.set("model.base", "[1]");
  text.set("model.fixed", "[2]");
  text.set("model.contact", list(matrices.contact));
  if (numbers.whole(0, 2) == 0) {
    text.erase("excitation.amplitude");
    text.set("excitation.force", numbers.log_uniform(0.1, 10.0));
    text.set("model.load", list(matrices.load));
  }
  return text;
}

/// Calls claim(matrices, numbers) for `count` random structures.
template <typename Claim>
void on_random_structures(int count, const StructureRange& range, Claim&& claim) {
  for (int i = 0; i < count; ++i) {
    RandomNumbers numbers(62 + static_cast<std::uint64_t>(i));
    const data::StructureMatrices matrices = random_matrices(numbers, range);
    SCOPED_TRACE("random structure " + std::to_string(i) + " of " + std::to_string(matrices.rows) + " rows");
    claim(matrices, numbers);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

}  // namespace stickslip::testing
