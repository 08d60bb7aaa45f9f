// SPDX-License-Identifier: MIT
/// Sums of sines, sweeps, shocks and records: closed forms, pieces, splines, filters and what is refused.

#include "stickslip/data/general_motion.hpp"

#include "stickslip/data/case_file.hpp"
#include "stickslip/data/input_text.hpp"
#include "support/input_folder.hpp"
#include "support/random_beams.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using data::AmplitudeOf, data::GeneralMotion, data::MotionPiece, data::MotionRecord;
constexpr double pi = std::numbers::pi;

// At the end of a piece: its acceleration, and velocity and displacement by its integrals.
struct End {
  double acceleration, velocity, displacement;
};
End end_of(const MotionPiece& piece) {
  const auto polynomial = [&](double tau) {
    double sum = 0.0;
    for (std::size_t k = 8; k-- > 0;) sum = sum * tau + piece.acceleration[k];
    return sum;
  };
  double once = 0.0, twice = 0.0;
  for (std::size_t k = 8; k-- > 0;) {
    const auto order = static_cast<double>(k);
    once += piece.acceleration[k] * std::pow(piece.length, order + 1.0) / (order + 1.0);
    twice += piece.acceleration[k] * std::pow(piece.length, order + 2.0) / ((order + 1.0) * (order + 2.0));
  }
  return {polynomial(piece.length), piece.velocity + once,
          piece.displacement + piece.velocity * piece.length + twice};
}

End peaks_of(const GeneralMotion& motion) {
  End peaks{};
  for (int i = 0; i <= 2000; ++i) {
    const double t = motion.duration() * i / 2000.0;
    peaks = {std::max(peaks.acceleration, std::abs(motion.acceleration(t))),
             std::max(peaks.velocity, std::abs(motion.velocity(t))),
             std::max(peaks.displacement, std::abs(motion.displacement(t)))};
  }
  return peaks;
}

GeneralMotion random_motion(RandomNumbers& numbers, double duration) {
  const auto kind = [&] { return static_cast<AmplitudeOf>(numbers.whole(0, 2)); };
  const double hz = numbers.log_uniform(1.0, 50.0);
  switch (numbers.whole(0, 2)) {
    case 0: {
      std::vector<data::Sine> sines;
      for (int i = numbers.whole(1, 4); i > 0; --i)
        sines.push_back(
            {numbers.log_uniform(1.0, 50.0), numbers.uniform(0.0, 2.0), kind(), numbers.uniform(-7.0, 7.0)});
      return GeneralMotion(sines, duration).scaled(numbers.uniform(0.1, 3.0));
    }
    case 1: {
      const bool is_logarithmic = numbers.whole(0, 1) == 1;
      const double to = hz * numbers.log_uniform(0.2, 5.0), slowest = std::min(hz, to);
      const double most = is_logarithmic ? 10.0 * slowest / std::numbers::ln2 : 10.0 * slowest * slowest;
      return GeneralMotion(
          data::Sweep{hz, to, most * numbers.log_uniform(1e-4, 1.0), is_logarithmic, 1.5, kind()}, duration);
    }
    default: {
      const auto shape = static_cast<data::ShockShape>(numbers.whole(0, 3));
      const bool may_be_velocity = shape != data::ShockShape::sawtooth &&
                                   shape != data::ShockShape::rectangle && numbers.whole(0, 1) == 1;
      return GeneralMotion(data::Shock{shape, numbers.uniform(0.2, 1.2) * duration, 2.0,
                                       may_be_velocity ? AmplitudeOf::velocity : AmplitudeOf::acceleration},
                           duration);
    }
  }
}

