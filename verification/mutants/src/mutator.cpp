#include "stickslip/mutants/mutator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <tuple>
#include <utility>

#include "fingerprint.hpp"
#include "stickslip/report/text_file.hpp"

namespace stickslip::mutants {

namespace fs = std::filesystem;

namespace {

struct Token {
  enum class Kind { word, number, punctuator, text } kind{};
  std::size_t offset{};
  std::string_view text;

  [[nodiscard]] std::size_t end() const { return offset + text.size(); }
};

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

std::size_t end_of_line(std::string_view source, std::size_t place) {
  return std::min(source.find('\n', place), source.size());
}

std::size_t end_of_quotation(std::string_view source, std::size_t place) {
  const char quote = source[place++];
  while (place < source.size() && source[place] != quote) place += source[place] == '\\' ? 2 : 1;
  return std::min(place + 1, source.size());
}

// 1e-12, 0x1.8p3, 1'000'000, 4U
std::size_t end_of_number(std::string_view source, std::size_t place) {
  while (place < source.size()) {
    const char c = source[place], before = place > 0 ? source[place - 1] : ' ';
    const bool exponent = (c == '+' || c == '-') && (before == 'e' || before == 'E');
    if (!is_word(c) && c != '.' && c != '\'' && !exponent) break;
    ++place;
  }
  return place;
}

std::size_t punctuator_length(std::string_view rest) {
  constexpr std::array<std::string_view, 23> longest_first{"<=>", "<<=", ">>=", "...", "->", "++", "--", "<<",
                                                           ">>",  "<=",  ">=",  "==",  "!=", "&&", "||", "+=",
                                                           "-=",  "*=",  "/=",  "%=",  "&=", "|=", "::"};
  for (const auto text : longest_first)
    if (rest.starts_with(text)) return text.size();
  return 1;
}

std::vector<Token> tokens_of(std::string_view source) {
  std::vector<Token> tokens;
  for (std::size_t place = 0; place < source.size();) {
    const char c = source[place];
    const auto rest = source.substr(place);
    const auto take = [&](Token::Kind kind, std::size_t end) {
      tokens.push_back({kind, place, source.substr(place, end - place)});
      place = end;
    };
    if (std::isspace(static_cast<unsigned char>(c)) != 0) {
      ++place;
    } else if (c == '#' || rest.starts_with("//")) {
      place = end_of_line(source, place);
    } else if (rest.starts_with("/*")) {
      place = std::min(source.find("*/", place), source.size() - 2) + 2;
    } else if (c == '"' || c == '\'') {
      take(Token::Kind::text, end_of_quotation(source, place));
    } else if (is_digit(c)) {
      take(Token::Kind::number, end_of_number(source, place));
    } else if (is_word(c)) {
      std::size_t end = place;
      while (end < source.size() && is_word(source[end])) ++end;
      take(Token::Kind::word, end);
    } else {
      take(Token::Kind::punctuator, place + punctuator_length(rest));
    }
  }
  return tokens;
}

// Goes through the tokens of a source and notes what may be changed.
class Mutator {
 public:
  explicit Mutator(std::string_view source) : source_(source), tokens_(tokens_of(source)) {}

  std::vector<Mutation> run() {
    for (place_ = 0; place_ < tokens_.size(); ++place_) {
      if (at(0) == "static_assert") {
        skip_statement();
        continue;
      }
      switch (tokens_[place_].kind) {
        case Token::Kind::punctuator:
          change_operator();
          break;
        case Token::Kind::number:
          change_constant();
          break;
        case Token::Kind::word:
          change_word();
          break;
        case Token::Kind::text:
          break;
      }
      if (begins_statement()) delete_statement();
    }
    return std::move(mutations_);
  }

 private:
  // The text of the token that stands so many behind the present one; empty beyond the ends.
  [[nodiscard]] std::string_view at(std::ptrdiff_t distance) const {
    const auto index = static_cast<std::ptrdiff_t>(place_) + distance;
    return index >= 0 && index < std::ssize(tokens_) ? tokens_[static_cast<std::size_t>(index)].text : "";
  }

  // The place of the bracket that closes the one at `open`.
  [[nodiscard]] std::size_t closing(std::size_t open) const {
    int depth = 0;
    for (std::size_t i = open; i < tokens_.size(); ++i) {
      const auto text = tokens_[i].text;
      if (text == "(" || text == "[" || text == "{") ++depth;
      if (text == ")" || text == "]" || text == "}") --depth;
      if (depth == 0) return i;
    }
    return tokens_.size() - 1;
  }

