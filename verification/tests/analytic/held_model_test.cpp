// SPDX-License-Identifier: MIT
/// A structure given by its matrices, in the modes of its held contact: the reaction in stick of the beam as matrices, of random
/// structures against their whole matrices, and what is refused.

#include "stickslip/analytic/held_model.hpp"

#include <Eigen/Dense>

#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/damped_reaction.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/stick_reaction.hpp"
#include "studies/history/natural_frequencies.hpp"
#include "support/paper_case.hpp"
#include "support/structures.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using analytic::damped_reaction;
using analytic::DampedReaction;
using analytic::held_structure;
using analytic::HeldStructure;
using analytic::SteadyPart;
using analytic::StickReaction;
using Complex = std::complex<double>;
using std::numbers::pi;

constexpr int elements = 20, all_modes = 2 * elements - 1;

// --- The paper's beam, with an axial force that keeps its direction

data::Case beam_case(double hz, double kelvin_voigt = 0.0, bool wall_with_base = false) {
  data::BeamProperties properties = paper_beam_properties();
  properties.axial_direction = 1.0;
  data::Case problem = paper_problem(hz, 1.0, 10.0);
  problem.contact.wall = data::Wall({.with_base = wall_with_base});
  return with(problem, data::Beam(properties), data::Damping({.kelvin_voigt = kelvin_voigt}));
}

// The same as matrices, with so many modes.
data::Case as_matrices(const data::Case& beam, int modes) {
  data::Case problem = with_matrices(beam, beam_matrices(beam.beam(), elements, beam.damping.kelvin_voigt()));
  problem.damping = {};
  data::NumericalChoices choices = problem.numerics.choices();
  choices.modes = modes;
  problem.numerics = data::NumericalSettings(choices);
  return problem;
}

constexpr std::array six_frequencies{5.0, 15.0, 35.0, 70.0, 120.0, 200.0};
constexpr double two_percent = 2.5e-4;  // s, of the first mode

// The largest force of as many modes as numerics says, the others as residual mass.
double largest_force(const data::Case& problem) { return StickReaction(problem).largest().midpoint(); }

STICKSLIP_VERIFIES(HeldModel, "A13");
TEST(HeldModel, HasForceOfDampedBeam) {
  for (const double hz : six_frequencies)
    for (const bool with_base : {false, true}) {
      const data::Case beam = beam_case(hz, two_percent, with_base);
      const double expected = StickReaction(beam, 40).largest().midpoint();
      for (const int modes : {all_modes, 20})
        EXPECT_TRUE(within(largest_force(as_matrices(beam, modes)), expected,
                           reference(1e-4 * expected, "20 Hermite elements with 2 % damping")))
            << fmt::format("{} Hz, {} modes, wall with base: {}", hz, modes, with_base);
    }
}

// Undamped, each free vibration B sin(w t) keeps the phase error of its frequency, up to w e T with the error e of the mesh. Everything
// else is off by about e of the modes next to the excitation, 1e-4 here.
TEST(HeldModel, HasForceOfUndampedBeam) {
  for (const double hz : six_frequencies) {
    const data::Case beam = beam_case(hz);
    const double omega = 2.0 * pi * hz, expected = StickReaction(beam, 200).largest().midpoint();
    double predicted = 0.0;
    for (const auto& [natural, coefficient] : analytic::held_modes(beam, 20)) {
      const double vibration =
          coefficient * std::pow(omega, 3) / ((omega * omega - natural * natural) * natural);
      const double phase =
          natural * beam.numerics.duration() *
          studies::mesh_frequency_error(beam.beam(), natural, beam.beam().length() / elements);
      predicted += std::abs(vibration) * std::min(phase, 2.0);
    }
    EXPECT_TRUE(within(largest_force(as_matrices(beam, all_modes)), expected,
                       discretisation(predicted + 1e-4 * expected, 1.0, "phases of free vibrations")))
        << hz << " Hz";
  }
}

TEST(HeldModel, NeedsTwentyModesWithResidualMass) {
  for (const double hz : six_frequencies)
    for (const bool with_base : {false, true}) {
      const data::Case beam = beam_case(hz, 0.0, with_base);
      const double expected = largest_force(as_matrices(beam, all_modes));
      EXPECT_TRUE(within(largest_force(as_matrices(beam, 20)), expected,
                         reference(1e-4 * expected, "20 modes with residual mass")))
          << fmt::format("{} Hz, wall with base: {}", hz, with_base);
    }
}

// --- Random structures

