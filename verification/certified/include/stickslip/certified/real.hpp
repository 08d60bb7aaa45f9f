// SPDX-License-Identifier: MIT
#pragma once

/// Ball arithmetic: a Real is a midpoint with a radius. The result of each operation is a ball that contains
/// the exact results for all values in the balls of the operands, including the effect of rounding
/// (Johansson, Arb, IEEE Trans. Comput. 66, 2017).

#include <arb.h>
#include <flint/fmpq.h>

#include <string>
#include <string_view>

namespace stickslip::certified {

/// The precision of the midpoints in the calling thread, in bits; 256 unless a PrecisionScope has changed it.
[[nodiscard]] long precision() noexcept;

/// Sets the precision during its lifetime. Throws std::invalid_argument unless 32 ≤ bits ≤ 1e6.
class PrecisionScope {
 public:
  explicit PrecisionScope(long bits);
  ~PrecisionScope();
  PrecisionScope(const PrecisionScope&) = delete;
  PrecisionScope& operator=(const PrecisionScope&) = delete;

 private:
  long previous_;
};

/// An exact rational number, used for inputs.
class Rational {
 public:
  /// Reads a decimal or a ratio of two decimals, such as "0.5e-3", "2e9" or "1/120000". Throws
  /// std::invalid_argument, quoting the text, for any other text, for a zero denominator, and for exponents
  /// above 10000 in magnitude.
  Rational(const char* text) : Rational(std::string_view(text)) {}
  Rational(std::string_view text);
  /// The exact value of the double, which may differ from the decimal in the source. Throws
  /// std::invalid_argument if it is not finite.
  explicit Rational(double value);
  Rational(const Rational& other);
  Rational& operator=(const Rational& other);
  ~Rational();

  [[nodiscard]] int sign() const noexcept;
  [[nodiscard]] double approximately() const;
  [[nodiscard]] const fmpq* data() const noexcept { return value_; }

 private:
  fmpq_t value_;
};

/// A real number that is enclosed by a ball.
class Real {
 public:
  Real(int value = 0);
  /// The exact value of the double. Throws std::invalid_argument if it is not finite.
  explicit Real(double value);
  /// The ball of one rounding at the current precision.
  Real(const Rational& value);
  Real(const Real& other);
  Real(Real&& other) noexcept;
  Real& operator=(const Real& other);
  Real& operator=(Real&& other) noexcept;
  ~Real();

  Real& operator+=(const Real& other);
  Real& operator-=(const Real& other);
  Real& operator*=(const Real& other);
  Real& operator/=(const Real& other);

  [[nodiscard]] Real midpoint() const;  ///< exact
  [[nodiscard]] Real radius() const;    ///< exact
  [[nodiscard]] Real lower() const;     ///< exact, not above any value in the ball
  [[nodiscard]] Real upper() const;     ///< exact, not below any value in the ball
  [[nodiscard]] bool is_finite() const noexcept;
  [[nodiscard]] bool contains_zero() const noexcept;
  /// +1 or -1 if all values in the ball have that sign, otherwise 0.
  [[nodiscard]] int certain_sign() const noexcept;
  [[nodiscard]] bool contains(const Real& other) const noexcept;
  [[nodiscard]] bool overlaps(const Real& other) const noexcept;
  /// The number of bits of the midpoint that are accurate in view of the radius; very negative if the ball is
  /// not finite.
  [[nodiscard]] long accurate_bits() const noexcept;
  [[nodiscard]] double nearest_double() const;  ///< the double nearest to the midpoint

  [[nodiscard]] const arb_struct* data() const noexcept { return value_; }
  [[nodiscard]] arb_struct* data() noexcept { return value_; }

 private:
  arb_t value_;
};

[[nodiscard]] Real operator-(const Real& x);
[[nodiscard]] Real operator+(Real x, const Real& y);
[[nodiscard]] Real operator-(Real x, const Real& y);
[[nodiscard]] Real operator*(Real x, const Real& y);
[[nodiscard]] Real operator/(Real x, const Real& y);

/// True only if certain: for overlapping balls x < y and y < x are both false.
[[nodiscard]] bool operator<(const Real& x, const Real& y) noexcept;
[[nodiscard]] bool operator>(const Real& x, const Real& y) noexcept;
[[nodiscard]] bool operator<=(const Real& x, const Real& y) noexcept;
[[nodiscard]] bool operator>=(const Real& x, const Real& y) noexcept;

[[nodiscard]] Real sqrt(const Real& x);
[[nodiscard]] Real exp(const Real& x);
[[nodiscard]] Real sin(const Real& x);
[[nodiscard]] Real cos(const Real& x);
[[nodiscard]] Real tan(const Real& x);
[[nodiscard]] Real sinh(const Real& x);
[[nodiscard]] Real cosh(const Real& x);
[[nodiscard]] Real sinc(const Real& x);  ///< sin(x)/x, 1 at 0
[[nodiscard]] Real abs(const Real& x);
[[nodiscard]] Real pow(const Real& x, unsigned exponent);
[[nodiscard]] Real pi();
/// A ball that contains the larger of any value of x and any value of y.
[[nodiscard]] Real max(const Real& x, const Real& y);
/// A ball that contains both balls.
[[nodiscard]] Real hull(const Real& x, const Real& y);
/// A ball that contains the common values of both balls. Throws std::logic_error if there are none.
[[nodiscard]] Real intersection(const Real& x, const Real& y);

/// A ball in decimals: |true - value| ≤ radius. The radius includes the rounding of the printed digits.
struct Enclosure {
  std::string value;
  std::string radius;
  double midpoint{};  ///< the double nearest to the midpoint of the ball
};

/// Converts a ball to decimals. Throws std::invalid_argument if the ball is not finite.
[[nodiscard]] Enclosure enclosure(const Real& x, int digits = 30);

/// An upper bound of |computed - exact|; infinite if either value is not finite.
[[nodiscard]] double distance(double computed, const Real& exact);

}  // namespace stickslip::certified
