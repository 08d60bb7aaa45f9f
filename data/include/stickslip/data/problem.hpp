// SPDX-License-Identifier: MIT
#pragma once

/// The problem statement, and nothing that follows from it.
///
/// Won, Lee and Chung, "Stick-slip vibration of a cantilever beam subjected to harmonic base excitation",
/// Nonlinear Dynamics (2018), Sects. 2 and 3. A beam, clamped in a base that moves by h(t), is pressed by an axial
/// force P against a frictional wall at its other end. Governing equation, for the deflection u relative to the
/// base, with a dot for a derivative in time and a prime for one in x:
///
///     ρA ü + EI u'''' + P u'' = -ρA ḧ,      h(t) = A0 sin(2π f t),                                       (1)
///
/// with u = u' = 0 at x = 0 and, at x = L, u'' = 0 and the friction force on the beam
///
///     f_d = -(EI u''' + χ P u').
///
/// The paper has χ = 0, an axial force that follows the tip.
///
/// With a shear stiffness kGA (Timoshenko, Phil. Mag. 41, 1921) the section rotates by φ, and
///
///     ρA (ü + ḧ) = [kGA (u' - φ) - P u']',     ρI φ̈ = EI φ'' + kGA (u' - φ),                             (1b)
///
/// with u = φ = 0 at x = 0 and, at x = L, φ' = 0 and
///
///     f_d = kGA (u' - φ) - P u' + (1 - χ) P φ.
///
/// P acts along the axis of the beam (Engesser), and the part of it that follows the tip follows its section.
///
/// Every quantity is in SI units. Derived quantities (E I, ρ A, Ω, μ(v), h(t)) are left to each of the
/// two implementations on purpose, so that a slip in one of them shows when they are compared.

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include "stickslip/data/general_motion.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/data/model.hpp"

namespace stickslip::data {

/// What a Beam is built from; field names are the keys of the table [beam] in a case file.
struct BeamProperties {
  double length{};                 ///< L, m, > 0
  double area{};                   ///< A, m², > 0
  double second_moment_of_area{};  ///< I, m⁴, > 0
  double density{};                ///< ρ, kg/m³, > 0
  double youngs_modulus{};         ///< E, Pa, > 0
  double axial_force{};            ///< P, N, compression positive, any finite value
  /// χ, 0 ≤ χ ≤ 1: P has the slope (1 - χ) u_x(L), 0 if it follows the tip (the paper), 1 if it keeps
  /// its direction (a dead load, the normal force of a flat wall)
  double axial_direction{};
  double shear_stiffness{};  ///< k G A, N, ≥ 0; 0 for the beam of Euler and Bernoulli, rigid in shear

  bool operator==(const BeamProperties&) const = default;
};

/// A uniform beam. Cannot be built invalid.
class Beam {
 public:
  /// Throws FieldError.
  explicit Beam(const BeamProperties& properties);

  [[nodiscard]] double length() const noexcept { return properties_.length; }
  [[nodiscard]] double area() const noexcept { return properties_.area; }
  [[nodiscard]] double second_moment_of_area() const noexcept { return properties_.second_moment_of_area; }
  [[nodiscard]] double density() const noexcept { return properties_.density; }
  [[nodiscard]] double youngs_modulus() const noexcept { return properties_.youngs_modulus; }
  [[nodiscard]] double axial_force() const noexcept { return properties_.axial_force; }
  [[nodiscard]] double axial_direction() const noexcept { return properties_.axial_direction; }
  [[nodiscard]] double shear_stiffness() const noexcept { return properties_.shear_stiffness; }
  [[nodiscard]] const BeamProperties& properties() const noexcept { return properties_; }
  bool operator==(const Beam&) const = default;

 private:
  BeamProperties properties_;
};

/// The cross-section, if the beam was given by its sides: those of one shape, NaN for the others. Field names are the keys of
/// the table [section]; poissons_ratio is one of [beam].
struct Section {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  double width{none};           ///< b of a rectangle, m
  double height{none};          ///< of a rectangle, in the direction of vibration, m
  double diameter{none};        ///< d of a circle, outer one of a tube, m
  double wall_thickness{none};  ///< t of a tube, m, at most d/2
  double poissons_ratio{none};  ///< ν; NaN if the shear stiffness is not from it