// f/h of exp(s t), from the numbers of the closed form.
Complex transfer(const DampedReaction& reaction, Complex s) {
  Complex sum = reaction.quasi_static + s * (reaction.rate - s * reaction.inertia);
  for (const auto& share : reaction.shares)
    sum += 0.5 * s *
           ((share.cosine - s * share.sine) / (s - share.eigenvalue) +
            (std::conj(share.cosine) - s * std::conj(share.sine)) / (s - std::conj(share.eigenvalue)));
  return sum;
}

Eigen::MatrixXd dense(int rows, const std::vector<data::MatrixEntry>& entries) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(rows, rows);
  for (const auto& [row, column, value] : entries) matrix(row, column) += value;
  return matrix;
}

// The same from the whole matrices in the frame at rest: the free rows are Z z + v y_c with a basis Z of what leaves the contact where
// it is, and f_d is the force along v, for which the contact moves by 1.
Complex transfer(const data::Case& problem, Complex s) {
  const data::StructureMatrices& given = problem.model()->matrices();
  const int rows = given.rows;
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(rows), base = weights, load = weights;
  for (const auto& [row, weight] : given.contact) weights[row] = weight;
  for (const auto& [row, weight] : given.load) load[row] = weight;
  Eigen::MatrixXd constraints = weights.transpose();
  for (const auto* held : {&given.base, &given.fixed})
    for (const int row : *held) {
      constraints.conservativeResize(constraints.rows() + 1, rows);
      constraints.bottomRows<1>() = Eigen::RowVectorXd::Unit(rows, row);
    }
  for (const int row : given.base) base[row] = 1.0;
  const Eigen::MatrixXd free = Eigen::FullPivLU<Eigen::MatrixXd>(constraints).kernel();
  const Eigen::VectorXd along = weights / weights.squaredNorm();
  const Eigen::MatrixXd m = dense(rows, given.mass), k = dense(rows, given.stiffness),
                        c = dense(rows, given.damping);
  const auto held =
      [&](const Eigen::VectorXd& motion) -> Eigen::VectorXd {  // static under a motion of base and contact
    return motion - free * (free.transpose() * k * free).llt().solve(free.transpose() * (k * motion));
  };
  const bool is_force = problem.excitation().is_force();
  const double with_wall = is_force || problem.contact.wall.moves_with_base() ? 1.0 : 0.0;  // y_c/h
  const Eigen::VectorXd frame = held(base + along), sigma = held(along);
  const data::Damping& damping = problem.damping;
  Eigen::MatrixXd relative = damping.mass_proportional() * m + damping.kelvin_voigt() * k;
  if (damping.has_ratio()) {
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(free.transpose() * m * free,
                                                                          free.transpose() * k * free);
    for (Eigen::Index n = 0; n < modes.eigenvalues().size(); ++n) {
      const double squared = 1.0 / modes.eigenvalues().reverse()[n];
      if (!(squared > 0.0 && squared < 1e11)) break;
      const Eigen::VectorXd shape =
          free * modes.eigenvectors().rowwise().reverse().col(n) * std::sqrt(squared);
      const Eigen::VectorXd momentum = m * shape - weights * sigma.dot(m * shape);
      relative += 2.0 * damping.ratio_of(static_cast<std::size_t>(n) + 1) * std::sqrt(squared) * momentum *
                  momentum.transpose();
    }
  }
  const Eigen::MatrixXcd impedance = s * s * m + s * (c + relative) + k.cast<Complex>();
  Eigen::VectorXcd prescribed = (base + with_wall * along).cast<Complex>(),
                   force = s * (relative * frame).cast<Complex>();
  if (is_force) {
    prescribed.setZero();
    force = -s * s * load;
  }
  const Eigen::MatrixXcd z = free.cast<Complex>();
  const Eigen::VectorXcd motion =
      prescribed + z * (free.transpose() * impedance * z)
                           .partialPivLu()
                           .solve(free.transpose() * (force - impedance * prescribed));
  return along.cast<Complex>().dot(force - impedance * motion);
}

// On a base or under a force, a wall at rest or with the base, damped by matrices, by [damping] or not.
data::Case random_case_of(data::StructureMatrices matrices, RandomNumbers& numbers) {
  if (numbers.whole(0, 1) == 0) matrices.damping.clear();
  data::DampingProperties damping;
  if (numbers.whole(0, 1) == 0) damping = {.kelvin_voigt = 1e-4, .mass_proportional = 3.0};
  if (numbers.whole(0, 1) == 0 && matrices.damping.empty()) damping.ratios = {0.01, 0.03, 0.02};
  data::Case problem = paper_problem(1.0, 1.0, 2.0);
  problem.contact.wall = data::Wall({.with_base = numbers.whole(0, 1) == 0});
  problem = with_matrices(std::move(problem), std::move(matrices));
  problem.damping = data::Damping(damping);
  const double first = analytic::held_modes(problem, 1).front().angular_frequency;
  const auto kind = numbers.whole(0, 2) == 0 ? data::AmplitudeOf::force : data::AmplitudeOf::displacement;
  problem.motion = data::HarmonicExcitation({.frequency_hz = first * numbers.uniform(0.3, 2.5) / (2.0 * pi),
                                             .amplitude = 1.0,
                                             .amplitude_of = kind});
  return problem;
}

