// SPDX-License-Identifier: MIT
/// The published data: what is in the repository is what the code makes, and every file says where it is
/// from.

#include <Eigen/LU>
#include <nlohmann/json.hpp>

#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/analytic/timoshenko_modes.hpp"
#include "stickslip/data/atomic_file.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/data/reference.hpp"
#include "stickslip/reference/package.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/modal_stick_run.hpp"
#include "studies/verification/finite_element_contact_model.hpp"
#include "support/published_data.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

namespace fs = std::filesystem;

std::vector<reference::DataSet> quick_sets() {
  std::vector<reference::DataSet> sets;
  for (const reference::Recipe& recipe : reference::recipes())
    if (recipe.is_quick) sets.push_back(recipe.make());
  return sets;
}

// To a quarter: they have two printed digits, and some are differences, with the rounding of both sides.
void expect_same_half_widths(const data::ReferencePackage& package,
                             const std::vector<reference::DataSet>& sets) {
  int compared = 0;
  for (const reference::DataSet& set : sets) {
    if (set.resource.provenance.value_class != data::ValueClass::converged) continue;
    const data::ReferenceTable published = data::read_table(package, set.resource.name);
    for (std::size_t column = 0; column < set.resource.fields.size(); ++column) {
      const std::string& name = set.resource.fields[column].name;
      if (!name.ends_with("_radius")) continue;
      for (std::size_t row = 0; row < set.rows.size(); ++row) {
        const double before = published.columns[column].values[row], now = std::stod(set.rows[row][column]);
        ASSERT_LT(std::abs(now - before), 0.25 * before)
            << set.resource.name << ", " << name << ", row " << row + 1;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 1000);
}

// But for the size, and for the version of the library for ball arithmetic.
void expect_same_description(const std::vector<reference::DataSet>& sets) {
  const auto resources = [](const std::string& text) {
    std::map<std::string, nlohmann::json> by_name;
    const auto package = nlohmann::json::parse(text);
    for (nlohmann::json resource : package.at("resources")) {
      for (const char* key : {"bytes", "hash"}) resource.erase(key);
      resource.at("provenance").erase("software");
      by_name[resource.at("name")] = resource;
    }
    return by_name;
  };
  const auto published = resources(data::read_text(data::reference_directory() / "datapackage.json"));
  const auto made = resources(reference::package_files(sets).at("datapackage.json"));
  EXPECT_EQ(made.size(), sets.size());
  for (const auto& [name, resource] : made) EXPECT_EQ(published.at(name), resource);
}

STICKSLIP_VERIFIES(PublishedData, "P6");
TEST(PublishedData, IsWhatTheCodeMakes) {
  const data::ReferencePackage package = data::load_reference();
  const auto sets = quick_sets();
  for (const reference::DataSet& set : sets)
    expect_same_data(data::read_table(package, set.resource.name), set);
  expect_same_half_widths(package, sets);
  expect_same_description(sets);
}

TEST(PublishedData, HoldsTheDataSetsThatAreMadeAndNothingElse) {
  const data::ReferencePackage package = data::load_reference();
  std::vector<std::string> made, published;
  for (const reference::Recipe& recipe : reference::recipes()) made.emplace_back(recipe.name);
  std::set<fs::path> files{"datapackage.json", "datapackage.schema.json", "README.md", "CHANGELOG.md",
                           "example.py"};
  for (const data::Resource& resource : package.resources) {
    published.push_back(resource.name);
    files.insert(resource.path);
  }
  EXPECT_EQ(published, made);
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(package.folder)) {
    if (!entry.is_regular_file()) continue;
    bytes += entry.file_size();
    EXPECT_TRUE(files.contains(fs::relative(entry.path(), package.folder))) << entry.path();
  }
  EXPECT_LT(bytes, 5'000'000U);
}

TEST(PublishedData, SaysOfEveryNumberHowFarItCanBeTrusted) {
  // Values that are not exact have a radius that is not negative and, but for a zero, is below 1e-3 of the
  // largest value of the column or, where the range measures the error, of the range; enclosed ones have
  // thirty digits, but for an exact zero.
  const data::ReferencePackage package = data::load_reference();
  for (const data::Resource& resource : package.resources) {
    const data::ReferenceTable table = data::read_table(package, resource.name);
    for (const data::Column& column : table.columns) {
      if (!column.field.value_class || *column.field.value_class == data::ValueClass::exact) continue;
      double largest = 0.0;
      for (const double value : column.values) largest = std::max(largest, std::abs(value));
      double allowed = 1e-3 * largest;
      if (resource.comparison)
        for (const data::ComparedValue& value : resource.comparison->values)
          if (value.field == column.field.name && value.norm == data::Norm::range) {
            const auto [least, greatest] = std::ranges::minmax(column.values);
            allowed = 1e-3 * (greatest - least);
          }
      const std::vector<double> radius = table.radius_of(column.field.name);
      for (std::size_t row = 0; row < table.rows(); ++row) {
        ASSERT_GE(radius[row], 0.0) << resource.name << ", " << column.field.name;
        ASSERT_LT(radius[row], allowed) << resource.name << ", " << column.field.name;
        if (*column.field.value_class != data::ValueClass::enclosed) continue;
        if (radius[row] == 0.0 && column.text[row] == "0") continue;  // an exact zero has no digits
        const auto digits = std::ranges::count_if(column.text[row].substr(0, column.text[row].find('e')),
                                                  [](char c) { return c >= '0' && c <= '9'; });
        ASSERT_GE(digits, 30) << resource.name << ", " << column.field.name << ": " << column.text[row];
      }
    }
  }
}

TEST(PublishedData, ResolvesEveryReferenceOfItsRowsAndProblems) {
  const data::ReferencePackage package = data::load_reference();
  const auto cells_of = [&](const std::string& resource, const std::string& column) {
    const auto cells = data::read_table(package, resource).column(column).text;
    return std::set(cells.begin(), cells.end());
  };
  const auto beams = cells_of("beams", "beam");
  for (const data::Resource& resource : package.resources) {
    SCOPED_TRACE(resource.name);
    for (const data::ForeignKey& key : resource.foreign_keys) {
      const auto known = cells_of(key.resource, key.reference_column);
      for (const std::string& cell : cells_of(resource.name, key.column))
        EXPECT_TRUE(known.contains(cell)) << cell;
    }
    const bool has_beam = resource.name != "beams" && resource.field("beam") != nullptr;
    EXPECT_EQ(has_beam, !resource.foreign_keys.empty());
    if (resource.problem.empty()) continue;
    const auto problem = nlohmann::json::parse(resource.problem);
    if (const auto beam = problem.find("beam"); beam != problem.end() && beam->is_string()) {
      EXPECT_TRUE(beams.contains(beam->get<std::string>())) << *beam;
    }
    if (problem.contains("history"))
      for (const std::string& history : resource.field("history")->allowed) {
        EXPECT_NO_THROW((void)package.resource(history));
      }
  }
}

TEST(PublishedData, StatesTheProblemsAndTheWordsOfColumns) {
  const data::ReferencePackage package = data::load_reference();
  const std::set<fs::path> folders{"frequencies", "static", "shapes", "stick", "criterion", "stick-slip"};
  for (const data::Resource& resource : package.resources) {
    SCOPED_TRACE(resource.name);
    for (const char* word : {"phase", "change", "verdict"})
      if (const data::Field* field = resource.field(word)) {
        EXPECT_FALSE(field->allowed.empty()) << word;
      }
    if (!folders.contains(resource.path.parent_path())) continue;
    ASSERT_FALSE(resource.problem.empty());
    const auto problem = nlohmann::json::parse(resource.problem);
    if (problem.contains("history")) continue;
    std::vector<std::string> members{"beam", "tip", "damping"};
    if (problem.contains("excitation"))
      for (const char* member : {"friction", "initial_state", "modes"}) members.emplace_back(member);
    for (const std::string& member : members) EXPECT_TRUE(problem.contains(member)) << member;
  }
}

// --- The published fields, energies, forces and matrices against the finite elements of the solver, which share nothing with the code that made the data.

const data::ReferencePackage& published() {
  static const data::ReferencePackage package = data::load_reference();
  return package;
}

// The case of stick-history, with another damping, in s.
data::Case held_case(double kelvin_voigt) {
  data::Case problem = data::load_case("paper-figure9");
  problem.damping = data::Damping({.kelvin_voigt = kelvin_voigt});
  return problem;
}

// y and y_t of a mesh from event to event, in the rows of a set of fields up to the time `end`.
struct MeshFields {
  std::vector<double> displacement, velocity;

  MeshFields(const data::Case& problem, int elements, const data::ReferenceTable& table, double end) {
    const solver::BeamModel mesh(problem.beam, elements);
    const studies::FiniteElementContactModel contact(
        solver::beam_contact_system(mesh, problem.friction, solver::harmonic_motion(problem.excitation),
                                    problem.damping),
        2.0 * std::numbers::pi * problem.excitation.frequency_hz());
    analytic::EventDriven run(contact.model());
    const double omega = 2.0 * std::numbers::pi * problem.excitation.frequency_hz();
    const double amplitude = problem.excitation.amplitude();
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const double time = table.column("time").values[row];
      if (time > end) break;
      run.advance_to(time);
      const Eigen::VectorXd at = mesh.interpolation(table.column("x").values[row]);
      displacement.push_back(amplitude * std::sin(omega * time) +
                             at.dot(contact.full(run.amplitudes(), run.contact_displacement())));
      velocity.push_back(amplitude * omega * std::cos(omega * time) +
                         at.dot(contact.full(run.rates(), run.contact_velocity())));
    }
  }
};

