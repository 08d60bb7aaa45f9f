#include "paper_index.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cctype>
#include <cstddef>

#include "latex_table.hpp"

namespace stickslip::report {

namespace {

// Labels of the figures that repeat those of the paper.
constexpr std::array<const char*, paper_figures> own_figures{
    "model",       "friction",  "motions", "tip-small", "tip-large",      "search",         "modes",
    "coordinates", "histories", "surface", "criterion", "classification", "half-stiffness", "length-force"};

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

// Takes "(12)" or "4b" off the front; 0 if there is no number.
int take_number(std::string_view& text) {
  std::string_view rest = text;
  if (rest.starts_with('(')) rest.remove_prefix(1);
  int number = 0;
  for (; !rest.empty() && is_digit(rest.front()); rest.remove_prefix(1))
    number = 10 * number + (rest.front() - '0');
  if (number == 0) return 0;
  while (!rest.empty() && std::islower(static_cast<unsigned char>(rest.front())) != 0) rest.remove_prefix(1);
  if (rest.starts_with(')')) rest.remove_prefix(1);
  text = rest;
  return number;
}

// The numbers at the front, joined by commas, "and" and "to".
void take_list(std::string_view text, std::set<int>& numbers) {
  int last = take_number(text);
  if (last == 0) return;
  numbers.insert(last);
  for (bool goes_on = true; goes_on;) {
    goes_on = false;
    for (const std::string_view joint : {", ", " and ", " to "}) {
      if (!text.starts_with(joint)) continue;
      std::string_view after = text.substr(joint.size());
      const int next = take_number(after);
      if (next == 0) return;
      for (int number = joint == " to " ? last : next; number <= next; ++number) numbers.insert(number);
      last = next;
      text = after;
      goes_on = true;
      break;
    }
  }
}

struct Item {
  std::set<std::string> requirements;
  std::size_t tests{};
  std::array<int, 3> claims{};  ///< by verdict
};

Item item_of(std::string_view kind, int number, const std::vector<TestResult>& tests,
             const std::vector<data::Claim>& claims) {
  Item item;
  for (const TestResult& test : tests)
    if (numbers_named(test.source, kind).contains(number)) {
      item.requirements.insert(test.requirement);
      ++item.tests;
    }
  for (const data::Claim& claim : claims)
    if (numbers_named(claim.place, kind).contains(number))
      ++item.claims[static_cast<std::size_t>(claim.verdict)];
  return item;
}

std::string claims_text(const Item& item) {
  constexpr std::array words{"hold", "with correction", "\\textbf{not}"};
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < words.size(); ++i)
    if (item.claims[i] > 0) parts.push_back(fmt::format("{} {}", item.claims[i], words[i]));
  return parts.empty() ? "--" : fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

std::set<int> numbers_named(std::string_view text, std::string_view kind) {
  std::set<int> numbers;
  for (std::size_t at = text.find(kind); at != std::string_view::npos; at = text.find(kind, at + 1)) {
    std::string_view rest = text.substr(at + kind.size());
    if (rest.starts_with('s')) rest.remove_prefix(1);
    if (!rest.starts_with(". ")) continue;
    take_list(rest.substr(2), numbers);
  }
  return numbers;
}

std::string paper_index_rows(const std::vector<TestResult>& tests, const std::vector<data::Claim>& claims) {
  Rows rows;
  const auto add = [&](std::string_view kind, int number, const std::string& name,
                       const std::string& figure) {
    const Item item = item_of(kind, number, tests, claims);
    rows.add({name, item.requirements.empty() ? "--" : fmt::format("{}", fmt::join(item.requirements, ", ")),
              std::to_string(item.tests), claims_text(item), figure});
  };
  for (int number = 1; number <= paper_equations; ++number)
    add("Eq", number, fmt::format("Eq.~({})", number), "");
  rows.space();
  for (int number = 1; number <= paper_figures; ++number)
    add("Fig", number, fmt::format("Fig.~{}", number),
        fmt::format("Fig.~\\ref{{fig:{}}}", own_figures[static_cast<std::size_t>(number - 1)]));
  return rows.text();
}

}  // namespace stickslip::report
