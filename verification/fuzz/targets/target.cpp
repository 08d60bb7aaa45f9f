// SPDX-License-Identifier: MIT
#include "target.hpp"

#include <sys/mman.h>
#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "range_text.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/held_beam.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/data/problem.hpp"
#include "stickslip/data/user_table.hpp"
#include "stickslip/solver/beam_simulation.hpp"

namespace stickslip::fuzz {

namespace {

// A required property does not hold.
class Violation : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

// The parts of the input between the bytes 0x1e.
std::vector<std::string> split(Bytes bytes) {
  constexpr std::uint8_t separator = 0x1e;
  std::vector<std::string> parts(1);
  for (const std::uint8_t byte : bytes) {
    if (byte == separator)
      parts.emplace_back();
    else
      parts.back() += static_cast<char>(byte);
  }
  return parts;
}

// The message of the error is one line of text or more.
void require_sentence(const std::exception& error) {
  const std::string_view text(error.what());
  if (text.empty()) throw Violation("an error message is empty");
  if (std::ranges::any_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x20U && c != '\n'; }))
    throw Violation("an error message is not lines of text: " + std::string(text));
}

// Runs what may refuse its input, in lines of text.
template <class Run>
void allow_input_errors(const Run& run) {
  try {
    run();
  } catch (const data::InputError& error) {
    require_sentence(error);
  }
}

// A file in memory that has a path, so that functions which read files can use it.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(::memfd_create("input", MFD_CLOEXEC)) {
    if (descriptor_ < 0) throw std::system_error(errno, std::generic_category(), "memfd_create");
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  // Replaces the content of the file by `text` and returns the path.
  [[nodiscard]] std::filesystem::path with(std::string_view text) {
    if (::ftruncate(descriptor_, 0) != 0 ||
        ::pwrite(descriptor_, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size()))
      throw std::system_error(errno, std::generic_category(), "the file in memory");
    return "/proc/self/fd/" + std::to_string(descriptor_);
  }

 private:
  int descriptor_;
};

// The numbers of a case as overrides of a file without any.
std::vector<data::Override> overrides_of(const std::map<std::string, double>& numbers) {
  std::vector<data::Override> overrides;
  for (const auto& [key, value] : numbers) {
    // In TOML an integer is no float: 2 and 2.0 differ, and 1e+05 is none.
    const bool is_integer = data::key_named(key).member.is_integer;
    if (data::key_named(key).member.is_flag) {
      overrides.push_back({key, "true"});
      continue;
    }
    std::string text = is_integer ? std::to_string(static_cast<int>(value)) : data::shortest_text(value);
    if (!is_integer && text.find_first_of(".en") == std::string::npos) text += ".0";
    overrides.push_back({key, text});
  }
  return overrides;
}

void require_the_same_again(const data::Case& problem, MemoryFile& file) {
  auto numbers = data::numbers_of(problem);
  // Of a section only its area, second moment and shear stiffness.
  std::erase_if(numbers, [](const auto& number) {
    return number.first.starts_with("section.") || number.first == "beam.poissons_ratio";
  });
  const auto again =
      data::numbers_of(data::read_case(file.with("# all of it in overrides\n"), overrides_of(numbers)));
  for (const auto& [key, value] : numbers)
    if (again.at(key) != value)
      throw Violation(key + " = " + data::shortest_text(value) + " is read as " +
                      data::shortest_text(again.at(key)));
}

void require_ascending(std::span<const double> values, std::string_view text) {
  const bool holds =
      std::ranges::all_of(values, [](double value) { return std::isfinite(value) && value >= 0.0; }) &&
      std::ranges::is_sorted(values);
  if (!holds) throw Violation("the numbers are not ascending, finite and at least 0: " + std::string(text));
}

std::vector<data::ReferenceTable> comparable_tables() {
  const data::ReferencePackage package = data::load_reference();
  std::vector<data::ReferenceTable> tables;
  for (const data::Resource& resource : package.resources)
    if (resource.comparison) tables.push_back(data::read_table(package, resource.name));
  return tables;
}

void require_whole(const data::UserTable& table) {
  if (table.rows() == 0) throw Violation("a table without rows is accepted");
  for (const data::Column& column : table.columns) {
    if (column.values.size() != table.rows() || column.text.size() != table.rows())
      throw Violation("the column " + column.field.name + " does not have one cell for each row");
    const bool is_number = column.field.type != data::FieldType::string;
    if (is_number && !std::ranges::all_of(column.values, [](double value) { return std::isfinite(value); }))
      throw Violation("the column " + column.field.name + " has a number that is not finite");
  }
}

// Converts bytes to numbers; zeros after the last byte.
class Choices {
 public:
  explicit Choices(Bytes bytes) : bytes_(bytes) {}

  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const std::uint8_t first = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return first;
  }

  // `usual` itself, a value up to five decades above or below it in 25 steps per decade, or a value that is
  // not allowed (0, -1).
  double near(double usual) {
    constexpr std::array odd{0.0, -1.0};
    const int choice = byte();
    if (choice < 254) return usual * std::pow(10.0, (choice <= 125 ? choice : 125 - choice) / 25.0);
    return odd[static_cast<std::size_t>(choice - 254)];
  }

  int between(int lowest, int highest) { return lowest + byte() % (highest - lowest + 1); }

 private:
  Bytes bytes_;
};

