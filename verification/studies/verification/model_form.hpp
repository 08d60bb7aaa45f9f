// SPDX-License-Identifier: MIT
#pragma once

/// The effect of choices in the model. The axial force follows the tip in the paper (χ = 0), but the normal force of a
/// flat wall keeps its direction (χ = 1). The beam of the paper has neither shear nor rotary inertia nor damping, and its
/// contact is rigid; beams have damping, and contacts a tangential stiffness.

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/common/members.hpp"

namespace stickslip::studies {

/// What takes the place of the rigid contact and the undamped beam; by default nothing.
struct ModelVariant {
  /// k_t over 3 EI/L³, the stiffness of the cantilever at its tip; infinite for a rigid contact
  double stiffness_ratio{std::numeric_limits<double>::infinity()};
  double damping_ratio{};  ///< damping.ratio
};
STICKSLIP_MEMBERS(ModelVariant, (stiffness_ratio, "1"), (damping_ratio, "1"))

/// The criterion |f_max| ≤ μ_s P over the plane of a figure of the paper in another model against the model of the
/// paper, closed form.
struct ModelPlane {
  std::string figures{};   ///< "10 to 12"
  ModelVariant variant{};  ///< of variant_planes()
  std::size_t cells{};     ///< with a stick state in both models
  std::size_t to_stick{};  ///< of these, slipping in the model of the paper and sticking in the other
  std::size_t to_slip{};   ///< the other way round
  /// Cells that have a stable stick state in the model of the paper alone, and are in no other number here.
  std::size_t lost{};
  std::size_t buckled{};  ///< for χ = 1: cells at which the sliding beam is at its buckling load or over it
  /// |f_max| in the other model over that in the model of the paper, over the cells.
  double lowest_ratio{std::numeric_limits<double>::infinity()}, highest_ratio{};
  [[nodiscard]] double flipped_share() const {
    return static_cast<double>(to_stick + to_slip) / static_cast<double>(cells);
  }
  [[nodiscard]] double buckled_share() const {
    return static_cast<double>(buckled) / static_cast<double>(cells);
  }
};
STICKSLIP_MEMBERS(ModelPlane, (figures, "-"), (variant), (lost, "1"), (lowest_ratio, "1"),
                  (highest_ratio, "1"), (flipped_share(), "1"), (buckled_share(), "1"))

/// |f_max| with χ = 1 over that with χ = 0 at one frequency, numerics.duration() and modes() of the case.
struct AxialDirectionForce {
  double frequency_hz{}, ratio{};
};
STICKSLIP_MEMBERS(AxialDirectionForce, (frequency_hz, "Hz"), (ratio, "1"))

struct ModelForm {
  std::vector<AxialDirectionForce> forces;  ///< of the paper's beam at the frequencies of Fig. 12
  std::vector<ModelPlane> planes;           ///< χ = 1 in Figs. 10 to 12, which share one plane, 13 and 14
  std::vector<ModelPlane> shear;            ///< the same planes, of the beams of with_shear()
};
STICKSLIP_MEMBERS(ModelForm, (forces), (planes), (shear))

/// `paper`, `half_stiffness` and `flat_section` are the cases of Figs. 10 to 12, 13 and 14. The planes are the
/// excitations of Fig. 12 and, for Fig. 14, `lengths` from 0.4 to 2 m (at least 2) by figure14_axial_forces().
[[nodiscard]] ModelForm model_form(const data::Case& paper, const data::Case& half_stiffness,
                                   const data::Case& flat_section, int lengths);

/// The variant on the planes of model_form(), against the rigid contact and the undamped beam, both with the exact steady
/// part of the rigid contact. A law that falls with the velocity lets a compliant contact slip at less than μ_s P: that is
/// not in here. Of Fig. 14 every `stride`-th axial force is taken.
[[nodiscard]] std::vector<ModelPlane> variant_planes(const ModelVariant& variant, const data::Case& paper,
                                                     const data::Case& half_stiffness,
                                                     const data::Case& flat_section, int lengths,
                                                     std::size_t stride = 1);

}  // namespace stickslip::studies
