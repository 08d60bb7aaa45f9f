#include "latex_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>
#include <cmath>
#include <regex>

#include "stickslip/data/problem.hpp"
#include "stickslip/report/latex_text.hpp"

namespace stickslip::report {

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
  const std::string without_zeros = std::regex_replace(text, std::regex("\\b0e[+]00\\b"), "0");
  return std::regex_replace(without_zeros, std::regex("\\b([0-9.]+)e[+]?(-?)0*([0-9]+)\\b"), "$1 x 10^$2$3");
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
