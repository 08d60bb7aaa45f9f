// SPDX-License-Identifier: MIT
#include "stickslip/analytic/random_reaction.hpp"

#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_linalg.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "gsl_handles.hpp"
#include "stickslip/data/fourier_transform.hpp"

namespace stickslip::analytic {
namespace {

using Complex = HeldTransfer::Complex;
constexpr double pi = std::numbers::pi;

const data::PowerSpectrum* spectrum_of(const data::GeneralMotion* motion) {
  return motion == nullptr ? nullptr : std::get_if<data::PowerSpectrum>(&motion->statement());
}

// λ_0, λ_1, λ_2 and E[f_n f].
using Integrals = std::vector<double>;

class Integrator {
 public:
  Integrator(const ContactModel& model, const RandomDrive& drive)
      : transfer_(model), drive_(drive), size_(3 + model.modes()) {}

  // Over an interval of frequencies, Hz, between the nodes of Gauss and Legendre.
  [[nodiscard]] Integrals rule(double from, double to) const {
    Integrals sum(size_);
    for_each_gauss_point(from, to, 1, [&](double hz, double weight) { add(hz, weight, sum); });
    return sum;
  }
  // In halves until they agree with the whole.
  [[nodiscard]] Integrals refined(double from, double to, const Integrals& whole, const Integrals& total,
                                  int depth = 0) const {
    constexpr double enough = 1e-12;
    constexpr int deepest = 40;
    const double middle = 0.5 * (from + to);
    Integrals left = rule(from, middle), right = rule(middle, to);
    const auto agrees = [&](std::size_t j) {
      return std::abs(left[j] + right[j] - whole[j]) <= enough * total[j];
    };
    if (depth < deepest && !(agrees(0) && agrees(2))) {
      left = refined(from, middle, left, total, depth + 1);
      right = refined(middle, to, right, total, depth + 1);
    }
    for (std::size_t j = 0; j < size_; ++j) left[j] += right[j];
    return left;
  }

 private:
  void add(double hz, double weight, Integrals& sum) const {
    const double omega = 2.0 * pi * hz;
    for (const bool of_wall : {false, true}) {
      const auto* spectrum = of_wall ? drive_.wall : drive_.base;
      if (spectrum == nullptr) continue;
      const double scale = of_wall ? drive_.wall_scale : drive_.base_scale,
                   density = weight * scale * scale * spectrum->density(hz);
      const auto terms = transfer_.terms(omega, of_wall);
      Complex force = 0.0;
      for (const Complex& term : terms) force += term;
      for (std::size_t j = 0; j < 3; ++j)
        sum[j] += density * std::norm(force) * std::pow(omega, static_cast<double>(j));
      for (std::size_t n = 0; n + 1 < terms.size(); ++n)
        sum[3 + n] += density * (terms[n] * std::conj(force)).real();
    }
  }

