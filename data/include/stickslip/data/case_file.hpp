// SPDX-License-Identifier: MIT
#pragma once

/// Cases as TOML files: the tables [beam] or [model], [friction], [excitation], [numerics], [damping], [contact], [wall] and
/// [initial], whose keys are those of key.hpp. A value is a number in SI units, or a text of a number and a unit ("1.5 mm").
/// These keys may be missing:
///   those of [damping], [contact] and [wall], friction.viscous, beam.axial_direction, beam.shear_stiffness: they have the
///     defaults of problem.hpp;
///   those of [numerics]: they have the values of default_numerics();
///   excitation.duration: it is default_duration;
///   friction.kinetic_coefficient: the friction is Coulomb's, with the static coefficient.
/// In place of some keys a file may hold others:
///   [section] shape = "rectangle" (width; height, in the direction of the vibration), "circle" (diameter) or
///     "tube" (diameter, wall_thickness): beam.area, beam.second_moment_of_area;
///   beam.material, a name of list_materials(): beam.density, beam.youngs_modulus;
///   beam.poissons_ratio, with a section: beam.shear_stiffness;
///   excitation.velocity_amplitude (m/s) or acceleration_amplitude (m/s^2): excitation.amplitude, which takes their units, too.
/// [excitation] has in place of frequency_hz one of
///   sines = [[20, "0.1 mm", 0], [35, "0.5 g", 90]]: Hz, an amplitude of any kind, a phase in degrees that may be missing;
///   sweep = { from = "5 Hz", to = "200 Hz", rate = "1 oct/min" } or a rate as "2 Hz/s", with one of the amplitudes;
///   shock = { shape = "half-sine", duration = "11 ms" } or "sawtooth", "trapezoid", "rectangle", with an amplitude;
///   file = "road.csv", a table in the folder of the case or below, with column, quantity ("displacement", "velocity",
///     "acceleration" or "force"), unit where the name of the column does not say it, rate where it has no column "t" or "time", and
///     high_pass or initial_displacement and initial_velocity. The duration is that of the record.
/// [wall] takes the same keys, but no frequency_hz and no force.
/// [model] has the numbers of one mass, or in place of mass, stiffness and damping of the matrices of a structure, in files in the
/// folder of the case or below: mass_matrix, stiffness_matrix, damping_matrix (Matrix Market, or with dofs those of CalculiX), in the
/// units "m" (m, kg, s) or "mm" (mm, t, s; a row that is a rotation is then that times 1 mm), and base, fixed, contact and load, which
/// name rows or nodes.
/// A table [uncertainty] (uncertainty.hpp) gives keys a distribution; one that is missing elsewhere has the mean
/// of its distribution.

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "stickslip/data/input_error.hpp"
#include "stickslip/data/key.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::data {

// Where the files are that the program reads but does not contain.

/// A folder of files that come with the program: the one that the environment variable `variable` names; else
/// `folder` in share/stickslip of the installation that the running program belongs to, wherever that has
/// been moved; else `source`, its place in the source tree. It need not exist.
[[nodiscard]] std::filesystem::path installed_folder(const char* variable, std::string_view folder,
                                                     std::string_view source);

/// Throws InputError for a result that is not finite, as "the answer comes out as inf, but must be finite":
/// quantities that are allowed one by one can overflow together.
[[noreturn]] void throw_overflow(std::string_view result);

/// One `table.key=value` that replaces what the file says, or supplies what it lacks.
struct Override {
  std::string key;      ///< "beam.length"
  std::string value;    ///< "1.8", as TOML
  std::string place{};  ///< where it was given, "--hz"; empty: "override beam.length=1.8"

  /// Splits "beam.length=1.8". Throws InputError if there is no '=' or either side is empty.
  static Override parse(std::string_view text);
};

/// The folder with cases/, paper/ and reference/: installed_folder() with the environment variable
/// STICKSLIP_DATA.
[[nodiscard]] std::filesystem::path data_directory();

/// A name of a case in data_directory()/cases (without .toml), or a path to a file, as a path.
/// Throws InputError, naming the cases there are, if neither exists.
[[nodiscard]] std::filesystem::path find_case(const std::string& name_or_path);

/// Throws InputError, naming the place, if no case may have a number of that magnitude at the key, as
/// "beam.length", which must be one of case_keys().
void require_magnitude(std::string_view key, double value, const std::string& place);

/// Reads and validates a case, of at most 1 MB; the last override of a key wins, and one of the three amplitudes
/// replaces the other two. An integer may stand where a float is expected, but not the other way round. Throws
/// InputError for a file that cannot be read, a syntax error, an unknown, missing or mistyped key, a value that the
/// problem types do not allow, or one that no beam has: each quantity has a range of magnitudes, in SI units, that the
/// problem types do not know.
[[nodiscard]] Case read_case(const std::filesystem::path& file, const std::vector<Override>& overrides = {});

/// The case that a file with this text holds, but for matrices: the files that it names are not read. Throws what read_case()
/// throws.
[[nodiscard]] Case parse_case(const std::filesystem::path& file, const std::string& text);

/// find_case, then read_case.
[[nodiscard]] Case load_case(const std::string& name_or_path, const std::vector<Override>& overrides = {});

/// A material by its name.
struct Material {
  std::string name;
  double density{};         ///< kg/m^3
  double youngs_modulus{};  ///< Pa
  std::string source;       ///< the standard or publication that the two are from
};

/// The rows of materials.toml in data_directory(), in the order of the file. Throws InputError if it is not there.
[[nodiscard]] std::vector<Material> list_materials();

/// The names of the published cases, each with the first comment line of its file.
[[nodiscard]] std::map<std::string, std::string> list_cases();

/// excitation.duration where a case does not state it: that of the paper, s.
constexpr double default_duration = 10.0;

/// Settings for a case that does not state them, from its shortest vibration that matters. That is stick mode
/// k: the tenth, or the first of more than four times the highest frequency of the motions if that is higher, at most the
/// 200th. Its frequency without axial force is f_k = ((k + 1/4) pi)^2 sqrt(EI/(rho A L^4))/(2 pi), to 1e-7 of
/// itself.
///
///     elements            4 k: four for each half-wave of mode k
///     time_step           1/(50 f_k), rounded down to 1, 2 or 5 times a power of ten, at most the duration if that is
///                         positive, s
///     spectral_radius     0 with damping.kelvin_voigt, which makes the modes that the step does not resolve turn over
///                         by -spectral_radius in each step (theory.md, Section 8); else 0.9
///     velocity_threshold  0 m/s
///     modes               k
///
/// Of a Model: 1 element, which nothing uses; a time step of 1/(2000 f) with the higher of the highest frequency of the motions and, of
/// one mass, that of its spring; spectral_radius 0.9; 20 modes.
///
/// Why these: see the user guide, "Defaults of [numerics]".
[[nodiscard]] NumericalChoices default_numerics(const Structure& structure, double highest_hz,
                                                double duration, const Damping& damping = Damping());

}  // namespace stickslip::data
