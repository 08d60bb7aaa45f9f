// SPDX-License-Identifier: MIT
#include "stickslip/analytic/damped_reaction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include "arguments.hpp"
#include "separated_system.hpp"
#include "special_functions.hpp"
#include "stickslip/analytic/contact_dynamics.hpp"
#include "stickslip/analytic/timoshenko_modes.hpp"

namespace stickslip::analytic {
namespace {

using Complex = std::complex<double>;

constexpr double kUnitRoundoff = 0.5 * std::numeric_limits<double>::epsilon();
constexpr double kMostPieces = 1e8;

constexpr double kTail = 1.04;
constexpr double kNearUnderflow = -700.0;  // in exp(), which is slow beyond
constexpr double kForgotten = -37.0;       // exp() of it is below the unit roundoff: the rest is in rounding_

// exp(x), 0 where that is below the unit roundoff.
double decay(double x) { return x > kForgotten ? std::exp(x) : 0.0; }

double cubed(double x) { return x * x * x; }

// P of one sign of Ω, the amplitude of what drives a share.
Complex drive(const ModalShare& share, double signed_omega) {
  return 0.5 * (std::abs(signed_omega) * share.cosine -
                Complex(0.0, signed_omega * std::abs(signed_omega)) * share.sine);
}

// The shares of `half` at the places of those of `all` with the nearest eigenvalues, and at the others shares of nothing.
std::vector<ModalShare> matched(const std::vector<ModalShare>& all, const std::vector<ModalShare>& half) {
  std::vector<ModalShare> partners(all.size());
  std::vector<bool> taken(all.size(), false);
  for (std::size_t k = 0; k < all.size(); ++k) partners[k].eigenvalue = all[k].eigenvalue;
  for (const ModalShare& share : half) {
    double least = std::numeric_limits<double>::infinity();
    std::size_t nearest = 0;
    for (std::size_t k = 0; k < all.size(); ++k)
      if (const double distance = std::abs(all[k].eigenvalue - share.eigenvalue);
          !taken[k] && distance < least) {
        least = distance;
        nearest = k;
      }
    taken[nearest] = true;
    partners[nearest] = share;
  }
  return partners;
}

// On a base that moves by sin(t): Ω = 1 rad/s.
ContactModel unit_motion(const HeldStructure& structure) {
  return contact_model(structure,
                       data::HarmonicExcitation({.frequency_hz = 0.5 / std::numbers::pi, .amplitude = 1.0}));
}

}  // namespace

DampedReaction damped_reaction(const HeldStructure& structure, SteadyPart steady_part) {
  const ContactDynamics dynamics(unit_motion(structure));
  const Harmonic force = dynamics.held_force();

  // f = -f_d, and w = -h.
  DampedReaction reaction;
  reaction.quasi_static = structure.wall_share * dynamics.held_stiffness() - structure.base_stiffness;
  if (steady_part == SteadyPart::exact) reaction.inertia = -(force.sine + reaction.quasi_static);
  reaction.rate = -force.cosine;
  for (const auto& share : StickPropagator(dynamics).force_shares())
    reaction.shares.push_back({share.eigenvalue, -share.sine, -share.cosine, {}});
  return reaction;
}

DampedReaction compliant_reaction(const HeldStructure& structure, double tangential_stiffness) {
  require_free_mass(structure);
  HeldStructure without_static_load = structure;
  without_static_load.base_stiffness = 0.0;
  const ContactDynamics dynamics(unit_motion(without_static_load));
  const std::size_t m = dynamics.modes(), size = m + 1;
  const double scale = dynamics.fastest();
  const double static_share = (structure.wall_share * dynamics.held_stiffness() - structure.base_stiffness) /
                              (dynamics.held_stiffness() + tangential_stiffness);  // x_s
  const double drift = static_share - structure.wall_share;  // of the static part of u_c
  // Accelerations from rest under the load with sin(t), and under that with cos(t) while the contact drifts.
  std::vector<double> state(2 * size), sine(size), cosine(size);
  sine[m] = drift + dynamics.accelerate(view(state.data(), m), {.sine = 1.0}, 0.0, std::span(sine).first(m));
  state.back() = drift;
  cosine[m] = dynamics.accelerate(view(state.data(), m), {.cosine = 1.0}, 0.0, std::span(cosine).first(m));

  DampedReaction reaction;
  reaction.quasi_static = tangential_stiffness * static_share;
  const auto [eigenvalue, shape, inverse, error] = separated_system(
      first_order_matrix(dynamics, std::vector<double>(size, scale), scale, tangential_stiffness),
      "eigenvalues of the beam on its contact spring");
  if (!(error <= 1e-9))  // nine digits
    throw std::runtime_error(
        "a mode of the beam on its contact spring is too nearly critically damped to be separated.");
  for (std::size_t k = 0; k < eigenvalue.size(); ++k) {
    constexpr double rounding = 1e-9;
    if (eigenvalue[k].real() > rounding || (eigenvalue[k].imag() == 0.0 && eigenvalue[k].real() > -rounding))
      throw data::FieldError("contact.tangential_stiffness", tangential_stiffness,
                             "so large that the beam on its contact spring neither buckles nor flutters");
    const Complex weight = tangential_stiffness / scale * shape[m * eigenvalue.size() + k];
    const Complex* to_coordinate = &inverse[k * 2 * size + size];
    ModalShare share;
    share.eigenvalue = scale * Complex(std::min(eigenvalue[k].real(), 0.0), eigenvalue[k].imag());
    share.start = -static_share * weight * to_coordinate[m];
    for (std::size_t n = 0; n < size; ++n) {
      share.sine += weight * to_coordinate[n] * sine[n];
      share.cosine += weight * to_coordinate[n] * cosine[n];
    }
    reaction.shares.push_back(share);
  }
  return reaction;
}

DampedForce::DampedForce(const DampedReaction& reaction, double angular_frequency, double duration)
    : omega_(angular_frequency), duration_(duration) {
  require_positive("excitation.frequency_hz", angular_frequency);
  require_positive("excitation.duration", duration);
  const double omega = angular_frequency;
  const Complex i(0.0, 1.0);
  // sin = Re[-i exp(i Ω t)]
  Complex steady = -i * (reaction.quasi_static + reaction.inertia * omega * omega) + reaction.rate * omega;
  Complex apart = steady;  // without what is in the beats
  double cancelled = std::abs(steady);
  terms_.push_back({.amplitude = 0.0, .exponent = i * omega});
  for (const ModalShare& one : reaction.shares) {
    const Complex eigenvalue = one.eigenvalue;
    Complex transient = one.start * omega;
    for (const double sign : {1.0, -1.0}) {
      const Complex amplitude = drive(one, sign * omega), pole = sign * i * omega;
      const Complex share = amplitude / (pole - eigenvalue);
      steady += sign > 0.0 ? share : std::conj(share);
      if (std::abs(pole - eigenvalue) * duration < 2.0) {
        near_resonant_terms_.push_back({amplitude, pole, eigenvalue});
        continue;
      }
      apart += sign > 0.0 ? share : std::conj(share);
      cancelled += std::abs(share);
      transient -= share;
    }
    terms_.push_back({.amplitude = transient, .exponent = eigenvalue});
  }
  terms_.front().amplitude = apart;
  for (Term& term : terms_) {
    term.size = std::abs(term.amplitude);
    term.third = term.size * cubed(std::abs(term.exponent));
  }
  steady_amplitude_ = std::abs(steady);

  const auto operations = static_cast<double>(terms_.size() + near_resonant_terms_.size()) + 20.0;
  rounding_ = operations * cancelled;
  for (const Term& term : terms_) {
    // A phase is wrong by up to |λ| t eps, and counts while exp(Re λ t) lets it.
    const double longest = std::min(duration, 1.0 / (std::numbers::e * std::abs(term.exponent.real())));
    rounding_ += term.size * (4.0 * std::abs(term.exponent) * longest + operations);
  }
  for (const NearResonantTerm& beat : near_resonant_terms_)
    rounding_ +=
        std::abs(beat.amplitude) * duration * (4.0 * std::abs(beat.exponent) * duration + operations);
  rounding_ *= kUnitRoundoff;
}

DampedForce::DampedForce(const DampedReaction& reaction, double angular_frequency, double duration,
                         const DampedReaction& half)
    : DampedForce(reaction, angular_frequency, duration) {
  bound_omitted(reaction, half);
}

void DampedForce::bound_omitted(const DampedReaction& reaction, const DampedReaction& half) {
  const Complex i(0.0, 1.0);
  Complex steady =
      -i * (reaction.quasi_static - half.quasi_static + (reaction.inertia - half.inertia) * omega_ * omega_) +
      (reaction.rate - half.rate) * omega_;
  Complex apart = steady;  // without what is in the beats
  double rounding = 0.0, beats = 0.0, fastest = 0.0;
  for (const ModalShare& share : reaction.shares) fastest = std::max(fastest, std::abs(share.eigenvalue));
  const auto partners = matched(reaction.shares, half.shares);
  for (std::size_t k = 0; k < partners.size(); ++k) {
    const ModalShare &now = reaction.shares[k], &before = partners[k];
    const double slip = 8.0 * kUnitRoundoff * fastest,
                 shift = std::abs(now.eigenvalue - before.eigenvalue) + slip;
    const double rate = -std::max(now.eigenvalue.real(), before.eigenvalue.real());
    Complex change = (now.start - before.start) * omega_;
    double size = std::abs(now.start) * omega_;
    for (const double sign : {1.0, -1.0}) {
      const Complex pole = sign * i * omega_, p = drive(now, sign * omega_), q = drive(before, sign * omega_);
      const Complex share = p / (pole - now.eigenvalue), difference = share - q / (pole - before.eigenvalue);
      const double distance = std::min(std::abs(pole - now.eigenvalue), std::abs(pole - before.eigenvalue));
      steady += sign > 0.0 ? difference : std::conj(difference);
      rounding += std::abs(share) * slip / distance;
      if (distance * duration_ < 2.0) {
        beats += duration_ * (std::abs(p - q) + 0.5 * shift * duration_ * std::abs(p));
        continue;
      }
      apart += sign > 0.0 ? difference : std::conj(difference);
      change -= difference;
      size += std::abs(share);
    }
    omitted_.push_back({std::abs(change), rate});
    // t exp(-d t) ≤ T exp(-d t), and ≤ 2/(e d) exp(-d t/2)
    if (rate * duration_ < 1.0)
      omitted_.push_back({size * shift * duration_, rate});
    else
      omitted_.push_back({size * shift * 2.0 / (std::numbers::e * rate), 0.5 * rate});
  }
  omitted_.push_back({std::abs(apart) + beats + rounding, 0.0});
  for (Decay& decay : omitted_) decay.amplitude *= kTail;
  steady_omitted_ = kTail * (std::abs(steady) + rounding);
}

double DampedForce::omitted(double t) const {
  double sum = 0.0;
  for (const auto& [amplitude, rate] : omitted_)
    sum += amplitude * std::exp(std::max(-rate * t, kNearUnderflow));
  return sum;
}

void DampedForce::add(TaylorCoefficients& sum, const Term& term, double t) const {
  const Complex value =
                    term.amplitude * std::polar(std::exp(term.exponent.real() * t), term.exponent.imag() * t),
                slope = term.exponent * value;
  sum.value += value.real();
  sum.slope += slope.real();
  sum.curvature += (term.exponent * slope).real();
}

void DampedForce::add(TaylorCoefficients& sum, const NearResonantTerm& beat, double t) const {
  const Complex value = beat.amplitude * exponential_difference(beat.pole, beat.exponent, t);
  const Complex forcing = beat.amplitude * std::exp(beat.pole * t);
  const Complex slope = beat.exponent * value + forcing;
  sum.value += value.real();
  sum.slope += slope.real();
  sum.curvature += (beat.exponent * slope + beat.pole * forcing).real();
}

TaylorCoefficients DampedForce::jet(double t) const {
  TaylorCoefficients sum;
  for (const Term& term : terms_)
    if (term.exponent.real() * t > kForgotten) add(sum, term, t);
  for (const NearResonantTerm& beat : near_resonant_terms_) add(sum, beat, t);
  return sum;
}

double DampedForce::transient_bound(double t) const {
  double sum = 0.0;
  for (std::size_t k = 1; k < terms_.size(); ++k)
    sum += terms_[k].size * decay(terms_[k].exponent.real() * t);
  return sum;
}

/// All pieces of one width at a time, from the first one on. A piece whose upper bound does not exceed the larger of `enough_` and
/// lower (1 + relative width) is done with; a lower bound above `too_much_` ends the search.
class DampedForce::Search {
 public:
  Search(const DampedForce& force, double relative_width, double enough, double too_much)
      : force_(force), relative_width_(relative_width), enough_(enough), too_much_(too_much) {
    for (const NearResonantTerm& beat : force.near_resonant_terms_) {
      const double b = std::abs(beat.amplitude), w = std::abs(beat.exponent), o = force.omega_;
      beats_value_ += b * force.duration_;
      beats_third_ += b * (cubed(w) * force.duration_ + w * w + w * o + o * o);
    }
    double end = force.duration_;
    if (const auto settled = settling_time()) {
      end = *settled;
      const double amplitude = force.terms_.front().size;
      const double rest = force.transient_bound(end) + force.omitted(end) + force.rounding_;
      lower_ = std::max(0.0, amplitude - rest);
      upper_ = amplitude + rest;
    }
    look(end);
    require_count(end * force.omega_);
    const double count = std::ceil(end * force.omega_ / 64.0);
    radius_ = 0.5 * end / count;
    for (double k = 0.0; k < count; ++k) centres_.push_back((2.0 * k + 1.0) * radius_);
    while (!centres_.empty() && lower_ <= too_much_) halve();
  }

