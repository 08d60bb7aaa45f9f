// SPDX-License-Identifier: MIT
/// The published data: what is in the repository is what the code makes, and every file says where it is
/// from.

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "comparison/diagnosis/wrong_models.hpp"
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

// To a quarter: they have two printed digits, and some are differences, with the rounding of both sides.
int expect_same_half_widths(const data::ReferenceTable& published, const reference::DataSet& set) {
  int compared = 0;
  if (set.resource.provenance.value_class != data::ValueClass::converged) return compared;
  for (std::size_t column = 0; column < set.resource.fields.size(); ++column) {
    const std::string& name = set.resource.fields[column].name;
    for (std::size_t row = 0; name.ends_with("_radius") && row < set.rows.size(); ++row, ++compared) {
      const double before = published.columns[column].values[row], now = std::stod(set.rows[row][column]);
      EXPECT_LT(std::abs(now - before), 0.25 * before) << set.resource.name << ", " << name << " " << row + 1;
    }
  }
  return compared;
}

STICKSLIP_VERIFIES(PublishedData, "P6");
TEST(PublishedData, IsWhatTheCodeMakes) {
  const data::ReferencePackage package = data::load_reference();
  std::vector<reference::DataSet> sets;
  int half_widths = 0;
  for (const reference::Recipe& recipe : reference::recipes()) {
    if (!recipe.is_quick) continue;
    sets.push_back(recipe.make());
    const data::ReferenceTable published = data::read_table(package, sets.back().resource.name);
    expect_same_data(published, sets.back());
    half_widths += expect_same_half_widths(published, sets.back());
  }
  EXPECT_GT(half_widths, 1000);
  // The same description, but for the size and the version of the library for ball arithmetic.
  const auto made =
      nlohmann::json::parse(reference::package_files(sets).at("datapackage.json")).at("resources");
  EXPECT_EQ(made.size(), sets.size());
  for (const nlohmann::json& resource : made) {
    data::Resource published = package.resource(resource.at("name"));
    published.bytes = resource.at("bytes");
    published.sha256 = resource.at("hash").get<std::string>().substr(7);  // behind "sha256:"
    published.provenance.software = resource.at("provenance").at("software");
    EXPECT_EQ(nlohmann::json::parse(data::json_text(published)), resource);
  }
}

