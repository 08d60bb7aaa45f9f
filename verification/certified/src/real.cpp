// SPDX-License-Identifier: MIT
#include "stickslip/certified/real.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

namespace stickslip::certified {
namespace {

thread_local long bits_of_thread = 256;

/// Applies a function of Arb with rounding to the current precision.
template <class Function, class... Arguments>
Real rounded(Function function, const Arguments&... arguments) {
  Real result;
  function(result.data(), arguments.data()..., precision());
  return result;
}

[[noreturn]] void throw_no_number(std::string_view text) {
  throw std::invalid_argument("'" + std::string(text) +
                              "' is no exact number; write it like -0.5e-3, 2e9 or 1/120000.");
}

void require_finite(double value) {
  if (!std::isfinite(value)) throw std::invalid_argument("A number is not finite; it must be.");
}

/// Removes the leading digits of `text` and returns them.
std::string take_digits(std::string_view& text) {
  std::size_t count = 0;
  while (count < text.size() && text[count] >= '0' && text[count] <= '9') ++count;
  const std::string taken(text.substr(0, count));
  text.remove_prefix(count);
  return taken;
}

bool take(std::string_view& text, std::string_view characters) {
  if (text.empty() || characters.find(text.front()) == std::string_view::npos) return false;
  text.remove_prefix(1);
  return true;
}

/// Reads [-+]digits[.digits][e[-+]digits] into `value`. Returns false if the text has another form.
bool read_decimal(std::string_view text, fmpq_t value) {
  constexpr long kLargestExponent = 10000;
  const bool negative = !text.empty() && text.front() == '-';
  take(text, "-+");
  std::string digits = take_digits(text);
  long exponent = 0;
  if (take(text, ".")) {
    const std::string fraction = take_digits(text);
    digits += fraction;
    exponent = -static_cast<long>(fraction.size());
  }
  if (digits.empty()) return false;
  if (take(text, "eE")) {
    const bool has_plus = take(text, "+");
    if (has_plus && text.starts_with('-')) return false;
    long power = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), power);
    if (error != std::errc{} || std::abs(power) > kLargestExponent) return false;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    exponent += power;
  }
  if (!text.empty()) return false;

  fmpq_t power_of_ten;
  fmpq_init(power_of_ten);
  fmpq_set_si(power_of_ten, 10, 1);
  fmpq_pow_si(power_of_ten, power_of_ten, exponent);
  fmpz_set_str(fmpq_numref(value), digits.c_str(), 10);
  fmpz_one(fmpq_denref(value));
  fmpq_mul(value, value, power_of_ten);
  if (negative) fmpq_neg(value, value);
  fmpq_clear(power_of_ten);
  return true;
}

}  // namespace

long precision() noexcept { return bits_of_thread; }

PrecisionScope::PrecisionScope(long bits) : previous_(bits_of_thread) {
  if (bits < 32 || bits > 1000000)
    throw std::invalid_argument("The precision is " + std::to_string(bits) +
                                " bits; it must be 32 ... 1000000.");
  bits_of_thread = bits;
}

PrecisionScope::~PrecisionScope() { bits_of_thread = previous_; }

Rational::Rational(std::string_view text) {
  const std::size_t slash = text.find('/');
  fmpq_t denominator;
  fmpq_init(value_);
  fmpq_init(denominator);
  fmpq_one(denominator);
  const bool is_read = read_decimal(text.substr(0, slash), value_) &&
                       (slash == std::string_view::npos || read_decimal(text.substr(slash + 1), denominator));
  const bool is_number = is_read && !fmpq_is_zero(denominator);
  if (is_number) fmpq_div(value_, value_, denominator);
  fmpq_clear(denominator);
  if (is_number) return;
  fmpq_clear(value_);
  throw_no_number(text);
}

Rational::Rational(double value) {
  require_finite(value);
  fmpq_init(value_);
  arf_t exact;
  arf_init(exact);
  arf_set_d(exact, value);
  arf_get_fmpq(value_, exact);
  arf_clear(exact);
}

Rational::Rational(const Rational& other) {
  fmpq_init(value_);
  fmpq_set(value_, other.value_);
}

Rational& Rational::operator=(const Rational& other) {
  fmpq_set(value_, other.value_);
  return *this;
}

Rational::~Rational() { fmpq_clear(value_); }

int Rational::sign() const noexcept { return fmpq_sgn(value_); }

double Rational::approximately() const { return Real(*this).nearest_double(); }

Real::Real(int value) {
  arb_init(value_);
  arb_set_si(value_, value);
}

Real::Real(double value) {
  require_finite(value);
  arb_init(value_);
  arb_set_d(value_, value);
}

Real::Real(const Rational& value) {
  arb_init(value_);
  arb_set_fmpq(value_, value.data(), precision());
}

Real::Real(const Real& other) {
  arb_init(value_);
  arb_set(value_, other.value_);
}

Real::Real(Real&& other) noexcept {
  arb_init(value_);
  arb_swap(value_, other.value_);
}

Real& Real::operator=(const Real& other) {
  arb_set(value_, other.value_);
  return *this;
}

