// SPDX-License-Identifier: MIT
#include "studies/analyses/slip_probability.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <set>

#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/stick_reaction.hpp"
#include "studies/common/parallel.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::studies {

namespace {

using analytic::Verdict;

constexpr double force_width = 1e-8, band_width = 1e-3, common_width = 1e-6;
constexpr std::size_t pilot_count = 1000;  // samples whose beams are the range of the tables of modes
constexpr std::array quantile_probabilities{0.05, 0.25, 0.5, 0.75, 0.95};

// The result of one sample.
struct SampleResult {
  double critical_load{};  // the stated amplitude, or the scale of a general motion
  double margin{};
  bool slips{};
};

// The verdict on the cases in which keys have other values.
class Verdicts {
 public:
  Verdicts(const data::Case& problem, const data::Uncertainty& uncertainty,
           const std::optional<analytic::FrequencyBand>& band)
      : problem_(problem), keys_(uncertainty.keys), band_(band), reactions_(problem) {
    if (band_) {  // BandMaximum counts in the amplitude at its lower end
      problem_ = with_value(problem_, "excitation.frequency_hz", band_->from_hz);
      band_->held = problem_.excitation().motion().amplitude_of;
    }
    if (std::ranges::any_of(keys_, [&](const auto& key) {
          return data::key_named(key.key).effects.moves_the_force && !is_a_factor(problem, key.key);
        }))
      return;
    force_ = band_ ? search_of(problem_).refined_to(common_width) : unit_force(problem);
  }

  // From now on the modes of beams like those of these values are interpolated.
  void tabulate(const std::vector<std::vector<double>>& values, std::size_t samples) {
    std::vector<data::Case> cases;
    for (const auto& sample : values) {
      try {
        const data::Case problem = case_at(sample);
        analytic::require_contact(problem);
        cases.push_back(problem);
      } catch (const data::InputError&) {
        continue;
      }
    }
    reactions_.tabulate(cases, samples);
  }

  // Whether all samples have one |f_max| per unit of analytic::load().
  [[nodiscard]] bool have_one_force() const { return force_.has_value(); }

  // Throws data::InputError for values that no beam has.
  [[nodiscard]] SampleResult at(std::span<const double> values) const { return of(case_at(values)); }

  // The verdict alone, which far from the limit is cheaper than the force.
  [[nodiscard]] bool slips_at(std::span<const double> values) const {
    const data::Case problem = case_at(values);
    const double load = analytic::load(problem);
    if (force_ || load == 0.0) return of(problem).slips;
    analytic::require_contact(problem);
    const double limit = friction_limit(problem) / load;
    return band_ ? search_of(problem).exceeds(limit) : reactions_.of(problem).exceeds(limit, force_width);
  }

  [[nodiscard]] double nominal_margin() const { return of(problem_).margin; }

  [[nodiscard]] const analytic::StickReactions& reactions() const { return reactions_; }

 private:
  [[nodiscard]] SampleResult of(const data::Case& problem) const {
    analytic::require_contact(problem);
    const double limit = friction_limit(problem), load = analytic::load(problem);
    const bool is_sine = !problem.has(data::Feature::general_motion);
    if (!(load > 0.0))
      throw is_sine ? data::FieldError("excitation.amplitude", load, "above 0 (m)")
                    : data::FieldError("excitation.scale", load, "above 0");
    const analytic::Bounds force = force_ ? *force_ : unit_force(problem);
    return {
        .critical_load = limit / force.midpoint() / (is_sine ? problem.excitation().unit_amplitude() : 1.0),
        .margin = limit / (load * force.midpoint()),
        .slips = analytic::verdict_of(load * force, limit) == Verdict::stick_slip};
  }

  [[nodiscard]] data::Case case_at(std::span<const double> values) const {
    return studies::case_at(problem_, keys_, values);
  }

  [[nodiscard]] analytic::BandMaximum search_of(const data::Case& problem) const {
    return reactions_.of(problem).over(*band_);
  }

  [[nodiscard]] analytic::Bounds unit_force(const data::Case& problem) const {
    if (!band_) return reactions_.of(problem).largest(force_width);
    return search_of(problem).refined_to(band_width);
  }