STICKSLIP_VERIFIES(GeneralMotions, "P8");
TEST(GeneralMotions, HaveDerivativesAndPiecesThatFit) {
  RandomNumbers numbers(631);
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    const GeneralMotion motion = random_motion(numbers, 1.3);
    const auto [peak, fastest, farthest] = peaks_of(motion);
    const double rounding = 1e-11 * (peak + 1.0), most = rounding + 1.01 * motion.piece_error();
    EXPECT_LT(motion.piece_error(), 1e-8 * peak);
    double end = 0.0, end_velocity = motion.velocity(0.0);
    for (std::size_t n = 0; n < motion.pieces(); ++n) {
      const MotionPiece piece = motion.piece(n);
      EXPECT_NEAR(piece.begin, end, 1e-12);
      end = piece.begin + piece.length;
      EXPECT_NEAR(piece.velocity, motion.velocity(piece.begin), rounding);
      EXPECT_NEAR(piece.velocity, end_velocity, most);  // the velocity does not jump
      EXPECT_NEAR(piece.displacement, motion.displacement(piece.begin), rounding);
      const double inside = end - 1e-9 * piece.length;
      const auto [acceleration, velocity, displacement] = end_of(piece);
      end_velocity = velocity;
      ASSERT_NEAR(acceleration, motion.acceleration(inside), most + 1e-8 * peak);
      ASSERT_NEAR(velocity, motion.velocity(inside), most * piece.length + 3e-9 * peak * piece.length);
      ASSERT_NEAR(displacement, motion.displacement(inside),
                  rounding + 2e-9 * piece.length * (std::abs(velocity) + peak * piece.length));
      for (const double part : {0.31, 0.77}) {  // the pieces are smooth inside
        double sum = 0.0;
        for (std::size_t k = 8; k-- > 0;) sum = sum * part * piece.length + piece.acceleration[k];
        const double t = piece.begin + part * piece.length, h = 0.01 * piece.length;
        ASSERT_NEAR(sum, motion.acceleration(t), most);
        const auto slope = [&](auto of) {
          return (8.0 * (of(t + h) - of(t - h)) - of(t + 2.0 * h) + of(t - 2.0 * h)) / (12.0 * h);
        };
        const double noise = 1e-13 / h;
        ASSERT_NEAR(slope([&](double at) { return motion.displacement(at); }), motion.velocity(t),
                    1e-9 * fastest + noise * farthest);
        ASSERT_NEAR(slope([&](double at) { return motion.velocity(at); }), motion.acceleration(t),
                    1e-8 * peak + noise * fastest);
      }
    }
    EXPECT_NEAR(end, motion.duration(), 1e-12);
  }
}

TEST(GeneralMotions, AreOneSineAndFollowTheirStatement) {
  const data::HarmonicExcitation sine({35.0, 2.0, AmplitudeOf::velocity, 3.0});
  const GeneralMotion motion =
      GeneralMotion(std::vector<data::Sine>{{35.0, 2.0, AmplitudeOf::velocity, 0.0}}, 1.0).scaled(3.0);
  EXPECT_NEAR(motion.displacement(0.1234), sine.amplitude() * std::sin(70.0 * pi * 0.1234), 1e-15);
  EXPECT_EQ(motion.highest_frequency_hz(), 35.0);
  // The bound of the pieces is nearly reached, 5e-13 of the acceleration.
  const GeneralMotion slow(std::vector<data::Sine>{{1.0, 1.0, AmplitudeOf::acceleration, 0.0}}, 1.0);
  double error = 0.0;
  for (std::size_t n = 0; n < slow.pieces(); ++n)
    for (int i = 0; i <= 50; ++i) {
      MotionPiece part = slow.piece(n);
      part.length *= i / 50.0;
      error =
          std::max(error, std::abs(end_of(part).acceleration - slow.acceleration(part.begin + part.length)));
    }
  EXPECT_NEAR(error / slow.piece_error(), 1.0, 0.1);
  // An octave a second from 2 to 8 Hz: 4 Hz after a second, and at most 8 Hz.
  const GeneralMotion sweep(data::Sweep{2.0, 8.0, 1.0, true, 0.5, AmplitudeOf::displacement}, 5.0);
  EXPECT_NEAR(sweep.displacement(1.0), 0.5 * std::sin(2.0 * pi * 2.0 / std::numbers::ln2), 1e-12);
  EXPECT_NEAR(sweep.highest_frequency_hz(), 7.9, 0.1);
  EXPECT_NEAR(sweep.displacement(4.0 + 1.0 / sweep.highest_frequency_hz()), sweep.displacement(4.0), 1e-9);
  // A half-sine leaves the velocity 2 A D/pi, a sawtooth A D/2, a trapezoid 0.9 A D, a rectangle A D.
  for (const auto& [shape, change] : {std::pair{data::ShockShape::half_sine, 2.0 / pi},
                                      {data::ShockShape::sawtooth, 0.5},
                                      {data::ShockShape::trapezoid, 0.9},
                                      {data::ShockShape::rectangle, 1.0}}) {
    const GeneralMotion shock(data::Shock{shape, 0.011, 50.0, AmplitudeOf::acceleration}, 1.0);
    EXPECT_NEAR(shock.velocity(0.5), 0.55 * change, 1e-12);
    EXPECT_NEAR(shock.displacement(0.7) - shock.displacement(0.5), 0.2 * 0.55 * change, 1e-12);
  }
  const GeneralMotion force(std::vector<data::Sine>{{5.0, 4.0, AmplitudeOf::force, 0.5 * pi}}, 1.0);
  EXPECT_NEAR(force.acceleration(0.0), -4.0, 1e-12);
  EXPECT_EQ(force.velocity(0.1), 0.0);
}

