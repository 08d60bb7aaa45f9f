#include "stickslip/report/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>

#include "document.hpp"
#include "drawing.hpp"
#include "external_tool.hpp"
#include "figures.hpp"
#include "progress.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/report/output_folder.hpp"
#include "study_results.hpp"

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

void write_tables(const Figure& figure, const FigureData& data, OutputFolder& output) {
  for (const auto& [name, table] : data.tables) output.write(name + ".csv", table.text());
  if (!data.values.empty()) output.write(figure.name + "-values.csv", values_table(data.values).text());
}

void draw_all(const std::vector<Figure>& figures, const Progress& progress, OutputFolder& output) {
  try {
    for (const Figure& figure : figures) {
      progress(fmt::format("drawing {}", figure.name));
      draw(figure.name, output);
    }
  } catch (const ToolMissing& missing) {
    throw std::runtime_error(fmt::format("{}, so that no figure is drawn; their data are in {}/*.csv",
                                         missing.what(), output.folder().string()));
  }
}

}  // namespace

void write_report(const ReportOptions& options) {
  const std::vector<Figure> chosen = chosen_figures(options.only);
  (void)templates_directory();  // refused now rather than after the studies
  OutputFolder output(options.output);
  const Progress progress("report", options.quiet);
  StudyResults results(progress);

  for (const Figure& figure : chosen) write_tables(figure, figure.data(results), output);
  draw_all(chosen, progress, output);
  if (!options.only.empty()) return;

  const Document document = make_document(results, options, output.scratch());
  progress("typesetting vv-report.pdf");
  typeset_document(document, output);
}

std::vector<std::string> figure_names() {
  std::vector<std::string> names;
  for (const Figure& figure : all_figures()) names.push_back(figure.name);
  return names;
}

std::filesystem::path templates_directory() {
  const char* directory = std::getenv("STICKSLIP_REPORTS");
  std::filesystem::path chosen =
      directory != nullptr && *directory != '\0' ? directory : STICKSLIP_REPORTS_DIRECTORY;
  if (!std::filesystem::is_directory(chosen / "figures") || !std::filesystem::is_directory(chosen / "latex"))
    throw data::InputError(fmt::format(
        "the folder of the report's templates (STICKSLIP_REPORTS) is {}, but must hold the folders "
        "figures and latex",
        chosen.string()));
  return chosen;
}

}  // namespace stickslip::report