  data::Case problem_;
  std::vector<data::UncertainKey> keys_;
  std::optional<analytic::FrequencyBand> band_;
  analytic::StickReactions reactions_;
  std::optional<analytic::Bounds> force_;
};

// What a function of a sample returns, or nothing for a sample that is no valid beam, and the key or the sentence that
// says why.
template <class Function>
auto result_or_reason(const Function& function, std::string* reason = nullptr)
    -> std::optional<decltype(function())> {
  try {
    return function();
  } catch (const data::FieldError& error) {
    if (reason != nullptr) *reason = error.field();
  } catch (const data::InputError& error) {
    if (reason != nullptr) *reason = error.what();
  }
  return std::nullopt;
}

std::size_t at_most(std::size_t most, const SlipSampling& sampling) {
  return std::min(sampling.samples, sampling.band ? most / band_part : most);
}

struct Count {
  std::size_t valid{}, slips{};
  std::map<std::string, std::size_t> invalid{};
};

// Sums over all samples, which do not depend on their order.
Count count_samples(const Verdicts& verdicts, const JointDistribution& joint, const SlipSampling& sampling,
                    std::span<const double> spreads, const std::function<void(double)>& progress) {
  Count count;
  std::atomic<std::size_t> valid{}, slips{};
  std::mutex guard;
  in_parallel(
      sampling.samples,
      [&](std::size_t index) {
        const auto values = joint.at(independent_point(sampling.seed, index, joint.size()), spreads);
        std::string reason;
        if (const auto slip = result_or_reason([&] { return verdicts.slips_at(values); }, &reason)) {
          ++valid;
          if (*slip) ++slips;
          return;
        }
        const std::lock_guard lock(guard);
        ++count.invalid[reason];
      },
      progress);
  count.valid = valid;
  count.slips = slips;
  return count;
}

// Of the first samples; nothing for one that is no valid beam.
template <class Function>
auto results_of(std::size_t count, const JointDistribution& joint, const SlipSampling& sampling,
                const std::function<void(double)>& progress, const Function& function) {
  std::vector<decltype(result_or_reason([&] { return function(std::span<const double>()); }))> all(count);
  in_parallel(
      count,
      [&](std::size_t index) {
        const auto values = joint.at(independent_point(sampling.seed, index, joint.size()));
        all[index] = result_or_reason([&] { return function(values); });
      },
      progress);
  return all;
}

void add_quantiles(SlipUncertainty& result, const std::vector<std::optional<SampleResult>>& samples) {
  std::vector<double> loads;
  for (const auto& sample : samples) {
    if (!sample) continue;
    loads.push_back(sample->critical_load);
    result.margins.push_back(sample->margin);
  }
  if (loads.empty()) return;
  std::ranges::sort(loads);
  std::ranges::sort(result.margins);
  for (const double p : quantile_probabilities)
    result.quantiles.push_back({p, quantile_of(loads, p), quantile_of(result.margins, p)});
}

// The verdict on a sample; where all have one force, that is computed once.
auto judge_of_all_modes(const data::Case& problem, const data::Uncertainty& uncertainty,
                        const Verdicts& verdicts) {
  std::optional<analytic::Bounds> force;
  if (verdicts.have_one_force()) force = analytic::criterion_with_all_modes(problem, force_width).force_max;
  return [&problem, &uncertainty, &verdicts, force](std::span<const double> values) {
    const data::Case sample = studies::case_at(problem, uncertainty.keys, values);
    const double ratio = analytic::load(sample) / analytic::load(problem);
    const Verdict known =
        force ? analytic::verdict_of(ratio * *force, friction_limit(sample)) : Verdict::undecided;
    return known == Verdict::undecided
               ? analytic::verdict_with_all_modes(sample, verdicts.reactions(), force_width)
               : known;
  };
}

SlipUncertainty::AllModes all_modes_of(const std::vector<std::optional<SampleResult>>& truncated,
                                       const std::vector<std::optional<Verdict>>& verdicts) {
  SlipUncertainty::AllModes all;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    if (!verdicts[i] || !truncated[i]) continue;
    ++all.valid;
    if (*verdicts[i] == Verdict::stick_slip) ++all.slips;
    if (*verdicts[i] == Verdict::undecided) ++all.undecided;
    if (truncated[i]->slips) ++all.slips_truncated;
  }
  if (all.valid == 0) return all;
  all.probability_of_slip = probability_of(all.slips, all.valid);
  all.probability_of_slip.upper = probability_of(all.slips + all.undecided, all.valid).upper;
  return all;
}

