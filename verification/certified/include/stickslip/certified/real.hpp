#pragma once

/// Ball arithmetic: a Real is a midpoint with a radius, and every operation returns a ball that holds the
/// exact result for all values in its operands' balls, rounding included (Johansson, Arb, IEEE Trans.
/// Comput. 66, 2017).

#include <arb.h>
#include <flint/fmpq.h>

#include <string>
#include <string_view>

namespace stickslip::certified {

/// Bits in which midpoints are rounded, of the calling thread; 256 unless a PrecisionScope says otherwise.
[[nodiscard]] long precision() noexcept;

/// Sets the precision while it lives. Throws std::invalid_argument unless 32 <= bits <= 1e6.
class PrecisionScope {
 public:
  explicit PrecisionScope(long bits);
  ~PrecisionScope();
  PrecisionScope(const PrecisionScope&) = delete;
  PrecisionScope& operator=(const PrecisionScope&) = delete;

 private:
  long previous_;
};

/// An exact input.
class Rational {
 public:
  /// A decimal or a ratio of two: "0.5e-3", "2e9", "1/120000". Throws std::invalid_argument, quoting the
  /// text, for anything else, a zero denominator and exponents beyond 10000 included.
  Rational(const char* text) : Rational(std::string_view(text)) {}
  Rational(std::string_view text);
  /// The double itself, not the decimal that was typed. Throws std::invalid_argument if it is not finite.
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

class Real {
 public:
  Real(int value = 0);
  /// Exactly the double. Throws std::invalid_argument if it is not finite.
  explicit Real(double value);
  /// Within one rounding at the current precision.
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
  /// +1 or -1 if every value in the ball has that sign, else 0.
  [[nodiscard]] int certain_sign() const noexcept;
  [[nodiscard]] bool contains(const Real& other) const noexcept;
  [[nodiscard]] bool overlaps(const Real& other) const noexcept;
  /// Bits of the midpoint that the radius leaves standing; very negative if the ball is not finite.
  [[nodiscard]] long accurate_bits() const noexcept;
  [[nodiscard]] double nearest_double() const;  ///< to the midpoint

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

/// True only if certain: for overlapping balls both x < y and y < x are false.
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
[[nodiscard]] Real tanh(const Real& x);
[[nodiscard]] Real sinc(const Real& x);  ///< sin(x)/x, 1 at 0
[[nodiscard]] Real abs(const Real& x);
[[nodiscard]] Real pow(const Real& x, unsigned exponent);
[[nodiscard]] Real pi();
/// Holds the larger of any value of x and any value of y.
[[nodiscard]] Real max(const Real& x, const Real& y);
/// The smallest ball around both.
[[nodiscard]] Real hull(const Real& x, const Real& y);
/// What both balls have in common. Throws std::logic_error if that is nothing.
[[nodiscard]] Real intersection(const Real& x, const Real& y);

/// A ball in decimals: |true - value| <= radius, with the rounding of the printed digits in the radius.
struct Enclosure {
  std::string value;
  std::string radius;
  double midpoint{};  ///< the double nearest to the ball's midpoint
};

/// Throws std::invalid_argument if the ball is not finite.
[[nodiscard]] Enclosure enclosure(const Real& x, int digits = 30);

/// A number that is not smaller than |computed - exact| in units in the last place of `computed` (the gap to
/// the next double away from zero); infinite if either is not finite.
[[nodiscard]] double distance_in_ulps(double computed, const Real& exact);

/// Evaluates `quantity` (a function without arguments) at rising precision until its ball, relative to its
/// midpoint, is below 10^-digits. Throws std::runtime_error if 16384 bits do not do: a quantity that is zero
/// never gets there.
template <class Quantity>
[[nodiscard]] Real to_digits(int digits, const Quantity& quantity);

/// Throws the std::runtime_error of to_digits().
[[noreturn]] void throw_digits_out_of_reach(int digits);

template <class Quantity>
Real to_digits(int digits, const Quantity& quantity) {
  constexpr double kBitsPerDigit = 3.3219280948873626;
  constexpr long kMostBits = 16384;
  for (long bits = 128; bits <= kMostBits; bits *= 2) {
    const PrecisionScope scope(bits);
    const Real value = quantity();
    if (static_cast<double>(value.accurate_bits()) > kBitsPerDigit * digits + 1.0) return value;
  }
  throw_digits_out_of_reach(digits);
}

}  // namespace stickslip::certified
