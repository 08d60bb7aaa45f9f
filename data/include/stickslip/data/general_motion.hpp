// SPDX-License-Identifier: MIT
#pragma once

/// Motions that are no single sine: sums of sines, sweeps, shocks, measured records and random motions with a power spectrum. SI units.

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace stickslip::data {

/// What an amplitude is one of: of the motion of the base, or of the force on the load of a Model.
enum class AmplitudeOf { displacement, velocity, acceleration, force };

/// The number of derivatives in time of the base motion that are proportional to it.
[[nodiscard]] constexpr int derivatives(AmplitudeOf kind) noexcept {
  return kind == AmplitudeOf::force ? 2 : static_cast<int>(kind);
}

/// A piece of a motion: its acceleration is
///
///     a(t) = Σ_k c_k τ^k,   τ = t - begin,   0 ≤ τ ≤ length,
///
/// and it has the velocity and displacement at its begin.
struct MotionPiece {
  double begin{}, length{};              ///< s
  std::array<double, 8> acceleration{};  ///< c_k, m/s^(2+k)
  double velocity{}, displacement{};     ///< m/s, m
};

/// h(t) = A Ω^-k sin(Ω t + φ) with Ω = 2π frequency_hz, where A is the amplitude of the k-th derivative; with a force,
/// F(t) = A sin(Ω t + φ).
struct Sine {
  double frequency_hz{};       ///< Hz, > 0
  double amplitude{};          ///< A, m, m/s, m/s² or N, ≥ 0
  AmplitudeOf amplitude_of{};  ///< what it is the amplitude of
  double phase{};              ///< φ, rad, any finite value
};

/// h(t) = A φ'(t)^-k sin φ(t) with φ(t) = 2π ∫ f, where A is the amplitude of the k-th derivative and
///
///     f = from + rate t   or   f = from 2^(rate t)
///
/// until the last zero of h before it is `to`; it stays as it is there, so that the velocity does not jump. Displacement, velocity and acceleration are closed forms, without drift; the k-th derivative
/// has the amplitude A up to terms of f'/f² relative to it. With a force, F(t) = A sin φ(t).
struct Sweep {
  double from_hz{}, to_hz{};  ///< Hz, > 0, up or down
  double rate{};          ///< Hz/s, or octaves/s, > 0 up or down; at most ten times the frequency in a period
  bool is_logarithmic{};  ///< the rate is in octaves
  double amplitude{};     ///< A, m, m/s, m/s² or N, ≥ 0
  AmplitudeOf amplitude_of{};  ///< what it is the amplitude of
};

enum class ShockShape {
  half_sine,  ///< A sin(π t/D)
  sawtooth,   ///< A t/D, with its peak at the end (IEC 60068-2-27)
  trapezoid,  ///< rises to A and falls from it in D/10 each
  rectangle   ///< A
};

/// From rest at t = 0 the stated quantity has a shape of the duration D, then is 0. Shapes that need an infinite acceleration are
/// refused: a displacement, and a sawtooth or rectangle of the velocity.
struct Shock {
  ShockShape shape{};
  double duration{};           ///< D, s, > 0
  double amplitude{};          ///< A, m/s, m/s² or N, ≥ 0
  AmplitudeOf amplitude_of{};  ///< what it is the amplitude of
};

/// Equidistant or other samples of a quantity. Between them it is the cubic spline with two continuous derivatives (de Boor's
/// not-a-knot), which is differentiated or integrated exactly.
///
/// With a high pass ω = 2π high_pass_hz, its acceleration a(t) goes through two sections of Butterworth's second order, from rest,
///
///     ẍ_1 + √2 ω ẋ_1 + ω² x_1 = a(t),     ẍ_2 + √2 ω ẋ_2 + ω² x_2 = ẍ_1,
///
/// and the displacement is x_2. Without one an acceleration needs an initial velocity, a velocity an initial displacement.
struct MotionRecord {
  std::string file;                              ///< as the case file has it
  std::string sha256;                            ///< of its bytes
  std::string column;                            ///< as the file has it
  std::string unit;                              ///< as it is stated
  AmplitudeOf quantity{};                        ///< what is sampled
  double begin{};                                ///< time of the first sample, s, which is t = 0
  double step{};                                 ///< s, > 0; of times that are not equidistant, the mean
  std::vector<double> times{};                   ///< s, from 0; empty if they are equidistant
  std::vector<double> samples;                   ///< m, m/s, m/s² or N
  std::optional<double> high_pass_hz{};          ///< Hz, > 0
  std::optional<double> initial_displacement{};  ///< m
  std::optional<double> initial_velocity{};      ///< m/s
};

/// A stationary Gaussian motion with the one-sided power spectral density S(f) of a quantity: between its points a straight line of
/// log S over log f, outside 0. Its realisation of the seed until T has that period and lines 1/T apart,
///
///     Σ_k √(S(k/T)/T) (a_k cos(2π k t/T) + b_k sin(2π k t/T)),     first point < k/T ≤ last point,
///
/// with independent normal numbers a_k, b_k of mean 0 and variance 1.
struct PowerSpectrum {
  struct Point {
    double frequency_hz{};  ///< Hz, > 0, ascending
    double density{};       ///< the square of the SI unit of the quantity over Hz, > 0
  };
  std::vector<Point> points;  ///< two or more
  AmplitudeOf quantity{};     ///< what has this density
  std::string unit;           ///< as it is stated,
  double to_si{1.0};          ///< and what it is in SI units
  std::string file;           ///< as the case file has it; empty where the points stand in it
  std::string sha256;         ///< of its bytes
  std::uint64_t seed{1};      ///< of the numbers; base and wall are independent whatever their seeds
  bool is_of_wall{};

  /// S(f) of the acceleration, (m/s²)²/Hz, or of a force, N²/Hz.
  [[nodiscard]] double density(double frequency_hz) const;
  /// c_k of the acceleration Σ Re(c_k exp(2πi k t/T)), m/s², or of a force, N; from k = 0 on.
  [[nodiscard]] std::vector<std::complex<double>> lines(double duration) const;
};

class MotionShape;

/// A motion h(t), t ≥ 0, of base or wall, in the frame at rest. A force F(t) on the load of a Model is -ḧ times 1 kg, as that of
/// HarmonicExcitation, but its displacement and velocity are 0. Cannot be built invalid; cheap to copy.
class GeneralMotion {
 public:
  using Statement = std::variant<std::vector<Sine>, Sweep, Shock, MotionRecord, PowerSpectrum>;

  /// From 0 to `duration`, s, which may be anything for a record. Throws FieldError, naming a key of `table`, "excitation" or
  /// "wall".
  GeneralMotion(Statement statement, double duration, std::string_view table = "excitation");

  /// m, m/s and m/s² at 0 ≤ t ≤ duration(), to rounding: in closed form, or from the pieces of a record.
  [[nodiscard]] double displacement(double t) const;
  [[nodiscard]] double velocity(double t) const;
  [[nodiscard]] double acceleration(double t) const;

  /// The pieces cover [0, duration()] without gaps; each is made as it is asked for, the scale applied.
  [[nodiscard]] std::size_t pieces() const noexcept;
  [[nodiscard]] MotionPiece piece(std::size_t index) const;
  /// Bound of the difference of the acceleration of the pieces from the closed form, m/s²: that of the interpolation in eight
  /// Chebyshev points, max |h^(10)| (length/2)^8/(2^7 8!), without rounding. 0 for a record, which its pieces are. Of a spectrum, whose pieces
  /// have the displacement and three derivatives of the lines at six points in a period of the highest of them, Σ|c_k| (ω_k length)^6/322560.
  [[nodiscard]] double piece_error() const noexcept;
  /// Estimate of what the interpolation between the samples of a record can change in its acceleration, m/s²; 0 for the others.
  /// A spline of every second sample misses the others by at most e; then the spline of all misses a value by e/16, its first
  /// derivative by at most 0.45 e/step and its second by 2 e/step², the leading terms for a smooth quantity.
  [[nodiscard]] double interpolation_error() const noexcept;

  /// s; of a record its own.
  [[nodiscard]] double duration() const noexcept;
  /// The same motion until another time. Throws FieldError, naming the duration, if a record is shorter.
  [[nodiscard]] GeneralMotion lasting(double duration) const;
  /// Hz: of sines the highest; of a sweep the highest that it comes to; of a shock 1/(2 D) times 5 for a half-sine, 12 for the
  /// others, below which 99.9 % of the power of a half-sine and of a trapezoid of the acceleration lies; of a record the one
  /// below which 99.9 % of the power of its acceleration about its mean lies, by Hann windows of at most 2^16 samples; of a spectrum
  /// its last one.
  [[nodiscard]] double highest_frequency_hz() const noexcept;

  [[nodiscard]] double scale() const noexcept { return scale_; }
  /// The statement times another scale, finite and ≥ 0, in place of the present one. Throws FieldError.
  [[nodiscard]] GeneralMotion scaled(double scale) const;
  [[nodiscard]] bool is_force() const noexcept;
  /// Without the scale.
  [[nodiscard]] const Statement& statement() const noexcept;
  /// The key that states it, "excitation.sines".
  [[nodiscard]] std::string key() const;

 private:
  std::shared_ptr<const MotionShape> shape_;
  double scale_{1.0};
};

}  // namespace stickslip::data
