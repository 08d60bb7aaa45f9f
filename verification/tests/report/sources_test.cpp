// SPDX-License-Identifier: MIT
/// The LaTeX sources hold no result: every number of a text, a table or a caption comes from a study.

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "render/report.hpp"
#include "stickslip/data/atomic_file.hpp"
#include "support/requirements.hpp"

namespace stickslip {
namespace {

namespace fs = std::filesystem;

std::string without(const std::string& text, const std::string& pattern) {
  return std::regex_replace(text, std::regex(pattern), " ");
}

// Comments, the preamble, and what is layout or a pointer and not a statement.
std::string prose_of(std::string text) {
  if (const std::size_t begin = text.find("\\begin{document}"); begin != std::string::npos)
    text.erase(0, begin);
  if (const std::size_t list = text.find("\\begin{thebibliography}"); list != std::string::npos)
    text.erase(list);
  for (const char* pattern :
       {"<#[^]*?#>", "<%[^]*?%>", "<<[^]*?>>",  // of templates
        "(^|[^\\\\])%[^\n]*",                   // comments
        "\\\\(label|ref|cite|input|includegraphics|begin|end|addcontentsline|texttt)(\\[[^\\]]*\\])"
        "?\\{[^{}]*\\}",
        "\\\\drawing(\\[[^\\]]*\\])?\\{[^{}]*\\}\\{[^{}]*\\}",  // its text says what is drawn
        "\\[[^\\]\n]*(textwidth|linewidth|cm|ex|t)\\]", "\\\\(setlength|addtolength)\\{[^{}]*\\}\\{[^{}]*\\}",
        "\\\\(hspace|vspace)\\*?\\{[^{}]*\\}", "\\\\cmidrule(\\([lr]*(\\{[^{}]*\\})?\\))?\\{[0-9-]*\\}",
        "\\\\multicolumn\\{[0-9]\\}\\{[^{}]*(\\{[^{}]*\\}[^{}]*)*\\}", "\\\\\\\\\\[[^\\]]*\\]",
        "[LRp]\\{[0-9.]+cm\\}", "\\\\tag\\{[^{}]*\\}",
        "(Eqs?|Figs?|Sects?)\\.[~ \n]*\\(?[0-9][0-9, ~\n()]*((and|to)[~ \n]*\\(?[0-9]+\\)?)?",  // of the
                                                                                                // paper
        "[Ee]rrat(um|a)[~ ]E[0-9]+", "\\((19|20)[0-9][0-9]\\)",
        "(Roache|Hulbert|Dynamics),? (19|20)[0-9][0-9]", "(V\\\\&V |NASA-STD-)[0-9]+"})
    text = without(text, pattern);
  return text;
}

// Digits that a sentence states: decimals, powers of ten, whatever has a unit or a per cent sign, and every
// number outside mathematics. Whole numbers of a formula, exponents and factors, are theory.
std::vector<std::string> results_in(const std::string& source) {
  std::string text = prose_of(source);
  std::vector<std::string> found;
  const auto collect = [&](const std::string& pattern) {
    const std::regex expression(pattern);
    for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match)
      found.push_back(match->str());
  };
  collect("[0-9]+\\.[0-9]+");
  collect("10\\s*\\^\\s*\\{?-?[0-9]+");
  collect("[0-9]\\s*(\\\\unit\\{|\\\\,\\\\?%|\\\\,(Hz|mm|m|s|ms|N)\\b|~?\\\\%|\\s(Hz|mm|ms|N|per cent)\\b)");
  text = without(text, "\\$[^$]*\\$");
  collect("(^|[^A-Za-z0-9{^_\\\\])[0-9]+");
  return found;
}

// Displayed formulas as inline ones.
std::string with_inline_formulas(const std::string& source) {
  return std::regex_replace(
      source,
      std::regex("\\\\begin\\{(equation|align|gather)\\*?\\}([^]*?)\\\\end\\{(equation|align|gather)\\*?\\}"),
      "$$$2$$");
}

class ReportSources : public ::testing::TestWithParam<fs::path> {};

STICKSLIP_VERIFIES(ReportSources, "U5");
TEST_P(ReportSources, HoldNoLiteralResult) {
  const std::string source = with_inline_formulas(data::read_text(GetParam()));
  ASSERT_FALSE(source.empty());
  for (const std::string& result : results_in(source))
    ADD_FAILURE() << GetParam().filename() << " holds " << result;
}

std::vector<fs::path> latex_sources() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(report::templates_directory() / "report"))
    if (entry.path().extension() == ".tex") files.push_back(entry.path());
  return files;
}