TEST(PublishedData, HoldsWhatIsMadeAndNothingElse) {
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

// Values that are not exact have a radius that is not negative and, but for a zero, is below 1e-3 of the largest value of the column
// or, where the range measures the error, of the range; enclosed ones have thirty digits, but for an exact zero.
TEST(PublishedData, SaysHowFarItCanBeTrusted) {
  const data::ReferencePackage package = data::load_reference();
  for (const data::Resource& resource : package.resources) {
    const data::ReferenceTable table = data::read_table(package, resource.name);
    for (const auto& [field, text, values] : table.columns) {
      if (!field.value_class || *field.value_class == data::ValueClass::exact) continue;
      SCOPED_TRACE(resource.name + ", " + field.name);
      const auto [least, greatest] = std::ranges::minmax(values);
      double scale = std::max(std::abs(least), std::abs(greatest));
      if (resource.comparison)
        for (const data::ComparedValue& value : resource.comparison->values)
          if (value.field == field.name && value.norm == data::Norm::range) scale = greatest - least;
      const std::vector<double> radius = table.radius_of(field.name);
      for (std::size_t row = 0; row < table.rows(); ++row) {
        ASSERT_GE(radius[row], 0.0);
        ASSERT_LT(radius[row], 1e-3 * scale);
        const bool is_zero = radius[row] == 0.0 && text[row] == "0";
        if (*field.value_class != data::ValueClass::enclosed || is_zero) continue;
        ASSERT_GE(std::ranges::count_if(text[row].substr(0, text[row].find('e')),
                                        [](char c) { return c >= '0' && c <= '9'; }),
                  30)
            << text[row];
      }
    }
  }
}

TEST(PublishedData, StatesProblemsAndReferences) {
  const data::ReferencePackage package = data::load_reference();
  const auto cells_of = [&](const std::string& resource, const std::string& column) {
    const auto cells = data::read_table(package, resource).column(column).text;
    return std::set(cells.begin(), cells.end());
  };
  const auto beams = cells_of("beams", "beam");
  const std::set<fs::path> folders{"frequencies", "static", "shapes", "stick", "criterion", "stick-slip"};
  for (const data::Resource& resource : package.resources) {
    SCOPED_TRACE(resource.name);
    for (const char* word : {"phase", "change", "verdict"})
      EXPECT_FALSE(resource.field(word) != nullptr && resource.field(word)->allowed.empty()) << word;
    for (const data::ForeignKey& key : resource.foreign_keys) {
      const auto known = cells_of(key.resource, key.reference_column);
      for (const std::string& cell : cells_of(resource.name, key.column))
        EXPECT_TRUE(known.contains(cell)) << cell;
    }
    const bool has_beam = resource.name != "beams" && resource.field("beam") != nullptr;
    EXPECT_EQ(has_beam, !resource.foreign_keys.empty());
    EXPECT_TRUE(resource.stated.beam.empty() || beams.contains(resource.stated.beam)) << resource.stated.beam;
    if (!folders.contains(resource.path.parent_path())) continue;
    ASSERT_FALSE(resource.problem.empty());
    const auto problem = nlohmann::json::parse(resource.problem);
    if (problem.contains("history")) {
      for (const std::string& history : resource.field("history")->allowed)
        EXPECT_NO_THROW((void)package.resource(history));
      continue;
    }
    std::vector<std::string> members{"beam", "tip", "damping"};
    if (problem.contains("excitation")) members.insert(members.end(), {"friction", "initial_state", "modes"});
    for (const std::string& member : members) EXPECT_TRUE(problem.contains(member)) << member;
  }
}

// --- The published fields, energies, forces and matrices against the finite elements of the solver, which share nothing with the code that made the data.

data::ReferenceTable published(const std::string& set) {
  static const data::ReferencePackage package = data::load_reference();
  return data::read_table(package, set);
}

// The case of stick-history, with another damping, in s.
data::Case held_case(double kelvin_voigt) {
  return with_value(data::load_case("paper-figure9"), "damping.kelvin_voigt", kelvin_voigt);
}

using Columns = std::map<std::string, std::vector<double>>;

// What a mesh has from event to event at the times of a data set up to the last one, by the names of the columns; NaN in
// another phase than that of the data set.
Columns on_a_mesh(const data::Case& problem, int elements, const data::ReferenceTable& table, double last) {
  const solver::BeamModel mesh(problem.beam(), elements);
  const double omega = 2.0 * std::numbers::pi * problem.excitation().frequency_hz();
  const double amplitude = problem.excitation().amplitude(), length = problem.beam().length();
  const studies::FiniteElementContactModel contact(solver::beam_contact_system(mesh, problem), omega);
  analytic::EventDriven run(contact.model());
  Columns columns;
  for (std::size_t row = 0; row < table.rows() && table.column("time").values[row] <= last; ++row) {
    const double time = table.column("time").values[row];
    run.advance_to(time);
    const auto displacement = [&](double x) {
      return amplitude * std::sin(omega * time) +
             mesh.interpolation(x).dot(contact.full(run.amplitudes(), run.contact_displacement()));
    };
    const auto velocity = [&](double x) {
      return amplitude * omega * std::cos(omega * time) +
             mesh.interpolation(x).dot(contact.full(run.rates(), run.contact_velocity()));
    };
    const data::Column *x = data::find_column(table.columns, "x"),
                       *phase = data::find_column(table.columns, "phase");
    const double place = x == nullptr ? length : x->values[row];
    const double factor =
        phase == nullptr || phase->text[row] == data::to_string(run.state()) ? 1.0 : std::nan("");
    for (const auto& [name, value] :
         std::map<std::string, double>{{"displacement", displacement(place)},
                                       {"velocity", velocity(place)},
                                       {"tip_displacement", displacement(length)},
                                       {"tip_velocity", velocity(length)},
                                       {"midspan_displacement", displacement(0.5 * length)},
                                       {"midspan_velocity", velocity(0.5 * length)},
                                       {"friction_force", -run.friction_force()}})
      columns[name].push_back(factor * value);
  }
  return columns;
}

struct MeshedSet {
  std::string name;
  data::Case problem;
  double last;  // s
  double order_of_velocities{4.0};
};

// The error of 20 elements is their difference from 10 elements over 2^order - 1. The order is 4. In velocities of the undamped
// beam it is 8/3: with N elements the free vibration n has a phase error of order (n/N)^4 n^2 and is lost from n ~ N^(2/3) on,
// and the velocities of these vibrations, n^-5, add up to n^-4.
STICKSLIP_VERIFIES(PublishedFields, "P6");
TEST(PublishedFields, AreThoseOfFiniteElements) {
  const data::Case damped = data::load_case("damped");
  for (const auto& [name, problem, last, order_of_velocities] :
       std::vector<MeshedSet>{{"stick-fields", held_case(0.0), 1.0, 8.0 / 3.0},
                              {"stick-velocities", held_case(0.0), 0.5, 8.0 / 3.0},
                              {"damped-stick-history", held_case(6.4e-5), 0.3},
                              {"stick-slip-fields", damped, 0.1},
                              {"stick-slip-history", damped, 0.06},
                              {"stick-slip-velocities", damped, 0.08}}) {
    const data::ReferenceTable table = published(name);
    const Columns coarse = on_a_mesh(problem, 10, table, last), fine = on_a_mesh(problem, 20, table, last);
    int compared = 0;
    for (const auto& [column, values] : fine) {
      if (table.resource.field(column) == nullptr) continue;
      double error = 0.0, difference = 0.0;
      for (std::size_t row = 0; row < values.size(); ++row) {
        if (std::isnan(values[row] + coarse.at(column)[row])) continue;
        const double radius = table.radius_of(column)[row];
        error = largest_or_nan({error, std::abs(values[row] - table.column(column).values[row]) - radius});
        difference = largest_or_nan({difference, std::abs(values[row] - coarse.at(column)[row])});
        ++compared;
      }
      const double order = column.ends_with("velocity") ? order_of_velocities : 4.0;
      EXPECT_TRUE(
          within(error, 0.0, discretisation(difference / (std::pow(2.0, order) - 1.0), 2.0, "Richardson")))
          << name << ", " << column;
    }
    EXPECT_GE(compared, 10) << name;
  }
}

// The first 0.15 s by steps that damp what the mesh cannot resolve. Mesh and step are refined together, h as l^2: order 1 in
// l or better, so that the difference is above the error.
TEST(PublishedFields, UndampedAreThoseOfAMesh) {
  const auto table = published("undamped-fields"), history = published("undamped-history-25");
  const auto on_mesh = [&](int elements, double steps_per_period) {
    const double step = 1.0 / (25.0 * steps_per_period);
    solver::BeamSimulation run(with_values(
        with(data::load_case("paper"), data::HarmonicExcitation({.frequency_hz = 25.0, .amplitude = 1e-3})),
        {{"numerics.elements", elements}, {"numerics.spectral_radius", 0.5}, {"numerics.time_step", step}}));
    std::vector<double> displacement;
    for (std::size_t row = 0; row < table.rows() && table.column("time").values[row] < 0.151; ++row) {
      while (run.integrator().time() + 0.5 * step < table.column("time").values[row]) run.integrator().step();
      displacement.push_back(run.displacement(table.column("x").values[row]));
    }
    return displacement;
  };
  const auto fine = on_mesh(40, 6400.0), coarse = on_mesh(20, 1600.0);
  const auto& values = table.column("displacement").values;
  double error = 0.0, difference = 0.0;
  for (std::size_t row = 0; row < fine.size(); ++row) {
    error = largest_or_nan({error, std::abs(fine[row] - values[row])});
    difference = largest_or_nan({difference, std::abs(fine[row] - coarse[row])});
  }
  EXPECT_EQ(fine.size(), 105U);
  EXPECT_TRUE(within(error, 0.0, discretisation(difference, 1.0, "order 1")));
  EXPECT_TRUE(within(error, 0.0, reference(5e-3 * std::ranges::max(fine), "the data set, of the largest")));
  // The ten fields pass through the history.
  for (std::size_t row = 0; row < table.rows(); ++row)
    for (const auto& [place, name] : {std::pair{1.0, "midspan_displacement"}, {2.0, "tip_displacement"}}) {
      if (table.column("x").values[row] != place) continue;
      const auto at = static_cast<std::size_t>(std::lround(table.column("time").values[row] / 5e-4));
      EXPECT_TRUE(within(
          values[row], history.column(name).values[at],
          reference(table.radius_of("displacement")[row] + history.radius_of(name)[at], "both data sets")))
          << row;
    }
}

TEST(PublishedFields, HaveTheEnergiesOfTheirWorks) {
  const auto table = published("stick-slip-energy");
  std::vector<double> balance(table.rows());
  double radius = 0.0;
  for (const auto& [name, sign] : {std::pair{"kinetic_energy", 1.0},
                                   {"potential_energy", 1.0},
                                   {"damping_loss", 1.0},
                                   {"friction_loss", 1.0},
                                   {"base_work", -1.0},
                                   {"follower_work", -1.0}}) {
    for (std::size_t row = 0; row < table.rows(); ++row)
      balance[row] += sign * table.column(name).values[row];
    radius += std::ranges::max(table.radius_of(name));
  }
  for (const double sum : balance)
    EXPECT_TRUE(
        within(sum, 0.0580633362, reference(radius, "the data set, which states the energy at t = 0")));
}

// Of 100 periods in place of 250, at 50 samples each: the motion has nothing at the frequencies that these fold back.
TEST(PublishedFields, HaveTheSpectrumOfAMesh) {
  const auto table = published("stick-slip-spectrum");
  constexpr int steps = 200, first = 250, last = 350;  // per period, periods
  solver::BeamSimulation run(
      with_values(data::load_case("damped"), {{"numerics.time_step", 1.0 / (25.0 * steps)}}));
  std::vector<double> tip;
  for (int i = 0; i < last * steps; ++i) {
    if (i >= first * steps && i % 4 == 0) tip.push_back(run.tip_displacement());
    run.integrator().step();
  }
  const auto count = static_cast<double>(tip.size());
  const auto amplitude = [&](double cycles) {
    std::complex<double> sum;
    for (std::size_t i = 0; i < tip.size(); ++i) {
      const double turns = static_cast<double>(i) / count;
      sum += (1.0 - std::cos(2.0 * std::numbers::pi * turns)) * tip[i] *
             std::polar(1.0, -2.0 * std::numbers::pi * turns * cycles * (last - first));
    }
    return 2.0 * std::abs(sum) / count;
  };
  const auto& parts = table.column("tip_amplitude").values;
  const Tolerance proposed = reference(5e-3 * std::ranges::max(parts), "the data set, of the largest part");
  EXPECT_EQ(table.column("part").text[2], "harmonic-1");
  EXPECT_TRUE(within(amplitude(1.0), parts[2], proposed));
  EXPECT_TRUE(within(amplitude(3.0), parts[3], proposed));
  EXPECT_TRUE(within(amplitude(2.0), 0.0, proposed));
}

TEST(PublishedFields, SteadyAreThoseOfAMesh) {
  using enum comparison::Quantity;
  const auto table = published("damped-steady-state");
  const auto& frequencies = table.column("frequency").values;
  const auto on_mesh = [&](comparison::Quantity quantity, int elements) {
    return comparison::reference_result(with_value(held_case(6.4e-5), "numerics.elements", elements),
                                        quantity, frequencies);
  };
  for (const auto& [name, quantity] : {std::pair{"midspan_amplitude", steady_amplitude},
                                       {"midspan_phase", steady_phase},
                                       {"force_amplitude", steady_force_amplitude},
                                       {"force_phase", steady_force_phase},
                                       {"heat", heat}}) {
    const auto fine = on_mesh(quantity, 40), coarse = on_mesh(quantity, 20);
    for (std::size_t row = 0; row < fine.size(); ++row) {
      const double value = table.column(name).values[row],
                   turn = table.column(name).field.unit == "rad" ? 2.0 * std::numbers::pi : 1e300;
      const double by_mesh = std::abs(std::remainder(fine[row] - coarse[row], turn)) / 15.0,
                   by_rounding = round_off(1, std::pow(40, 4), value).value;
      EXPECT_TRUE(within(std::remainder(fine[row] - value, turn), 0.0,
                         discretisation(by_mesh + by_rounding + table.radius_of(name)[row], 2.0,
                                        "Richardson, and rounding")))
          << name << " at " << frequencies[row] << " Hz";
    }
  }
}

STICKSLIP_VERIFIES(PublishedFrequencies, "P6");
TEST(PublishedFrequencies, AreThoseInDoubles) {
  for (const auto& [set, tip] : {std::pair{"timoshenko-stick-frequencies", analytic::TipSupport::held},
                                 {"timoshenko-slip-frequencies", analytic::TipSupport::free}}) {
    const auto table = published(set);
    for (std::size_t row = 0; row < table.rows(); ++row) {
      data::BeamProperties beam = data::load_case(table.column("beam").text[row]).beam().properties();
      beam.axial_force = 0.0;
      beam.shear_stiffness = 5.0 / 6.0 * beam.area * beam.youngs_modulus / 2.6;
      const int mode = static_cast<int>(table.column("mode").values[row]);
      const double computed =
          analytic::timoshenko_frequencies(data::Beam(beam), tip, mode).back() / (2.0 * std::numbers::pi);
      const double value = table.column("frequency").values[row];
      EXPECT_TRUE(within(computed, value, round_off(2.5 * (mode + 1), 1, value))) << set << " " << row;
    }
  }
}

STICKSLIP_VERIFIES(PublishedForces, "P6");
TEST(PublishedForces, AreThoseOfFiniteElements) {
  const auto table = published("friction-maxima-all-modes"),
             amplitudes = published("critical-amplitudes-all-modes");
  const data::Case problem =
      with_values(data::load_case("paper"), {{"numerics.elements", 40}, {"numerics.time_step", 1e-4}});
  for (const int hz : {15, 70}) {
    const auto row = static_cast<std::size_t>(hz - 1);
    const double value = table.column("friction_force").values[row];
    const data::HarmonicExcitation excitation = shaking(hz);
    const double modes = analytic::StickResponse(problem.beam(), excitation, 200, analytic::SteadyPart::exact)
                             .max_abs_friction_force(10.0)
                             .midpoint(),
                 mesh = solver::ModalStickRun(with(problem, excitation)).max_abs_friction_force(100'000);
    EXPECT_TRUE(within(modes, value, reference(table.radius_of("friction_force")[row], "the data set")))
        << hz;
    EXPECT_TRUE(within(mesh, value, reference(1e-2 * value, "the data set, for meshes"))) << hz;
    // mu_s P = 300 N.
    const double critical = amplitudes.column("amplitude").values[static_cast<std::size_t>(hz / 5 - 1)];
    EXPECT_TRUE(within(critical * value / (300.0 * excitation.amplitude()), 1.0,
                       reference(1e-6, "seven digits of both")))
        << hz;
  }
}

STICKSLIP_VERIFIES(PublishedMatrices, "P6");
TEST(PublishedMatrices, AreThoseOfTheSolver) {
  const auto table = published("beam-matrices");
  const solver::BeamModel mesh(data::load_case("paper").beam(), 4);
  const Eigen::MatrixXd stiffness(mesh.elastic_stiffness());
  // A few roundings of each entry; of the follower term, those of the stiffness that it is the difference of.
  const auto expect = [&](const std::string& name, const Eigen::MatrixXd& solved, double scale) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(8, solved.cols());
    for (std::size_t row = 0; row < table.rows(); ++row)
      if (table.column("matrix").text[row] == name)
        matrix(static_cast<Eigen::Index>(table.column("row").values[row]) - 1,
               static_cast<Eigen::Index>(table.column("column").values[row]) - 1) =
            table.column("value").values[row];
    for (Eigen::Index i = 0; i < 8; ++i)
      for (Eigen::Index j = 0; j < solved.cols(); ++j)
        EXPECT_TRUE(
            within(solved(i, j), matrix(i, j), round_off(5, 1, std::max(scale, std::abs(matrix(i, j))))))
            << name << " " << i << " " << j;
  };
  expect("mass", Eigen::MatrixXd(mesh.mass()), 0.0);
  expect("stiffness", stiffness, 0.0);
  expect("geometric", Eigen::MatrixXd(mesh.geometric_stiffness()), 0.0);
  expect("load", mesh.base_load(), 0.0);
  expect("follower", Eigen::MatrixXd(mesh.slip_stiffness()) - Eigen::MatrixXd(mesh.stick_stiffness()),
         stiffness.cwiseAbs().maxCoeff());
}

}  // namespace
}  // namespace stickslip::testing