data::Case case_of(Choices& choices) {
  const data::Beam beam({.length = choices.near(1.0),
                         .area = choices.near(5e-4),
                         .second_moment_of_area = choices.near(4e-9),
                         .density = choices.near(1000.0),
                         .youngs_modulus = choices.near(2e9),
                         .axial_force = choices.near(20.0)});
  const double static_coefficient = choices.near(0.5);
  const data::FrictionLaw friction({.static_coefficient = static_coefficient,
                                    .kinetic_coefficient = static_coefficient * choices.between(0, 4) / 4.0,
                                    .decay = choices.near(1.0)});
  const data::HarmonicExcitation excitation(
      {.frequency_hz = choices.near(25.0), .amplitude = choices.near(1e-3)});
  const double time_step = choices.near(1e-3);
  const data::NumericalSettings numerics({.elements = choices.between(1, 8),
                                          .time_step = time_step,
                                          .spectral_radius = choices.between(0, 4) / 4.0,
                                          .velocity_threshold = choices.near(1e-4),
                                          .modes = choices.between(1, 6),
                                          .duration = time_step * choices.between(1, 200)});
  return {.name = "fuzz",
          .structure = beam,
          .motion = excitation,
          .contact = {.friction = friction},
          .numerics = numerics,
          .damping = data::Damping({.kelvin_voigt = choices.byte() % 2 == 0 ? 0.0 : choices.near(1e-5),
                                    .ratio = choices.byte() % 2 == 0 ? 0.0 : choices.near(1e-2)})};
}

void require_finite(double time, std::initializer_list<double> values) {
  for (const double value : values)
    if (!std::isfinite(value))
      throw Violation("a number that is not finite at t = " + data::shortest_text(time) + " s");
}

void follow_by_finite_elements(const data::Case& problem, solver::ContactScheme scheme) {
  solver::BeamSimulation run(problem, {.scheme = scheme, .coordinates = solver::Coordinates::nodal});
  const long steps = solver::step_count(problem.numerics.duration(), problem.numerics.time_step());
  for (long n = 0; n <= steps; ++n) {
    if (n > 0) run.integrator().step();
    require_finite(run.integrator().time(),
                   {run.base_displacement(), run.tip_displacement(), run.midspan_displacement(),
                    run.integrator().sliding_velocity(), run.friction_force()});
  }
}

// The cost of an event-driven run: the angle (rad) of its fastest motion plus the number of time constants of
// the friction law.
double cost_of(const analytic::ContactModel& model, const data::Case& problem) {
  const double fastest = std::max(model.load_angular_frequency, std::ranges::max(model.angular_frequency));
  const double slope = model.friction.decay() * model.normal_force * model.friction.static_coefficient();
  double free_mass = model.contact_mass;
  for (const double coupling : model.mass_coupling) free_mass -= coupling * coupling;
  return problem.numerics.duration() * (fastest + slope / free_mass);
}

void follow_event_by_event(const data::Case& problem) {
  const analytic::HeldBeam beam(problem.beam(), problem.damping, problem.numerics.modes());
  constexpr double most = 300.0;  // runs above this cost would only take time
  const analytic::ContactModel model = analytic::contact_model(beam.structure(), problem);
  if (cost_of(model, problem) > most) return;
  analytic::EventDriven run(model);
  const std::vector<double> midspan = beam.shapes(problem.beam().length() / 2.0);
  const long steps = solver::step_count(problem.numerics.duration(), problem.numerics.time_step());
  for (long n = 0; n <= steps; ++n) {
    run.advance_to(static_cast<double>(n) * problem.numerics.time_step());
    require_finite(run.time(), {run.wall_displacement(), run.contact_position(),
                                analytic::absolute_displacement(midspan, run), run.sliding_velocity(),
                                run.friction_force()});
  }
}

}  // namespace

void read_case_file(Bytes bytes) {
  static MemoryFile file;
  const auto parts = split(bytes);
  allow_input_errors([&] {
    std::vector<data::Override> overrides;
    for (std::size_t i = 1; i < parts.size(); ++i) overrides.push_back(data::Override::parse(parts[i]));
    require_the_same_again(data::read_case(file.with(parts.front()), overrides), file);
  });
}

void parse_ranges(Bytes bytes) {
  const std::string text(bytes.begin(), bytes.end());
  allow_input_errors([&] {
    const auto axis = cli::parse_axis("--x", text);
    if (axis.values.size() < 2) throw Violation("an axis of fewer than two values: " + text);
    require_ascending(axis.values, text);
    if (axis.values.front() == axis.values.back()) throw Violation("an axis with equal ends: " + text);
  });
  for (const bool equal : {false, true})
    allow_input_errors([&] {
      const auto [from, to] = cli::parse_range("--band", "excitation.frequency_hz", text, equal);
      require_ascending(std::array{from, to}, text);
    });
}

void read_results(Bytes bytes) {
  static const std::vector<data::ReferenceTable> tables = comparable_tables();
  static MemoryFile file;
  if (bytes.empty()) return;
  const data::ReferenceTable& reference = tables[bytes.front() % tables.size()];
  const auto parts = split(bytes.subspan(1));
  allow_input_errors([&] {
    std::vector<data::ColumnMapping> mappings;
    for (std::size_t i = 1; i < parts.size(); ++i) mappings.push_back(data::ColumnMapping::parse(parts[i]));
    data::require_known_columns(mappings, {&reference});
    require_whole(data::read_user_table(file.with(parts.front()), reference, mappings));
  });
}

void respond(Bytes bytes) {
  Choices choices(bytes);
  const bool by_finite_elements = choices.byte() % 2 == 0;
  const auto scheme = static_cast<solver::ContactScheme>(choices.between(0, 2));
  // Invalid input and failed runs, as the command line distinguishes them from internal errors.
  try {
    const data::Case problem = case_of(choices);
    if (by_finite_elements)
      follow_by_finite_elements(problem, scheme);
    else
      follow_event_by_event(problem);
  } catch (const std::invalid_argument& error) {
    require_sentence(error);
  } catch (const std::runtime_error& failure) {
    require_sentence(failure);
  }
}

}  // namespace stickslip::fuzz