// The error of 20 elements is their difference from 10 elements over 2^order - 1; twice that is allowed. The order is 4.
// In velocities of the undamped beam it is 8/3: with N elements the free vibration n has a phase error of order (n/N)^4
// n^2 and is lost from n ~ N^(2/3) on, and the velocities of these vibrations, n^-5, add up to n^-4.
void expect_fields_of_mesh(const std::string& set, const data::Case& problem, double end,
                           double velocity_order) {
  const data::ReferenceTable table = data::read_table(published(), set);
  const MeshFields coarse(problem, 10, table, end), fine(problem, 20, table, end);
  ASSERT_GE(fine.displacement.size(), 42U);
  const auto expect = [&](const std::string& column, const std::vector<double>& of_fine,
                          const std::vector<double>& of_coarse, double order) {
    double error = 0.0, difference = 0.0;
    for (std::size_t row = 0; row < of_fine.size(); ++row) {
      const double radius = table.radius_of(column)[row];
      error = largest_or_nan({error, std::abs(of_fine[row] - table.column(column).values[row]) - radius});
      difference = largest_or_nan({difference, std::abs(of_fine[row] - of_coarse[row])});
    }
    EXPECT_LE(error, 2.0 * difference / (std::pow(2.0, order) - 1.0))
        << set << ", " << column << ", difference " << difference;
  };
  expect("displacement", fine.displacement, coarse.displacement, 4.0);
  expect("velocity", fine.velocity, coarse.velocity, velocity_order);
}