// One sine, displacement A sin(Ω t + φ), as a record of one of its derivatives.
struct SineRecord {
  double hz{35.0}, amplitude{5e-4}, phase{0.7};
  [[nodiscard]] double omega() const { return 2.0 * pi * hz; }
  [[nodiscard]] double value(int k, double t) const {
    return amplitude * std::pow(omega(), k) * std::sin(omega() * t + phase + 0.5 * pi * k);
  }
  [[nodiscard]] MotionRecord record(int k, double per_period, double periods, double from = 0.0) const {
    MotionRecord made{.file = "sine.csv",
                      .sha256 = {},
                      .column = "a",
                      .unit = "m",
                      .quantity = static_cast<AmplitudeOf>(k),
                      .step = 1.0 / (hz * per_period),
                      .samples = {}};
    for (int i = 0; i <= static_cast<int>(per_period * periods); ++i)
      made.samples.push_back(value(k, from + i * made.step));
    if (k > 0) made.initial_displacement = value(0, from);
    if (k == 2) made.initial_velocity = value(1, from);
    return made;
  }
};

double largest_error(const GeneralMotion& motion, const SineRecord& sine, int k) {
  double error = 0.0;
  for (int i = 0; i <= 7919; ++i) {
    const double t = motion.duration() * i / 7919.0;
    const double value = k == 0   ? motion.displacement(t)
                         : k == 1 ? motion.velocity(t)
                                  : motion.acceleration(t);
    error = std::max(error, std::abs(value - sine.value(k, t)));
  }
  return error;
}

STICKSLIP_VERIFIES(Records, "P8");
TEST(Records, AreTheSineOfOrderFourInWhatTheyState) {
  const SineRecord sine;
  for (const int k : {0, 1, 2}) {
    const double coarse = largest_error(GeneralMotion(sine.record(k, 40.0, 20.0), 0.0), sine, k),
                 fine = largest_error(GeneralMotion(sine.record(k, 80.0, 20.0), 0.0), sine, k);
    EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.15) << k;
    // All derivatives and integrals are those of the sine.
    const GeneralMotion motion(sine.record(k, 500.0, 20.0), 0.0);
    for (const int other : {0, 1, 2})
      EXPECT_LT(largest_error(motion, sine, other),
                (other > k ? 2e-4 : 1e-8) * sine.amplitude * std::pow(sine.omega(), other))
          << k << other;
    EXPECT_NEAR(motion.highest_frequency_hz(), 35.0, 7.0);
  }
}

TEST(Records, HaveTheirHighestFrequencyWhereTheirPowerEnds) {
  const SineRecord sine;
  for (const auto& [share, highest] :
       {std::pair{0.05, 175.0}, {0.01, 35.0}}) {  // of the power 0.25 % and 0.01 %
    MotionRecord record = sine.record(2, 50.0, 40.0);
    for (std::size_t i = 0; i < record.samples.size(); ++i)
      record.samples[i] += share * sine.value(2, 0.0) / std::sin(sine.phase) *
                           std::sin(5.0 * sine.omega() * record.step * static_cast<double>(i));
    EXPECT_NEAR(GeneralMotion(record, 0.0).highest_frequency_hz(), highest, 5.0);
  }
}

// A cubic is its own spline, whatever the times.
TEST(Records, AreExactForCubics) {
  for (const int k : {0, 1, 2}) {
    MotionRecord record{.file = "cubic.csv",
                        .sha256 = {},
                        .column = "a",
                        .unit = "m",
                        .quantity = static_cast<AmplitudeOf>(k),
                        .step = 0.1,
                        .samples = {}};
    for (int i = 0; i <= 32; ++i) {
      record.times.push_back(0.1 * (i + 0.3 * (i % 2)));
      record.samples.push_back(0.1 * std::pow(record.times.back(), 3));
    }
    if (k > 0) record.initial_displacement = 0.25;
    if (k == 2) record.initial_velocity = -0.5;
    const GeneralMotion motion(record, 0.0);
    for (const double t : {0.0, 0.05, 1.234, 2.6, motion.duration()}) {
      const std::array of{0.1 * std::pow(t, 3), 0.3 * t * t, 0.6 * t},
          once{0.25 + std::pow(t, 4) / 40.0, of[0], of[1]},
          twice{0.25 - 0.5 * t + std::pow(t, 5) / 200.0, -0.5 + std::pow(t, 4) / 40.0, of[0]};
      const auto& expected = k == 0 ? of : k == 1 ? once : twice;
      EXPECT_NEAR(motion.displacement(t), expected[0], 1e-12) << k;
      EXPECT_NEAR(motion.velocity(t), expected[1], 1e-12) << k;
      EXPECT_NEAR(motion.acceleration(t), expected[2], 1e-10) << k;
    }
  }
}