constexpr int plenty = 200;

// Rounding relative to the lowest mode: up to 1e4 times the highest frequency squared here.
TEST(HeldModel, HasReactionOfWholeMatrices) {
  for (const bool massless : {false, true})
    on_random_structures(
        60, {.massless_contact = massless, .damping = 1.0}, [&](const auto& matrices, auto& numbers) {
          const data::Case problem = random_case_of(matrices, numbers);
          const HeldStructure structure = held_structure(problem, plenty);
          const DampedReaction reaction = damped_reaction(structure, SteadyPart::exact);
          for (int i = 0; i < 4; ++i) {
            const Complex s = structure.angular_frequency.front() *
                              Complex(numbers.uniform(0.0, 0.3), numbers.uniform(0.1, 4.0));
            const Complex expected = transfer(problem, s);
            EXPECT_TRUE(within(transfer(reaction, s), expected,
                               reference(1e-8 * (std::abs(expected) + std::abs(reaction.quasi_static)),
                                         "rounding, empirical")));
          }
        });
}

// With the difference of the closed forms of few modes and of all at random times.
TEST(HeldModel, BoundsWhatModesLeftOutChange) {
  on_random_structures(40, {.fewest_rows = 8}, [](const auto& matrices, auto& numbers) {
    const data::Case problem = random_case_of(matrices, numbers);
    if (!problem.model()->matrices().damping.empty()) return;  // this has no such bound
    const HeldStructure all = held_structure(problem, plenty);
    const double omega = 2.0 * pi * problem.excitation().frequency_hz(),
                 duration = problem.numerics.duration();
    const analytic::DampedForce exact(damped_reaction(all, SteadyPart::exact), omega, duration);
    for (int modes = 3; modes < static_cast<int>(all.modes()); modes += 4) {
      const HeldStructure few = held_structure(problem, modes);
      if (few.omitted.angular_frequency < 1.5 * omega) continue;
      const analytic::DampedForce force(damped_reaction(few, SteadyPart::exact), omega, duration);
      const auto omitted = analytic::omitted_force(problem, few);
      const double rounding = 1e-7 * exact.steady_amplitude();
      for (int i = 0; i < 50; ++i) {
        const double t = numbers.uniform(0.0, i < 25 ? 0.02 * duration : duration);
        EXPECT_LE(std::abs(force.value(t) - exact.value(t)), omitted.start_up + rounding)
            << modes << " modes";
      }
      EXPECT_LE(std::abs(force.steady_amplitude() - exact.steady_amplitude()), omitted.steady + rounding);
    }
  });
}

// Equal masses on equal springs: with both ends held, w_n = 2 sqrt(k/m) sin(n pi/(2 N)), and sigma falls linearly from the contact to the
// base. 700 rows are ARPACK's.
TEST(HeldModel, HasModesOfLongChain) {
  constexpr int last = 700;
  constexpr double mass = 2.0, stiffness = 3e6;
  data::StructureMatrices chain{.rows = last + 1,
                                .mass = {},
                                .stiffness = {},
                                .damping = {},
                                .base = {0},
                                .fixed = {},
                                .contact = {{last}},
                                .load = {},
                                .files = {}};
  for (int row = 1; row <= last; ++row) {
    chain.mass.push_back({row, row, mass});
    for (const auto& [i, j, sign] :
         {std::tuple{row, row, 1.0}, {row - 1, row - 1, 1.0}, {row, row - 1, -1.0}, {row - 1, row, -1.0}})
      chain.stiffness.push_back({i, j, sign * stiffness});
  }
  const auto frequency = [](int n) {
    return 2.0 * std::sqrt(stiffness / mass) * std::sin(0.5 * n * pi / last);
  };
  // sum over the rows of U_n times 1 or times sigma
  const auto share = [](int n, bool of_sigma) {
    double sum = 0.0;
    for (int row = 1; row < last; ++row)
      sum +=
          std::sqrt(2.0 * mass / last) * std::sin(n * pi * row / last) * (of_sigma ? 1.0 * row / last : 1.0);
    return sum;
  };
  constexpr int modes = 30;
  const HeldStructure held = held_structure(with_matrices(paper_problem(1.0, 1.0), chain), modes);
  ASSERT_EQ(held.modes(), 30u);
  double contact = 0.0, load = 0.0;
  for (int n = 1; n < last; ++n) {
    const double a = share(n, true), p = share(n, false), omega = frequency(n);
    if (n > modes) {
      contact += a * a;
      load += std::pow((p - a) / omega, 2);
      continue;
    }
    const auto k = static_cast<std::size_t>(n) - 1;
    const Tolerance rounding = reference(1e-10, "rounding of 700 rows, empirical");
    EXPECT_TRUE(within(held.angular_frequency[k] / omega, 1.0, rounding));
    EXPECT_TRUE(within(std::abs(held.mass_coupling[k]) / std::abs(a), 1.0, rounding));
    EXPECT_TRUE(within(held.mass_coupling[k] * held.participation[k], a * p,
                       reference(1e-9 * mass * last, "rounding, empirical")));
  }
  EXPECT_TRUE(within(held.contact_stiffness, stiffness / last, round_off(last, last, stiffness / last)));
  EXPECT_TRUE(
      within(held.omitted.angular_frequency / frequency(modes + 1), 1.0, reference(1e-10, "rounding")));
  // The mass of the last row is the contact's own.
  EXPECT_TRUE(within(held.omitted.contact, contact + mass, reference(1e-8 * contact, "rounding")));
  EXPECT_TRUE(within(held.omitted.load, load, reference(1e-6 * load, "rounding")));
}