STICKSLIP_VERIFIES(PublishedFields, "P6");
TEST(PublishedFields, OfTheHeldBeamAreThoseOfFiniteElements) {
  expect_fields_of_mesh("stick-fields", held_case(0.0), 1.0, 8.0 / 3.0);
}

TEST(PublishedFields, OfStickSlipAreThoseOfFiniteElements) {
  expect_fields_of_mesh("stick-slip-fields", data::load_case("damped"), 0.1, 4.0);
}

// y at the rows of undamped-fields up to 0.15 s, by steps that damp what the mesh cannot resolve.
std::vector<double> undamped_mesh(const data::ReferenceTable& table, int elements, double steps_per_period) {
  const double step = 1.0 / (25.0 * steps_per_period);
  solver::BeamSimulation run(with_values(
      with(data::load_case("paper"), data::HarmonicExcitation({.frequency_hz = 25.0, .amplitude = 1e-3})),
      {{"numerics.elements", elements}, {"numerics.spectral_radius", 0.5}, {"numerics.time_step", step}}));
  std::vector<double> displacement;
  for (std::size_t row = 0; row < table.rows() && table.column("time").values[row] < 0.151; ++row) {
    while (run.time() + 0.5 * step < table.column("time").values[row]) run.step();
    displacement.push_back(run.displacement(table.column("x").values[row]));
  }
  return displacement;
}

