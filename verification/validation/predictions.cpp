// SPDX-License-Identifier: MIT
/// Calibration on the records set apart for it, and what follows for the others.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "validation/models.hpp"
#include "validation/study.hpp"

namespace stickslip::validation {

namespace {

// Standard uncertainties of the conditions, which are not published: assumed.
constexpr double relative_stiffness = 0.05, relative_speed = 0.02, relative_mass = 0.002;
// Of the amplitude of the damper's displacement, by the difference of its first and last full cycles.
constexpr double relative_amplitude = 0.005;

// The mean of values and the standard deviation of one of them, joined with the mean of their own uncertainties.
Figure spread_of(const std::vector<Figure>& figures) {
  const auto n = static_cast<double>(figures.size());
  double mean = 0.0, square = 0.0, own = 0.0;
  for (const Figure& figure : figures)
    mean += figure.value / n, own += figure.uncertainty * figure.uncertainty / n;
  for (const Figure& figure : figures) square += (figure.value - mean) * (figure.value - mean) / (n - 1.0);
  return {mean, std::sqrt(square + own), figures.size()};
}

struct Friction {
  Figure kinetic, excess;  // mu_k, mu_s - mu_k
};

// Of the records at 42 um/s: mu_k is the mean force; mu_s - mu_k half the range of those that stick, where the force
// overshoots mu_k in slip by as much as it was above. A harmonic motion that just reaches the speed of the drive has the
// rise ratio 2/pi: below it no record sticks.
Friction calibrated_friction(const FigureTable& figures, const std::vector<SetPoint>& points) {
  std::vector<Figure> kinetic, excess;
  for (const SetPoint& point : points) {
    if (point.experiment != "paper-slider" || point.role != "calibration") continue;
    kinetic.push_back(figures.at({point.record, "mean_force"}));
    const Figure& range = figures.at({point.record, "force_range"});
    if (figures.at({point.record, "rise_ratio"}).value > 2.0 / std::numbers::pi)
      excess.push_back({0.5 * range.value, 0.5 * range.uncertainty, range.count});
  }
  return {spread_of(kinetic), spread_of(excess)};
}

// What the estimators make of the model's own force at 2 kHz, less what the closed form says.
double reading_error(const Slider& slider, const Friction& friction, const std::string& quantity,
                     double exact) {
  Record record;
  const double period = rigid_slider(slider, friction.kinetic.value, friction.excess.value).at("period");
  for (int i = 0; i < static_cast<int>(2000.0 * 20.0 * period); ++i) {
    record.time.push_back(i / 2000.0);
    record.force.push_back(
        rigid_slider_force(slider, friction.kinetic.value, friction.excess.value, record.time.back()));
  }
  return std::abs(read_slider(record, slider).at(quantity).value - exact);
}

// The moved mass by the fall of the force at 42 um/s with the softest spring, whose slips are the longest: k (t/1.8546)^2. There
// the fall does not depend on the friction.
Figure calibrated_mass(const FigureTable& figures, const std::vector<SetPoint>& points) {
  const auto softest = std::ranges::min_element(points, {}, [](const SetPoint& point) {
    return std::pair(point.role != "calibration" || point.experiment != "paper-slider", point.stiffness);
  });
  const Figure& fall = figures.at({softest->record, "fall_time"});
  const double time = fall.value / (std::acos(-0.8) - std::acos(0.8));
  const double mass = softest->stiffness * time * time;
  return {mass, 2.0 * mass * fall.uncertainty / fall.value, fall.count};
}

// The moved mass is that of the weight, or `moved_mass` where that has a value.
void predict_slider(const SetPoint& point, const Friction& friction, const Figure& moved_mass,
                    std::vector<Prediction>& all) {
  Slider slider = point.slider();
  const bool is_lighter = moved_mass.value > 0.0;
  if (is_lighter) slider.moved_mass = moved_mass.value;
  const auto model = [&](const std::vector<double>& x) {
    return rigid_slider(
        {.mass = x[2], .stiffness = x[3], .speed = x[4], .moved_mass = is_lighter ? x[5] : x[2]}, x[0], x[1]);
  };
  const auto relative = [](double value, double share) { return Figure{value, share * value, 0}; };
  const auto results =
      propagated(model, {friction.kinetic, friction.excess, relative(slider.mass, relative_mass),
                         relative(slider.stiffness, relative_stiffness),
                         relative(slider.speed, relative_speed), moved_mass});
  for (const auto& [quantity, result] : results) {
    // At the points of calibration the fall of the force alone is a prediction, unless the mass is calibrated on it.
    if (point.role == "calibration" && (quantity != "fall_time" || is_lighter)) continue;
    all.push_back({point.record, quantity, is_lighter ? "lighter" : "rigid", result.value, result.uncertainty,
                   reading_error(slider, friction, quantity, result.value), is_lighter ? 2 : 1});
  }
}

// Of the record of calibration with the same tension, whose name begins alike (dataset1, dataset2).
void predict_damper(const SetPoint& point, const FigureTable& figures, const std::vector<SetPoint>& points,
                    std::vector<Prediction>& all) {
  const auto base = std::ranges::find_if(points, [&](const SetPoint& other) {
    return other.role == "calibration" && other.tension == point.tension &&
           other.record.substr(0, 8) == point.record.substr(0, 8);
  });
  if (base == points.end()) throw std::logic_error("no record of calibration for " + point.record);
  const auto input = [&](const std::string& quantity) { return figures.at({base->record, quantity}); };
  const double amplitude = figures.at({point.record, "amplitude"}).value;
  for (const bool has_play : {false, true}) {
    const auto model = [](const std::vector<double>& x) { return damper_loop(x[0], x[1], x[2], x[3]); };
    const auto results = propagated(model, {{amplitude, relative_amplitude * amplitude, 0},
                                            input("slip_force"),
                                            input("contact_stiffness"),
                                            has_play ? input("play") : Figure{}});
    for (const auto& [quantity, result] : results)
      if (!has_play || quantity == "energy")  // play leaves the force as it is
        all.push_back({point.record, quantity, has_play ? "spring-and-play" : "spring", result.value,
                       result.uncertainty, 0.0, 1});
  }
  const Figure force = input("slip_force");  // constant friction has no peak
  all.push_back({point.record, "peak_force", "spring", force.value, force.uncertainty, 0.0, 2});
}

// By the dimensions and handbook values of steel, each with an assumed uncertainty; and with the stiffness by the first frequency.
void predict_strip(const SetPoint& point, const FigureTable& figures, std::vector<Prediction>& all) {
  const Strip nominal;
  const auto drawn = propagated(
      [](const std::vector<double>& x) {
        return strip_frequencies({x[0], x[1], x[2], x[3]});
      },
      {{nominal.modulus, 5e9, 0},
       {nominal.density, 50.0, 0},
       {nominal.length, 0.5e-3, 0},
       {nominal.height, 0.02e-3, 0}});
  const Figure& first = figures.at({point.record, "frequency_1"});
  for (const auto& [quantity, result] : drawn) {
    all.push_back({point.record, quantity, "dimensions", result.value, result.uncertainty, 0.0, 3});
    const double ratio = result.value / drawn.at("frequency_1").value;
    if (quantity != "frequency_1")
      all.push_back({point.record, quantity, "first-frequency", ratio * first.value,
                     ratio * first.uncertainty, 0.0, 3});
  }
}

}  // namespace

std::vector<Prediction> predictions() {
  const std::vector<SetPoint> points = set_points();
  const FigureTable figures = measured_figures();
  const Friction friction = calibrated_friction(figures, points);
  const Figure moved_mass = calibrated_mass(figures, points);
  std::vector<Prediction> all;
  for (const SetPoint& point : points) {
    if (point.experiment == "paper-slider") {
      predict_slider(point, friction, {}, all);
      predict_slider(point, friction, moved_mass, all);
    } else if (point.experiment == "strip") {
      predict_strip(point, figures, all);
    } else if (point.role == "prediction") {
      predict_damper(point, figures, points, all);
    }
  }
  return all;
}

}  // namespace stickslip::validation
