// SPDX-License-Identifier: MIT
#include "comparison/diagnosis/patterns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <tuple>

#include "comparison/samples.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::comparison {

namespace {

using studies::two_pi;
using Values = std::vector<double>;
using Found = std::optional<Hypothesis>;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr int patterns_tried = 30;  // 16 usual factors, a fitted one, 10 shifts by samples and some more

bool is_of_frequencies(const ComparedValues& values) {
  return values.unit == "Hz" && values.abscissa_name == "mode" &&
         std::ranges::is_sorted(values.reference, std::less_equal());
}

// --- factors

struct UsualFactor {
  double value;
  const char* text;
};
constexpr std::array usual_factors{
    UsualFactor{-1.0, "-1: the opposite sign"},
    UsualFactor{2.0, "2: a load, an amplitude or a rigidity is twice the right one"},
    UsualFactor{0.5, "1/2: a load, an amplitude or a rigidity is half the right one"},
    UsualFactor{std::numbers::sqrt2,
                "sqrt 2: EI is double or rho A half, or a peak is given for an rms value"},
    UsualFactor{1.0 / std::numbers::sqrt2,
                "1/sqrt 2: EI is half or rho A double, or an rms value is given for a peak"},
    UsualFactor{two_pi, "2 pi: rad/s for Hz"},
    UsualFactor{1.0 / two_pi, "1/(2 pi): divided by 2 pi once too often"},
    UsualFactor{1e3, "1000: another unit, such as mm for m or mHz for Hz"},
    UsualFactor{1e-3, "1/1000: another unit, such as kN for N or km for m"},
    UsualFactor{1e2, "100: another unit, such as cm for m"},
    UsualFactor{1e-2, "1/100: another unit"},
    UsualFactor{1e6, "1e6: another unit, such as um for m"},
    UsualFactor{-2.0, "-2"},
    UsualFactor{-0.5, "-1/2"},
    UsualFactor{-1e3, "-1000: another unit and the opposite sign"},
    UsualFactor{-1e-3, "-1/1000: another unit and the opposite sign"}};

Values multiplied(const Values& values, double factor) {
  Values result;
  for (const double value : values) result.push_back(factor * value);
  return result;
}

// The least squares factor, in the measure of the distances.
double fitted_factor(const ComparedValues& values) {
  double product = 0.0, square = 0.0;
  for (std::size_t i = 0; i < values.theirs.size(); ++i) {
    const double s = values.norm == data::Norm::relative ? values.reference[i] : 1.0;
    if (s == 0.0) continue;
    product += values.theirs[i] * values.reference[i] / (s * s);
    square += values.reference[i] * values.reference[i] / (s * s);
  }
  return product / square;
}

// The values over the factor are compared with the reference, because values near zero would else have every
// small factor. A hundredth of the difference, and of the values, may remain; this is empirical.
Found with_factor(const ComparedValues& values, double factor, const std::string& text, int free) {
  constexpr double least_ratio = 100.0;
  const auto& [abscissa_name, abscissa_unit, unit, norm, abscissa, theirs, reference] = values;
  Hypothesis hypothesis{.name = "constant-factor",
                        .values = multiplied(reference, factor),
                        .free = free,
                        .sentence = "all values are those of the data set times " + text};
  hypothesis.distance = distance(norm, reference, multiplied(theirs, 1.0 / factor), reference);
  hypothesis.from_reference = distance(norm, reference, hypothesis.values, reference);
  const double ratio = std::max(least_ratio, required_ratio(theirs.size(), free, patterns_tried));
  if (!(hypothesis.distance * ratio <= std::min(distance(norm, reference, theirs, reference), 1.0)))
    return {};
  return hypothesis;
}

Found factor_of(const ComparedValues& values) {
  for (const auto& [factor, text] : usual_factors)
    if (auto found = with_factor(values, factor, text, 0)) return found;
  // Any one or two values have a factor.
  const auto zeros = std::ranges::count(values.reference, 0.0);
  if (std::ssize(values.reference) - zeros < 3) return {};
  const double factor = fitted_factor(values);
  const std::string text = fmt::format("{:.5g}", factor);
  return text == "1" ? Found() : with_factor(values, factor, text, 1);
}

// --- angles, constants, zeros

// The conventions of a phase. sin(omega t + phase) = cos(omega t + phase - pi/2).
struct AngleConvention {
  double factor, plus;
  const char* text;
};
constexpr double right_angle = std::numbers::pi / 2.0;
constexpr std::array angle_conventions{
    AngleConvention{1.0, 2.0 * right_angle, "plus half a turn: what they belong to has the opposite sign"},
    AngleConvention{1.0, -right_angle, "minus a quarter turn: those of a cosine"},
    AngleConvention{1.0, right_angle, "plus a quarter turn"},
    AngleConvention{-1.0, 2.0 * right_angle, "with the opposite sign, plus half a turn"},
    AngleConvention{-1.0, -right_angle, "with the opposite sign, minus a quarter turn"},
    AngleConvention{-1.0, right_angle, "with the opposite sign, plus a quarter turn"},
    AngleConvention{180.0 / std::numbers::pi, 0.0, "in degrees"}};

Found angle_of(const ComparedValues& values) {
  const auto with = [&values](double factor, double plus, const std::string& text) {
    Values predicted;
    for (std::size_t i = 0; i < values.theirs.size(); ++i)
      predicted.push_back(nearest_angle(factor * values.reference[i] + plus, values.theirs[i]));
    return accepted(values,
                    {.name = "angle-convention",
                     .values = predicted,
                     .sentence = fmt::format("all values are those of the data set {}", text)},
                    patterns_tried);
  };
  for (const auto& [factor, plus, text] : angle_conventions)
    if (auto found = with(factor, plus, text)) return found;
  for (const auto& [factor, text] : usual_factors)
    if (auto found = with(factor, 0.0, fmt::format("times {}", text))) return found;
  return {};
}

// The same constant added to all values, with what is said of it.
template <class Sentence>
Found constant_of(const ComparedValues& values, const char* name, const Sentence& sentence) {
  double sum = 0.0;
  for (std::size_t i = 0; i < values.theirs.size(); ++i) sum += values.theirs[i] - values.reference[i];
  const double constant = sum / static_cast<double>(values.theirs.size());
  Values predicted = values.reference;
  for (double& value : predicted) value += constant;
  return accepted(values,
                  {.name = name,
                   .values = predicted,
                   .free = 1,
                   .sentence = sentence(constant > 0.0, std::abs(constant))},
                  patterns_tried);
}

Found constant_of(const ComparedValues& values) {
  return constant_of(values, "constant-added", [&](bool is_more, double size) {
    return fmt::format("all values are those of the data set {} {:.5g}{}{}", is_more ? "plus" : "minus", size,
                       values.unit.empty() ? "" : " ", values.unit);
  });
}

// --- shifts

// The reference k samples further on.
Values later(const Values& values, int k) {
  Values result(values.size(), nothing);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto from = static_cast<std::ptrdiff_t>(i) + k;
    if (from >= 0 && from < std::ssize(values)) result[i] = values[static_cast<std::size_t>(from)];
  }
  return result;
}