TEST(PublishedFields, OfUndampedStickSlipAreThoseOfFiniteElements) {
  const auto table = data::read_table(published(), "undamped-fields");
  // Mesh and step refined together, h as l^2: order 1 in l or better, so that the difference is above the error.
  const auto fine = undamped_mesh(table, 40, 6400.0), coarse = undamped_mesh(table, 20, 1600.0);
  ASSERT_EQ(fine.size(), 105U);
  double error = 0.0, difference = 0.0;
  for (std::size_t row = 0; row < fine.size(); ++row) {
    error = largest_or_nan({error, std::abs(fine[row] - table.column("displacement").values[row])});
    difference = largest_or_nan({difference, std::abs(fine[row] - coarse[row])});
  }
  EXPECT_LE(error, difference);
  EXPECT_LE(error, 5e-3 * std::ranges::max(fine));
}

TEST(PublishedFields, OfUndampedStickSlipPassThroughItsHistory) {
  const auto fields = data::read_table(published(), "undamped-fields"),
             history = data::read_table(published(), "undamped-history-25");
  const auto radius = fields.radius_of("displacement");
  int compared = 0;
  for (std::size_t row = 0; row < fields.rows(); ++row)
    for (const auto& [place, name] : {std::pair{1.0, "midspan_displacement"}, {2.0, "tip_displacement"}}) {
      if (fields.column("x").values[row] != place) continue;
      const auto at = static_cast<std::size_t>(std::lround(fields.column("time").values[row] / 5e-4));
      EXPECT_NEAR(fields.column("displacement").values[row], history.column(name).values[at],
                  radius[row] + history.radius_of(name)[at])
          << row;
      ++compared;
    }
  EXPECT_EQ(compared, 20);  // two places at ten times
}

TEST(PublishedFields, HaveTheSpectrumOfAMeshOverTenSeconds) {
  const auto table = data::read_table(published(), "stick-slip-spectrum");
  constexpr double step = 1e-4;  // 400 a period
  solver::BeamSimulation run(
      with_values(data::load_case("damped"), {{"numerics.elements", 20}, {"numerics.time_step", step}}));
  // 100 samples per period instead of 64; the motion has nothing at the frequencies that either folds back.
  std::vector<double> tip;
  for (int i = 0; i < 500 * 400; ++i) {
    if (i >= 250 * 400 && i % 4 == 0) tip.push_back(run.tip_displacement());
    run.step();
  }
  const auto count = static_cast<double>(tip.size());
  const auto amplitude = [&](double cycles) {
    std::complex<double> sum;
    for (std::size_t i = 0; i < tip.size(); ++i)
      sum += (1.0 - std::cos(2.0 * std::numbers::pi * static_cast<double>(i) / count)) * tip[i] *
             std::polar(1.0, -2.0 * std::numbers::pi * cycles * static_cast<double>(i) / 100.0);
    return 2.0 * std::abs(sum) / count;
  };
  const auto& published_parts = table.column("tip_amplitude").values;
  const double tolerance = 5e-3 * std::ranges::max(published_parts);  // that of the data set
  EXPECT_EQ(table.column("part").text[2], "harmonic-1");
  EXPECT_NEAR(amplitude(1.0), published_parts[2], tolerance);
  EXPECT_NEAR(amplitude(3.0), published_parts[3], tolerance);
  EXPECT_NEAR(amplitude(2.0), 0.0, tolerance);
}