  [[nodiscard]] Bounds bounds() const { return {lower_, std::max(lower_, upper_)}; }

 private:
  void see(double t, double value, double uncertainty) {
    lower_ = std::max(lower_, std::abs(value) - uncertainty - force_.omitted(t));
  }

  void look(double end) {
    constexpr int looks = 16;
    const double early = std::min(end, 60.0 / force_.omega_);
    for (int k = 1; k <= looks && lower_ <= too_much_; ++k)
      for (const double span : {early, end})
        see(span * k / looks, force_.value(span * k / looks), force_.rounding_);
  }

  void require_count(double count) const {
    if (!(count <= kMostPieces))
      throw data::FieldError("excitation.duration", force_.duration_,
                             "at most " + data::shortest_text(force_.duration_ * kMostPieces / count) +
                                 " s, a hundred million pieces");
  }

  /// From when on the steady vibration bounds the force, if that is half a period before the end.
  [[nodiscard]] std::optional<double> settling_time() const {
    const double enough = 0.25 * relative_width_ * force_.terms_.front().size;
    const double last = force_.duration_ - std::numbers::pi / force_.omega_;
    if (!force_.near_resonant_terms_.empty() || !(last > 0.0) || force_.transient_bound(last) > enough)
      return std::nullopt;
    double early = 0.0, late = last;
    for (int k = 0; k < 20; ++k) {
      const double middle = 0.5 * (early + late);
      (force_.transient_bound(middle) > enough ? early : late) = middle;
    }
    return late;
  }