  [[nodiscard]] bool is_given() const noexcept;
  /// Throws FieldError for a side that is not above 0, or for another number that no section has.
  void require_valid() const;
  [[nodiscard]] double area() const noexcept;
  [[nodiscard]] double second_moment_of_area() const noexcept;
  /// k of k G A: Cowper, J. Appl. Mech. 33, 335-340 (1966); 1 without Poisson's ratio.
  [[nodiscard]] double shear_coefficient() const noexcept;
};

/// What a FrictionLaw is built from; field names are the keys of the table [friction].
struct FrictionCoefficients {
  double static_coefficient{};   ///< μ_s, ≥ 0
  double kinetic_coefficient{};  ///< μ_m, 0 ≤ μ_m ≤ μ_s: what the exponential leaves at high velocity
  double decay{};                ///< α, s/m, ≥ 0; infinite for a jump from μ_s to μ_m
  double viscous{};              ///< β, s/m, ≥ 0
};

/// The exponential friction law of Eq. (7) with a viscous term,
///
///     μ(v) = μ_m + (μ_s - μ_m) exp(-α |v|) + β |v|.
///
/// Coulomb friction is μ_m = μ_s and β = 0, the paper's law β = 0. With 0 < β < (μ_s - μ_m) α it has a minimum
/// (Stribeck) at |v| = ln((μ_s - μ_m) α/β)/α. μ is convex in |v| and falls no faster than (μ_s - μ_m) α, but may
/// exceed μ_s. With α infinite the contact holds up to μ_s while it sticks, and μ is μ_m + β |v| as soon as it
/// slides. Cannot be built invalid.
class FrictionLaw {
 public:
  /// Throws FieldError.
  explicit FrictionLaw(const FrictionCoefficients& coefficients);

  [[nodiscard]] double static_coefficient() const noexcept { return coefficients_.static_coefficient; }
  [[nodiscard]] double kinetic_coefficient() const noexcept { return coefficients_.kinetic_coefficient; }
  [[nodiscard]] double decay() const noexcept { return coefficients_.decay; }
  [[nodiscard]] double viscous() const noexcept { return coefficients_.viscous; }
  [[nodiscard]] const FrictionCoefficients& coefficients() const noexcept { return coefficients_; }
  /// The law while the contact slides, with a finite α: of a jump what it leaves, else the same law.
  [[nodiscard]] FrictionLaw in_slip() const;

 private:
  FrictionCoefficients coefficients_;
};

/// What a TangentialContact is built from; field names are the keys of the table [contact].
struct ContactProperties {
  double tangential_stiffness{std::numeric_limits<double>::infinity()};  ///< k_t, N/m, > 0; infinite: rigid
  double regularisation_velocity{};  ///< v_r, m/s, ≥ 0; 0: the set-valued law
};

/// Compliance of the contact. By default it is rigid: in stick, friction is the force that holds the contact, up to
/// μ_s N (the set-valued law). Cannot be built invalid. Either of these, but not both:
///
/// - A spring k_t in series with friction (Jenkins element). With the position z of the slider and x of the contact
///
///       f_d = k_t (z - x),     |f_d| ≤ μ(max(d v_s, 0)) N,     d = -sgn(f_d),
///
///   and z moves only to keep the bound, in the direction d. The coefficient is that of the sliding velocity v_s = x_t
///   of the contact, as a spring without mass cannot follow a law that falls with the velocity of the slider.
/// - A smooth law, f_d = -μ(|v_s|) N tanh(v_s/v_r): a contact that creeps and never sticks.
class TangentialContact {
 public:
  TangentialContact() = default;
  /// Throws FieldError.
  explicit TangentialContact(const ContactProperties& properties);

  [[nodiscard]] double tangential_stiffness() const noexcept { return properties_.tangential_stiffness; }
  [[nodiscard]] double regularisation_velocity() const noexcept {
    return properties_.regularisation_velocity;
  }
  [[nodiscard]] const ContactProperties& properties() const noexcept { return properties_; }
  [[nodiscard]] bool has_spring() const noexcept;
  [[nodiscard]] bool is_smooth() const noexcept { return regularisation_velocity() > 0.0; }
  /// Neither: the set-valued law.
  [[nodiscard]] bool is_rigid() const noexcept { return !has_spring() && !is_smooth(); }