TEST(Records, EstimateWhatTheInterpolationMisses) {
  const SineRecord sine;
  for (const int k : {0, 1, 2})
    for (const double per_period : {14.0, 29.0, 57.0, 143.0}) {
      const GeneralMotion motion(sine.record(k, per_period, 30.0), 0.0);
      const double error = largest_error(motion, sine, 2);
      EXPECT_GT(motion.interpolation_error(), 0.8 * error) << k << " " << per_period;
      EXPECT_LT(motion.interpolation_error(), 8.0 * error) << k << " " << per_period;
    }
}

// The spline ends at the cut: with θ = ΩΔt the acceleration misses 0.03 θ^4 in the first step, the velocity 0.01 θ^5.
TEST(Records, GoOnWhereTheyAreCut) {
  const SineRecord sine;
  const GeneralMotion whole(sine.record(2, 200.0, 8.0), 0.0);
  MotionRecord second = sine.record(2, 200.0, 5.0, 3.0 / sine.hz);
  const double begin = 3.0 / sine.hz;
  second.initial_displacement = whole.displacement(begin);
  second.initial_velocity = whole.velocity(begin);
  const GeneralMotion rest(second, 0.0);
  for (const double t : {0.0, 0.01, 0.07, 0.11})
    EXPECT_NEAR(rest.displacement(t), whole.displacement(begin + t), 1e-7 * sine.amplitude);
}

// The steady response has the gain of both sections, ((iΩ)²/(ω² - Ω² + i √2 ω Ω))², and the pieces go on into each other.
TEST(Records, AreFilteredAsButterworthSays) {
  for (const auto& [high_pass, per_period] :
       {std::pair{2.0, 200.0}, {20.0, 200.0}, {60.0, 200.0}, {200.0, 20.0}}) {
    const SineRecord sine;
    MotionRecord record = sine.record(2, per_period, 150.0);
    record.initial_displacement.reset();
    record.initial_velocity.reset();
    record.high_pass_hz = high_pass;
    const GeneralMotion motion(record, 0.0);
    const std::complex<double> s(0.0, sine.omega()),
        section =
            s * s /
            (s * s + std::numbers::sqrt2 * 2.0 * pi * high_pass * s + std::pow(2.0 * pi * high_pass, 2));
    const double t = motion.duration() - 0.01;
    const auto steady = section * section * std::polar(sine.amplitude, sine.omega() * t + sine.phase);
    const double omega = 2.0 * pi * high_pass, missed = std::pow(2.0 * pi / per_period, 4) / 100.0,
                 start =
                     10.0 * sine.omega() / omega * (1.0 + omega * t) * std::exp(-std::sqrt(0.5) * omega * t);
    EXPECT_NEAR(motion.displacement(t), steady.imag(), (missed + start) * sine.amplitude);
    EXPECT_NEAR(motion.velocity(t), (steady * s).imag(), (missed + start) * sine.amplitude * sine.omega());
    EXPECT_NEAR(motion.acceleration(t), (steady * s * s).imag(),
                (missed + start) * sine.amplitude * std::norm(s));
    for (std::size_t n = 0; n + 1 < motion.pieces(); n += 7) {
      const auto [acceleration, velocity, displacement] = end_of(motion.piece(n));
      const MotionPiece next = motion.piece(n + 1);
      EXPECT_NEAR(acceleration, next.acceleration[0], 1e-12 * sine.amplitude * std::norm(s));
      EXPECT_NEAR(velocity, next.velocity, 1e-12 * sine.amplitude * std::abs(s));
      EXPECT_NEAR(displacement, next.displacement, 1e-12 * sine.amplitude);
    }
  }
}