  [[nodiscard]] bool is_done(double upper) const {
    return upper <= std::max(enough_, (1.0 + relative_width_) * lower_ + 2.0 * force_.rounding_);
  }

  /// The bound of a piece without what is omitted from its value and parabola; `amplitudes` is that from the amplitudes.
  [[nodiscard]] double upper_of(double centre, double amplitudes) {
    const double reach = cubed(radius_) / 6.0;
    TaylorCoefficients sum;
    double rest = force_.rounding_, excess = 0.0;
    for (std::size_t k = 0; k < force_.terms_.size(); ++k) {
      const Term& term = force_.terms_[k];
      if (decay_[k] == 0.0) continue;
      if (term.third * reach < term.size) {
        force_.add(sum, term, centre);
        excess += term.third * decay_[k] * reach;
      } else {
        rest += term.size * decay_[k];
      }
    }
    for (const NearResonantTerm& beat : force_.near_resonant_terms_) force_.add(sum, beat, centre);
    excess += beats_third_ * reach;
    see(centre, sum.value, rest);
    return std::min(amplitudes,
                    largest_parabola(sum.value, sum.slope, sum.curvature, radius_) + excess + rest);
  }

  /// The bound of all that comes from t on by the amplitudes, and decay_.
  [[nodiscard]] double amplitudes_from(double t) {
    double sum = beats_value_ + force_.rounding_;
    decay_.clear();
    for (const Term& term : force_.terms_) {
      decay_.push_back(decay(term.exponent.real() * t));
      sum += term.size * decay_.back();
    }
    return sum;
  }

