// SPDX-License-Identifier: MIT
#include "stickslip/data/problem.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <numbers>

namespace stickslip::data {

FieldError::FieldError(std::string_view field, std::string_view value, std::string_view allowed)
    : InputError(std::string(field) + " is " + std::string(value) + ", but must be " + std::string(allowed)),
      field_(field) {}

std::string shortest_text(double value) {
  std::array<char, 32> buffer{};  // the longest shortest text of a double has 24 characters
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), result.ptr};
}

namespace {

void require_finite(std::string_view field, double value, std::string_view unit) {
  if (std::isfinite(value)) return;
  throw FieldError(field, value, "a finite number" + std::string(unit));
}

void require_positive(std::string_view field, double value, std::string_view unit) {
  if (std::isfinite(value) && value > 0.0) return;
  throw FieldError(field, value, "a finite number above 0" + std::string(unit));
}

void require_not_negative(std::string_view field, double value, std::string_view unit) {
  if (std::isfinite(value) && value >= 0.0) return;
  throw FieldError(field, value, "a finite number of 0 or more" + std::string(unit));
}

void require_between(std::string_view field, int value, int lowest, int highest) {
  if (lowest <= value && value <= highest) return;
  throw FieldError(field, std::to_string(value),
                   "an integer from " + std::to_string(lowest) + " to " + std::to_string(highest));
}

}  // namespace

Beam::Beam(const BeamProperties& properties) : properties_(properties) {
  require_positive("beam.length", length(), " (m)");
  require_positive("beam.area", area(), " (m^2)");
  require_positive("beam.second_moment_of_area", second_moment_of_area(), " (m^4)");
  require_positive("beam.density", density(), " (kg/m^3)");
  require_positive("beam.youngs_modulus", youngs_modulus(), " (Pa)");
  require_finite("beam.axial_force", axial_force(), " (N, compression positive)");
  if (!(axial_direction() >= 0.0 && axial_direction() <= 1.0))
    throw FieldError("beam.axial_direction", axial_direction(),
                     "a number from 0 (follows the tip) to 1 (keeps its direction)");
  require_not_negative("beam.shear_stiffness", shear_stiffness(), " (N; 0: rigid in shear)");
}

Model::Model(const ModelProperties& mass) : properties_(mass) {
  require_positive("model.mass", mass.mass, " (kg)");
  require_not_negative("model.stiffness", mass.stiffness, " (N/m)");
  require_not_negative("model.damping", mass.damping, " (N s/m)");
  require_positive("model.normal_force", mass.normal_force, " (N)");
  const auto link = [](double value) {  // between the rows of base and mass
    return std::vector<MatrixEntry>{{0, 0, value}, {0, 1, -value}, {1, 0, -value}, {1, 1, value}};
  };
  matrices_ = std::make_shared<const StructureMatrices>(StructureMatrices{.rows = 2,
                                                                          .mass = {{1, 1, mass.mass}},
                                                                          .stiffness = link(mass.stiffness),
                                                                          .damping = link(mass.damping),
                                                                          .base = {0},
                                                                          .fixed = {},
                                                                          .contact = {{1}},
                                                                          .load = {{1}},
                                                                          .files = {}});
}

Model::Model(double normal_force, std::shared_ptr<const StructureMatrices> matrices)
    : properties_{.normal_force = normal_force}, matrices_(std::move(matrices)) {
  require_positive("model.normal_force", normal_force, " (N)");
}

bool Model::is_mass() const noexcept { return !std::isnan(properties_.mass); }

bool Model::operator==(const Model& other) const noexcept {
  if (normal_force() != other.normal_force()) return false;
  if (is_mass() != other.is_mass()) return false;
  if (!is_mass()) return matrices_ == other.matrices_;
  return properties_.mass == other.properties_.mass && properties_.stiffness == other.properties_.stiffness &&
         properties_.damping == other.properties_.damping;
}

bool Section::is_given() const noexcept { return !std::isnan(width) || !std::isnan(diameter); }

void Section::require_valid() const {
  const auto require_side = [](std::string_view field, double side) {
    if (!std::isnan(side)) require_positive(field, side, " (m)");
  };
  require_side("section.width", width);
  require_side("section.height", height);
  require_side("section.diameter", diameter);
  require_side("section.wall_thickness", wall_thickness);
  if (wall_thickness > 0.5 * diameter)
    throw FieldError("section.wall_thickness", wall_thickness,
                     "at most half of section.diameter, which is " + shortest_text(diameter));
  if (poissons_ratio <= -1.0 || poissons_ratio >= 0.5)
    throw FieldError("beam.poissons_ratio", poissons_ratio, "a number above -1 and below 0.5");
}

