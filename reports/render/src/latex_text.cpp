#include "stickslip/report/latex_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace stickslip::report {

namespace {

void require_finite(double value) {
  if (!std::isfinite(value)) throw std::invalid_argument(fmt::format("{} cannot stand in the report", value));
}

std::string in_math_if_negative(const std::string& number) {
  return number.starts_with('-') ? "\\ensuremath{" + number + "}" : number;
}

// The decimal exponent of the value once rounded to this many significant digits.
int decimal_exponent(double value, int digits) {
  const std::string text = fmt::format("{:.{}e}", value, digits - 1);
  return std::stoi(text.substr(text.find('e') + 1));
}

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

constexpr std::array<std::string_view, 9> greek{"alpha",  "beta", "gamma", "epsilon", "Omega",
                                                "lambda", "mu",   "rho",   "omega"};

constexpr std::string_view always_symbols = "PLIfu";  // quantities that are no unit and no word

// The LaTeX of a symbol that prose would not hold ("omega", "betabar"), or nothing.
std::string greek_symbol(std::string_view word) {
  if (std::ranges::find(greek, word) != greek.end()) return fmt::format("\\{}", word);
  if (word == "betabar") return "\\bar\\beta";
  return "";
}

std::string subscript_text(std::string_view word) {
  if (word == "max") return "\\max";
  return word.size() == 1 ? std::string(word) : fmt::format("\\mathrm{{{}}}", word);
}

// Reads plain notation from left to right.
class Typesetter {
 public:
  explicit Typesetter(std::string_view text) : text_(text) {}

  std::string run() {
    while (at_ < text_.size()) {
      if (is_letter(text_[at_])) {
        word();
        end_of_last_word_ = at_;
      } else if (!superscript() && !relation() && !minus())
        result_ += escape(text_.substr(at_++, 1));
    }
    return std::move(result_);
  }

 private:
  std::string_view take_while(bool (*belongs)(char)) {
    const std::size_t start = at_;
    while (at_ < text_.size() && belongs(text_[at_])) ++at_;
    return text_.substr(start, at_ - start);
  }

  // A symbol with its subscript, primes, exponent and argument; any other word as it stands.
  void word() {
    const std::size_t start = at_;
    const std::string_view base = take_while(is_letter);
    if (base == "x" && stands_between_numbers(start)) {
      result_ += "\\ensuremath{\\times}";
      return;
    }
    after_symbol_ = is_symbol(base, start);
    if (!after_symbol_) {
      result_ += base;
      return;
    }
    const std::string greek_letter = greek_symbol(base);
    std::string symbol = greek_letter.empty() ? std::string(base) : greek_letter;
    if (is_split_rigidity(base)) {
      symbol = "EI";
      at_ += 2;
    }
    if (subscript_follows()) {
      symbol += fmt::format("_{{{}}}", subscripts());
    } else if (const std::string_view number = take_while(is_digit); !number.empty()) {
      symbol += fmt::format("_{{{}}}", number);
    }
    symbol += take_while([](char c) { return c == '\''; });
    if (next_is('^')) symbol += exponent();
    symbol += argument();
    result_ += fmt::format("\\ensuremath{{{}}}", symbol);
  }

  // "_n_tt": one subscript, its parts separated by commas.
  std::string subscripts() {
    std::string text;
    while (subscript_follows()) {
      ++at_;
      if (!text.empty()) text += ",";
      text += subscript_text(take_while(is_letter));
    }
    return text;
  }

  // Greek letters, "EI", "E I" and the letters of always_symbols; another single letter where its neighbours
  // show that it is neither a unit nor an article: "u_t", "S(x)", "A = 0.01", "x = L", "rho A".
  [[nodiscard]] bool is_symbol(std::string_view base, std::size_t start) const {
    if (!greek_symbol(base).empty() || base == "EI") return true;
    if (base.size() != 1) return false;
    if (always_symbols.find(base) != std::string_view::npos || is_split_rigidity(base)) return true;
    const std::string_view before = text_.substr(0, start);
    const bool follows_symbol = after_symbol_ && before.ends_with(' ') && end_of_last_word_ + 1 == start;
    return follows_symbol || subscript_follows() || next_is('\'') || !argument_text().empty() ||
           rest().starts_with(" = ") || before.ends_with("= ");
  }