// The reference at x + shift by the parabola through three neighbouring samples.
Values shifted(const ComparedValues& values, double shift) {
  const Values& x = values.abscissa;
  Values result(x.size(), nothing);
  for (std::size_t i = 1; i + 1 < x.size(); ++i) {
    const double at = x[i] + shift;
    if (at < x.front() || at > x.back()) continue;
    const auto next = static_cast<std::size_t>(std::ranges::lower_bound(x, at) - x.begin());
    const std::size_t first = std::clamp<std::size_t>(next, 1, x.size() - 2) - 1;
    result[i] = 0.0;
    for (std::size_t j = first; j < first + 3; ++j) {
      double weight = 1.0;
      for (std::size_t m = first; m < first + 3; ++m)
        if (m != j) weight *= (at - x[m]) / (x[j] - x[m]);
      result[i] += weight * values.reference[j];
    }
  }
  return result;
}

// The shift of the abscissa by Gauss and Newton: theirs = reference + shift reference'.
double fitted_shift(const ComparedValues& values) {
  double shift = 0.0;
  const double width =
      1e-3 * (values.abscissa.back() - values.abscissa.front()) / static_cast<double>(values.abscissa.size());
  for (int iteration = 0; iteration < 20; ++iteration) {
    const Values here = shifted(values, shift), beside = shifted(values, shift + width);
    double product = 0.0, square = 0.0;
    for (std::size_t i = 0; i < here.size(); ++i) {
      const double slope = (beside[i] - here[i]) / width;
      if (!std::isfinite(slope)) continue;
      product += slope * (values.theirs[i] - here[i]);
      square += slope * slope;
    }
    shift += product / square;
  }
  return shift;
}