double Section::area() const noexcept {
  if (!std::isnan(width)) return width * height;
  if (std::isnan(wall_thickness)) return std::numbers::pi * diameter * diameter / 4.0;
  return std::numbers::pi * wall_thickness * (diameter - wall_thickness);
}

// Of a tube with the inner diameter b: d^4 - b^4 = (d^2 - b^2) (d^2 + b^2), without a difference of near numbers.
double Section::second_moment_of_area() const noexcept {
  if (!std::isnan(width)) return width * height * height * height / 12.0;
  const double d = diameter, b = d - 2.0 * wall_thickness;
  if (std::isnan(wall_thickness)) return std::numbers::pi * d * d * d * d / 64.0;
  return area() * (d * d + b * b) / 16.0;
}

double Section::shear_coefficient() const noexcept {
  const double nu = poissons_ratio;
  if (std::isnan(nu)) return 1.0;
  if (!std::isnan(width)) return 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu);
  if (std::isnan(wall_thickness)) return 6.0 * (1.0 + nu) / (7.0 + 6.0 * nu);
  const double b = diameter - 2.0 * wall_thickness, ratio = b * b / (diameter * diameter);
  const double sum = (1.0 + ratio) * (1.0 + ratio);
  return 6.0 * (1.0 + nu) * sum / ((7.0 + 6.0 * nu) * sum + (20.0 + 12.0 * nu) * ratio);
}

FrictionLaw::FrictionLaw(const FrictionCoefficients& coefficients) : coefficients_(coefficients) {
  require_not_negative("friction.static_coefficient", static_coefficient(), "");
  require_not_negative("friction.kinetic_coefficient", kinetic_coefficient(), "");
  if (kinetic_coefficient() > static_coefficient())
    throw FieldError("friction.kinetic_coefficient", kinetic_coefficient(),
                     "at most friction.static_coefficient, which is " + shortest_text(static_coefficient()));
  if (!(decay() >= 0.0))
    throw FieldError("friction.decay", decay(), "a number of 0 or more (s/m), or inf for a jump");
  require_not_negative("friction.viscous", viscous(), " (s/m)");
}

FrictionLaw FrictionLaw::in_slip() const {
  if (std::isfinite(decay())) return *this;
  return FrictionLaw({.static_coefficient = kinetic_coefficient(),
                      .kinetic_coefficient = kinetic_coefficient(),
                      .viscous = viscous()});
}

TangentialContact::TangentialContact(const ContactProperties& properties) : properties_(properties) {
  if (!(tangential_stiffness() > 0.0))
    throw FieldError("contact.tangential_stiffness", tangential_stiffness(),
                     "a number above 0 (N/m), or inf for a rigid contact");
  require_not_negative("contact.regularisation_velocity", regularisation_velocity(), " (m/s)");
  if (has_spring() && is_smooth())
    throw FieldError(
        "contact.regularisation_velocity", regularisation_velocity(),
        "0 with a finite contact.tangential_stiffness: a spring in series with a smooth law that falls "
        "with the velocity has no motion");
}

bool TangentialContact::has_spring() const noexcept { return std::isfinite(tangential_stiffness()); }

void require_rigid(const TangentialContact& contact, std::string_view what) {
  if (contact.has_spring())
    throw FieldError("contact.tangential_stiffness", contact.tangential_stiffness(),
                     "inf (a rigid contact) for " + std::string(what));
  if (contact.is_smooth())
    throw FieldError("contact.regularisation_velocity", contact.regularisation_velocity(),
                     "0 (the set-valued law) for " + std::string(what));
}

void require_usable(const FrictionLaw& friction, const TangentialContact& contact) {
  if (contact.is_rigid() || std::isfinite(friction.decay())) return;
  throw FieldError(
      "friction.decay", friction.decay(),
      std::string("finite (s/m) with ") +
          (contact.has_spring() ? "contact.tangential_stiffness" : "contact.regularisation_velocity") +
          ": a contact that moves at rest would never feel friction.static_coefficient");
}

HarmonicExcitation::HarmonicExcitation(const HarmonicMotion& motion)
    : motion_(motion),
      unit_amplitude_(
          1.0 / std::pow(2.0 * std::numbers::pi * motion.frequency_hz, derivatives(motion.amplitude_of))) {
  require_positive("excitation.frequency_hz", frequency_hz(), " (Hz)");
  constexpr std::array units{" (m)", " (m/s)", " (m/s^2)", " (N)"};
  const auto kind = static_cast<std::size_t>(motion.amplitude_of);
  require_not_negative(amplitude_keys.at(kind), motion.amplitude, units.at(kind));
  require_not_negative("excitation.scale", motion.scale, "");
}