// --- One mass, a contact without mass, and what is refused

TEST(HeldModel, OfOneMassIsSpringAndDamper) {
  data::Case problem = paper_problem(7.0, 1.0);
  problem.structure = data::Model({.mass = 2.0, .stiffness = 300.0, .damping = 4.0, .normal_force = 10.0});
  const double omega = 14.0 * pi, expected = std::hypot(300.0, 4.0 * omega);
  EXPECT_TRUE(analytic::held_modes(problem, 5).empty());
  EXPECT_TRUE(analytic::free_vibrations(problem).empty());
  EXPECT_TRUE(within(analytic::steady_reaction(problem).midpoint(), expected, round_off(10, 1, expected)));
  EXPECT_TRUE(within(analytic::criterion_with_all_modes(problem).force_max.midpoint(), expected,
                     round_off(1e4, 1, expected)));
  problem.contact.wall = data::Wall({.with_base = true});  // f = -m h_tt
  EXPECT_TRUE(within(analytic::steady_reaction(problem).midpoint(), 2.0 * omega * omega,
                     round_off(10, 1, 2.0 * omega * omega)));
}

TEST(HeldModel, OfMasslessContactSticksAlone) {
  on_random_structures(10, {.massless_contact = true}, [](const auto& matrices, auto&) {
    if (matrices.contact.size() > 1) return;
    const data::Case problem = with_matrices(paper_problem(1.0, 1.0), matrices);
    EXPECT_EQ(held_structure(problem, plenty).free_mass(), 0.0);
    expect_error_message<data::FieldError>(
        [&] { (void)analytic::EventDriven(analytic::contact_model(problem, plenty)); },
        {"model.mass_matrix is 0 at the contact"});
  });
}

TEST(HeldModel, RefusesWhatIsNotHeldOrIndefinite) {
  const auto refusal = [](const auto& change) {
    data::StructureMatrices matrices = beam_matrices(paper_beam(), 4);
    change(matrices);
    return error_message_of<data::FieldError>(
        [&] { (void)held_structure(with_matrices(paper_problem(1.0, 1.0), matrices), 5); });
  };
  EXPECT_TRUE(holds(refusal([](auto& m) { m.stiffness.clear(); }),
                    "model.stiffness_matrix is 0 on the diagonal in row 3"));
  // A row that only itself holds.
  EXPECT_TRUE(holds(refusal([](auto& m) {
                      m.rows += 2;
                      for (const auto& [i, j, sign] :
                           {std::tuple{10, 10, 1.0}, {11, 11, 1.0}, {10, 11, -1.0}, {11, 10, -1.0}})
                        m.stiffness.push_back({i, j, sign * 1e5});
                    }),
                    "model.stiffness_matrix is not positive definite"));
  // A row without mass on a spring, with a damper.
  EXPECT_TRUE(holds(refusal([](auto& m) {
                      m.rows += 1;
                      m.stiffness.push_back({10, 10, 1e5});
                      m.damping.push_back({10, 10, 3.0});
                    }),
                    "model.damping_matrix is above 0 on the diagonal in row 11, which has no mass"));
  EXPECT_TRUE(holds(refusal([](auto& m) {
                      m.mass.push_back({4, 4, -100.0});
                    }),
                    "model.mass_matrix is indefinite"));
}

}  // namespace
}  // namespace stickslip::testing