STICKSLIP_VERIFIES(RandomMotions, "P8");
// Its lines are summed here; each piece goes on from the one before with three derivatives.
TEST(RandomMotions, AreTheSumOfTheirLines) {
  RandomNumbers numbers(641);
  for (const auto kind :
       {AmplitudeOf::displacement, AmplitudeOf::velocity, AmplitudeOf::acceleration, AmplitudeOf::force}) {
    data::PowerSpectrum spectrum;
    spectrum.points = {{3.0, 1e-2}, {10.0, 4e-2}, {numbers.uniform(20.0, 60.0), 1e-3}};
    spectrum.quantity = kind;
    spectrum.seed = static_cast<std::uint64_t>(numbers.whole(1, 100));
    constexpr double duration = 2.0;
    const GeneralMotion motion(spectrum, duration);
    const auto lines = spectrum.lines(duration);
    double variance = 0.0, size = 0.0;
    for (const auto& line : lines) size += std::abs(line);
    for (int i = 0; i < 200; ++i) {
      const double t = numbers.uniform(0.0, duration);
      double acceleration = 0.0, displacement = 0.0;
      for (std::size_t k = 1; k < lines.size(); ++k) {
        const double omega = 2.0 * pi * static_cast<double>(k) / duration;
        const double line = (lines[k] * std::polar(1.0, omega * t)).real();
        acceleration += line;
        displacement -= line / (omega * omega);
      }
      const bool is_force = kind == AmplitudeOf::force;
      EXPECT_NEAR(motion.acceleration(t), is_force ? -acceleration : acceleration,
                  1.01 * motion.piece_error());
      EXPECT_NEAR(motion.displacement(t), is_force ? 0.0 : displacement, 1e-7 * size / 400.0);
      variance += acceleration * acceleration / 200.0;
    }
    EXPECT_GT(variance, 0.0);
    EXPECT_LT(motion.piece_error(), 1e-5 * size);
    if (kind == AmplitudeOf::force) continue;
    for (std::size_t n = 0; n + 1 < motion.pieces(); n += 5) {
      const auto [a, v, d] = end_of(motion.piece(n));
      const MotionPiece next = motion.piece(n + 1);
      EXPECT_NEAR(a, next.acceleration[0], 1e-9 * size);
      EXPECT_NEAR(v, next.velocity, 1e-11 * size);
      EXPECT_NEAR(d, next.displacement, 1e-12 * size);
    }
  }
}

// The mean square of the lines over many seeds: S/T each, so that 400 seeds of 100 lines know the sum to 0.5 %.
TEST(RandomMotions, HaveTheDensityTheyState) {
  data::PowerSpectrum spectrum;
  spectrum.points = {{10.0, 2.0}, {60.0, 2.0}};
  spectrum.quantity = AmplitudeOf::acceleration;
  double sum = 0.0;
  for (spectrum.seed = 1; spectrum.seed <= 400; ++spectrum.seed)
    for (const auto& line : spectrum.lines(2.0)) sum += 0.5 * std::norm(line) / 400.0;
  EXPECT_NEAR(sum, 100.0, 3.3 * 0.5);
  EXPECT_DOUBLE_EQ(spectrum.density(30.0), 2.0);
  EXPECT_EQ(spectrum.density(61.0), 0.0);
  spectrum.points = {{10.0, 1.0}, {40.0, 16.0}};  // straight on logarithmic axes
  EXPECT_NEAR(spectrum.density(20.0), 4.0, 1e-12);
  spectrum.quantity = AmplitudeOf::displacement;
  EXPECT_NEAR(spectrum.density(20.0), 4.0 * std::pow(40.0 * pi, 4), 1e-3);
}

const std::string
    head = "[model]\nmass = 2\nstiffness = 100\nnormal_force = 3\n[friction]\nstatic_coefficient = 0.5\n",
    record_keys = "file = 'r.csv'\ncolumn = 'az'\nquantity = 'acceleration'\n";

class MotionFile : public ::testing::Test {
 protected:
  [[nodiscard]] data::Case read(const std::string& tables,
                                const std::vector<data::Override>& overrides = {}) const {
    return data::read_case(folder_.write("case.toml", head + tables), overrides);
  }
  [[nodiscard]] std::string refusal(const std::string& tables) const {
    return folder_.error_message([&] { (void)read(tables); });
  }
  // A sine of 5 Hz in milli-g, in each row of which `change` may change time and text.
  void write_record(const std::function<void(int, double&, std::string&)>& change = {},
                    int rows = 101) const {
    std::string text = "# made for a test\ntime [ms]; az [g]\n";
    for (int i = 0; i < rows; ++i) {
      double time = 7.0 + 4.0 * i;
      std::string cell = fmt::format("{:.9f}", 0.1 * std::sin(10.0 * pi * 0.004 * i));
      if (change) change(i, time, cell);
      text += fmt::format("{};{}\n", time, cell);
    }
    (void)folder_.write("r.csv", text);
  }