// What the measured thing at x is called if it belongs to another x.
std::string place_of(const ComparedValues& values) {
  return values.abscissa_name == "x" ? "those of a neighbouring node" : "shifted";
}

Found shift_of(const ComparedValues& values) {
  constexpr std::size_t fewest = 6;
  if (values.abscissa.size() < fewest || !std::ranges::is_sorted(values.abscissa, std::less_equal()))
    return {};
  // Where only values at an end differ, a shift may leave none of them to explain.
  // Of other motions, too, much is explained by a shift, but not as much as this; empirical.
  constexpr double near = 0.05;
  const auto explains = [](const Found& found) {
    return found && found->from_reference > 0.0 && found->distance <= near;
  };
  Found best;
  for (const int k : {1, -1, 2, -2, 3, -3, 4, -4, 5, -5})
    if (const auto found =
            accepted(values,
                     {.name = "shifted-by-samples",
                      .values = later(values.reference, k),
                      .sentence = fmt::format("the values are {}: those of the data set {} row{} {}",
                                              place_of(values), std::abs(k), std::abs(k) == 1 ? "" : "s",
                                              k > 0 ? "further down" : "further up")},
                     patterns_tried);
        explains(found) && (!best || found->distance < best->distance))
      best = found;
  if (best || values.abscissa_unit.empty() || values.abscissa_unit == "Hz") return best;
  const double shift = fitted_shift(values);
  const auto found =
      accepted(values,
               {.name = "shifted",
                .values = shifted(values, shift),
                .free = 1,
                .sentence = fmt::format("the values are {}: those of the data set at {} {} {:.3g} {}",
                                        place_of(values), values.abscissa_name, shift > 0.0 ? "+" : "-",
                                        std::abs(shift), values.abscissa_unit)},
               patterns_tried);
  return explains(found) ? found : Found();
}

// Times of events that are all late by the same time.
Found delay_of(const ComparedValues& values) {
  if (values.abscissa_unit != "s" || values.unit != "s") return {};
  return constant_of(values, "shifted", [](bool is_late, double delay) {
    return fmt::format("all events are {:.3g} s {}", delay, is_late ? "late" : "early");
  });
}

// --- frequencies

// The number of the axial frequency (2k-1)/(4L) sqrt(E/rho) within 1 %, else none above 0.
int axial_number(const data::Beam& beam, double hz) {
  const double first = std::sqrt(beam.youngs_modulus() / beam.density()) / (4.0 * beam.length());
  const int k = static_cast<int>(std::lround(0.5 * (hz / first + 1.0)));
  return std::abs(hz / ((2 * k - 1) * first) - 1.0) < 0.01 ? k : 0;
}

std::string foreign_mode(double number, double hz, double before, const data::Beam* beam) {
  std::string text = fmt::format("{:.0f} ({:.6g} Hz", number, hz);
  if (std::abs(hz / before - 1.0) < 1e-3)
    text += ", the one before it a second time";
  else if (const int k = beam == nullptr ? 0 : axial_number(*beam, hz); k > 0)
    text += fmt::format(", the axial mode {}", k);
  return text + ")";
}

