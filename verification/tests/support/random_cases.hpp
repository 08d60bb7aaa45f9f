// SPDX-License-Identifier: MIT
#pragma once

/// Random cases over the range that a case file may state, as case files: a claim that fails prints the file, and the simplest one of
/// its relatives with which it fails as well. A case is drawn in dimensionless numbers, so that a plastic clip and a steel pipe are
/// equally likely.

#include <fmt/ranges.h>
#include <gtest/gtest-spi.h>

#include <cstdlib>
#include <map>
#include <string>

#include "stickslip/data/case_file.hpp"
#include "support/random_beams.hpp"

namespace stickslip::testing {

/// Which cases are drawn: ranges, and the share of the cases that have a feature.
struct CaseDomain {
  double lowest_force{0.001}, highest_force{0.99};  ///< P/P_cr, P_cr of the held tip
  double lowest_load{0.3}, highest_load{5.0};       ///< amplitude over an estimate of the critical one
  double shortest{1.0}, longest{12.0};              ///< duration over the period of the base
  double lowest_frequency{0.05},
      highest_frequency{5.0};  ///< over the first natural frequency of the held tip
  double kelvin_voigt{0.4}, ratio{0.4};
  double shear{0.0}, fixed_direction{0.4}, moving_wall{0.0}, yielding{0.0};
  double jump{0.1}, viscous{0.2};
  double resonant{0.0};    ///< next to the first natural frequency
  double stated{0.0};      ///< the amplitude as a velocity or an acceleration
  double units{0.0};       ///< the numbers of the beam as texts with units
  double any_motion{0.0};  ///< sines, a sweep or a shock in place of one sine
};

/// The keys of a case with their values, as a file states them.
class CaseText {
 public:
  void set(const std::string& key, const std::string& value) { values_[key] = value; }
  void set(const std::string& key, double value) { set(key, data::shortest_text(value)); }
  void erase(const std::string& key) { values_.erase(key); }
  [[nodiscard]] bool has(const std::string& key) const { return values_.contains(key); }

  [[nodiscard]] const std::string& value(const std::string& key) const { return values_.at(key); }
  [[nodiscard]] double number(const std::string& key) const { return data::value_of(problem(), key); }

  [[nodiscard]] std::string text() const {
    std::string lines, table;
    for (const auto& [key, value] : values_) {
      const std::string its_table = key.substr(0, key.find('.'));
      if (its_table != table) lines += "[" + (table = its_table) + "]\n";
      lines += key.substr(key.find('.') + 1) + " = " + value + "\n";
    }
    return lines;
  }
  /// Throws InputError.
  [[nodiscard]] data::Case problem() const { return data::parse_case("random.toml", text()); }