 private:
  ContactProperties properties_;
};

/// Throws FieldError, naming the key of [contact], unless the contact is rigid; `what` needs it to be.
void require_rigid(const TangentialContact& contact, std::string_view what);

/// Throws FieldError, naming friction.decay, for a jump of the friction law with a contact that is not rigid: as it
/// never is quite at rest, the static coefficient would not act.
void require_usable(const FrictionLaw& friction, const TangentialContact& contact);

/// The keys that state an amplitude, by AmplitudeOf.
inline constexpr std::array<std::string_view, 4> amplitude_keys{
    "excitation.amplitude", "excitation.velocity_amplitude", "excitation.acceleration_amplitude",
    "excitation.force"};

/// What a HarmonicExcitation is built from; field names are the keys of the table [excitation].
struct HarmonicMotion {
  double frequency_hz{};       ///< Hz, > 0
  double amplitude{};          ///< as it is stated, m, m/s, m/s² or N, ≥ 0
  AmplitudeOf amplitude_of{};  ///< what it is the amplitude of
  double scale{1.0};           ///< of the amplitude, ≥ 0
};

/// Harmonic base displacement h(t) = A0 sin(Ω t), Ω = 2 π frequency_hz. The k-th derivative of h has the amplitude A0 Ω^k. One
/// of these amplitudes is stated, times a scale, and stays where the frequency changes. A force F0 sin(Ω t) on the load of a Model is
/// -h_tt times 1 kg: it has A0 = F0 Ω^-2, and everything per unit of A0 holds for it as for an acceleration. Cannot be built
/// invalid.
class HarmonicExcitation {
 public:
  /// Throws FieldError.
  explicit HarmonicExcitation(const HarmonicMotion& motion);

  [[nodiscard]] double frequency_hz() const noexcept { return motion_.frequency_hz; }
  /// A0, m.
  [[nodiscard]] double amplitude() const noexcept { return stated() * unit_amplitude_; }
  /// The amplitude as it is stated, times the scale.
  [[nodiscard]] double stated() const noexcept { return motion_.amplitude * motion_.scale; }
  /// A0 where what is stated is 1: Ω^-k, m.
  [[nodiscard]] double unit_amplitude() const noexcept { return unit_amplitude_; }
  [[nodiscard]] const HarmonicMotion& motion() const noexcept { return motion_; }
  /// Whether it is a force on the load of a Model, in place of a motion of the base.
  [[nodiscard]] bool is_force() const noexcept { return motion_.amplitude_of == AmplitudeOf::force; }
  /// The same motion by another statement.
  [[nodiscard]] HarmonicMotion stated_as(AmplitudeOf kind) const;

 private:
  HarmonicMotion motion_;
  double unit_amplitude_;
};

/// What a Damping is built from; field names are the keys of the table [damping].
struct DampingProperties {
  double kelvin_voigt{};  ///< η, s, ≥ 0: the bending moment is EI (u_xx + η u_xxt)
  /// ζ, 0 ≤ ζ < 1: fraction of critical damping of every mode of the beam with its tip free and P = 0
  double ratio{};
  double mass_proportional{};  ///< δ, 1/s, ≥ 0: a force -δ ρA u_t per length, u_t relative to the base
  /// ζ_n of mode n in place of one ζ for all; the last one is that of all further modes
  std::vector<double> ratios{};

  bool operator==(const DampingProperties&) const = default;
};

/// Damping of the motion relative to the base, the same in stick and slip; none by default. The kinds add. Cannot be built
/// invalid.
class Damping {
 public:
  Damping() = default;
  /// Throws FieldError.
  explicit Damping(const DampingProperties& properties);

  [[nodiscard]] double kelvin_voigt() const noexcept { return properties_.kelvin_voigt; }
  [[nodiscard]] double ratio() const noexcept { return properties_.ratio; }
  /// ζ of a mode from 1 on, without the other kinds.
  [[nodiscard]] double ratio_of(std::size_t mode) const noexcept {
    const auto& ratios = properties_.ratios;
    return ratios.empty() ? ratio() : ratios[std::min(mode, ratios.size()) - 1];
  }
  /// Whether any mode has ζ > 0.
  [[nodiscard]] bool has_ratio() const noexcept;
  [[nodiscard]] double mass_proportional() const noexcept { return properties_.mass_proportional; }
  [[nodiscard]] const DampingProperties& properties() const noexcept { return properties_; }
  [[nodiscard]] bool is_none() const noexcept {
    return !has_ratio() && kelvin_voigt() == 0.0 && mass_proportional() == 0.0;
  }
  /// Kelvin-Voigt damping or none: what a beam has in closed form.
  [[nodiscard]] bool is_kelvin_voigt() const noexcept { return !has_ratio() && mass_proportional() == 0.0; }
  /// Of a mode, a fraction of critical: ζ + (η ω + δ/ω)/2, ω in rad/s; ζ of the first mode unless it is told.
  [[nodiscard]] double ratio_at(double angular_frequency, std::size_t mode = 1) const noexcept {
    return ratio_of(mode) +
           0.5 * (kelvin_voigt() * angular_frequency + mass_proportional() / angular_frequency);
  }
  bool operator==(const Damping&) const = default;