// Their modes in the order of the reference, without those that it does not have, and without those that they
// leave out. Two frequencies are the same if they agree to 1 %.
Found mixed_modes(const ComparedValues& values, const data::Beam* beam) {
  constexpr double same = 0.01;
  Values predicted(values.theirs.size(), nothing);
  std::vector<std::string> foreign, missing;
  std::size_t next = 0, matched = 0;
  for (std::size_t i = 0; i < values.theirs.size(); ++i) {
    const double hz = values.theirs[i];
    const auto found =
        std::find_if(values.reference.begin() + static_cast<std::ptrdiff_t>(next), values.reference.end(),
                     [hz](double reference) { return std::abs(hz / reference - 1.0) < same; });
    if (found == values.reference.end()) {
      const bool is_beyond = hz > values.reference.back();
      if (!is_beyond)
        foreign.push_back(foreign_mode(values.abscissa[i], hz, i > 0 ? values.theirs[i - 1] : 0.0, beam));
      continue;
    }
    const auto at = static_cast<std::size_t>(found - values.reference.begin());
    for (; next < at; ++next) missing.push_back(fmt::format("{:.0f}", values.abscissa[next]));
    predicted[i] = *found;
    ++next, ++matched;
  }
  if (foreign.size() + missing.size() == 0 || 2 * matched < values.theirs.size()) return {};
  std::string text;
  if (!foreign.empty())
    text = fmt::format("mode {} of the file {} none of this data set{}", fmt::join(foreign, ", "),
                       foreign.size() == 1 ? "is" : "are",
                       missing.empty() ? ", and those after it are numbered too high" : "");
  if (!missing.empty())
    text += fmt::format("{}mode {} of the data set is missing in the file", text.empty() ? "" : "; ",
                        fmt::join(missing, ", "));
  const int free = static_cast<int>(foreign.size() + missing.size());
  return accepted(values, {.name = "mixed-modes", .values = predicted, .free = free, .sentence = text},
                  patterns_tried);
}

double squared_wave_number(const data::Beam& beam, double hz) {
  return two_pi * hz *
         std::sqrt(beam.density() * beam.area() / (beam.youngs_modulus() * beam.second_moment_of_area()));
}

// The lowest natural frequencies on a mesh of cubic Hermite elements, Hz, as many as the mesh has but at most `count`;
// empty if one is complex.
Values mesh_frequencies(const data::Beam& beam, int elements, bool is_slip, int count) {
  const solver::BeamModel mesh(beam, elements);
  const int most = static_cast<int>(mesh.degrees_of_freedom()) - (is_slip ? 0 : 1);
  Values hz;
  try {
    for (const auto& mode : (is_slip ? solver::slip_modes : solver::stick_modes)(mesh, std::min(count, most)))
      hz.push_back(mode.angular_frequency / two_pi);
  } catch (const data::InputError&) {
    return {};
  }
  return hz;
}

// The mesh of Hermite elements whose frequencies are theirs. The leading error (beta l)^4/1440 of a frequency gives
// the number of elements of the smallest error that is still above round-off, to one.
Found hermite_mesh(const ComparedValues& values, const data::Beam& beam, bool is_slip) {
  constexpr double round_off = 1e-6;
  constexpr int most = 100;
  std::set<int> tried;
  for (std::size_t i = 0; i < values.theirs.size() && tried.size() < 15; ++i) {
    const double error = values.theirs[i] / values.reference[i] - 1.0;
    if (error < round_off) continue;
    const double beta = std::sqrt(squared_wave_number(beam, values.reference[i]));
    const int estimate = static_cast<int>(
        std::lround(std::min(beam.length() * beta / std::pow(1440.0 * error, 0.25), 2.0 * most)));
    for (const int elements : {estimate, estimate - 1, estimate + 1}) {
      if (elements < 1 || elements > most || !tried.insert(elements).second) continue;
      const Values mesh =
          mesh_frequencies(beam, elements, is_slip, static_cast<int>(std::ranges::max(values.abscissa)));
      Values predicted(values.theirs.size(), nothing);
      for (std::size_t j = 0; j < predicted.size(); ++j)
        if (const auto mode = static_cast<std::size_t>(values.abscissa[j]); mode <= mesh.size())
          predicted[j] = mesh[mode - 1];
      if (auto found = accepted(values,
                                {.name = "mesh",
                                 .values = predicted,
                                 .free = 1,
                                 .sentence = fmt::format("the error is that of a mesh of {} cubic Hermite "
                                                         "elements; its leading term is (beta l)^4/1440",
                                                         elements)},
                                patterns_tried))
        return found;
    }
  }
  return {};
}