INSTANTIATE_TEST_SUITE_P(Latex, ReportSources, ::testing::ValuesIn(latex_sources()),
                         [](const auto& instance) {
                           return std::regex_replace(instance.param.stem().string(), std::regex("-"), "_");
                         });

STICKSLIP_VERIFIES(ReportFigureScripts, "U5");
// Labels and titles of figures: a number with a unit, or of something counted, is a result.
TEST(ReportFigureScripts, HoldNoLiteralResult) {
  const std::regex label(
      "'[^']*[0-9][  ]*(Hz|mm|ms|EI|N|elements|modes|points)\\b[^']*'|\"[^\"]*[0-9][  "
      "]*(Hz|mm|ms|EI|N|elements|modes|points)\\b[^\"]*\"");
  int scripts = 0;
  for (const auto& entry : fs::directory_iterator(report::templates_directory() / "figures")) {
    if (entry.path().extension() != ".gp") continue;
    ++scripts;
    const std::string text = without(data::read_text(entry.path()), "#[^\n']*\n");
    for (std::sregex_iterator match(text.begin(), text.end(), label), end; match != end; ++match)
      ADD_FAILURE() << entry.path().filename() << " holds " << match->str();
  }
  EXPECT_GT(scripts, 20);
}

// All text of figures is legible as printed because style.gp sets its size, and nothing else does.
TEST(ReportFigureScripts, LeaveTheSizeOfTextToTheStyle) {
  for (const auto& entry : fs::directory_iterator(report::templates_directory() / "figures")) {
    if (entry.path().extension() != ".gp" || entry.path().filename() == "style.gp") continue;
    const std::string text = without(data::read_text(entry.path()), "#[^\n']*\n");
    EXPECT_FALSE(std::regex_search(text, std::regex("\\bfont|\\{/"))) << entry.path().filename();
  }
}

STICKSLIP_VERIFIES(LiteralResults, "U5");
TEST(LiteralResults, AreFoundWhereverTheyStand) {
  for (const std::string text : {"The first frequency is 25 Hz.", "at $A_0 = 1\\unit{mm}$",
                                 "within 2\\,\\% of", "about $20.19\\,EI/L^2$", "an error of $10^{-12}$",
                                 "\\caption{15, 35 and 70}", "of 480 points", "at 25\\,Hz", "order 3.99"})
    EXPECT_FALSE(results_in(text).empty()) << text;
}

TEST(LiteralResults, AreNotWhatTheoryThePaperOrTheLayoutHave) {
  for (const std::string text :
       {"$(\\beta\\ell)^4/720$ and $f \\propto n^{-4}$",
        "Eqs.~(29) and (30), Fig.~12, the paper's Figs.~4 and 5", "Chung and Hulbert (1993)", "erratum E6",
        "\\begin{tabular}{@{}L{4.2cm}R{3cm}@{}}", "\\includegraphics[width=.85\\textwidth]{fig8}",
        "\\cmidrule(lr){3-4}\\cmidrule(l){6-7}", "\\multicolumn{2}{c}{Modes}",
        "at << stick.frequency_hz | fixed(2) >>\\unit{Hz} % by 15 Hz", "\\vspace{1.6cm}", "\\\\[4.5ex]"})
    EXPECT_TRUE(results_in(text).empty()) << text << ": " << results_in(text).front();
}

}  // namespace
}  // namespace stickslip