  InputFolder folder_;
};

STICKSLIP_VERIFIES(MotionFile, "P8");
TEST_F(MotionFile, StatesEveryKindOfMotion) {
  const data::Case sines = read(
      "[excitation]\nsines = [[20, '0.1 mm', 0], [35, '0.5 g', 90], ['0.04 kHz', 1e-3]]\nscale = 2\nduration "
      "= 3\n");
  const GeneralMotion& motion = *sines.general_motion();
  EXPECT_NEAR(motion.acceleration(0.0), -9.80665, 1e-9);
  EXPECT_EQ(motion.duration(), 3.0);
  EXPECT_EQ(data::highest_frequency_hz(sines), 40.0);
  EXPECT_EQ(data::value_of(sines, "excitation.scale"), 2.0);
  EXPECT_NEAR(data::with_values(sines, {{"excitation.scale", 4.0}, {"excitation.duration", 5.0}})
                  .general_motion()
                  ->acceleration(4.0),
              2.0 * GeneralMotion(motion.statement(), 5.0).scaled(2.0).acceleration(4.0), 1e-9);
  EXPECT_TRUE(sines.has(data::Feature::general_motion));
  expect_error_message<data::FieldError>(
      [&] { (void)sines.excitation(); },
      {"excitation.sines is given, but must be left out: this needs one sine"});
  const data::Case both = read(
      "[excitation]\nfrequency_hz = 10\namplitude = '1 mm'\nscale = 3\n[wall]\nsweep = { from = 5, to = '20 "
      "Hz', rate = "
      "'1 oct/min' }\namplitude = '0.2 g'\n");
  EXPECT_NEAR(both.excitation().amplitude(), 3e-3, 1e-15);
  EXPECT_EQ(std::get<data::Sweep>(both.contact.wall_motion->statement()).amplitude_of,
            AmplitudeOf::acceleration);
  EXPECT_NEAR(data::highest_frequency_hz(both), 10.0, 1e-12);
  const data::Case shock = read(
      "[excitation]\nshock = { shape = 'sawtooth', duration = '11 ms' }\nacceleration_amplitude = '50 g'\n");
  EXPECT_EQ(shock.general_motion()->pieces(), 2u);
}

TEST_F(MotionFile, ReadsASpectrum) {
  const std::string keys = "unit = 'g^2/Hz'\nseed = 7\nduration = 2\nscale = 3\n";
  (void)folder_.write("psd.csv", "f [kHz],ASD,other\n0.005,0.01,1\n0.02,0.02,1\n0.2,0.0005,1\n");
  const data::Case listed = read("[excitation]\nspectrum = [[5, 0.01], [20, 0.02], [200, 0.0005]]\n" + keys),
                   filed = read("[excitation]\nspectrum = 'psd.csv'\ncolumn = 'ASD'\n" + keys);
  for (const data::Case* problem : {&listed, &filed}) {
    const auto& spectrum = std::get<data::PowerSpectrum>(problem->general_motion()->statement());
    EXPECT_EQ(spectrum.seed, 7U);
    EXPECT_NEAR(spectrum.density(20.0), 0.02 * 9.80665 * 9.80665, 1e-12);
    EXPECT_EQ(data::highest_frequency_hz(*problem), 200.0);
    EXPECT_EQ(problem->general_motion()->scale(), 3.0);
  }
  EXPECT_EQ(listed.general_motion()->acceleration(0.7), filed.general_motion()->acceleration(0.7));
  EXPECT_NE(read("[excitation]\nspectrum = 'psd.csv'\ncolumn = 'ASD'\n" + keys, {{"excitation.seed", "8"}})
                .general_motion()
                ->acceleration(0.7),
            filed.general_motion()->acceleration(0.7));
  const data::Case both = read(
      "[excitation]\nspectrum = [[5, 1], [9, 1]]\nunit = '(mm/s)^2/Hz'\n[wall]\nspectrum = "
      "[[5, 1], [9, 1]]\nunit = 'm^2/Hz'\n");
  EXPECT_NEAR(std::get<data::PowerSpectrum>(both.general_motion()->statement()).to_si, 1e-6, 1e-21);
  EXPECT_NE(both.general_motion()->displacement(0.1), both.contact.wall_motion->displacement(0.1));
}