// The number of elements whose error is k (beta l)^2 if that is `coefficient` beta^2.
std::string elements_of(double k, double coefficient, const data::Beam& beam) {
  return fmt::format("{:.0f}", std::max(1.0, beam.length() * std::sqrt(k / std::abs(coefficient))));
}

// The leading errors, by the dispersion of a harmonic wave in an endless mesh: linear elements with one point of
// integration (beta l)^2/8, with lumped masses /24; cubic elements with masses m l/2 and m l^3/78 at each end
// -(beta l)^2/78; central differences -(beta l)^2/12.
std::string square_growth(double coefficient, const data::Beam* beam) {
  if (coefficient > 0.0) {
    const std::string linear = "as with linear (Timoshenko) elements";
    return beam == nullptr
               ? linear + "; refine the mesh"
               : linear + fmt::format(", about {} with one point of integration, {} if masses are lumped",
                                      elements_of(1.0 / 8.0, coefficient, *beam),
                                      elements_of(1.0 / 24.0, coefficient, *beam));
  }
  if (beam == nullptr) return "as with lumped masses or finite differences";
  return fmt::format(
      "as with lumped masses on about {} cubic elements, or finite differences of {} intervals",
      elements_of(1.0 / 78.0, coefficient, *beam), elements_of(1.0 / 12.0, coefficient, *beam));
}

// Consistent masses have the leading error (beta l)^4/1440 and lumped ones without rotary inertia -(beta l)^4/1440.
std::string fourth_power_growth(double coefficient, const data::Beam* beam) {
  const std::string elements =
      beam == nullptr
          ? "cubic elements"
          : fmt::format("about {:.0f} cubic elements",
                        std::max(1.0, beam->length() / std::pow(1440.0 * std::abs(coefficient), 0.25)));
  return coefficient > 0.0 ? "as with a coarse mesh of " + elements
                           : "as with lumped masses without rotary inertia on " + elements;
}

}  // namespace

Found pattern_of(const ComparedValues& values, const data::Beam* beam, bool is_slip) {
  if (values.theirs == values.reference) return {};
  if (auto found = is_angle(values.unit, values.norm) ? angle_of(values) : factor_of(values)) return found;
  if (auto found = delay_of(values)) return found;
  if (is_of_frequencies(values)) {
    if (auto found = mixed_modes(values, beam)) return found;
    return beam == nullptr ? Found() : hermite_mesh(values, *beam, is_slip);
  }
  if (auto found = shift_of(values)) return found;
  return constant_of(values);
}

Found zeros_of(const ComparedValues& values) {
  constexpr double nearly = 1e-4;  // below the factor 1/1000 of another unit
  double largest = 0.0, largest_reference = 0.0;
  for (const double value : values.theirs) largest = std::max(largest, std::abs(value));
  for (const double value : values.reference)
    largest_reference = std::max(largest_reference, std::abs(value));
  if (values.theirs.size() < 3 || !(largest < nearly * largest_reference)) return {};
  return Hypothesis{.name = "zeros",
                    .values = Values(values.theirs.size(), 0.0),
                    .sentence = largest == 0.0
                                    ? "all values are 0"
                                    : fmt::format("all values are nearly 0: at most {:.2g} of the largest "
                                                  "of the data set",
                                                  largest / largest_reference),
                    .from_reference = 1.0};
}

