#include "stickslip/report/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>

#include "document.hpp"
#include "drawing.hpp"
#include "environment.hpp"
#include "external_tool.hpp"
#include "figures.hpp"
#include "fingerprint.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/data/installation.hpp"
#include "stickslip/report/interruption.hpp"
#include "stickslip/report/output_folder.hpp"
#include "stickslip/report/progress.hpp"
#include "study_code.hpp"
#include "study_results.hpp"
#include "test_results.hpp"

namespace stickslip::report {

namespace {

// The figures asked for, in the order of the report.
std::vector<Figure> chosen_figures(const std::vector<std::string>& only) {
  const std::vector<std::string> known = figure_names();
  for (const std::string& name : only)
    if (std::ranges::find(known, name) == known.end())
      throw data::InputError(fmt::format("--only names the figure '{}', but must name some of {}", name,
                                         fmt::join(known, ", ")));
  std::vector<Figure> chosen;
  for (const Figure& figure : all_figures())
    if (only.empty() || std::ranges::find(only, figure.name) != only.end()) chosen.push_back(figure);
  return chosen;
}

// The steps of a report are the data of each figure, its drawing, and the document.
double share_done(std::size_t figures, std::size_t steps) {
  return static_cast<double>(steps) / static_cast<double>(2 * figures + 1);
}

// A figure whose tables are in the output folder.
struct TabledFigure {
  std::string name;
  std::string fingerprint;
};

TabledFigure write_tables(const std::string& figure, FigureData data, OutputFolder& output) {
  if (!data.values.empty()) data.tables.push_back({figure + "-values", values_table(data.values)});
  std::vector<std::string> files;
  for (const auto& [name, table] : data.tables) {
    files.push_back(name + ".csv");
    output.write(files.back(), table.text());
  }
  return {figure, fingerprint_of(figure, files, output)};
}

void draw_all(const std::vector<TabledFigure>& figures, Progress& progress, OutputFolder& output) {
  try {
    for (std::size_t i = 0; i < figures.size(); ++i) {
      progress(share_done(figures.size(), figures.size() + i));
      const auto& [name, fingerprint] = figures[i];
      if (output.is_current(name, {name + ".pdf", name + ".png"}, fingerprint)) continue;
      progress.stage(fmt::format("drawing {}", name));
      draw(name, output);
      output.record(name, fingerprint);
    }
  } catch (const ToolMissing& missing) {
    throw std::runtime_error(fmt::format("{}, so that no figure is drawn; their data are in {}/*.csv",
                                         missing.what(), output.folder().string()));
  }
}

// The results of the last report serve again while the code of the studies and the data that they read stand.
StudyStore study_store(const OutputFolder& output) {
  Fingerprint fingerprint;
  fingerprint.add(study_code)
      .add_folder(data::data_directory() / "cases")
      .add_file(data::data_directory() / "paper" / "printed-numbers.toml");
  return {output.folder() / ".studies", fingerprint.text()};
}

// What the PDF is made from, its date apart: a report of which nothing has changed keeps the old one.
std::string fingerprint_of(const Document& document, const Environment& environment,
                           const std::vector<TabledFigure>& figures) {
  Fingerprint fingerprint;
  fingerprint.add_folder(templates_directory() / "latex");
  for (const auto& [name, text] : document) {
    const std::size_t date = text.find(environment.date);
    fingerprint.add(name).add(
        date == std::string::npos ? text : std::string(text).erase(date, environment.date.size()));
  }
  for (const TabledFigure& figure : figures) fingerprint.add(figure.name).add(figure.fingerprint);
  return fingerprint.text();
}

}  // namespace

void write_report(const ReportOptions& options) {
  const std::vector<Figure> chosen = chosen_figures(options.only);
  (void)templates_directory();  // refused now rather than after the studies
  const std::vector<TestResult> tests =
      options.tests.empty() ? std::vector<TestResult>{} : read_test_results(options.tests);
  OutputFolder output(options.output);
  Progress progress("stickslip report", Progress::standard_error(options.quiet));
  const Interruption interruption([&] {
    progress.finish();
    output.clear_scratch();
    return fmt::format("interrupted after {:.0f} % of the report; what the studies have found is kept in {}",
                       100.0 * progress.share(), (output.folder() / ".studies").string());
  });
  StudyResults results([&](const std::string& what) { progress.stage(what); }, study_store(output));

  std::vector<TabledFigure> figures;
  for (const Figure& figure : chosen) {
    progress(share_done(chosen.size(), figures.size()));
    figures.push_back(write_tables(figure.name, figure.data(results), output));
  }
  draw_all(figures, progress, output);
  if (!options.only.empty()) return;

  const Environment environment = describe_environment(options, output.scratch());
  const Document document = make_document(results, environment, tests);
  const std::string fingerprint = fingerprint_of(document, environment, figures);
  if (output.is_current("vv-report", {"vv-report.pdf"}, fingerprint)) return;
  progress.stage("typesetting vv-report.pdf");
  typeset_document(document, output);
  output.record("vv-report", fingerprint);
}

std::vector<std::string> figure_names() {
  std::vector<std::string> names;
  for (const Figure& figure : all_figures()) names.push_back(figure.name);
  return names;
}

std::filesystem::path templates_directory() {
  std::filesystem::path chosen =
      data::installed_folder("STICKSLIP_REPORTS", "reports", STICKSLIP_REPORTS_DIRECTORY);
  if (!std::filesystem::is_directory(chosen / "figures") || !std::filesystem::is_directory(chosen / "latex"))
    throw data::InputError(fmt::format(
        "the folder of the report's templates (STICKSLIP_REPORTS) is {}, but must hold the folders "
        "figures and latex",
        chosen.string()));
  return chosen;
}

}  // namespace stickslip::report