 private:
  DampingProperties properties_;
};

/// Throws FieldError, naming the first key of [damping] that is not 0; `allowed` is the end of its sentence, "0 for ...".
void require_undamped(const Damping& damping, std::string_view allowed);
/// The same, but there may be Kelvin-Voigt damping.
void require_kelvin_voigt(const Damping& damping, std::string_view allowed);

/// What a Wall is built from; field names are the keys of the table [wall].
struct WallProperties {
  double speed{};    ///< V, m/s, any finite value; 0 in the paper
  bool with_base{};  ///< the wall moves by h(t) besides
};

/// The wall that the tip is pressed against. It does not move with the base: the paper's tip sticks while y(L) = h + u(L)
/// is constant. A wall that moves by V t along the direction of y makes the sliding velocity v_s = y_t(L) - V, and a tip
/// that sticks moves with V. Steady sliding on it has v_s = -V and the friction force f_d = sgn(V) μ(|V|) P. A wall that
/// belongs to the base moves by h + V t: then v_s = u_t(L) - V. Cannot be built invalid.
class Wall {
 public:
  Wall() = default;
  /// Throws FieldError.
  explicit Wall(const WallProperties& properties);
  explicit Wall(double speed) : Wall(WallProperties{.speed = speed}) {}

  [[nodiscard]] double speed() const noexcept { return properties_.speed; }
  [[nodiscard]] bool moves_with_base() const noexcept { return properties_.with_base; }
  [[nodiscard]] const WallProperties& properties() const noexcept { return properties_; }

 private:
  WallProperties properties_;
};

/// How the contact of one mass starts; field names are the keys of the table [initial]. At rest on the wall by default.
struct InitialState {
  double position{};  ///< of the mass, m, in the frame at rest; the wall's contact then has the position 0
  double velocity{};  ///< of the mass, m/s, in the frame at rest

  bool operator==(const InitialState&) const = default;
};

/// What NumericalSettings are built from; field names are the keys of the table [numerics].
struct NumericalChoices {
  int elements{};               ///< number of finite elements, 1 ... 100000
  double time_step{};           ///< s, > 0
  double spectral_radius{};     ///< of generalised-alpha at infinite frequency, 0 ... 1
  double velocity_threshold{};  ///< ε of Sect. 3, m/s, ≥ 0
  int modes{};                  ///< N of Eq. (21), 1 ... 200
  double duration{};            ///< s, 1 ... 1e9 times time_step; in a case file excitation.duration
};

/// Settings of both implementations. Cannot be built invalid.
class NumericalSettings {
 public:
  /// Throws FieldError.
  explicit NumericalSettings(const NumericalChoices& choices);

  [[nodiscard]] int elements() const noexcept { return choices_.elements; }
  [[nodiscard]] double time_step() const noexcept { return choices_.time_step; }
  [[nodiscard]] double spectral_radius() const noexcept { return choices_.spectral_radius; }
  [[nodiscard]] double velocity_threshold() const noexcept { return choices_.velocity_threshold; }
  [[nodiscard]] int modes() const noexcept { return choices_.modes; }
  [[nodiscard]] double duration() const noexcept { return choices_.duration; }
  [[nodiscard]] const NumericalChoices& choices() const noexcept { return choices_; }

