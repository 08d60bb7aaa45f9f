// SPDX-License-Identifier: MIT
#include "render/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>

#include "render/document.hpp"
#include "render/drawing.hpp"
#include "render/external_tool.hpp"
#include "render/interruption.hpp"
#include "render/output_folder.hpp"
#include "render/progress.hpp"
#include "render/studies.hpp"
#include "render/study_table.hpp"
#include "stickslip/data/atomic_file.hpp"
#include "stickslip/data/case_file.hpp"

namespace stickslip::report {

namespace {

// The figures asked for, in the order of the report.
std::vector<Figure> chosen_figures(std::vector<std::string> only) {
  const std::vector<std::string> known = figure_names();
  for (std::string& name : only) {
    if (name == "fig6" || name == "fig11") name = "limits";  // the critical amplitude over frequency
    if (name == "fig8")
      throw data::InputError(
          "--only names the figure 'fig8', the static shape, which is not drawn; `stickslip reference export "
          "static-shapes` has it");
    if (std::ranges::find(known, name) == known.end())
      throw data::InputError(fmt::format("--only names the figure '{}', but must name some of {}", name,
                                         fmt::join(known, ", ")));
  }
  std::vector<Figure> chosen;
  for (const Figure& figure : all_figures())
    if (only.empty() || std::ranges::find(only, figure.name) != only.end()) chosen.push_back(figure);
  return chosen;
}

// The steps of a report are the data of each figure (of the whole report all studies), its drawing, and the document.
double share_done(std::size_t figures, std::size_t steps) {
  return static_cast<double>(steps) / static_cast<double>(2 * figures + 1);
}

void write_tables(const std::string& figure, FigureData data, OutputFolder& output) {
  if (!data.values.empty()) data.tables.push_back({figure + "-values", values_table(data.values)});
  for (const auto& [name, table] : data.tables) output.write(name + ".csv", table.text());
}

void draw_all(const std::vector<Figure>& figures, const Look& look, Progress& progress,
              OutputFolder& output) {
  try {
    for (std::size_t i = 0; i < figures.size(); ++i) {
      progress(share_done(figures.size(), figures.size() + i));
      progress.stage(fmt::format("drawing {}", figures[i].name));
      draw(figures[i].name, look, output);
    }
  } catch (const ToolMissing& missing) {
    throw std::runtime_error(fmt::format("{}, so that no figure is drawn; their data are in {}/*.csv",
                                         missing.what(), output.folder().string()));
  }
}

// The commit that a run of the tests has noted in its folder; empty if there is none.
std::string tested_commit(const std::filesystem::path& tests) {
  const std::string text = tests.empty() ? "" : data::read_text(tests / "commit");
  return text.substr(0, text.find('\n'));
}

}  // namespace

std::vector<std::string> write_report(const ReportOptions& options) {
  const std::vector<Figure> chosen = chosen_figures(options.only);
  (void)templates_directory();  // refused now rather than after the studies
  const std::string tests = options.tests.empty() ? "[]\n" : read_test_results(options.tests);
  OutputFolder output(options.output);
  const std::filesystem::path values = output.folder() / "studies", site = output.folder() / "site";
  if (options.only.empty() && std::filesystem::exists(site) &&
      !std::filesystem::exists(site / "verdicts.html"))
    throw data::InputError(
        fmt::format("{} is not of a report; remove it or name another --output", site.string()));
  Progress progress("stickslip report", Progress::standard_error(options.quiet));
  const Interruption interruption([&] {
    progress.finish();
    output.clear_scratch();
    return fmt::format("interrupted after {:.0f} % of the report; what is finished is in {}",
                       100.0 * progress.share(), output.folder().string());
  });
  Results results([&](const std::string& what) { progress.stage(what); }, values, options.overrides,
                  options.commit);

  const bool whole = options.only.empty();
  if (whole)
    results.run_all([&](double share) { progress(share * share_done(chosen.size(), chosen.size())); });
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (!whole) progress(share_done(chosen.size(), i));
    write_tables(chosen[i].name, chosen[i].data(results), output);
  }
  draw_all(chosen, options.look, progress, output);
  std::vector<std::string> drawn;
  for (const Figure& figure : chosen) drawn.push_back(figure.name);
  if (!whole) return drawn;

  data::write_text(values / "tests.json", tests);
  data::write_text(values / "tested_commit.json", json_text(tested_commit(options.tests)));
  data::write_text(values / "environment.json", environment_json(options, output.scratch()));
  progress.stage("typesetting vv-report.pdf");
  typeset(fill_in_templates(values, output), output);
  progress.stage("writing the pages of evidence");
  write_site(values, output);
  return drawn;
}

std::vector<std::string> figure_names() {
  std::vector<std::string> names;
  for (const Figure& figure : all_figures()) names.push_back(figure.name);
  return names;
}

std::filesystem::path templates_directory() {
  std::filesystem::path chosen =
      data::installed_folder("STICKSLIP_REPORTS", "reports", STICKSLIP_REPORTS_DIRECTORY);
  for (const char* folder : {"figures", "report", "site"})
    if (!std::filesystem::is_directory(chosen / folder))
      throw data::InputError(fmt::format(
          "the folder of the report's templates (STICKSLIP_REPORTS) is {}, but must hold the folders "
          "figures, report and site",
          chosen.string()));
  return chosen;
}

}  // namespace stickslip::report