TEST_F(MotionFile, ReadsARecord) {
  write_record();
  const data::Case problem = read("[excitation]\n" + record_keys + "high_pass = '1 Hz'\n");
  const auto& record = std::get<MotionRecord>(problem.general_motion()->statement());
  EXPECT_EQ(record.samples.size(), 101u);
  EXPECT_TRUE(record.times.empty());
  EXPECT_EQ(record.unit, "g");
  EXPECT_NEAR(record.begin, 0.007, 1e-15);
  EXPECT_NEAR(problem.numerics.duration(), 0.4, 1e-12);
  EXPECT_NEAR(record.samples[12], 0.980665 * std::sin(0.48 * pi), 1e-8);
  std::ifstream stream(folder_.path() / "r.csv");
  const std::string bytes(std::istreambuf_iterator<char>(stream), {});
  EXPECT_EQ(record.sha256, data::sha256(bytes));
  // Times that are not equidistant, without unit and in parts of the file.
  std::string text = "t,az\n";
  for (int i = 0; i < 60000; ++i)
    text += fmt::format("{:.7f},{:.9f}\n", 0.004 * (i + 0.2 * (i % 2)),
                        std::sin(10.0 * pi * 0.004 * (i + 0.2 * (i % 2))));
  (void)folder_.write("r.csv", text);
  const data::Case uneven =
      read("[excitation]\n" + record_keys + "unit = 'm/s^2'\ninitial_velocity = '-0.031831 m/s'\n");
  EXPECT_EQ(std::get<MotionRecord>(uneven.general_motion()->statement()).times.size(), 60000u);
  EXPECT_NEAR(uneven.general_motion()->acceleration(200.0021), std::sin(10.0 * pi * 200.0021), 1e-5);
  EXPECT_NEAR(uneven.general_motion()->velocity(200.0), -0.031831, 1e-5);
  (void)folder_.write("r.csv", text + "240.1,x\n");
  EXPECT_TRUE(holds(refusal("[excitation]\n" + record_keys + "unit = 'g'\n"),
                    "r.csv:60002, column 2 (az): the cell is 'x'"));
}

