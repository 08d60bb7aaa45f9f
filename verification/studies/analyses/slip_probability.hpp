// SPDX-License-Identifier: MIT
#pragma once

/// The probability of slip if keys of the case are uncertain.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "stickslip/analytic/stick_reaction.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/data/problem.hpp"
#include "studies/analyses/criterion_answer.hpp"
#include "studies/analyses/sampling.hpp"

namespace stickslip::studies {

struct SlipSampling {
  std::size_t samples = 10000;
  std::uint64_t seed = 1;
  /// The margin over a band of excitation frequencies (BandMaximum) instead of that at excitation.frequency_hz.
  std::optional<analytic::FrequencyBand> band{};
  bool is_short{};  ///< without all_modes and sensitivity, which take nine tenths of the time
};

/// The margin is μ_s P/|f_max| = critical load / load; the tip slips below 1.
struct SlipUncertainty {
  struct Quantile {
    double probability{};
    Estimate
        critical_load;  ///< of the amplitude as the case states it, m, m/s or m/s², or of the scale of a general motion
    Estimate margin;
  };
  /// The margin with one key at its 5 % and 95 % quantiles and the others as in the case; empty where there is no
  /// such beam.
  struct Tornado {
    std::string key;
    double low{}, high{};
    std::optional<double> margin_low, margin_high;
  };

  std::size_t valid{}, slips{};
  /// Samples without a verdict, by the key that cannot have its value, as in {"beam.axial_force", 12}. They
  /// count in no other result.
  std::map<std::string, std::size_t> invalid;
  double nominal_margin{};
  Estimate probability_of_slip;     ///< among the valid samples
  std::vector<Quantile> quantiles;  ///< at 5, 25, 50, 75, 95 %
  std::vector<double> margins;      ///< of the samples of the quantiles, ascending
  /// The first samples with all modes (analytic::criterion_with_all_modes), and how many of them slip with numerics.modes.
  struct AllModes {
    std::size_t valid{}, slips{}, undecided{}, slips_truncated{};
    Estimate probability_of_slip;  ///< up to the upper end with all undecided samples
  };
  std::optional<AllModes> all_modes;  ///< nothing over a band, or if it is to be short
  std::vector<Tornado> tornado;       ///< in the order of the keys
  /// Indices of log(margin), in the order of the keys; empty if keys are correlated, or more than 20.
  std::optional<Sensitivity> sensitivity;
  std::size_t decisive{};  ///< the key with the largest total index, or the widest row of the tornado
  /// The same samples, with the normal score of that key halved.
  Estimate probability_with_half_spread;
  bool
      tightening_helps{};  ///< that is below the probability of slip; a case that slips in the mean slips more surely
  std::optional<Change> best_change;  ///< of the mean, where tightening does not help and samples slip
};

/// The largest number of rows of the Sobol' indices, and the part of it that is taken with a band, whose margins are
/// forty times as expensive.
constexpr std::size_t most_index_rows = 4096, band_part = 16;

/// The largest number of samples whose margin is computed for the quantiles, the first ones; with a band the same
/// part of it.
constexpr std::size_t most_quantile_samples = 10000;

/// The largest number of samples that are judged with all modes, the first ones.
constexpr std::size_t most_samples_of_all_modes = 1000;

/// Draws independent samples of the keys, builds the case of each and evaluates the criterion: the verdict of all
/// samples (ForceMaximum::exceeds, BandMaximum::exceeds), and |f_max| to 1e-8, or over a band to 1e-3, of those
/// whose margin is asked for. If a sampled static coefficient is below the kinetic one, and that is certain, the
/// kinetic one is set to the same value. The indices take as many rows as samples, up to most_index_rows. Uses
/// thread_count() threads; the result depends on the seed and not on their number.
///
/// Throws data::InputError for a case without a verdict of its own (no compression, no amplitude, no friction),
/// without uncertain keys, or with a band and damping or an uncertain frequency, and if no sample is valid.
[[nodiscard]] SlipUncertainty slip_uncertainty(const data::Case& problem,
                                               const data::Uncertainty& uncertainty,
                                               const SlipSampling& sampling,
                                               const std::function<void(double)>& progress = {});

/// The same case, with the amplitude of its base stated by the key that is uncertain.
[[nodiscard]] data::Case stated_as(const data::Case& problem, const data::Uncertainty& uncertainty);

/// The case with a sample of the keys. Throws data::FieldError for values that no beam has.
[[nodiscard]] data::Case case_at(const data::Case& problem, const std::vector<data::UncertainKey>& keys,
                                 std::span<const double> values);

/// What is uncertain without the keys that are given.
[[nodiscard]] data::Uncertainty without(const data::Uncertainty& uncertainty,
                                        const std::vector<data::Override>& given);

}  // namespace stickslip::studies