 private:
  NumericalChoices choices_;
};

/// What vibrates: one of these. They state no derived quantity.
using Structure = std::variant<Beam, Model>;

/// The motion of the base: one of these.
using Motion = std::variant<HarmonicExcitation, GeneralMotion>;

/// The frictional contact: law, compliance and wall. The force that closes it is Case::normal_force().
struct Contact {
  FrictionLaw friction;
  TangentialContact compliance{};
  Wall wall{};
  std::optional<GeneralMotion> wall_motion{};  ///< besides that of `wall`, on the clock of the base
};

/// What a case, or a run of it, asks for beyond a beam of Euler and Bernoulli without damping on a rigid contact at rest.
enum class Feature {
  slip,               ///< the motion after the first slip, with its changes of contact
  kelvin_voigt,       ///< damping.kelvin_voigt
  other_damping,      ///< damping.ratio or damping.mass_proportional
  yielding_contact,   ///< a spring or a smooth law of friction, [contact]
  moving_wall,        ///< wall.speed
  shear,              ///< beam.shear_stiffness
  fixed_axial_force,  ///< beam.axial_direction
  own_structure,      ///< a Model in place of a beam
  wall_with_base,     ///< wall.with_base
  force,              ///< excitation.force
  constant_force,     ///< excitation.constant_force
  initial_state,      ///< [initial]
  general_motion,     ///< a GeneralMotion of base or wall
  start_at_rest,      ///< u_t(x,0) = 0, of a run
  contact_scheme,     ///< a choice of it, of a run
  further_columns     ///< accelerations and reactions, of a run
};

/// One complete problem with the settings to solve it.
struct Case {
  std::string name;
  Structure structure;
  Motion motion;
  Contact contact;
  NumericalSettings numerics;
  Damping damping{};
  Section section{};  ///< the beam's, as long as its area and second moment of area follow from it
  std::set<std::string>
      default_numerics{};  ///< the keys of [numerics] that its file leaves to data::default_numerics()

  double constant_force{};  ///< N, on the contact, in the direction of y
  InitialState initial{};

  /// Throws FieldError, naming model.normal_force, for a Model: what calls this needs a beam.
  [[nodiscard]] const Beam& beam() const;
  /// nullptr for a beam.
  [[nodiscard]] const Model* model() const noexcept { return std::get_if<Model>(&structure); }
  /// Throws FieldError, naming the key that states the motion, for a GeneralMotion: what calls this needs one sine.
  [[nodiscard]] const HarmonicExcitation& excitation() const;
  /// nullptr for one sine.
  [[nodiscard]] const GeneralMotion* general_motion() const noexcept {
    return std::get_if<GeneralMotion>(&motion);
  }
  /// Whether the excitation is a force on the load of a Model, in place of a motion of the base.
  [[nodiscard]] bool is_force() const noexcept {
    return std::visit([](const auto& excitation) { return excitation.is_force(); }, motion);
  }
  /// Whether the structure loses energy without friction: by [damping], or by what a Model has of its own.
  [[nodiscard]] bool is_damped() const noexcept;
  /// Whether spectra alone move base and wall, at least one of them.
  [[nodiscard]] bool is_random() const noexcept;
  /// N, newton: the axial force of a beam, or that of a Model.
  [[nodiscard]] double normal_force() const noexcept;
  /// Whether one of feature_keys() asks for it; a feature of a run is none of a case.
  [[nodiscard]] bool has(Feature feature) const noexcept;
};

/// A key that asks for a feature by any other number than `plain`.
struct FeatureKey {
  std::string_view path;  ///< "wall.speed"
  Feature feature{};
  double (*value)(const Case&){};  ///< SI units; `plain` where the case has no such key
  double plain{};
  std::string_view word{};  ///< in place of the number, "true" or "given"
};

/// All of them; two keys may ask for one feature.
[[nodiscard]] std::span<const FeatureKey> feature_keys();

/// Hz: of one sine its frequency, else the higher of the highest frequencies of the motions of base and wall.
[[nodiscard]] double highest_frequency_hz(const Motion& base, const std::optional<GeneralMotion>& wall);
[[nodiscard]] double highest_frequency_hz(const Case& problem);

/// The case with other parts, each known by its type: with(problem, excitation, damping). Another beam has no section.
template <typename... Part>
[[nodiscard]] Case with(Case problem, const Part&... parts) {
  const auto set = [&problem](const auto& part) {
    using Type = std::remove_cvref_t<decltype(part)>;
    if constexpr (std::is_same_v<Type, Beam>) {
      problem.structure = part;
      problem.section = {};
    } else if constexpr (std::is_same_v<Type, HarmonicExcitation> || std::is_same_v<Type, GeneralMotion>) {
      problem.motion = part;
    } else {
      std::get<Type&>(std::tie(problem.contact.friction, problem.numerics, problem.damping,
                               problem.contact.compliance, problem.contact.wall)) = part;
    }
  };
  (set(parts), ...);
  return problem;
}

}  // namespace stickslip::data