TEST_F(MotionFile, RefusesInOneSentence) {
  write_record();
  const std::string sine = "frequency_hz = 20\n", sines = "sines = [[20, 1e-3]]\n",
                    sweep = "sweep = { from = 5, to = 50, rate = '1 oct/min' }\n",
                    shock = "shock = { shape = 'half-sine', duration = 0.01 }\n",
                    amplitude = "amplitude = 1e-3\n", record = record_keys + "high_pass = 1\n",
                    spectrum = "spectrum = [[5, 1], [9, 1]]\nunit = 'g^2/Hz'\n";
  for (const auto& [keys, sentence] : std::vector<std::pair<std::string, std::string>>{
           {amplitude,
            "excitation.frequency_hz is missing, but a case must hold it or one of excitation.sines, sweep"},
           {sine + amplitude + sines,
            "excitation.sines is an array, but must be left out where excitation.frequency_hz is given"},
           {sines + amplitude,
            "excitation.amplitude is 0.001 (a float), but must be left out where excitation.sines is given"},
           {sweep, "excitation.amplitude is missing, but must be given where excitation.sweep is"},
           {sines + "unit = 'g'\n",
            "excitation.unit is 'g' (a string), but must be left out without excitation.file"},
           {shock + amplitude, "excitation.shock is of displacement, but must be of an acceleration"},
           {"shock = { shape = 'rectangle', duration = 0.01 }\nvelocity_amplitude = 1.0\n",
            "excitation.shock is a rectangle of velocity, but must be of an acceleration"},
           {"shock = { shape = 'square', duration = 0.01 }\n" + amplitude, "excitation.shock is 'square'"},
           {"sines = [[20]]\n",
            "excitation.sines is an array, but must be a list of [frequency, amplitude, phase]"},
           {"sines = [[20, '1 s']]\n", "excitation.sines is '1 s' (a string), but must be a number (m)"},
           {"sweep = { from = 5, to = 50, rate = 1.0 }\n" + amplitude, "excitation.sweep is of rate 1"},
           {"sweep = { from = 5, to = 50, rate = '900 Hz/s' }\n" + amplitude,
            "excitation.sweep is 900, but must be of a rate"},
           {record_keys,
            "excitation.high_pass is missing, but must be given, or excitation.initial_velocity: from rest "
            "the "
            "record would drift by up to 0.01249 m"},
           {record + "duration = 2.0\n",
            "excitation.duration is 2, but must be at most that of r.csv, 0.4 s"},
           {record + "rate = 100\n",
            "excitation.rate is 100, but must be left out where the record has a column of time"},
           {record + "unit = 'm'\n", "excitation.unit is m, but must be a unit: m/s^2, g"},
           {record + "initial_velocity = 0\n",
            "excitation.initial_velocity is 0, but must be left out: the record has it"},
           {"file = 'r.csv'\ncolumn = 'ay'\nquantity = 'velocity'\n", "r.csv:2: the column ay is missing"},
           {"file = '../r.csv'\ncolumn = 'az'\nquantity = 'velocity'\n",
            "must be a file in the folder of the case"},
           {sine + amplitude + "[wall]\nspeed = 1.0\n" + sines,
            "wall.speed is 1, but must be left out where wall.sines is given"},
           {sine + amplitude + "[wall]\nsines = [[20, '1 N']]\n",
            "wall.sines is a force, but must be a motion"},
           {sine + amplitude + "[wall]\nscale = 2.0\n",
            "wall.scale is 2, but must be left out without a motion of the wall"},
           {sine + amplitude + "[wall]\namplitude = 2.0\n",
            "wall.amplitude is 2 (a float), but must be left out without wall.sweep"},
           {"spectrum = [[5, 1], [9, 1]]\n",
            "excitation.unit is missing, but must be given where excitation.spectrum is"},
           {"spectrum = [[5, 1], [9, 1]]\nunit = 'g'\n",
            "excitation.unit is g, but must be that of a density"},
           {"spectrum = [[5, 1], [9, 1]]\nunit = 'Pa^2/Hz'\n",
            "excitation.unit is Pa^2/Hz, but must be that of a density"},
           {spectrum + "seed = -1\n",
            "excitation.seed is -1 (an integer), but must be an integer of 0 or more"},
           {spectrum + "rate = 3\n",
            "excitation.rate is 3 (an integer), but must be left out without excitation.file"},
           {sines + "seed = 3\n",
            "excitation.seed is 3 (an integer), but must be left out without excitation.spectrum"},
           {"unit = 'g^2/Hz'\nspectrum = [[5, 1]]\n",
            "excitation.spectrum is 1, but must be of two points or more"},
           {"unit = 'g^2/Hz'\nspectrum = [[5, 1], [5, 1]]\n",
            "excitation.spectrum is 5, but must be of frequencies above 0 (Hz) that increase"},
           {"unit = 'g^2/Hz'\nspectrum = [[5, 0], [9, 1]]\n",
            "excitation.spectrum is 0, but must be of densities above 0"},
           {"unit = 'g^2/Hz'\nspectrum = 'none.csv'\n", "none.csv"},
           {"unit = 'g^2/Hz'\nspectrum = 'r.csv'\n",
            "the column f or frequency is missing; the file has time [ms], az [g]"},
           {spectrum + "duration = 1e6\n", "excitation.duration is 1e+06, but must be at most"},
           {spectrum + "duration = 1e-3\n", "excitation.duration is 0.001, but must be so long that lines"}})
    EXPECT_TRUE(holds(refusal("[excitation]\n" + keys), sentence));
  const auto refused = [&](const auto& change, const std::string& sentence, int rows = 101) {
    write_record(change, rows);
    EXPECT_TRUE(holds(refusal("[excitation]\n" + record), sentence));
  };
  refused(
      [](int i, double&, std::string& cell) {
        if (i == 50) cell = "nan";
      },
      "r.csv:53, column 2 (az [g]): the cell is 'nan', but must be a finite number");
  refused(
      [](int i, double& time, std::string&) {
        if (i > 50) time += 8.0;
      },
      "r.csv: the time step behind row 51 is 0.012 s, but must be near the usual one, 0.004 s: the record "
      "has a gap");
  refused(
      [](int i, double& time, std::string&) {
        if (i == 50) time -= 5.0;
      },
      "r.csv:53, column 1 (time [ms]): the time is 202, but must be above that of the row before");
  refused([](int, double&, std::string&) {}, "excitation.file is r.csv of 3 rows, but must be of at least 8",
          3);
  refused([](int, double&, std::string& cell) { cell += "e6"; },
          "m/s^2, but must be of at most 1e+05: check the unit");
  refused([](int i, double&, std::string& cell) { cell = fmt::format("{}", (i * i * 7919) % 1013); },
          "of its power above 0.4 of its rate, but must be with at most 1 %, as such a record is aliased");
}

}  // namespace
}  // namespace stickslip::testing