// The margin with one key at a value, if that is a beam.
std::optional<double> margin_with(const data::Case& problem, const std::string& key, double value,
                                  const std::optional<analytic::FrequencyBand>& band) {
  return result_or_reason([&] {
    const Verdicts alone(problem, {.keys = {{key, {}, {}}}, .correlation = {1.0}}, band);
    return alone.at(std::span(&value, 1)).margin;
  });
}

std::vector<SlipUncertainty::Tornado> tornado_of(const data::Case& problem,
                                                 const data::Uncertainty& uncertainty,
                                                 const std::optional<analytic::FrequencyBand>& band) {
  std::vector<SlipUncertainty::Tornado> rows;
  for (const auto& key : uncertainty.keys) {
    const auto margin_at = [&](double value) { return margin_with(problem, key.key, value, band); };
    const double low = quantile(key.distribution, 0.05), high = quantile(key.distribution, 0.95);
    rows.push_back({key.key, low, high, margin_at(low), margin_at(high)});
  }
  return rows;
}

// Of the tornado: |log(margin_high/margin_low)|; a beam that is lost is as wide as it gets.
double width_of(const SlipUncertainty::Tornado& row) {
  if (!row.margin_low || !row.margin_high) return std::numeric_limits<double>::infinity();
  return std::abs(std::log(*row.margin_high / *row.margin_low));
}

std::size_t decisive_key(const SlipUncertainty& result) {
  if (!result.sensitivity) {
    const auto widest = std::ranges::max_element(result.tornado, {}, width_of);
    return static_cast<std::size_t>(widest - result.tornado.begin());
  }
  const auto& indices = result.sensitivity->indices;
  const auto largest =
      std::ranges::max_element(indices, {}, [](const auto& index) { return index.total.value; });
  return static_cast<std::size_t>(largest - indices.begin());
}

// Which key to tighten, and where that does not help, what to change.
void add_advice(SlipUncertainty& result, const data::Case& problem, const data::Uncertainty& uncertainty,
                const SlipSampling& sampling, const Verdicts& verdicts, const JointDistribution& joint,
                const std::function<void(double)>& progress) {
  result.decisive = decisive_key(result);
  std::vector<double> spreads(joint.size(), 1.0);
  spreads[result.decisive] = 0.5;
  const Count halved = count_samples(verdicts, joint, sampling, spreads, progress);
  if (halved.valid > 0) result.probability_with_half_spread = probability_of(halved.slips, halved.valid);
  result.tightening_helps = result.probability_with_half_spread.value < result.probability_of_slip.value;
  if (result.tightening_helps || result.slips == 0) return;
  result.best_change = best_change(problem, [&](std::string_view key, double value) {
    return result_or_reason([&] {
      return Verdicts(stated_as(restated(problem, {{key, value}}), uncertainty), {}, sampling.band)
          .nominal_margin();
    });
  });
}

void require_answerable(const data::Case& problem, const data::Uncertainty& uncertainty,
                        const SlipSampling& sampling) {
  if (uncertainty.keys.empty())
    throw data::InputError(
        "uncertainty is missing, but the case must have a table [uncertainty] with one key or more "
        "that --set does not fix");
  for (const auto& key : uncertainty.keys)
    if (key.key.starts_with("contact."))
      throw data::FieldError("[uncertainty]", key.key,
                             "a key of another table: here the tip is held or slides");
  require_friction(problem);
  if (!sampling.band) return;
  for (const auto& key : uncertainty.keys)
    if (key.key == "excitation.frequency_hz" || key.key.starts_with("damping."))
      throw data::InputError(key.place + ": " + key.key + " is uncertain, but must be certain with a band");
  if (problem.is_damped())
    throw data::InputError("the case is damped, but must have no damping with a band; design takes damping");
}

void require_finite(const std::string& key, double value) {
  if (!std::isfinite(value)) throw data::FieldError(key, value, "a finite number");
  try {
    data::require_magnitude(key, value, key);
  } catch (const data::InputError&) {
    throw data::FieldError(key, value, "of a magnitude that beams have");
  }
}

}  // namespace

data::Case case_at(const data::Case& problem, const std::vector<data::UncertainKey>& keys,
                   std::span<const double> values) {
  std::vector<std::pair<std::string_view, double>> numbers;
  for (std::size_t i = 0; i < values.size(); ++i) {
    require_finite(keys[i].key, values[i]);
    numbers.emplace_back(keys[i].key, values[i]);
  }
  return with_values(problem, numbers);
}