  // The place of the semicolon that ends the statement at `begin`, past all brackets in it.
  [[nodiscard]] std::size_t semicolon(std::size_t begin) const {
    for (std::size_t i = begin; i < tokens_.size(); ++i) {
      const auto text = tokens_[i].text;
      if (text == ";") return i;
      if (text == "(" || text == "[" || text == "{") i = closing(i);
    }
    return tokens_.size() - 1;
  }

  void skip_statement() { place_ = semicolon(place_); }

  void note(const char* kind, std::size_t from, std::size_t to, std::string replacement) {
    mutations_.push_back({kind, from, std::string(source_.substr(from, to - from)), std::move(replacement)});
  }
  void replace_token(const char* kind, std::string_view replacement) {
    note(kind, tokens_[place_].offset, tokens_[place_].end(), std::string(replacement));
  }

  // A binary operator has space on both sides, a bracket of a template or a pointer has not.
  [[nodiscard]] bool is_spaced() const {
    const Token& token = tokens_[place_];
    return token.offset > 0 && std::isspace(static_cast<unsigned char>(source_[token.offset - 1])) != 0 &&
           token.end() < source_.size() &&
           std::isspace(static_cast<unsigned char>(source_[token.end()])) != 0;
  }

  [[nodiscard]] bool is_unary() const {
    const auto before = at(-1);
    if (before.empty()) return false;
    const bool ends_operand = is_word(before.back()) || before == ")" || before == "]";
    return (!ends_operand || before == "return") && !is_spaced();
  }

  void change_operator() {
    static const std::multimap<std::string_view, std::pair<const char*, std::string_view>> changes{
        {"+", {"arithmetic", "-"}},   {"-", {"arithmetic", "+"}},   {"*", {"arithmetic", "/"}},
        {"/", {"arithmetic", "*"}},   {"+=", {"arithmetic", "-="}}, {"-=", {"arithmetic", "+="}},
        {"*=", {"arithmetic", "/="}}, {"/=", {"arithmetic", "*="}}, {"<", {"relational", "<="}},
        {"<", {"relational", ">="}},  {"<=", {"relational", "<"}},  {"<=", {"relational", ">"}},
        {">", {"relational", ">="}},  {">", {"relational", "<="}},  {">=", {"relational", ">"}},
        {">=", {"relational", "<"}},  {"==", {"relational", "!="}}, {"!=", {"relational", "=="}},
        {"&&", {"logical", "||"}},    {"||", {"logical", "&&"}},
    };
    if (is_spaced()) {
      const auto [first, last] = changes.equal_range(at(0));
      for (auto change = first; change != last; ++change)
        replace_token(change->second.first, change->second.second);
    } else if (is_unary() && at(0) == "-") {
      replace_token("sign", "");
    } else if (is_unary() && at(0) == "!") {
      replace_token("logical", "");
    } else if (at(0) == "[" && !at(-1).empty() && (is_word(at(-1).back()) || at(-1) == ")") &&
               at(-1) != "auto" && at(-1) != "return" && at(1) != "]") {
      const std::size_t end = tokens_[closing(place_)].offset;
      note("index", end, end, " + 1");
    }
  }

  void change_constant() {
    const auto text = at(0);
    const bool hexadecimal = text.starts_with("0x");
    if (!hexadecimal && text.find_first_of(".eE") != std::string_view::npos) {
      const bool zero = text.find_first_not_of("0.eE") == std::string_view::npos;
      replace_token("constant", zero ? "1.0" : fmt::format("(2.0 * {})", text));
    } else if (!hexadecimal && std::ranges::all_of(text, is_digit)) {
      const long value = std::stol(std::string(text));
      replace_token("constant", std::to_string(value + 1));
      if (value > 0) replace_token("constant", std::to_string(value - 1));
    }
  }

  void change_word() {
    if (at(0) == "for" && at(1) == "(") end_of_head_ = closing(place_ + 1);
    if (at(0) == "if" && at(1) == "(") {
      const std::size_t open = tokens_[place_ + 1].offset, close = tokens_[closing(place_ + 1)].end();
      const std::size_t initialised = semicolon(place_ + 2);
      if (tokens_[initialised].offset > close)
        note("condition", open, close, fmt::format("(!{})", source_.substr(open, close - open)));
    }
    if (at(0) == "std" && at(1) == "::" && at(2) == "abs")
      note("sign", tokens_[place_].offset, tokens_[place_ + 2].end(), "");
  }