 private:
  std::map<std::string, std::string> values_;
};

/// The same motion of the base, stated by one of the keys with a unit that has `one` of the SI unit; excitation.amplitude takes them all.
struct Statement {
  std::string key, unit, at{key};
  double one{1.0};
};
inline const std::vector<Statement> statements{
    {"excitation.amplitude", "mm", "excitation.amplitude", 1e-3},
    {"excitation.velocity_amplitude", "m/s"},
    {"excitation.acceleration_amplitude", "m/s^2"},
    {"excitation.acceleration_amplitude", "g", "excitation.amplitude", 9.80665}};

inline CaseText stated(CaseText text, const Statement& statement) {
  const double value = text.number(statement.key) / statement.one;
  text.erase("excitation.amplitude");
  text.set(statement.at, "\"" + data::shortest_text(value) + " " + statement.unit + "\"");
  return text;
}

inline bool is_damped(const CaseText& text) {
  return text.has("damping.kelvin_voigt") || text.has("damping.ratio") ||
         text.has("damping.mass_proportional") || text.has("model.damping") ||
         text.has("model.damping_matrix");
}

inline void give_units(CaseText& text) {
  for (const auto& [key, unit, one] : {std::tuple{"beam.length", "mm", 1e-3},
                                       {"section.width", "um", 1e-6},
                                       {"section.height", "cm", 1e-2},
                                       {"beam.density", "g/cm^3", 1e3},
                                       {"beam.youngs_modulus", "GPa", 1e9},
                                       {"beam.axial_force", "kN", 1e3},
                                       {"excitation.frequency_hz", "kHz", 1e3}})
    text.set(key, "\"" + data::shortest_text(text.number(key) / one) + " " + unit + "\"");
}

/// `first`: of the held tip, rad/s.
inline void give_damping(CaseText& text, RandomNumbers& numbers, const CaseDomain& domain, double first) {
  if (numbers.uniform(0.0, 1.0) < domain.kelvin_voigt)
    text.set("damping.kelvin_voigt", 2.0 * numbers.log_uniform(1e-4, 0.1) / first);
  if (numbers.uniform(0.0, 1.0) >= domain.ratio) return;
  const double ratio = numbers.log_uniform(1e-4, 0.1);
  if (numbers.uniform(0.0, 1.0) < 0.7)
    text.set("damping.ratio", ratio);
  else
    text.set("damping.mass_proportional", 2.0 * ratio * first);
}

/// In place of one sine, with accelerations of its size: of a few sines, a sweep through its frequency or a shock; of the wall now and then.
inline void give_motion(CaseText& text, RandomNumbers& numbers) {
  const double hz = text.number("excitation.frequency_hz"), duration = text.number("excitation.duration"),
               acceleration = text.number("excitation.amplitude") * std::pow(2.0 * std::numbers::pi * hz, 2);
  const auto amplitude = [](double value) { return fmt::format("\"{} m/s^2\"", data::shortest_text(value)); };
  const auto sines = [&](double share) {
    std::vector<std::string> rows;
    for (int i = numbers.whole(1, 4); i >= 0; --i)
      rows.push_back(fmt::format("[{}, {}, {}]", data::shortest_text(hz * numbers.log_uniform(0.3, 3.0)),
                                 amplitude(share * acceleration * numbers.uniform(0.2, 0.8)),
                                 data::shortest_text(numbers.uniform(-180.0, 180.0))));
    return fmt::format("[{}]", fmt::join(rows, ", "));
  };
  text.erase("excitation.frequency_hz");
  text.erase("excitation.amplitude");
  if (const int kind = numbers.whole(0, 2); kind == 0) {
    text.set("excitation.sines", sines(1.0));
  } else {
    text.set("excitation.amplitude", amplitude(acceleration));
    if (kind == 1)
      text.set("excitation.sweep", fmt::format("{{ from = \"{} Hz\", to = \"{} Hz\", rate = \"{} Hz/s\" }}",
                                               data::shortest_text(0.5 * hz), data::shortest_text(2.0 * hz),
                                               data::shortest_text(1.5 * hz / duration)));
    else
      text.set("excitation.shock", fmt::format("{{ shape = \"{}\", duration = \"{} s\" }}",
                                               numbers.whole(0, 1) == 0 ? "half-sine" : "trapezoid",
                                               data::shortest_text(numbers.uniform(0.3, 1.0) * duration)));
  }
  if (!text.has("wall.speed") && numbers.whole(0, 1) == 0) text.set("wall.sines", sines(0.3));
}

inline CaseText random_case(RandomNumbers& numbers, const CaseDomain& domain) {
  const auto happens = [&numbers](double share) { return numbers.uniform(0.0, 1.0) < share; };
  CaseText text;
  const double modulus = numbers.log_uniform(1e7, 210e9), density = numbers.log_uniform(900.0, 8000.0);
  const double length = numbers.log_uniform(0.05, 5.0), height = length / numbers.log_uniform(25.0, 300.0);
  const double width = height * numbers.log_uniform(0.5, 20.0),
               share = numbers.log_uniform(domain.lowest_force, domain.highest_force);
  const double rigidity = modulus * width * height * height * height / 12.0;
  const double force = share * buckling_factor * rigidity / (length * length);
  text.set("section.shape", "\"rectangle\"");
  text.set("section.width", width);
  text.set("section.height", height);
  text.set("beam.length", length);
  text.set("beam.density", density);
  text.set("beam.youngs_modulus", modulus);
  text.set("beam.axial_force", force);
  if (happens(domain.fixed_direction))
    text.set("beam.axial_direction", happens(0.5) ? 1.0 : numbers.uniform(0.0, 1.0));
  if (happens(domain.shear)) text.set("beam.poissons_ratio", numbers.uniform(-0.3, 0.49));

  // 15.42 rad: (3.927)² of the first mode of the held tip, which P lowers.
  const double first =
      15.42 * std::sqrt(rigidity / (density * width * height)) / (length * length) * std::sqrt(1.0 - share);
  const double relative = happens(domain.resonant)
                              ? 1.0 + 1e-3 * numbers.uniform(-1.0, 1.0)
                              : numbers.log_uniform(domain.lowest_frequency, domain.highest_frequency);
  const double omega = relative * first, period = 2.0 * std::numbers::pi / omega;
  const double mu = numbers.uniform(0.1, 1.0);
  // The static reaction and its amplification by the first mode, of the steady vibration and of the start.
  const double holding = 3.0 * rigidity / (length * length * length) * (1.0 - share);
  const double amplification =
      1.0 + relative * (1.0 + relative) / std::max(std::abs(1.0 - relative * relative), 0.02);
  const double amplitude =
      mu * force / (holding * amplification) * numbers.log_uniform(domain.lowest_load, domain.highest_load);
  const double speed = amplitude * omega;
  text.set("excitation.frequency_hz", 1.0 / period);
  text.set("excitation.amplitude", amplitude);
  text.set("excitation.duration", period * numbers.log_uniform(domain.shortest, domain.longest));

  text.set("friction.static_coefficient", mu);
  text.set("friction.kinetic_coefficient", mu * numbers.uniform(0.2, 1.0));
  if (!happens(domain.jump)) text.set("friction.decay", numbers.log_uniform(0.1, 3.0) / speed);
  if (happens(domain.viscous)) text.set("friction.viscous", numbers.log_uniform(0.01, 0.3) * mu / speed);
  give_damping(text, numbers, domain, first);
  if (happens(domain.moving_wall)) text.set("wall.speed", speed * numbers.uniform(-1.5, 1.5));
  if (happens(domain.yielding)) {
    if (text.erase("friction.viscous"), happens(0.5))
      text.set("contact.tangential_stiffness", holding * numbers.log_uniform(3.0, 1e3));
    else
      text.set("contact.regularisation_velocity", speed * numbers.log_uniform(1e-3, 0.1));
    if (!text.has("friction.decay")) text.set("friction.decay", 1.0 / speed);
  }
  if (domain.units > 0.0 && happens(domain.units)) give_units(text);
  if (domain.stated > 0.0 && happens(domain.stated))
    text = stated(text, statements[static_cast<std::size_t>(numbers.whole(0, 3))]);
  if (domain.any_motion > 0.0 && happens(domain.any_motion)) give_motion(text, numbers);
  return text;
}

/// The results of a claim about a case, which are not yet those of the test.
template <typename Claim>
std::vector<::testing::TestPartResult> failures_of(Claim& claim, const CaseText& text,
                                                   RandomNumbers numbers) {
  ::testing::TestPartResultArray results;
  {
    const ::testing::ScopedFakeTestPartResultReporter kept(
        ::testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
    claim(text, numbers);
  }
  std::vector<::testing::TestPartResult> failures;
  for (int i = 0; i < results.size(); ++i)
    if (results.GetTestPartResult(i).failed()) failures.push_back(results.GetTestPartResult(i));
  return failures;
}

/// The case with as many of its features at their defaults as leave the claim false.
template <typename Claim>
CaseText simplest(Claim& claim, CaseText text, const RandomNumbers& numbers) {
  for (const char* feature :
       {"damping.kelvin_voigt", "damping.ratio", "damping.mass_proportional", "wall.speed",
        "contact.tangential_stiffness", "contact.regularisation_velocity", "beam.axial_direction",
        "beam.poissons_ratio", "friction.viscous", "friction.decay", "friction.kinetic_coefficient"}) {
    if (!text.has(feature)) continue;
    CaseText simpler = text;
    simpler.erase(feature);
    try {
      if (!failures_of(claim, simpler, numbers).empty()) text = simpler;
    } catch (const std::exception&) {  // there is no such case
    }
  }
  return text;
}

/// How many times as many cases are drawn: STICKSLIP_TIMES_CASES of the environment, for the slow tests, or 1.
inline int times_cases() {
  const char* text = std::getenv("STICKSLIP_TIMES_CASES");
  return text == nullptr ? 1 : std::stoi(text);
}

/// Calls claim(text, numbers) for `count` random cases from the seed on, each with random numbers of its own.
template <typename Claim>
void on_random_cases(int count, const CaseDomain& domain, Claim&& claim, std::uint64_t first_seed = 1) {
  count *= times_cases();
  for (std::uint64_t seed = first_seed; seed < first_seed + static_cast<std::uint64_t>(count); ++seed) {
    RandomNumbers numbers(seed);
    const CaseText text = random_case(numbers, domain);
    const auto failures = failures_of(claim, text, numbers);
    if (failures.empty()) continue;
    SCOPED_TRACE("seed " + std::to_string(seed) + ", save it as random.toml:\n" + text.text());
    for (const auto& failure : failures)
      GTEST_MESSAGE_AT_(failure.file_name(), failure.line_number(), failure.message(), failure.type());
    ADD_FAILURE() << "try `stickslip respond random.toml` or `stickslip criterion random.toml`; the simplest "
                     "such case is\n"
                  << simplest(claim, text, numbers).text();
    if (::testing::Test::HasFatalFailure()) return;
  }
}

}  // namespace stickslip::testing