Found growth_of(const ComparedValues& values, const data::Beam* beam) {
  if (!is_of_frequencies(values)) return {};
  constexpr double spread = 0.25, largest_error = 0.2, smallest_error = 1e-7;
  for (const int power : {4, 2}) {
    Values ratios, errors;
    double lowest = std::numeric_limits<double>::infinity(), highest = 0.0;
    for (std::size_t i = 0; i < values.theirs.size(); ++i) {
      const double error = values.theirs[i] / values.reference[i] - 1.0;
      if (!(std::abs(error) < largest_error && std::abs(error) > smallest_error)) continue;
      ratios.push_back(error / std::pow(values.reference[i], power / 2));
      errors.push_back(std::abs(error));
      lowest = std::min(lowest, values.reference[i]);
      highest = std::max(highest, values.reference[i]);
    }
    if (ratios.size() < 3 || highest < 3.0 * lowest) continue;
    Values sorted = ratios;
    std::ranges::sort(sorted);
    const double middle = sorted[sorted.size() / 2];
    if (!std::ranges::all_of(ratios, [&](double c) { return std::abs(c / middle - 1.0) < spread; })) continue;
    // c of an error c beta^power in the highest mode: the lower ones feel the ends more.
    const double highest_ratio = ratios.back();
    const double coefficient = beam == nullptr
                                   ? highest_ratio
                                   : highest_ratio / std::pow(squared_wave_number(*beam, 1.0), power / 2);
    return Hypothesis{
        .name = power == 4 ? "error-of-fourth-power" : "error-of-second-power",
        .free = 1,
        .sentence = fmt::format(
            "the relative error of a frequency grows with the {} of the mode number, {}",
            power == 4 ? "fourth power" : "square",
            power == 4 ? fourth_power_growth(coefficient, beam) : square_growth(coefficient, beam)),
        .distance = spread * std::ranges::max(errors),
        .from_reference = std::ranges::max(errors)};
  }
  return {};
}

std::vector<Hypothesis> other_beams(const ComparedValues& values, const data::Beam& beam, bool is_slip,
                                    bool is_timoshenko) {
  if (values.unit != "Hz" || values.abscissa_name != "mode") return {};
  const auto frequencies = [&](double share_of_rotary_inertia, double stiffness) {
    data::BeamProperties properties = beam.properties();
    properties.area /= share_of_rotary_inertia;  // rho A as it is, I/A less
    properties.density *= share_of_rotary_inertia;
    properties.shear_stiffness = stiffness;
    return mesh_frequencies(data::Beam(properties), 40, is_slip,
                            static_cast<int>(std::ranges::max(values.abscissa)));
  };
  constexpr double none = 1e-6, all = 1.0, rigid = 1e6;
  const double coefficient = 5.0 / 6.0, ratio = 0.3, usual = shear_stiffness(beam, coefficient, ratio);
  const auto right = is_timoshenko ? frequencies(all, usual) : frequencies(none, rigid * usual);
  std::vector<Hypothesis> found;
  const auto add = [&](const std::vector<double>& wrong, const std::string& sentence) {
    Hypothesis one{.name = "other-beam", .values = {}, .sentence = sentence};
    for (std::size_t i = 0; i < values.reference.size(); ++i) {
      const auto mode = static_cast<std::size_t>(values.abscissa[i]);
      one.values.push_back(mode > std::min(wrong.size(), right.size())
                               ? nothing
                               : values.reference[i] * wrong[mode - 1] / right[mode - 1]);
    }
    if (auto near = accepted(values, one, 12)) found.push_back(*std::move(near));
  };
  add(frequencies(all, rigid * usual), "like a beam with rotary inertia and without shear (Rayleigh's)");
  add(frequencies(none, usual), "like a beam with shear and without rotary inertia");
  if (!is_timoshenko) {
    add(frequencies(all, usual), "like a Timoshenko beam with k = 5/6 and nu = 0.3");
    return found;
  }
  add(frequencies(none, rigid * usual), "like a beam of Euler and Bernoulli");
  for (const auto& [text, k, nu] : {std::tuple{"k = 1", 1.0, ratio},
                                    {"Cowper's k = 10 (1 + nu)/(12 + 11 nu)", 13.0 / 15.3, ratio},
                                    {"Mindlin's k = pi^2/12", 9.869604401089358 / 12.0, ratio},
                                    {"nu = 0, G = E/2", coefficient, 0.0},
                                    {"nu = 0.2", coefficient, 0.2},
                                    {"nu = 0.25", coefficient, 0.25},
                                    {"nu = 1/3", coefficient, 1.0 / 3.0},
                                    {"nu = 0.5", coefficient, 0.5}})
    add(frequencies(all, shear_stiffness(beam, k, nu)), fmt::format("like a Timoshenko beam with {}", text));
  return found;
}

double shear_stiffness(const data::Beam& beam, double coefficient, double poisson_ratio) {
  return coefficient * beam.youngs_modulus() * beam.area() / (2.0 * (1.0 + poisson_ratio));
}

}  // namespace stickslip::comparison