  // "E I", the flexural rigidity.
  [[nodiscard]] bool is_split_rigidity(std::string_view base) const {
    return base == "E" && rest().starts_with(" I") && !(rest().size() > 2 && is_letter(rest()[2]));
  }

  [[nodiscard]] std::string_view rest() const { return text_.substr(at_); }

  [[nodiscard]] bool subscript_follows() const {
    return rest().size() > 1 && rest()[0] == '_' && is_letter(rest()[1]);
  }

  // "(x,0)": a short bracket without spaces after a symbol, or nothing.
  [[nodiscard]] std::string_view argument_text() const {
    const std::size_t end = rest().find(')');
    if (!next_is('(') || end == std::string_view::npos) return {};
    const std::string_view text = rest().substr(0, end + 1);
    return text.find_first_not_of("(xtL0/2,)") == std::string_view::npos ? text : std::string_view{};
  }

  std::string_view argument() {
    const std::string_view text = argument_text();
    at_ += text.size();
    return text;
  }

  bool superscript() {
    if (!next_is('^')) return false;
    result_ += fmt::format("\\ensuremath{{{}}}", exponent());
    return true;
  }

  // "^-6" or "^4".
  std::string exponent() {
    ++at_;
    const bool negative = next_is('-');
    if (negative) ++at_;
    return fmt::format("^{{{}{}}}", negative ? "-" : "", take_while(is_digit));
  }

  bool relation() {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 2> relations{
        {{"<=", "\\ensuremath{\\le}"}, {">=", "\\ensuremath{\\ge}"}}};
    for (const auto& [plain, latex] : relations) {
      if (!text_.substr(at_).starts_with(plain)) continue;
      at_ += plain.size();
      result_ += latex;
      return true;
    }
    return false;
  }

  // A minus sign: after a space or a bracket, before a number, a symbol or a space.
  bool minus() {
    if (!next_is('-') || at_ + 1 >= text_.size()) return false;
    const bool after_space = at_ == 0 || text_[at_ - 1] == ' ' || text_[at_ - 1] == '(';
    const char after = text_[at_ + 1];
    if (!after_space || !(after == ' ' || is_digit(after) || is_letter(after))) return false;
    ++at_;
    result_ += "\\ensuremath{-}";
    return true;
  }

  // Whether the word just read has a number on either side: "3 x 10".
  [[nodiscard]] bool stands_between_numbers(std::size_t start) const {
    const bool number_before =
        start >= 2 && text_[start - 1] == ' ' && (is_digit(text_[start - 2]) || text_[start - 2] == ')');
    return number_before && rest().size() > 1 && rest()[0] == ' ' && is_digit(rest()[1]);
  }

  [[nodiscard]] bool next_is(char c) const { return at_ < text_.size() && text_[at_] == c; }

  std::string_view text_;
  std::size_t at_{};
  std::size_t end_of_last_word_{};
  bool after_symbol_{};  // the last word was a symbol
  std::string result_;
};

}  // namespace

std::string fixed(double value, int decimals) {
  require_finite(value);
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.starts_with('-') && text.find_first_of("123456789") == std::string::npos) text.erase(0, 1);
  return in_math_if_negative(text);
}

std::string significant(double value, int digits) {
  require_finite(value);
  if (value == 0.0) return "0";
  return fixed(value, std::max(0, digits - 1 - decimal_exponent(value, digits)));
}

std::string scientific(double value, int digits) {
  require_finite(value);
  if (value == 0.0) return "0";
  const std::string text = fmt::format("{:.{}e}", value, digits - 1);
  return fmt::format("\\ensuremath{{{}\\times10^{{{}}}}}", text.substr(0, text.find('e')),
                     decimal_exponent(value, digits));
}

std::string escape(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '\\':
        result += "\\textbackslash{}";
        break;
      case '^':
        result += "\\textasciicircum{}";
        break;
      case '~':
        result += "\\textasciitilde{}";
        break;
      case '#':
      case '$':
      case '%':
      case '&':
      case '_':
      case '{':
      case '}':
        result += '\\';
        [[fallthrough]];
      default:
        result += c;
    }
  }
  return result;
}

std::string typeset(std::string_view text) { return Typesetter(text).run(); }

}  // namespace stickslip::report