HarmonicMotion HarmonicExcitation::stated_as(AmplitudeOf kind) const {
  if (kind == motion_.amplitude_of) return motion_;
  const double omega = 2.0 * std::numbers::pi * frequency_hz();
  return {frequency_hz(), motion_.amplitude * unit_amplitude_ * std::pow(omega, derivatives(kind)), kind,
          motion_.scale};
}

Damping::Damping(const DampingProperties& properties) : properties_(properties) {
  require_not_negative("damping.kelvin_voigt", kelvin_voigt(), " (s)");
  if (!(ratio() >= 0.0 && ratio() < 1.0))
    throw FieldError("damping.ratio", ratio(), "a number from 0 to below 1");
  require_not_negative("damping.mass_proportional", mass_proportional(), " (1/s)");
  for (const double ratio_of_mode : properties.ratios)
    if (!(ratio_of_mode >= 0.0 && ratio_of_mode < 1.0))
      throw FieldError("damping.ratios", ratio_of_mode, "a list of numbers from 0 to below 1");
  if (!properties.ratios.empty() && ratio() != 0.0)
    throw FieldError("damping.ratio", ratio(), "0 where damping.ratios is given");
}

bool Damping::has_ratio() const noexcept {
  return ratio() > 0.0 ||
         std::ranges::any_of(properties_.ratios, [](double of_mode) { return of_mode > 0.0; });
}

void require_undamped(const Damping& damping, std::string_view allowed) {
  for (const auto& [path, kind] : {std::pair{"damping.kelvin_voigt", &DampingProperties::kelvin_voigt},
                                   {"damping.ratio", &DampingProperties::ratio},
                                   {"damping.mass_proportional", &DampingProperties::mass_proportional}})
    if (const double value = damping.properties().*kind; value != 0.0)
      throw FieldError(path, value, std::string(allowed));
  if (!damping.properties().ratios.empty())
    throw FieldError("damping.ratios", damping.properties().ratios.front(), allowed);
}

void require_kelvin_voigt(const Damping& damping, std::string_view allowed) {
  DampingProperties others = damping.properties();
  others.kelvin_voigt = 0.0;
  require_undamped(Damping(others), allowed);
}

Wall::Wall(const WallProperties& properties) : properties_(properties) {
  require_finite("wall.speed", speed(), " (m/s)");
}

NumericalSettings::NumericalSettings(const NumericalChoices& choices) : choices_(choices) {
  require_between("numerics.elements", elements(), 1, 100000);
  require_positive("numerics.time_step", time_step(), " (s)");
  if (!(spectral_radius() >= 0.0 && spectral_radius() <= 1.0))
    throw FieldError("numerics.spectral_radius", spectral_radius(), "a number from 0 to 1");
  require_not_negative("numerics.velocity_threshold", velocity_threshold(), " (m/s)");
  require_between("numerics.modes", modes(), 1, 200);
  require_positive("excitation.duration", duration(), " (s)");
  if (duration() < time_step())
    throw FieldError("excitation.duration", duration(),
                     "at least numerics.time_step, which is " + shortest_text(time_step()));
  constexpr double most_steps = 1e9;
  if (duration() > most_steps * time_step())
    throw FieldError("excitation.duration", duration(),
                     "at most a billion times numerics.time_step, which is " + shortest_text(time_step()));
}

namespace {

// Whether base or wall have a general motion of this kind, as 1 or 0.
template <bool Wall, std::size_t Kind>
constexpr FeatureKey general_motion(std::string_view path) {
  return {.path = path,
          .feature = Feature::general_motion,
          .value =
              [](const Case& of) {
                const auto* base = of.general_motion();
                const auto* wall = of.contact.wall_motion ? &*of.contact.wall_motion : nullptr;
                const auto* motion = Wall ? wall : base;
                return motion != nullptr && motion->statement().index() == Kind ? 1.0 : 0.0;
              },
          .word = "given"};
}

}  // namespace

