// SPDX-License-Identifier: MIT
#pragma once

/// The one list of the parameters of a case: each key of a case file with all that readers, commands, maps and figures
/// need to know of it. A parameter is named by its path, "beam.length".

#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "stickslip/data/problem.hpp"

namespace stickslip::data {

/// What the structure of a case is given by.
enum class StructureKind { beam, mass, matrices };

/// Every number of a case, before the problem types check it.
struct CaseNumbers {
  BeamProperties beam;  ///< unless there is a `model`
  ModelProperties model;
  std::shared_ptr<const StructureMatrices> matrices;  ///< of a model that is not one mass
  FrictionCoefficients friction;
  HarmonicMotion excitation;            ///< of `motion` only its scale
  std::optional<GeneralMotion> motion;  ///< of the base, in place of one sine
  std::optional<GeneralMotion> wall_motion;
  double wall_scale{1.0};
  NumericalChoices numerics;
  DampingProperties damping;
  ContactProperties contact;
  Section section;
  WallProperties wall;
  InitialState initial;
  double constant_force{};

  /// A Model has a normal force.
  [[nodiscard]] StructureKind kind() const noexcept {
    if (std::isnan(model.normal_force) && std::isnan(model.mass) && matrices == nullptr)
      return StructureKind::beam;
    return matrices == nullptr ? StructureKind::mass : StructureKind::matrices;
  }
};

/// Magnitudes that a quantity may have unless it is 0: far wider than any beam, and so narrow that no product
/// of powers of them leaves the range of a double. The unit is the SI unit of the quantity, "" for a pure number.
struct Magnitudes {
  double smallest{}, largest{std::numeric_limits<double>::infinity()};
  std::string_view unit;
};

enum class Presence {
  required,
  optional,     ///< it has a default, or belongs to a section
  alternative,  ///< one of those that state the same is required
  shorthand     ///< stands for other keys while the file is read, and is no number of a case
};

/// How the number of a key is read and changed; empty for a shorthand.
struct KeyMember {
  double (*get)(const CaseNumbers&){};
  void (*set)(CaseNumbers&, double){};
  bool is_integer{};
  bool is_flag{};  ///< true or false, as 1 or 0
};

/// A key as the axis of a map, a sweep or a figure; empty if it cannot be one.
struct KeyAxis {
  std::string_view name;    ///< "force", as in --x force=100:500:5
  std::string_view column;  ///< of a table, "axial_force_N"
  std::string_view label;   ///< of a figure, "axial force P / N"
  double scale{1.0};        ///< from SI units to those of the label
  bool may_be_zero{};

  /// The unit that the label names, "N".
  [[nodiscard]] std::string_view unit() const { return label.substr(label.rfind(" / ") + 3); }
};

/// What changes with a key, for those who vary it.
struct KeyEffects {
  bool is_a_factor{};        ///< the force that holds the contact, or its limit, is proportional to it
  bool moves_the_force{};    ///< |f_max| per metre of amplitude
  bool varies_beam{};        ///< stiffness, mass or load of the beam, and with them buckling
  bool couples_modes{};      ///< shares or damping of the modes, beyond the load factor
  bool keeps_frequencies{};  ///< neither a natural frequency nor that of the excitation
  bool has_proportions{};    ///< length or section: whether the beam is slender
  bool is_adjustable{};      ///< a designer may change it by a tenth
};

struct Key {
  std::string_view path;  ///< "beam.length"
  KeyMember member;
  Magnitudes magnitudes;
  Presence presence{Presence::required};
  KeyAxis axis{};
  KeyEffects effects{};

  [[nodiscard]] std::string_view table() const { return path.substr(0, path.find('.')); }
  [[nodiscard]] std::string_view name() const { return path.substr(path.find('.') + 1); }
  /// A number of the case that is no integer: it may be uncertain.
  [[nodiscard]] bool is_real() const { return member.get != nullptr && !member.is_integer; }
  /// Whether a case with such a structure can have it.
  [[nodiscard]] bool is_of(StructureKind kind) const;
  /// Why it cannot: "left out with one mass, whose damper is model.damping".
  [[nodiscard]] std::string reason_against(StructureKind kind) const;
};

/// Every key of a case file, in the order of the manual.
[[nodiscard]] std::span<const Key> case_keys();

/// The key with this path. Throws std::invalid_argument if there is none.
[[nodiscard]] const Key& key_named(std::string_view path);

/// Whether two keys state one quantity, so that a case has one of them: the amplitude of displacement, velocity or acceleration, the
/// duration in either table, the shear stiffness or Poisson's ratio, one damping ratio or several. A key states the same as itself.
[[nodiscard]] bool state_the_same(std::string_view path, std::string_view other);

/// The key that a number with a unit is one of where it stands at `path`: of "2 g" at excitation.amplitude that of the
/// acceleration; else the key with this path.
[[nodiscard]] const Key& key_stated(std::string_view path, std::string_view text);

/// The key by which the case states the amplitude of its base.
[[nodiscard]] const Key& stated_amplitude(const HarmonicExcitation& excitation);

/// The structure with these numbers. Throws FieldError.
[[nodiscard]] Structure structure_of(const CaseNumbers& numbers);

/// The motion of the base with these numbers. Throws FieldError.
[[nodiscard]] Motion motion_of(const CaseNumbers& numbers);

/// The case with these numbers. Throws FieldError for a number that the problem types do not allow, and where a force and the rows
/// that it acts on are not given together, or a damping ratio besides a damping matrix.
[[nodiscard]] Case case_of(const std::string& name, const CaseNumbers& numbers);

/// The numbers of a case by their paths; without the keys of a section that it was not given by, flags that are not set and scales of 1,
/// and with the amplitude that it states.
[[nodiscard]] std::map<std::string, double> numbers_of(const Case& problem);

/// The case of a beam or one mass with these numbers_of(). Throws std::out_of_range for one that is missing, and FieldError.
[[nodiscard]] Case case_with(const std::string& name, const std::map<std::string, double>& numbers);

/// The value of a key in SI units; NaN for a key that the case does not have, as of a section that it was not
/// given by, or of another structure.
[[nodiscard]] double value_of(const Case& problem, std::string_view path);

/// The case with other values of some keys, SI units. What follows from them follows, unless it is among them: area and
/// second moment of area from the sides of the section; the shear stiffness k G A from Young's modulus (G ~ E), the
/// section and Poisson's ratio; a kinetic coefficient above the static one becomes equal to it. A case whose area, second
/// moment or shear stiffness is changed itself forgets the section or Poisson's ratio. Throws FieldError for a value
/// that a field does not allow, and for a key of a section that the case was not given by.
[[nodiscard]] Case with_values(const Case& problem,
                               const std::vector<std::pair<std::string_view, double>>& values);
[[nodiscard]] Case with_value(const Case& problem, std::string_view path, double value);
/// As with_values(), and Case::default_numerics are those of the new case, as if its file held these values.
[[nodiscard]] Case restated(const Case& problem,
                            const std::vector<std::pair<std::string_view, double>>& values);

}  // namespace stickslip::data
