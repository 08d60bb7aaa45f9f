#include "latex_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>

#include "stickslip/data/problem.hpp"
#include "stickslip/report/latex_text.hpp"

namespace stickslip::report {

namespace {

bool belongs_to_a_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.'; }

struct PowerOfTen {
  std::string_view mantissa;
  int exponent{};
  std::size_t length{};  // of the number in the text
};

// The number at the front of the text, if it has an exponent: "8.5e-16".
std::optional<PowerOfTen> power_at_front(std::string_view text) {
  const std::size_t e = text.find_first_not_of("0123456789.");
  if (e == 0 || e == std::string_view::npos || text[e] != 'e') return std::nullopt;
  const std::size_t digits = e + (text.substr(e + 1).starts_with('+') ? 2 : 1);
  int exponent{};
  const auto [end, error] = std::from_chars(text.data() + digits, text.data() + text.size(), exponent);
  const auto length = static_cast<std::size_t>(end - text.data());
  if (error != std::errc{} ||
      (length < text.size() && std::isalnum(static_cast<unsigned char>(text[length])) != 0))
    return std::nullopt;
  return PowerOfTen{text.substr(0, e), exponent, length};
}

}  // namespace

void Rows::add(const std::vector<std::string>& cells) {
  text_ += fmt::format("{} \\\\\n", fmt::join(cells, " & "));
}

void Rows::add_heading(const std::string& text, int columns) {
  text_ += fmt::format("\\multicolumn{{{}}}{{@{{}}p{{.9\\linewidth}}@{{}}}}{{{}}} \\\\*\n", columns, text);
}

std::string plain_number(double value) { return typeset(data::shortest_text(value)); }

std::string compact_number(double value, int digits) {
  const double rounded = std::stod(fmt::format("{:.{}e}", value, digits - 1));
  const double magnitude = std::abs(rounded);
  if (magnitude == 0.0 || (magnitude >= 1e-3 && magnitude < 1e5)) return plain_number(rounded);
  int needed = 1;
  while (std::stod(fmt::format("{:.{}e}", rounded, needed - 1)) != rounded) ++needed;
  return scientific(rounded, needed);
}

std::string order_text(const studies::OrderEstimate& estimate) {
  const std::string order = fixed(estimate.order, 3);
  return std::isfinite(estimate.half_width) ? fmt::format("${}\\pm{}$", order, fixed(estimate.half_width, 3))
                                            : order;
}

std::string unit_text(const std::string& unit) { return unit == "1" ? "" : typeset(unit); }

std::string yes_or_no(bool holds) { return holds ? "yes" : "\\textbf{no}"; }

std::string with_powers_of_ten(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const bool may_begin = i == 0 || !belongs_to_a_word(text[i - 1]);
    if (const auto power = may_begin ? power_at_front(std::string_view(text).substr(i)) : std::nullopt) {
      result += power->mantissa == "0" ? "0" : fmt::format("{} x 10^{}", power->mantissa, power->exponent);
      i += power->length;
    } else {
      result += text[i++];
    }
  }
  return result;
}

std::string breakable(std::string_view name) {
  std::string text;
  char before = ' ';
  for (const char c : name) {
    const bool starts_a_word = std::isupper(static_cast<unsigned char>(c)) != 0 && before != ' ';
    if (starts_a_word || before == '.' || before == '/') text += "\\allowbreak{}";
    text += escape(std::string_view(&c, 1));
    before = c;
  }
  return text;
}

}  // namespace stickslip::report