std::span<const FeatureKey> feature_keys() {
  static constexpr auto of_beam = [](const Case& of, auto number) {
    const auto* beam = std::get_if<Beam>(&of.structure);
    return beam == nullptr ? 0.0 : std::invoke(number, *beam);
  };
  static constexpr std::array keys{
      FeatureKey{"model.normal_force", Feature::own_structure,
                 [](const Case& of) { return of.model() == nullptr ? 0.0 : of.normal_force(); }},
      FeatureKey{"damping.kelvin_voigt", Feature::kelvin_voigt,
                 [](const Case& of) { return of.damping.kelvin_voigt(); }},
      FeatureKey{"damping.ratio", Feature::other_damping, [](const Case& of) { return of.damping.ratio(); }},
      FeatureKey{"damping.mass_proportional", Feature::other_damping,
                 [](const Case& of) { return of.damping.mass_proportional(); }},
      FeatureKey{"damping.ratios", Feature::other_damping,
                 [](const Case& of) {
                   const std::vector<double>& ratios = of.damping.properties().ratios;
                   return ratios.empty() ? 0.0 : *std::ranges::max_element(ratios);
                 }},
      FeatureKey{"contact.tangential_stiffness", Feature::yielding_contact,
                 [](const Case& of) { return of.contact.compliance.tangential_stiffness(); },
                 std::numeric_limits<double>::infinity()},
      FeatureKey{"contact.regularisation_velocity", Feature::yielding_contact,
                 [](const Case& of) { return of.contact.compliance.regularisation_velocity(); }},
      FeatureKey{"wall.speed", Feature::moving_wall, [](const Case& of) { return of.contact.wall.speed(); }},
      FeatureKey{"beam.shear_stiffness", Feature::shear,
                 [](const Case& of) { return of_beam(of, &Beam::shear_stiffness); }},
      FeatureKey{"beam.axial_direction", Feature::fixed_axial_force,
                 [](const Case& of) { return of_beam(of, &Beam::axial_direction); }},
      FeatureKey{"wall.with_base", Feature::wall_with_base,
                 [](const Case& of) { return of.contact.wall.moves_with_base() ? 1.0 : 0.0; }, 0.0, "true"},
      FeatureKey{"excitation.force", Feature::force,
                 [](const Case& of) {
                   const auto* sine = std::get_if<HarmonicExcitation>(&of.motion);
                   if (sine == nullptr) return of.general_motion()->is_force() ? 1.0 : 0.0;
                   return sine->is_force() ? sine->motion().amplitude : 0.0;
                 }},
      FeatureKey{"excitation.constant_force", Feature::constant_force,
                 [](const Case& of) { return of.constant_force; }},
      FeatureKey{"initial.position", Feature::initial_state,
                 [](const Case& of) { return of.initial.position; }},
      FeatureKey{"initial.velocity", Feature::initial_state,
                 [](const Case& of) { return of.initial.velocity; }},
      general_motion<false, 0>("excitation.sines"),
      general_motion<false, 1>("excitation.sweep"),
      general_motion<false, 2>("excitation.shock"),
      general_motion<false, 3>("excitation.file"),
      general_motion<false, 4>("excitation.spectrum"),
      general_motion<true, 0>("wall.sines"),
      general_motion<true, 1>("wall.sweep"),
      general_motion<true, 2>("wall.shock"),
      general_motion<true, 3>("wall.file"),
      general_motion<true, 4>("wall.spectrum")};
  return keys;
}

const Beam& Case::beam() const {
  if (const auto* beam = std::get_if<Beam>(&structure)) return *beam;
  throw FieldError("model.normal_force", normal_force(),
                   "left out: this is for a [beam] alone, not for a [model]");
}

const HarmonicExcitation& Case::excitation() const {
  if (const auto* sine = std::get_if<HarmonicExcitation>(&motion)) return *sine;
  throw FieldError(general_motion()->key(), "given",
                   "left out: this needs one sine, by excitation.frequency_hz");
}

double highest_frequency_hz(const Motion& base, const std::optional<GeneralMotion>& wall) {
  const auto* sine = std::get_if<HarmonicExcitation>(&base);
  const double highest =
      sine != nullptr ? sine->frequency_hz() : std::get<GeneralMotion>(base).highest_frequency_hz();
  return wall ? std::max(highest, wall->highest_frequency_hz()) : highest;
}

double highest_frequency_hz(const Case& problem) {
  return highest_frequency_hz(problem.motion, problem.contact.wall_motion);
}

bool Case::is_damped() const noexcept {
  const auto loses = [](const MatrixEntry& entry) { return entry.value != 0.0; };
  return !damping.is_none() ||
         (model() != nullptr && std::ranges::any_of(model()->matrices().damping, loses));
}

bool Case::is_random() const noexcept {
  const auto has_spectrum = [](const GeneralMotion& of) {
    return std::holds_alternative<PowerSpectrum>(of.statement());
  };
  const auto* base = general_motion();
  const auto& wall = contact.wall_motion;
  const bool base_rests = base == nullptr && excitation().amplitude() == 0.0;
  return (base != nullptr || wall) && (base_rests || (base != nullptr && has_spectrum(*base))) &&
         (!wall || has_spectrum(*wall));
}

double Case::normal_force() const noexcept {
  const auto* beam = std::get_if<Beam>(&structure);
  return beam != nullptr ? beam->axial_force() : std::get<Model>(structure).normal_force();
}

bool Case::has(Feature feature) const noexcept {
  return std::ranges::any_of(feature_keys(), [&](const FeatureKey& key) {
    return key.feature == feature && key.value(*this) != key.plain;
  });
}

}  // namespace stickslip::data
