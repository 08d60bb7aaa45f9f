#include "document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <initializer_list>
#include <stdexcept>
#include <string_view>

#include "external_tool.hpp"
#include "numbers.hpp"
#include "speed_tables.hpp"
#include "stickslip/report/latex_text.hpp"
#include "stickslip/report/report.hpp"
#include "stickslip/report/text_file.hpp"
#include "tables.hpp"

namespace stickslip::report {

namespace fs = std::filesystem;

namespace {

constexpr int most_runs = 4;

bool mentions(const fs::path& log, std::initializer_list<std::string_view> phrases) {
  const std::string text = read_text(log);
  return std::ranges::any_of(phrases,
                             [&](std::string_view phrase) { return text.find(phrase) != std::string::npos; });
}

// "Rerun to get cross-references right.", "Table widths have changed. Rerun LaTeX."
bool wants_another_run(const fs::path& log) { return mentions(log, {"Rerun to get", "Rerun LaTeX"}); }

// "! Undefined control sequence." and the line after it, which says where.
std::string first_error(const fs::path& log) {
  std::ifstream stream(log);
  std::string line, next;
  while (std::getline(stream, line)) {
    if (!line.starts_with("! ")) continue;
    std::getline(stream, next);
    return fmt::format("{} {}", line.substr(2), next);
  }
  return "its log names no error";
}

void run_pdflatex(const fs::path& folder) {
  const int status = run_tool("pdflatex", {"-halt-on-error", "-interaction=nonstopmode", "vv-report.tex"},
                              folder, folder / "pdflatex.out");
  if (status == 0) return;
  throw std::runtime_error(fmt::format("pdflatex could not typeset the report (status {}): {}", status,
                                       first_error(folder / "vv-report.log")));
}

}  // namespace

Document make_document(StudyResults& results, const Environment& environment,
                       const std::vector<TestResult>& tests) {
  Document document = make_tables(results, environment, tests, studies::input_matrix());
  document["numbers.tex"] = make_numbers(results, environment, tests);
  const benchmarks::SpeedRecord speed = benchmarks::read_speed_record();
  document["speed-processor.tex"] = escape(speed.processor);
  document["table-speed.tex"] = speed_rows(speed);
  document["table-load.tex"] = load_rows(speed);
  document["table-scale.tex"] = scale_rows(speed);
  return document;
}

void typeset_document(const Document& document, OutputFolder& output) {
  const fs::path folder = output.scratch() / "latex";
  fs::copy(templates_directory() / "latex", folder, fs::copy_options::recursive);
  for (const auto& [name, text] : document) write_text(folder / name, text);
  try {
    run_pdflatex(folder);
    for (int run = 2; run <= most_runs; ++run) {
      run_pdflatex(folder);
      if (!wants_another_run(folder / "vv-report.log")) break;
    }
  } catch (const ToolMissing& missing) {
    throw std::runtime_error(fmt::format("{}, so that there is no PDF report; the figures are in {}",
                                         missing.what(), output.folder().string()));
  }
  if (mentions(folder / "vv-report.log", {"undefined references", "multiply-defined labels"}))
    throw std::runtime_error(
        "the report refers to a figure, a table or a section that it does not have, or that stands twice");
  output.forget("vv-report");
  output.publish(folder / "vv-report.pdf");
}

}  // namespace stickslip::report