  HeldTransfer transfer_;
  const RandomDrive& drive_;
  std::size_t size_;
};

// Corners of the spectra, natural frequencies and powers of 2, Hz, where there is a density.
std::vector<double> corners(const ContactModel& model, const RandomDrive& drive) {
  double lowest = std::numeric_limits<double>::infinity(), highest = 0.0;
  std::vector<double> all;
  for (const auto* spectrum : {drive.base, drive.wall}) {
    if (spectrum == nullptr) continue;
    for (const auto& point : spectrum->points) all.push_back(point.frequency_hz);
    lowest = std::min(lowest, spectrum->points.front().frequency_hz);
    highest = std::max(highest, spectrum->points.back().frequency_hz);
  }
  for (const double omega : model.angular_frequency) all.push_back(omega / (2.0 * pi));
  for (double edge = std::exp2(std::ceil(std::log2(lowest))); edge < highest; edge *= 2.0)
    all.push_back(edge);
  std::erase_if(all, [&](double hz) { return hz < lowest || hz > highest; });
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

RandomDrive require_random(const data::Case& problem) {
  if (!problem.is_random())
    throw data::FieldError("excitation.spectrum", "missing", "given: this is for random motions alone");
  if (!problem.is_damped())
    throw data::FieldError("damping.ratio", 0.0,
                           "above 0: without damping a random motion makes it vibrate more and more");
  return random_drive(problem);
}

}  // namespace

RandomDrive random_drive(const data::Case& problem) {
  if (!problem.is_random()) return {};
  const auto* base = problem.general_motion();
  const auto* wall = problem.contact.wall_motion ? &*problem.contact.wall_motion : nullptr;
  RandomDrive drive{.base = spectrum_of(base), .wall = spectrum_of(wall)};
  if (drive.base != nullptr) drive.base_scale = base->scale();
  if (drive.wall != nullptr) drive.wall_scale = wall->scale();
  return drive;
}

std::vector<Complex> HeldTransfer::amplitudes(double omega, const std::vector<Complex>& load) const {
  const std::size_t m = model_.modes();
  const Complex i(0.0, 1.0);
  const auto stiffness = [&](std::size_t n) {
    return model_.angular_frequency[n] * model_.angular_frequency[n] - omega * omega;
  };
  std::vector<Complex> amplitude(m);
  if (is_uncoupled_) {
    for (std::size_t n = 0; n < m; ++n)
      amplitude[n] =
          load[n] / (stiffness(n) + i * omega * (model_.damping.empty() ? 0.0 : model_.damping(n, n)));
    return amplitude;
  }
  const auto matrix = owned(gsl_matrix_complex_alloc(m, m));
  const auto vector = owned(gsl_vector_complex_alloc(m));
  const auto permutation = owned(gsl_permutation_alloc(m));
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column < m; ++column)
      gsl_matrix_complex_set(
          matrix.get(), row, column,
          gsl_complex_rect(row == column ? stiffness(row) : 0.0, omega * model_.damping(row, column)));
    gsl_vector_complex_set(vector.get(), row, gsl_complex_rect(load[row].real(), load[row].imag()));
  }
  int sign = 0;
  gsl_linalg_complex_LU_decomp(matrix.get(), permutation.get(), &sign);
  gsl_linalg_complex_LU_svx(matrix.get(), permutation.get(), vector.get());
  for (std::size_t n = 0; n < m; ++n) {
    const gsl_complex value = gsl_vector_complex_get(vector.get(), n);
    amplitude[n] = {GSL_REAL(value), GSL_IMAG(value)};
  }
  return amplitude;
}

std::vector<Complex> HeldTransfer::terms(double omega, bool of_wall) const {
  const std::size_t m = model_.modes();
  const Complex i(0.0, 1.0);
  const double moved = -1.0 / (omega * omega), base = of_wall ? 0.0 : moved,
               wall = of_wall ? moved : -model_.wall_share * moved;
  const auto damping = [&](std::size_t row, std::size_t column) {
    return model_.damping.empty() ? 0.0 : model_.damping(row, column);
  };
  const auto load = [&](std::size_t row) {
    const double drag = model_.load_cosine.empty() ? 0.0 : model_.load_cosine[row];
    return (-omega * omega * model_.load[row] + i * omega * drag) * base;
  };
  std::vector<Complex> held_load(m), terms(m + 1);
  for (std::size_t n = 0; n < m; ++n)
    held_load[n] = load(n) + (omega * omega * model_.mass_coupling[n] - i * omega * damping(n, m)) * wall;
  const std::vector<Complex> amplitude = amplitudes(omega, held_load);
  for (std::size_t n = 0; n < m; ++n)
    terms[n] = (-omega * omega * model_.mass_coupling[n] + i * omega * damping(m, n) + model_.follower[n]) *
               amplitude[n];
  terms[m] = (-omega * omega * model_.contact_mass + i * omega * damping(m, m) + model_.contact_stiffness +
              model_.contact_follower) *
                 wall -
             load(m) - model_.base_load * base;
  return terms;
}

Complex HeldTransfer::force(double omega, bool of_wall) const {
  Complex sum = 0.0;
  for (const Complex& term : terms(omega, of_wall)) sum += term;
  return sum;
}

RandomReaction random_reaction(const data::Case& problem, int modes) {
  const RandomDrive drive = require_random(problem);
  return random_reaction(contact_model(problem, modes), drive);
}

RandomReaction random_reaction(const ContactModel& model, const RandomDrive& drive) {
  const Integrator integrator(model, drive);
  const std::vector<double> at = corners(model, drive);
  std::vector<Integrals> parts;
  Integrals total(3 + model.modes());
  const auto add_to = [](Integrals& sum, const Integrals& part) {
    for (std::size_t j = 0; j < sum.size(); ++j) sum[j] += part[j];
  };
  for (std::size_t i = 0; i + 1 < at.size(); ++i)
    add_to(total, parts.emplace_back(integrator.rule(at[i], at[i + 1])));
  Integrals sum(total.size());
  RandomReaction reaction;
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    const Integrals part = integrator.refined(at[i], at[i + 1], parts[i], total);
    add_to(sum, part);
    const double octave = std::exp2(std::floor(std::log2(0.5 * (at[i] + at[i + 1]))));
    if (reaction.bands.empty() || reaction.bands.back().from_hz != octave)
      reaction.bands.push_back({octave, 2.0 * octave, 0.0});
    reaction.bands.back().force += part[0];
  }
  for (BandShare& band : reaction.bands) band.force /= sum[0];
  reaction.deviation = std::sqrt(sum[0]);
  reaction.rate_deviation = std::sqrt(sum[2]);
  reaction.bandwidth = std::sqrt(std::max(0.0, 1.0 - sum[1] * sum[1] / (sum[0] * sum[2])));
  for (std::size_t n = 0; n < model.modes(); ++n) reaction.mode_shares.push_back(sum[3 + n] / sum[0]);
  return reaction;
}