data::Uncertainty without(const data::Uncertainty& uncertainty, const std::vector<data::Override>& given) {
  std::vector<std::size_t> kept;
  data::Uncertainty result;
  for (std::size_t i = 0; i < uncertainty.keys.size(); ++i) {
    if (std::ranges::any_of(given, [&](const data::Override& one) {
          return data::state_the_same(one.key, uncertainty.keys[i].key);
        }))
      continue;
    kept.push_back(i);
    result.keys.push_back(uncertainty.keys[i]);
  }
  for (const std::size_t i : kept)
    for (const std::size_t j : kept)
      result.correlation.push_back(uncertainty.correlation[i * uncertainty.keys.size() + j]);
  return result;
}

data::Case stated_as(const data::Case& problem, const data::Uncertainty& uncertainty) {
  const auto key = std::ranges::find_if(uncertainty.keys, [](const data::UncertainKey& one) {
    return data::state_the_same(one.key, data::amplitude_keys.front());
  });
  return key == uncertainty.keys.end() ? problem : with_value(problem, key->key, value_of(problem, key->key));
}

SlipUncertainty slip_uncertainty(const data::Case& given, const data::Uncertainty& uncertainty,
                                 const SlipSampling& sampling, const std::function<void(double)>& progress) {
  const data::Case problem = stated_as(given, uncertainty);
  require_answerable(problem, uncertainty, sampling);
  Verdicts verdicts(problem, uncertainty, sampling.band);
  const JointDistribution joint(uncertainty);
  SlipUncertainty result;
  result.nominal_margin = verdicts.nominal_margin();
  std::vector<std::vector<double>> pilots;
  for (std::size_t index = 0; index < pilot_count; ++index)
    pilots.push_back(joint.at(independent_point(sampling.seed, index, joint.size())));
  verdicts.tabulate(pilots, sampling.samples);

  const bool has_indices = !sampling.is_short && joint.is_independent() && joint.size() <= 20;
  const std::size_t rows = at_most(most_index_rows, sampling);
  const double index_work = has_indices ? static_cast<double>(rows * (joint.size() + 2)) : 0.0;
  const auto draws = 0.1 * static_cast<double>(sampling.samples);  // what a verdict costs, of a margin
  const auto margins = static_cast<double>(at_most(most_quantile_samples, sampling));
  const bool has_all_modes = !sampling.band && !sampling.is_short;
  const std::size_t all_modes = has_all_modes ? std::min(most_samples_of_all_modes, sampling.samples) : 0;
  const double all_modes_work = 5.0 * static_cast<double>(all_modes);
  const double work = 2.0 * draws + margins + all_modes_work + index_work;
  double done = 0.0;
  const auto part = [&](double length) {
    const double from = done / work, share = length / work;
    done += length;
    return [&progress, from, share](double finished) {
      if (progress) progress(from + share * finished);
    };
  };
  const Count count = count_samples(verdicts, joint, sampling, {}, part(draws));
  if (count.valid == 0)
    throw data::InputError(
        "no sample is a beam with a verdict, but one or more must be; most have no valid " +
        std::ranges::max_element(count.invalid, {}, [](const auto& row) { return row.second; })->first);
  result.valid = count.valid;
  result.slips = count.slips;
  result.invalid = count.invalid;
  result.probability_of_slip = probability_of(count.slips, count.valid);
  const auto samples = results_of(at_most(most_quantile_samples, sampling), joint, sampling, part(margins),
                                  [&](std::span<const double> values) { return verdicts.at(values); });
  add_quantiles(result, samples);
  if (has_all_modes) {
    const auto judge = judge_of_all_modes(problem, uncertainty, verdicts);
    result.all_modes =
        all_modes_of(samples, results_of(all_modes, joint, sampling, part(all_modes_work), judge));
  }
  result.tornado = tornado_of(problem, uncertainty, sampling.band);
  if (has_indices)
    result.sensitivity = sobol_indices(
        [&](std::span<const double> u) {
          return result_or_reason([&] { return std::log(verdicts.at(joint.at(u)).margin); });
        },
        joint.size(), rows, sampling.seed, part(index_work));
  add_advice(result, problem, uncertainty, sampling, verdicts, joint, part(draws));
  return result;
}

}  // namespace stickslip::studies
