// SPDX-License-Identifier: MIT
#include "render/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <system_error>

#include "render/external_tool.hpp"
#include "render/report.hpp"
#include "render/temporary_folder.hpp"
#include "stickslip/data/atomic_file.hpp"

namespace stickslip::report {

namespace fs = std::filesystem;

namespace {

// gnuplot may report an error and yet leave a drawing behind, or say nothing and leave none.
void require_success(int status, const fs::path& drawing, const fs::path& log) {
  std::error_code error;
  const bool drawn = fs::exists(drawing, error) && fs::file_size(drawing, error) > 0;
  const std::string words = data::read_text(log);
  if (status == 0 && drawn && words.empty()) return;
  throw std::runtime_error(
      fmt::format("gnuplot could not draw {}: {}", drawing.filename().string(),
                  words.empty() ? fmt::format("it ended with status {} and said nothing", status) : words));
}

// Blanks out when a PDF was made, in place, so that the same data make the same bytes.
void remove_date(const fs::path& pdf) {
  std::string bytes = data::read_text(pdf);
  const std::size_t begin = bytes.find("/CreationDate (");
  const std::size_t end = bytes.find(')', begin);
  if (begin == std::string::npos || end == std::string::npos) return;
  std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(begin), end + 1 - begin, ' ');
  data::write_text(pdf, bytes);
}

}  // namespace

CsvTable values_table(const std::vector<FigureData::Value>& values) {
  CsvTable table("Single values of the figure", {{"name", "-"}, {"value", "see last column"}, {"unit", "-"}});
  for (const auto& [name, value, unit] : values) {
    const auto* text = std::get_if<std::string>(&value);
    table.add_row({name, text != nullptr ? *text : csv_number(std::get<double>(value)), unit});
  }
  return table;
}

std::vector<fs::path> draw_in_scratch(const std::string& script, const std::string& format,
                                      const std::string& tables, const std::vector<std::string>& drawings,
                                      OutputFolder& output) {
  const fs::path folder = output.scratch() / "figures";
  if (!fs::exists(folder)) fs::copy(templates_directory() / "figures", folder);
  const fs::path log = folder / (drawings.front() + ".log");
  const std::string definitions =
      fmt::format("folder='{}'; format='{}'; output='{}'", tables, format, drawings.front());
  const int status = run_tool("gnuplot", {"-e", definitions, script + ".gp"}, folder, log);
  std::vector<fs::path> files;
  for (const std::string& drawing : drawings) {
    files.push_back(folder / drawing);
    require_success(status, files.back(), log);
    if (format == "pdf") remove_date(files.back());
  }
  return files;
}

std::string drawing_of(const std::string& script, const std::string& format,
                       const std::map<std::string, std::string>& tables) {
  const TemporaryFolder folder;
  OutputFolder output(folder.path());
  for (const auto& [name, text] : tables) output.write(name, text);
  return data::read_text(draw_in_scratch(script, format, "../../", {script + "." + format}, output).front());
}

void draw(const std::string& name, OutputFolder& output) {
  std::vector<fs::path> drawn;
  for (const std::string format : {"pdf", "png"})
    drawn.push_back(
        draw_in_scratch(name, format, "../../", {fmt::format("{}.{}", name, format)}, output).front());
  for (const fs::path& file : drawn) output.publish(file);
}

}  // namespace stickslip::report