double RandomReaction::crossings(double limit) const {
  if (deviation == 0.0) return 0.0;
  const double r = limit / deviation;
  return rate_deviation / (pi * deviation) * std::exp(-0.5 * r * r);
}

double RandomReaction::poisson(double limit, double time) const {
  return -std::expm1(-crossings(limit) * time);
}

double RandomReaction::vanmarcke(double limit, double time) const {
  if (deviation == 0.0) return 0.0;
  const double r = limit / deviation, inside = -std::expm1(-0.5 * r * r);
  if (!(inside > 0.0)) return 1.0;
  const double clumps = -std::expm1(-std::sqrt(0.5 * pi) * std::pow(bandwidth, 1.2) * r);
  return 1.0 - inside * std::exp(-crossings(limit) * time * clumps / inside);
}

double RandomReaction::exceeded_with(double probability, double time) const {
  if (deviation == 0.0) return 0.0;
  double lower = 0.0, upper = deviation;
  while (vanmarcke(upper, time) > probability) upper *= 2.0;
  for (double middle = 0.5 * upper; lower < middle && middle < upper; middle = 0.5 * (lower + upper))
    (vanmarcke(middle, time) > probability ? lower : upper) = middle;
  return upper;
}

double RandomReaction::expected_largest(double time) const {
  const double c = std::sqrt(2.0 * std::log(std::max(std::numbers::e, crossings(0.0) * time)));
  return deviation * (c + std::numbers::egamma / c);
}

RandomRealisations::RandomRealisations(const data::Case& problem, int modes)
    : RandomRealisations(contact_model(problem, modes), require_random(problem),
                         problem.numerics.duration()) {}

RandomRealisations::RandomRealisations(const ContactModel& model, const RandomDrive& drive, double duration)
    : drive_(drive), duration_(duration) {
  const HeldTransfer transfer(model);
  std::size_t lines = 0;
  const auto set = [&](const data::PowerSpectrum* spectrum, double scale, bool of_wall,
                       std::vector<Complex>& factors) {
    if (spectrum == nullptr) return;
    factors.resize(spectrum->lines(duration_).size());
    for (std::size_t k = 1; k < factors.size(); ++k)
      factors[k] = scale * transfer.force(2.0 * pi * static_cast<double>(k) / duration_, of_wall);
    lines = std::max(lines, factors.size());
  };
  set(drive_.base, drive_.base_scale, false, of_base_);
  set(drive_.wall, drive_.wall_scale, true, of_wall_);
  instants_ = data::fast_size(32 * lines);
}

std::vector<double> RandomRealisations::force(std::uint64_t realisation) const {
  data::FourierTransform transform(instants_);
  std::ranges::fill(transform.spectrum(), 0.0);
  for (const auto& [spectrum, factors] :
       {std::pair(drive_.base, &of_base_), std::pair(drive_.wall, &of_wall_)}) {
    if (spectrum == nullptr) continue;
    data::PowerSpectrum one = *spectrum;
    one.seed += realisation;
    const auto lines = one.lines(duration_);
    for (std::size_t k = 1; k < lines.size(); ++k) transform.spectrum()[k] += 0.5 * (*factors)[k] * lines[k];
  }
  transform.backward();
  return {transform.values().begin(), transform.values().end()};
}

double RandomRealisations::largest(std::uint64_t realisation) const {
  const std::vector<double> f = force(realisation);
  double largest = std::max(std::abs(f.front()), std::abs(f.back()));
  for (std::size_t i = 1; i + 1 < f.size(); ++i) {
    const double before = std::abs(f[i - 1]), here = std::abs(f[i]), after = std::abs(f[i + 1]);
    if (here < largest * 0.99 || here < before || here < after) continue;
    const double bend = before - 2.0 * here + after, slope = 0.5 * (after - before);
    largest = std::max(largest, bend < 0.0 ? here - 0.5 * slope * slope / bend : here);
  }
  return largest;
}

}  // namespace stickslip::analytic