STICKSLIP_VERIFIES(PublishedFrequencies, "P6");
TEST(PublishedFrequencies, OfTimoshenkoBeamsAreThoseInDoublePrecision) {
  for (const auto& [set, tip] : {std::pair{"timoshenko-stick-frequencies", analytic::TipSupport::held},
                                 {"timoshenko-slip-frequencies", analytic::TipSupport::free}}) {
    const auto table = data::read_table(published(), set);
    for (std::size_t row = 0; row < table.rows(); ++row) {
      data::BeamProperties beam = data::load_case(table.column("beam").text[row]).beam.properties();
      beam.axial_force = 0.0;
      beam.shear_stiffness = 5.0 / 6.0 * beam.area * beam.youngs_modulus / 2.6;
      const int mode = static_cast<int>(table.column("mode").values[row]);
      const double computed =
          analytic::timoshenko_frequencies(data::Beam(beam), tip, mode).back() / (2.0 * std::numbers::pi);
      const double value = table.column("frequency").values[row];
      EXPECT_NEAR(computed, value, 2e-15 * (mode + 1) * value) << set << " " << row;
    }
  }
}

TEST(PublishedFields, HaveTheSlipForceInDirectionOfSliding) {
  const auto history = data::read_table(published(), "stick-slip-history");
  const auto velocities = data::read_table(published(), "stick-slip-velocities");
  const data::Case problem = data::load_case("damped");
  const double limit = problem.beam.axial_force(), drop = 0.3 * limit;  // mu falls by mu_s - mu_m = 0.3
  int compared = 0;
  for (std::size_t row = 0, i = 0; row < velocities.rows(); ++row) {
    const double time = velocities.column("time").values[row];
    while (i + 1 < history.rows() && history.column("time").values[i] < time - 1e-9) ++i;
    if (velocities.column("phase").text[row] != "slip" ||
        !data::is_same_key(history.column("time").values[i], time))
      continue;
    const double velocity = velocities.column("tip_velocity").values[row];
    const double force = std::copysign(0.3 * limit + drop * std::exp(-std::abs(velocity)), velocity);
    EXPECT_NEAR(history.column("friction_force").values[i], force,
                history.radius_of("friction_force")[i] + drop * velocities.radius_of("tip_velocity")[row])
        << time;
    ++compared;
  }
  EXPECT_GT(compared, 100);
}

TEST(PublishedFields, HaveTheEnergiesOfTheirWorks) {
  const auto table = data::read_table(published(), "stick-slip-energy");
  const std::vector<std::pair<std::string, double>> entries{
      {"kinetic_energy", 1.0}, {"potential_energy", 1.0}, {"damping_loss", 1.0},
      {"friction_loss", 1.0},  {"base_work", -1.0},       {"follower_work", -1.0}};
  const auto sum = [&](std::size_t row) {
    double balance = 0.0;
    for (const auto& [name, sign] : entries) balance += sign * table.column(name).values[row];
    return balance;
  };
  double radius = 0.0;
  for (const auto& entry : entries) radius += std::ranges::max(table.radius_of(entry.first));
  for (std::size_t row = 1; row < table.rows(); ++row) EXPECT_NEAR(sum(row), sum(0), 2.0 * radius) << row;
}

TEST(PublishedFields, OfTheSteadyStateAreThoseOfFiniteElements) {
  using Complex = std::complex<double>;
  const auto table = data::read_table(published(), "damped-steady-state");
  const data::Case problem = held_case(6.4e-5);
  const solver::BeamModel mesh(problem.beam, 40);
  const Eigen::MatrixXd mass(mesh.mass()), damping(solver::damping_matrix(mesh, problem.damping));
  const Eigen::MatrixXd stick(mesh.stick_stiffness()), slip(mesh.slip_stiffness());
  const Eigen::Index tip = mesh.tip_deflection();
  for (std::size_t row = 0; row < table.rows(); row += 17) {
    const double omega = 2.0 * std::numbers::pi * table.column("frequency").values[row], amplitude = 5e-4;
    const Eigen::MatrixXcd dynamic =
        damping.cast<Complex>() * Complex(0.0, omega) - (omega * omega * mass).cast<Complex>();
    Eigen::MatrixXcd held = stick.cast<Complex>() + dynamic;
    Eigen::VectorXcd load = (omega * omega * amplitude * mesh.base_load()).cast<Complex>();
    held.row(tip).setZero();
    held(tip, tip) = 1.0;
    load(tip) = -amplitude;
    const Eigen::VectorXcd u = held.partialPivLu().solve(load);
    const Complex middle = amplitude + mesh.interpolation(0.5 * problem.beam.length()).cast<Complex>().dot(u);
    const Eigen::VectorXcd balance = (slip.cast<Complex>() + dynamic) * u;
    const Complex force = omega * omega * amplitude * mesh.base_load()(tip) - balance(tip);
    const auto expect = [&](const std::string& name, const Complex& value) {
      const Complex reference = std::polar(table.column(name + "_amplitude").values[row],
                                           table.column(name + "_phase").values[row]);
      // Empirical: 40 elements shift the first resonances by less than 1e-6, which a resonance enlarges by 200.
      EXPECT_LT(std::abs(value - reference), 1e-3 * std::abs(reference)) << name << ", row " << row;
    };
    expect("midspan", middle);
    expect("force", force);
  }
}