  void halve() {
    std::vector<double> left;
    for (const double centre : centres_) {
      if (lower_ > too_much_) return;
      const double start = std::max(0.0, centre - radius_), omitted = force_.omitted(start);
      double upper = amplitudes_from(start);
      if (is_done(upper + omitted)) {  // and so are all later ones
        upper_ = std::max(upper_, upper + omitted);
        break;
      }
      if (radius_ * force_.omega_ <= 1.0) upper = upper_of(centre, upper);  // else too wide for a parabola
      // What is omitted widens the bounds, but no more than it does at the end of the piece, twice.
      if (is_done(upper + omitted) ||
          (is_done(upper - omitted) && omitted <= 2.0 * force_.omitted(centre + radius_))) {
        upper_ = std::max(upper_, upper + omitted);
        continue;
      }
      left.push_back(centre - 0.5 * radius_);
      left.push_back(centre + 0.5 * radius_);
    }
    require_count(static_cast<double>(left.size()));
    centres_ = std::move(left);
    radius_ *= 0.5;
  }

  const DampedForce& force_;
  double relative_width_, enough_, too_much_;
  double beats_value_{}, beats_third_{};
  double lower_{}, upper_{};
  double radius_{};
  std::vector<double> centres_;
  std::vector<double> decay_;  // exp(Re λ t) by term, at the start of a piece
};

Bounds DampedForce::refined_to(double relative_width) const {
  return refined_to(relative_width, 0.0, std::numeric_limits<double>::infinity());
}

Bounds DampedForce::refined_to(double relative_width, double enough, double too_much) const {
  require_relative_width(relative_width);
  if (const double most = upper_bound(); most <= enough) return {0.0, most};
  return Search(*this, relative_width, enough, too_much).bounds();
}

double DampedForce::upper_bound() const {
  double sum = terms_.front().size + transient_bound(0.0) + omitted(0.0) + rounding_;
  for (const NearResonantTerm& beat : near_resonant_terms_) sum += std::abs(beat.amplitude) * duration_;
  return sum;
}

}  // namespace stickslip::analytic
