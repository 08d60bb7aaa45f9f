// SPDX-License-Identifier: MIT
#include "stickslip/data/key.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "stickslip/data/case_file.hpp"
#include "stickslip/data/input_text.hpp"
#include "stickslip/data/units.hpp"

namespace stickslip::data {

namespace {

namespace key_table {

template <auto Table, auto Field>
constexpr KeyMember member() {
  using Number = std::remove_cvref_t<decltype((CaseNumbers{}.*Table).*Field)>;
  return {.get = [](const CaseNumbers& of) { return static_cast<double>((of.*Table).*Field); },
          .set = [](CaseNumbers& of, double value) { (of.*Table).*Field = static_cast<Number>(value); },
          .is_integer = std::is_integral_v<Number>,
          .is_flag = std::is_same_v<Number, bool>};
}

template <auto Field>
constexpr KeyMember beam = member<&CaseNumbers::beam, Field>();
template <auto Field>
constexpr KeyMember friction = member<&CaseNumbers::friction, Field>();
template <auto Field>
constexpr KeyMember excitation = member<&CaseNumbers::excitation, Field>();
template <auto Field>
constexpr KeyMember numerics = member<&CaseNumbers::numerics, Field>();
template <auto Field>
constexpr KeyMember damping = member<&CaseNumbers::damping, Field>();
template <auto Field>
constexpr KeyMember contact = member<&CaseNumbers::contact, Field>();
template <auto Field>
constexpr KeyMember section = member<&CaseNumbers::section, Field>();
template <auto Field>
constexpr KeyMember model = member<&CaseNumbers::model, Field>();
template <auto Field>
constexpr KeyMember wall = member<&CaseNumbers::wall, Field>();
template <auto Field>
constexpr KeyMember initial = member<&CaseNumbers::initial, Field>();
constexpr KeyMember constant_force{.get = [](const CaseNumbers& of) { return of.constant_force; },
                                   .set = [](CaseNumbers& of, double value) { of.constant_force = value; }};
constexpr KeyMember none{};
constexpr KeyMember frequency{
    .get = [](const CaseNumbers& of) { return of.motion ? Section::none : of.excitation.frequency_hz; },
    .set = [](CaseNumbers& of, double value) { of.excitation.frequency_hz = value; }};
template <AmplitudeOf Kind>
constexpr KeyMember amplitude{
    .get =
        [](const CaseNumbers& of) {
          return of.motion ? Section::none : HarmonicExcitation(of.excitation).stated_as(Kind).amplitude;
        },
    .set =
        [](CaseNumbers& of, double value) {
          of.excitation.amplitude = value;
          of.excitation.amplitude_of = Kind;
        }};
constexpr KeyMember wall_scale{
    .get = [](const CaseNumbers& of) { return of.wall_motion ? of.wall_scale : Section::none; },
    .set = [](CaseNumbers& of, double value) { of.wall_scale = value; }};

constexpr auto optional = Presence::optional, required = Presence::required, shorthand = Presence::shorthand,
               alternative = Presence::alternative;
constexpr bool may_be_zero = true;

// Effects of keys.
namespace has {
constexpr KeyEffects force{.moves_the_force = true}, factor{.is_a_factor = true, .keeps_frequencies = true},
    limit{.is_a_factor = true, .keeps_frequencies = true, .is_adjustable = true},
    beam_key{.moves_the_force = true, .varies_beam = true},
    adjustable_beam{.moves_the_force = true, .varies_beam = true, .is_adjustable = true},
    shape{.moves_the_force = true, .varies_beam = true, .has_proportions = true},
    adjustable_shape{
        .moves_the_force = true, .varies_beam = true, .has_proportions = true, .is_adjustable = true},
    scale{.moves_the_force = true, .keeps_frequencies = true},
    direction{.moves_the_force = true, .couples_modes = true, .keeps_frequencies = true},
    damper{.moves_the_force = true, .couples_modes = true};
}  // namespace has

// A further parameter is one more entry here.
// clang-format off
constexpr std::array all{
    Key{"beam.length", beam<&BeamProperties::length>, {1e-9, 1e6, "m"}, required,
        {"length", "length_m", "beam length L / m"}, has::adjustable_shape},
    Key{"beam.area", beam<&BeamProperties::area>, {1e-18, 1e12, "m^2"}, required,
        {"area", "area_m2", "area of the section A / mm²", 1e6}, has::shape},
    Key{"beam.second_moment_of_area", beam<&BeamProperties::second_moment_of_area>, {1e-36, 1e24, "m^4"},
        required, {"second-moment", "second_moment_m4", "second moment of area I / mm⁴", 1e12}, has::shape},
    Key{"beam.density", beam<&BeamProperties::density>, {1e-6, 1e9, "kg/m^3"}, required,
        {"density", "density_kg_per_m3", "density ρ / (kg/m³)"}, has::beam_key},
    Key{"beam.youngs_modulus", beam<&BeamProperties::youngs_modulus>, {1e-3, 1e18, "Pa"}, required,
        {"stiffness", "youngs_modulus_Pa", "Young's modulus E / GPa", 1e-9}, has::beam_key},
    Key{"beam.axial_force", beam<&BeamProperties::axial_force>, {1e-18, 1e18, "N"}, required,
        {"force", "axial_force_N", "axial force P / N"}, has::adjustable_beam},
    Key{"beam.axial_direction", beam<&BeamProperties::axial_direction>, {1e-9, 1.0, ""}, optional,
        {"direction", "axial_direction", "direction of the axial force χ", 1.0, may_be_zero}, has::direction},
    Key{"beam.shear_stiffness", beam<&BeamProperties::shear_stiffness>, {1e-18, 1e24, "N"}, optional,
        {"shear", "shear_stiffness_N", "shear stiffness k G A / N"}, has::beam_key},
    Key{"beam.material", none, {}, shorthand},
    Key{"beam.poissons_ratio", section<&Section::poissons_ratio>, {1e-9, 1.0, ""}, optional,
        {"poisson", "poissons_ratio", "Poisson's ratio ν", 1.0, may_be_zero}, has::beam_key},
    Key{"model.mass", model<&ModelProperties::mass>, {1e-18, 1e18, "kg"}, required,
        {"mass", "mass_kg", "mass m / kg"}, has::adjustable_beam},
    Key{"model.stiffness", model<&ModelProperties::stiffness>, {1e-18, 1e24, "N/m"}, required,
        {"spring", "stiffness_N_per_m", "spring k / (N/m)", 1.0, may_be_zero}, has::adjustable_beam},
    Key{"model.damping", model<&ModelProperties::damping>, {1e-18, 1e24, "N s/m"}, optional,
        {"damper", "damping_N_s_per_m", "damper c / (N s/m)", 1.0, may_be_zero}, has::damper},
    Key{"model.normal_force", model<&ModelProperties::normal_force>, {1e-18, 1e18, "N"}, required,
        {"normal-force", "normal_force_N", "normal force N / N"}, has::limit},
    Key{"model.mass_matrix", none, {}, shorthand},
    Key{"model.stiffness_matrix", none, {}, shorthand},
    Key{"model.damping_matrix", none, {}, shorthand},
    Key{"model.dofs", none, {}, shorthand},
    Key{"model.base", none, {}, shorthand},
    Key{"model.fixed", none, {}, shorthand},
    Key{"model.contact", none, {}, shorthand},
    Key{"model.load", none, {}, shorthand},
    Key{"model.units", none, {}, shorthand},
    Key{"friction.static_coefficient", friction<&FrictionCoefficients::static_coefficient>, {1e-9, 1e6, ""},
        required, {"friction", "static_coefficient", "static friction coefficient μ_s"}, has::limit},
    Key{"friction.kinetic_coefficient", friction<&FrictionCoefficients::kinetic_coefficient>, {1e-9, 1e6, ""},
        required, {"kinetic", "kinetic_coefficient", "kinetic friction coefficient μ_m", 1.0, may_be_zero}},
    Key{"friction.decay", friction<&FrictionCoefficients::decay>, {1e-15, 1e15, "s/m"}, required,
        {"decay", "decay_s_per_m", "decay of the friction α / (s/m)", 1.0, may_be_zero}},
    Key{"friction.viscous", friction<&FrictionCoefficients::viscous>, {1e-15, 1e15, "s/m"}, optional,
        {"viscous", "viscous_s_per_m", "viscous friction β / (s/m)", 1.0, may_be_zero}},
    Key{"excitation.frequency_hz", frequency, {1e-9, 1e12, "Hz"}, required,
        {"frequency", "frequency_Hz", "excitation frequency / Hz"}, has::force},
    Key{"excitation.amplitude", amplitude<AmplitudeOf::displacement>, {1e-18, 1e6, "m"}, alternative,
        {"amplitude", "amplitude_m", "excitation amplitude A_0 / mm", 1e3, may_be_zero}, has::factor},
    Key{"excitation.velocity_amplitude", amplitude<AmplitudeOf::velocity>, {1e-18, 1e18, "m/s"}, alternative,
        {"velocity", "velocity_amplitude_m_per_s", "velocity amplitude of the base / m/s", 1.0, may_be_zero}, has::factor},
    Key{"excitation.acceleration_amplitude", amplitude<AmplitudeOf::acceleration>, {1e-18, 1e18, "m/s^2"},
        alternative, {"acceleration", "acceleration_amplitude_m_per_s2", "acceleration amplitude of the base / g",
        1.0 / 9.80665, may_be_zero}, has::factor},
    Key{"excitation.force", amplitude<AmplitudeOf::force>, {1e-18, 1e18, "N"}, alternative,
        {"shaker", "force_amplitude_N", "force amplitude F_0 / N", 1.0, may_be_zero}, has::factor},
    Key{"excitation.scale", excitation<&HarmonicMotion::scale>, {1e-9, 1e9, ""}, optional,
        {"scale", "scale", "scale of the excitation", 1.0, may_be_zero}, has::scale},
    Key{"excitation.sines", none, {}, shorthand},
    Key{"excitation.sweep", none, {}, shorthand},
    Key{"excitation.shock", none, {}, shorthand},
    Key{"excitation.file", none, {}, shorthand},
    Key{"excitation.spectrum", none, {}, shorthand},
    Key{"excitation.seed", none, {}, shorthand},
    Key{"excitation.column", none, {}, shorthand},
    Key{"excitation.quantity", none, {}, shorthand},
    Key{"excitation.unit", none, {}, shorthand},
    Key{"excitation.rate", none, {1e-9, 1e12, "Hz"}, shorthand},
    Key{"excitation.high_pass", none, {1e-9, 1e12, "Hz"}, shorthand},
    Key{"excitation.initial_displacement", none, {1e-18, 1e6, "m"}, shorthand},
    Key{"excitation.initial_velocity", none, {1e-18, 1e9, "m/s"}, shorthand},
    Key{"excitation.constant_force", constant_force, {1e-18, 1e18, "N"}, optional, {}, has::force},
    Key{"excitation.duration", numerics<&NumericalChoices::duration>, {1e-15, 1e15, "s"}, optional, {}, has::force},
    Key{"numerics.elements", numerics<&NumericalChoices::elements>, {}, optional, {}, has::force},
    Key{"numerics.time_step", numerics<&NumericalChoices::time_step>, {1e-15, 1e9, "s"}, optional},
    Key{"numerics.spectral_radius", numerics<&NumericalChoices::spectral_radius>, {}, optional},
    Key{"numerics.velocity_threshold", numerics<&NumericalChoices::velocity_threshold>, {1e-18, 1e9, "m/s"},
        optional},
    Key{"numerics.modes", numerics<&NumericalChoices::modes>, {}, optional, {}, has::force},
    Key{"numerics.duration", none, {1e-15, 1e15, "s"}, shorthand},
    Key{"damping.kelvin_voigt", damping<&DampingProperties::kelvin_voigt>, {1e-18, 1e6, "s"}, optional,
        {"kelvin-voigt", "kelvin_voigt_s", "Kelvin-Voigt damping η / s", 1.0, may_be_zero}, has::damper},
    Key{"damping.ratio", damping<&DampingProperties::ratio>, {1e-9, 1.0, ""}, optional,
        {"damping", "damping_ratio", "damping ratio ζ", 1.0, may_be_zero}, has::damper},
    Key{"damping.mass_proportional", damping<&DampingProperties::mass_proportional>, {1e-18, 1e9, "1/s"}, optional,
        {"mass-damping", "mass_proportional_per_s", "mass-proportional damping δ / (1/s)", 1.0, may_be_zero},
        has::damper},
    Key{"damping.ratios", none, {}, shorthand},
    Key{"contact.tangential_stiffness", contact<&ContactProperties::tangential_stiffness>, {1e-18, 1e24, "N/m"},
        optional, {}, has::force},
    Key{"contact.regularisation_velocity", contact<&ContactProperties::regularisation_velocity>,
        {1e-18, 1e9, "m/s"}, optional, {}, has::force},
    Key{"wall.speed", wall<&WallProperties::speed>, {1e-15, 1e9, "m/s"}, optional, {}, has::force},
    Key{"wall.with_base", wall<&WallProperties::with_base>, {}, optional, {}, has::force},
    Key{"wall.scale", wall_scale, {1e-9, 1e9, ""}, optional,
        {"wall-scale", "wall_scale", "scale of the motion of the wall", 1.0, may_be_zero}, has::scale},
    Key{"wall.amplitude", none, {1e-18, 1e6, "m"}, shorthand},
    Key{"wall.velocity_amplitude", none, {1e-18, 1e18, "m/s"}, shorthand},
    Key{"wall.acceleration_amplitude", none, {1e-18, 1e18, "m/s^2"}, shorthand},
    Key{"wall.sines", none, {}, shorthand},
    Key{"wall.sweep", none, {}, shorthand},
    Key{"wall.shock", none, {}, shorthand},
    Key{"wall.file", none, {}, shorthand},
    Key{"wall.spectrum", none, {}, shorthand},
    Key{"wall.seed", none, {}, shorthand},
    Key{"wall.column", none, {}, shorthand},
    Key{"wall.quantity", none, {}, shorthand},
    Key{"wall.unit", none, {}, shorthand},
    Key{"wall.rate", none, {1e-9, 1e12, "Hz"}, shorthand},
    Key{"wall.high_pass", none, {1e-9, 1e12, "Hz"}, shorthand},
    Key{"wall.initial_displacement", none, {1e-18, 1e6, "m"}, shorthand},
    Key{"wall.initial_velocity", none, {1e-18, 1e9, "m/s"}, shorthand},
    Key{"initial.position", initial<&InitialState::position>, {1e-18, 1e6, "m"}, optional, {}, has::force},
    Key{"initial.velocity", initial<&InitialState::velocity>, {1e-18, 1e9, "m/s"}, optional, {}, has::force},
    Key{"section.shape", none, {}, shorthand},
    Key{"section.width", section<&Section::width>, {1e-9, 1e6, "m"}, optional,
        {"width", "width_m", "width of the section / mm", 1e3}, has::adjustable_shape},
    Key{"section.height", section<&Section::height>, {1e-9, 1e6, "m"}, optional,
        {"height", "height_m", "height of the section / mm", 1e3}, has::adjustable_shape},
    Key{"section.diameter", section<&Section::diameter>, {1e-9, 1e6, "m"}, optional,
        {"diameter", "diameter_m", "diameter of the section / mm", 1e3}, has::adjustable_shape},
    Key{"section.wall_thickness", section<&Section::wall_thickness>, {1e-9, 1e6, "m"}, optional,
        {"wall-thickness", "wall_thickness_m", "wall thickness of the section / mm", 1e3}, has::adjustable_shape},
};
// clang-format on

}  // namespace key_table

CaseNumbers numbers_in(const Case& problem) {
  const auto* beam = std::get_if<Beam>(&problem.structure);
  const Model* model = problem.model();
  const GeneralMotion* motion = problem.general_motion();
  const auto& wall_motion = problem.contact.wall_motion;
  return {.beam = beam != nullptr ? beam->properties() : BeamProperties(),
          .model = model != nullptr ? model->properties() : ModelProperties(),
          .matrices = model != nullptr && !model->is_mass() ? model->shared_matrices() : nullptr,
          .friction = problem.contact.friction.coefficients(),
          .excitation =
              motion == nullptr ? problem.excitation().motion() : HarmonicMotion{.scale = motion->scale()},
          .motion = motion == nullptr ? std::nullopt : std::optional(*motion),
          .wall_motion = wall_motion,
          .wall_scale = wall_motion ? wall_motion->scale() : 1.0,
          .numerics = problem.numerics.choices(),
          .damping = problem.damping.properties(),
          .contact = problem.contact.compliance.properties(),
          .section = problem.section,
          .wall = problem.contact.wall.properties(),
          .initial = problem.initial,
          .constant_force = problem.constant_force};
}

// Whether a case has the number: not every section has every side.
bool has(const CaseNumbers& numbers, const Key& key) {
  return key.member.get != nullptr && key.is_of(numbers.kind()) && !std::isnan(key.member.get(numbers));
}

// Throws FieldError for numbers that no case, or not this structure, takes together.
void require_consistent(const CaseNumbers& numbers) {
  for (const char* path : {"excitation.constant_force", "initial.position", "initial.velocity"})
    if (const double value = key_named(path).member.get(numbers); !std::isfinite(value))
      throw FieldError(path, value, "a finite number (" + std::string(key_named(path).magnitudes.unit) + ")");
  const auto& [motion, wall_motion] = std::tie(numbers.motion, numbers.wall_motion);
  const bool is_force = motion ? motion->is_force() : numbers.excitation.amplitude_of == AmplitudeOf::force;
  const std::string force_key = motion ? motion->key() : "excitation.force";
  const std::string force = motion ? "a force" : shortest_text(numbers.excitation.amplitude);
  if (motion && is_force && numbers.kind() == StructureKind::beam)
    throw FieldError(force_key, force, "a motion of the base with a [beam]");
  if (wall_motion && wall_motion->is_force()) throw FieldError(wall_motion->key(), "a force", "a motion");
  if (wall_motion && numbers.wall.speed != 0.0)
    throw FieldError("wall.speed", numbers.wall.speed, "left out where " + wall_motion->key() + " is given");
  if (!wall_motion && numbers.wall_scale != 1.0)
    throw FieldError("wall.scale", numbers.wall_scale, "left out without a motion of the wall");
  if (numbers.kind() != StructureKind::matrices) return;
  if (is_force && numbers.matrices->load.empty())
    throw FieldError(force_key, force, "left out without model.load, the rows that it acts on");
  if (!is_force && !numbers.matrices->load.empty())
    throw FieldError("model.load", "given", "left out without excitation.force, which acts on it");
  const DampingProperties& damping = numbers.damping;
  if (!numbers.matrices->damping.empty() && Damping(damping).has_ratio())
    throw FieldError(damping.ratios.empty() ? "damping.ratio" : "damping.ratios",
                     damping.ratios.empty() ? damping.ratio : damping.ratios.front(),
                     "left out where model.damping_matrix is given");
}

// k A/(1 + nu) of the section, to which k G A is proportional with G = E/(2 (1 + nu)).
double shear_area(const Section& section) {
  if (!section.is_given()) return 1.0;
  return section.shear_coefficient() * section.area() /
         (std::isnan(section.poissons_ratio) ? 1.0 : 1.0 + section.poissons_ratio);
}

}  // namespace

bool state_the_same(std::string_view path, std::string_view other) {
  constexpr std::array<std::string_view, 2> durations{"excitation.duration", "numerics.duration"},
      shears{"beam.shear_stiffness", "beam.poissons_ratio"}, ratios{"damping.ratio", "damping.ratios"};
  const auto are_both_in = [&](std::span<const std::string_view> keys) {
    return std::ranges::find(keys, path) != keys.end() && std::ranges::find(keys, other) != keys.end();
  };
  constexpr std::array<std::string_view, 3> walls{"wall.amplitude", "wall.velocity_amplitude",
                                                  "wall.acceleration_amplitude"};
  return path == other || are_both_in(amplitude_keys) || are_both_in(walls) || are_both_in(durations) ||
         are_both_in(shears) || are_both_in(ratios);
}

const Key& key_stated(std::string_view path, std::string_view text) {
  const bool is_wall = path == "wall.amplitude";
  if (is_wall || path == amplitude_keys.front())
    for (const std::string_view other : amplitude_keys)
      if (const Key& key = key_named(other); quantity_in(text, key.magnitudes.unit, false)) {
        if (!is_wall) return key;
        if (other != amplitude_keys.back()) return key_named("wall." + std::string(key.name()));
      }
  return key_named(path);
}

const Key& stated_amplitude(const HarmonicExcitation& excitation) {
  return key_named(amplitude_keys.at(static_cast<std::size_t>(excitation.motion().amplitude_of)));
}

bool Key::is_of(StructureKind kind) const {
  const bool is_beam = kind == StructureKind::beam, is_mass = kind == StructureKind::mass;
  if (table() == "beam" || table() == "section" || path == "numerics.elements") return is_beam;
  if (table() == "damping") return !is_mass;
  if (table() == "initial" || path == "excitation.constant_force") return is_mass;
  if (path == "excitation.force" || path == "model.normal_force") return !is_beam;
  if (table() == "model")
    return kind == (member.get == nullptr ? StructureKind::matrices : StructureKind::mass);
  return true;
}

std::string Key::reason_against(StructureKind kind) const {
  if (path == "beam.axial_force") return "left out where [model] is given: its force is model.normal_force";
  if (path == "model.normal_force") return "left out with a [beam], whose force is beam.axial_force";
  if (kind == StructureKind::beam) return "left out without a table [model]";
  if (kind == StructureKind::mass && table() == "damping")
    return "left out with one mass, whose damper is model.damping";
  return is_of(StructureKind::beam) ? "left out where the table [model] is given"
                                    : "left out: it is for one mass alone";
}

std::span<const Key> case_keys() { return key_table::all; }

const Key& key_named(std::string_view path) {
  const auto* const found = std::ranges::find(key_table::all, path, &Key::path);
  if (found == key_table::all.end()) throw std::invalid_argument("there is no key " + std::string(path));
  return *found;
}

Structure structure_of(const CaseNumbers& numbers) {
  if (numbers.kind() == StructureKind::beam) return Beam(numbers.beam);
  if (numbers.matrices == nullptr) return Model(numbers.model);
  return Model(numbers.model.normal_force, numbers.matrices);
}

Motion motion_of(const CaseNumbers& numbers) {
  if (!numbers.motion) return HarmonicExcitation(numbers.excitation);
  return numbers.motion->scaled(numbers.excitation.scale).lasting(numbers.numerics.duration);
}

namespace {

std::optional<GeneralMotion> wall_motion_of(const CaseNumbers& numbers) {
  if (!numbers.wall_motion) return std::nullopt;
  return numbers.wall_motion->scaled(numbers.wall_scale).lasting(numbers.numerics.duration);
}

}  // namespace

Case case_of(const std::string& name, const CaseNumbers& numbers) {
  require_consistent(numbers);
  return {.name = printable(name, 255),  // that of a file, which may hold anything
          .structure = structure_of(numbers),
          .motion = motion_of(numbers),
          .contact = {.friction = FrictionLaw(numbers.friction),
                      .compliance = TangentialContact(numbers.contact),
                      .wall = Wall(numbers.wall),
                      .wall_motion = wall_motion_of(numbers)},
          .numerics = NumericalSettings(numbers.numerics),
          .damping = Damping(numbers.damping),
          .section = numbers.section,
          .default_numerics = {},
          .constant_force = numbers.constant_force,
          .initial = numbers.initial};
}

namespace {

// A flag that is not set, and a scale of 1.
bool is_left_out(const Key& key, double value) {
  return (key.member.is_flag && value == 0.0) || (key.name() == "scale" && value == 1.0);
}

}  // namespace

std::map<std::string, double> numbers_of(const Case& problem) {
  const CaseNumbers all = numbers_in(problem);
  std::map<std::string, double> numbers;
  for (const Key& key : key_table::all)
    if (has(all, key) && !is_left_out(key, key.member.get(all)) &&
        (key.presence != Presence::alternative || &key == &stated_amplitude(problem.excitation())))
      numbers.emplace(key.path, key.member.get(all));
  return numbers;
}

Case case_with(const std::string& name, const std::map<std::string, double>& numbers) {
  CaseNumbers all;
  if (numbers.contains("model.normal_force"))
    all.model = {.mass = 1.0, .stiffness = 0.0, .damping = 0.0, .normal_force = 1.0},
    all.numerics.elements = 1;
  for (const Key& key : key_table::all) {
    const std::string path(key.path);
    const bool must_be_there = key.presence != Presence::alternative && !key.member.is_flag &&
                               key.name() != "scale" && has(all, key);
    if (must_be_there || numbers.contains(path)) key.member.set(all, numbers.at(path));
  }
  return case_of(name, all);
}

double value_of(const Case& problem, std::string_view path) {
  const CaseNumbers numbers = numbers_in(problem);
  const Key& key = key_named(path);
  return has(numbers, key) ? key.member.get(numbers) : std::numeric_limits<double>::quiet_NaN();
}

namespace {

// A kinetic coefficient that is not stated is at most the static one.
CaseNumbers with_coefficients(CaseNumbers numbers, bool states_kinetic) {
  FrictionCoefficients& friction = numbers.friction;
  if (!states_kinetic)
    friction.kinetic_coefficient = std::min(friction.kinetic_coefficient, friction.static_coefficient);
  return numbers;
}

CaseNumbers numbers_with(const Case& problem,
                         const std::vector<std::pair<std::string_view, double>>& values) {
  const auto has_value = [&](std::string_view path) {
    return std::ranges::find(values, path, &std::pair<std::string_view, double>::first) != values.end();
  };
  const CaseNumbers before = numbers_in(problem);
  CaseNumbers after = before;
  for (const auto& [path, value] : values) {
    const Key& key = key_named(path);
    const bool may_come = key.name() == "poissons_ratio" && before.section.is_given();
    if (!key.is_of(before.kind())) throw FieldError(path, value, key.reason_against(before.kind()));
    const GeneralMotion* motion = problem.general_motion();
    if (!has(before, key) && motion != nullptr && key.table() == "excitation")
      throw FieldError(path, value, "left out: the motion is that of " + motion->key());
    if (!has(before, key) && !may_come)
      throw FieldError(path, value, "left out: the case has no [" + std::string(key.table()) + "] with it");
    key.member.set(after, value);
  }
  after.section.require_valid();
  if (std::ranges::any_of(values, [](const auto& value) { return value.first.starts_with("section."); })) {
    if (!has_value("beam.area")) after.beam.area = after.section.area();
    if (!has_value("beam.second_moment_of_area"))
      after.beam.second_moment_of_area = after.section.second_moment_of_area();
  }
  if (before.kind() != StructureKind::beam)
    return with_coefficients(after, has_value("friction.kinetic_coefficient"));
  if (has_value("beam.shear_stiffness"))
    after.section.poissons_ratio = Section{}.poissons_ratio;
  else if (has_value("beam.poissons_ratio"))
    after.beam.shear_stiffness = 0.5 * after.beam.youngs_modulus * shear_area(after.section);
  else
    after.beam.shear_stiffness *= after.beam.youngs_modulus / before.beam.youngs_modulus *
                                  (shear_area(after.section) / shear_area(before.section));
  if (has_value("beam.area") || has_value("beam.second_moment_of_area")) after.section = {};
  return with_coefficients(after, has_value("friction.kinetic_coefficient"));
}

Case remade(const Case& problem, const CaseNumbers& numbers) {
  Case made = case_of(problem.name, numbers);
  made.default_numerics = problem.default_numerics;
  return made;
}

}  // namespace

Case with_values(const Case& problem, const std::vector<std::pair<std::string_view, double>>& values) {
  return remade(problem, numbers_with(problem, values));
}

Case restated(const Case& problem, const std::vector<std::pair<std::string_view, double>>& values) {
  CaseNumbers numbers = numbers_with(problem, values);
  CaseNumbers defaults;
  defaults.numerics =
      default_numerics(structure_of(numbers), highest_frequency_hz(motion_of(numbers), numbers.wall_motion),
                       numbers.numerics.duration, Damping(numbers.damping));
  for (const std::string& path : problem.default_numerics) {
    const KeyMember& member = key_named(path).member;
    member.set(numbers, member.get(defaults));
  }
  return remade(problem, numbers);
}

Case with_value(const Case& problem, std::string_view path, double value) {
  return with_values(problem, {{path, value}});
}

}  // namespace stickslip::data