STICKSLIP_VERIFIES(PublishedForces, "P6");
TEST(PublishedForces, OfAllModesAreThoseOfFiniteElements) {
  const auto table = data::read_table(published(), "friction-maxima-all-modes");
  const auto amplitudes = data::read_table(published(), "critical-amplitudes-all-modes");
  const data::Case problem = data::load_case("paper");
  for (const int hz : {15, 70}) {
    const auto row = static_cast<std::size_t>(hz - 1);
    const double value = table.column("friction_force").values[row],
                 radius = table.radius_of("friction_force")[row];
    const data::HarmonicExcitation excitation({.frequency_hz = hz + 0.0, .amplitude = 5e-4});
    const analytic::Bounds more =
        analytic::StickResponse(problem.beam, excitation, 200, analytic::SteadyPart::exact)
            .max_abs_friction_force(10.0);
    EXPECT_NEAR(more.midpoint(), value, radius) << hz;
    const auto mesh =
        with_values(problem, {{"numerics.elements", 40}, {"numerics.time_step", 1e-4}}).numerics;
    const solver::ModalStickRun run(problem.beam, excitation, mesh);
    // The tolerance that the data set proposes.
    EXPECT_NEAR(run.max_abs_friction_force(100'000), value, 1e-2 * value) << hz;
    const double critical = amplitudes.column("amplitude").values[static_cast<std::size_t>(hz / 5 - 1)];
    EXPECT_NEAR(critical * value, 300.0 * 5e-4, 1e-6 * 300.0 * 5e-4);
  }
}

STICKSLIP_VERIFIES(PublishedMatrices, "P6");
TEST(PublishedMatrices, AreThoseOfTheSolverToRounding) {
  const auto table = data::read_table(published(), "beam-matrices");
  const solver::BeamModel mesh(data::load_case("paper").beam, 4);
  const auto published_matrix = [&](const std::string& name, Eigen::Index columns) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(8, columns);
    for (std::size_t row = 0; row < table.rows(); ++row)
      if (table.column("matrix").text[row] == name)
        matrix(static_cast<Eigen::Index>(table.column("row").values[row]) - 1,
               static_cast<Eigen::Index>(table.column("column").values[row]) - 1) =
            table.column("value").values[row];
    return matrix;
  };
  // A few roundings of each entry; of the follower term, those of the stiffness that it is the difference of.
  const auto expect = [&](const std::string& name, const Eigen::MatrixXd& solved, double scale) {
    const Eigen::MatrixXd matrix = published_matrix(name, solved.cols());
    for (Eigen::Index i = 0; i < 8; ++i)
      for (Eigen::Index j = 0; j < solved.cols(); ++j)
        EXPECT_NEAR(solved(i, j), matrix(i, j), 1e-15 * std::max(scale, 4.0 * std::abs(matrix(i, j))))
            << name << " " << i << " " << j;
  };
  const Eigen::MatrixXd stiffness(mesh.elastic_stiffness());
  expect("mass", Eigen::MatrixXd(mesh.mass()), 0.0);
  expect("stiffness", stiffness, 0.0);
  expect("geometric", Eigen::MatrixXd(mesh.geometric_stiffness()), 0.0);
  expect("load", mesh.base_load(), 0.0);
  expect("follower", Eigen::MatrixXd(mesh.slip_stiffness()) - Eigen::MatrixXd(mesh.stick_stiffness()),
         stiffness.cwiseAbs().maxCoeff());
}

}  // namespace
}  // namespace stickslip::testing