Real& Real::operator=(Real&& other) noexcept {
  arb_swap(value_, other.value_);
  return *this;
}

Real::~Real() { arb_clear(value_); }

Real& Real::operator+=(const Real& other) {
  arb_add(value_, value_, other.value_, precision());
  return *this;
}

Real& Real::operator-=(const Real& other) {
  arb_sub(value_, value_, other.value_, precision());
  return *this;
}

Real& Real::operator*=(const Real& other) {
  arb_mul(value_, value_, other.value_, precision());
  return *this;
}

Real& Real::operator/=(const Real& other) {
  arb_div(value_, value_, other.value_, precision());
  return *this;
}

Real Real::midpoint() const {
  Real result;
  arb_get_mid_arb(result.value_, value_);
  return result;
}

Real Real::radius() const {
  Real result;
  arb_get_rad_arb(result.value_, value_);
  return result;
}

Real Real::lower() const {
  Real result;
  arb_get_lbound_arf(arb_midref(result.value_), value_, precision());
  return result;
}

Real Real::upper() const {
  Real result;
  arb_get_ubound_arf(arb_midref(result.value_), value_, precision());
  return result;
}

bool Real::is_finite() const noexcept { return arb_is_finite(value_) != 0; }

bool Real::contains_zero() const noexcept { return arb_contains_zero(value_) != 0; }

int Real::certain_sign() const noexcept { return arb_sgn_nonzero(value_); }

bool Real::contains(const Real& other) const noexcept { return arb_contains(value_, other.value_) != 0; }

bool Real::overlaps(const Real& other) const noexcept { return arb_overlaps(value_, other.value_) != 0; }

long Real::accurate_bits() const noexcept { return arb_rel_accuracy_bits(value_); }

double Real::nearest_double() const { return arf_get_d(arb_midref(value_), ARF_RND_NEAR); }

Real operator-(const Real& x) {
  Real result;
  arb_neg(result.data(), x.data());
  return result;
}

Real operator+(Real x, const Real& y) { return x += y; }
Real operator-(Real x, const Real& y) { return x -= y; }
Real operator*(Real x, const Real& y) { return x *= y; }
Real operator/(Real x, const Real& y) { return x /= y; }

bool operator<(const Real& x, const Real& y) noexcept { return arb_lt(x.data(), y.data()) != 0; }
bool operator>(const Real& x, const Real& y) noexcept { return arb_gt(x.data(), y.data()) != 0; }
bool operator<=(const Real& x, const Real& y) noexcept { return arb_le(x.data(), y.data()) != 0; }
bool operator>=(const Real& x, const Real& y) noexcept { return arb_ge(x.data(), y.data()) != 0; }

Real sqrt(const Real& x) { return rounded(arb_sqrt, x); }
Real exp(const Real& x) { return rounded(arb_exp, x); }
Real sin(const Real& x) { return rounded(arb_sin, x); }
Real cos(const Real& x) { return rounded(arb_cos, x); }
Real tan(const Real& x) { return rounded(arb_tan, x); }
Real sinh(const Real& x) { return rounded(arb_sinh, x); }
Real cosh(const Real& x) { return rounded(arb_cosh, x); }
Real sinc(const Real& x) { return rounded(arb_sinc, x); }

Real abs(const Real& x) {
  Real result;
  arb_abs(result.data(), x.data());
  return result;
}

Real pow(const Real& x, unsigned exponent) {
  Real result;
  arb_pow_ui(result.data(), x.data(), exponent, precision());
  return result;
}

Real pi() { return rounded(arb_const_pi); }
Real max(const Real& x, const Real& y) { return rounded(arb_max, x, y); }

Real hull(const Real& x, const Real& y) { return rounded(arb_union, x, y); }

Real intersection(const Real& x, const Real& y) {
  Real result;
  if (arb_intersection(result.data(), x.data(), y.data(), precision()) == 0)
    throw std::logic_error("Two enclosures of the same number do not overlap.");
  return result;
}

Enclosure enclosure(const Real& x, int digits) {
  if (!x.is_finite()) throw std::invalid_argument("A number is not finite; it cannot be printed.");
  const std::unique_ptr<char, void (*)(void*)> printed(arb_get_str(x.data(), digits, ARB_STR_MORE),
                                                       flint_free);
  // "[1.25 +/- 3.1e-4]", "1.25" if the decimals are exact, or "[+/- 3.1e-4]" if the midpoint is 0.
  const std::string text(printed.get());
  constexpr std::string_view kBetween = "+/- ";
  const std::size_t between = text.find(kBetween);
  if (between == std::string::npos) return {text, "0", x.nearest_double()};
  const std::size_t radius = between + kBetween.size();
  return {between == 1 ? "0" : text.substr(1, between - 2), text.substr(radius, text.size() - radius - 1),
          x.nearest_double()};
}

double distance(double computed, const Real& exact) {
  if (!std::isfinite(computed) || !exact.is_finite()) return std::numeric_limits<double>::infinity();
  return arf_get_d(arb_midref(abs(Real(computed) - exact).upper().data()), ARF_RND_UP);
}

}  // namespace stickslip::certified