  [[nodiscard]] bool begins_statement() const {
    const auto before = at(-1);
    if (is_in_head_of_loop()) return false;
    if (before == ";" || before == "{" || before == "}" || before == "else") return true;
    if (before != ")") return false;
    // After the head of an if, for or while.
    int depth = 0;
    for (std::size_t i = place_ - 1;; --i) {
      if (tokens_[i].text == ")") ++depth;
      if (tokens_[i].text == "(" && --depth == 0)
        return i > 0 && (tokens_[i - 1].text == "if" || tokens_[i - 1].text == "for" ||
                         tokens_[i - 1].text == "while");
      if (i == 0) return false;
    }
  }

  // Between the brackets of a for.
  [[nodiscard]] bool is_in_head_of_loop() const { return place_ < end_of_head_; }

  void delete_statement() {
    constexpr std::array<std::string_view, 28> not_to_delete{
        "return", "using",  "const",   "auto",   "static",   "constexpr", "if",
        "for",    "while",  "else",    "case",   "default",  "namespace", "struct",
        "class",  "public", "private", "friend", "template", "typedef",   "throw",
        "enum",   "switch", "do",      "try",    "explicit", "inline",    "double"};
    const auto first = at(0), second = at(1);
    const bool declares = tokens_[place_].kind != Token::Kind::word ||
                          std::ranges::find(not_to_delete, first) != not_to_delete.end() ||
                          (!second.empty() && (is_word(second.front()) || second == "<")) || first == "int" ||
                          first == "bool";
    const bool returns_nothing = first == "return" && second == ";";
    if (declares && !returns_nothing && first != "++" && first != "--") return;
    const std::size_t end = semicolon(place_);
    // A brace on the way to the semicolon is the body of a function or an initialiser, and `= default` a
    // definition: no plain statements.
    // Memory reserved changes no result.
    for (std::size_t i = place_; i < end; ++i)
      if (tokens_[i].text == "{" || tokens_[i].text == "default" || tokens_[i].text == "reserve") return;
    note("deletion", tokens_[place_].offset, tokens_[end].offset, "");
  }

  std::string_view source_;
  std::vector<Token> tokens_;
  std::size_t place_{};
  std::size_t end_of_head_{};  // the place of the bracket that closes the last for
  std::vector<Mutation> mutations_;
};

std::string_view trimmed(std::string_view line) {
  const auto first = line.find_first_not_of(' ');
  if (first == std::string_view::npos) return "";
  return line.substr(first, line.find_last_not_of(' ') - first + 1);
}

// The lines that a passage touches, on one line.
std::string on_one_line(std::string_view text, std::size_t from, std::size_t to) {
  const std::size_t begin = from == 0 ? 0 : text.rfind('\n', from - 1) + 1;
  std::string_view lines = text.substr(begin, end_of_line(text, to) - begin);
  std::string joined;
  while (true) {
    const std::size_t end = end_of_line(lines, 0);
    joined += trimmed(lines.substr(0, end));
    if (end == lines.size()) return joined;
    joined += ' ';
    lines.remove_prefix(end + 1);
  }
}

}  // namespace

std::vector<Mutation> mutations_of(std::string_view source) { return Mutator(source).run(); }

std::vector<GeneratedMutant> generated_mutants(const fs::path& source_tree, std::uint64_t seed) {
  std::vector<GeneratedMutant> mutants;
  for (const char* component : {"solver", "analytic"}) {
    for (const auto& entry : fs::recursive_directory_iterator(source_tree / component)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
      const std::string file = entry.path().lexically_relative(source_tree).generic_string();
      const std::string source = report::read_text(entry.path());
      std::map<std::pair<std::string, std::string>, int> seen;
      for (const Mutation& mutation : mutations_of(source)) {
        GeneratedMutant mutant;
        mutant.file = file;
        mutant.kind = mutation.kind;
        mutant.text = source;
        mutant.text.replace(mutation.offset, mutation.original.size(), mutation.replacement);
        mutant.line =
            1 + static_cast<int>(std::count(
                    source.begin(), source.begin() + static_cast<std::ptrdiff_t>(mutation.offset), '\n'));
        mutant.was = on_one_line(source, mutation.offset, mutation.offset + mutation.original.size());
        mutant.is = on_one_line(mutant.text, mutation.offset, mutation.offset + mutation.replacement.size());
        const int before = seen[{mutant.was, mutant.is}]++;
        mutant.name = report::Fingerprint()
                          .add(std::to_string(seed))
                          .add(file)
                          .add(mutant.was)
                          .add(mutant.is)
                          .add(std::to_string(before))
                          .text();
        mutants.push_back(std::move(mutant));
      }
    }
  }
  std::ranges::sort(mutants, {}, &GeneratedMutant::name);
  return mutants;
}

}  // namespace stickslip::mutants
