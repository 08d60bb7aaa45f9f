// SPDX-License-Identifier: MIT
#include "render/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <system_error>

#include "render/external_tool.hpp"
#include "render/report.hpp"
#include "stickslip/data/atomic_file.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/data/input_text.hpp"

namespace stickslip::report {

namespace fs = std::filesystem;

namespace {

// gnuplot may report an error and yet leave a drawing behind, or say nothing and leave none.
void require_success(int status, const Look& look, const fs::path& drawing, const fs::path& log) {
  std::error_code error;
  const bool drawn = fs::exists(drawing, error) && fs::file_size(drawing, error) > 0;
  std::string words = data::read_text(log);
  // What it says of every film.
  if (words.ends_with(" frames in animation sequence\n") && std::ranges::count(words, '\n') == 1)
    words.clear();
  if (status == 0 && drawn && words.empty()) return;
  if (look.size_cm && words.find("plot titles into key") != std::string::npos)
    throw data::FieldError("--size", fmt::format("{}x{}", look.size_cm->first, look.size_cm->second),
                           "so large that the legend fits into the figure");
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

std::string figure_format(const std::string& figure) {
  const std::string extension = std::filesystem::path(figure).extension().string();
  if (extension == ".pdf" || extension == ".png" || extension == ".svg") return extension.substr(1);
  throw data::FieldError("--figure", fmt::format("'{}'", data::printable(figure)),
                         "a file whose name ends in .pdf, .png or .svg");
}

CsvTable values_table(const std::vector<FigureData::Value>& values) {
  CsvTable table("Single values of the figure", "name [-], value [see last column], unit [-]");
  for (const auto& [name, value, unit, text] : values) {
    if (text.find_first_of(",\"") != std::string::npos)  // where gnuplot would end it, quoted or not
      throw std::logic_error(fmt::format("the text {} has a comma or a quotation mark: {}", name, text));
    table.add_row({name, text.empty() ? csv_number(value) : text, unit});
  }
  return table;
}

std::vector<fs::path> draw_in_scratch(const std::string& script, const Look& look, const std::string& tables,
                                      const std::vector<std::string>& drawings, OutputFolder& output) {
  const fs::path folder = output.scratch() / "figures";
  if (!fs::exists(folder)) fs::copy(templates_directory() / "figures", folder);
  const fs::path log = folder / (drawings.front() + ".log");
  std::string definitions =
      fmt::format("folder={}; format={}; output={}; heading={}", data::gnuplot_string(tables),
                  data::gnuplot_string(look.format), data::gnuplot_string(drawings.front()),
                  data::gnuplot_string(look.title));
  if (look.size_cm)
    definitions +=
        fmt::format("; chosen_width={}; chosen_height={}", look.size_cm->first, look.size_cm->second);
  const int status = run_tool("gnuplot", {"-d", "-e", definitions, script + ".gp"}, folder, log);
  std::vector<fs::path> files;
  for (const std::string& drawing : drawings) {
    files.push_back(folder / drawing);
    require_success(status, look, files.back(), log);
    if (look.format == "pdf") remove_date(files.back());
  }
  return files;
}

std::string drawing_of(const std::string& script, const Look& look,
                       const std::map<std::string, std::string>& tables) {
  const data::TemporaryFolder folder;
  OutputFolder output(folder.path());
  for (const auto& [name, text] : tables) output.write(name, text);
  return data::read_text(
      draw_in_scratch(script, look, "../../", {script + "." + look.format}, output).front());
}

void draw(const std::string& name, OutputFolder& output) {
  std::vector<fs::path> drawn;
  for (const std::string format : {"pdf", "png"})
    drawn.push_back(
        draw_in_scratch(name, {.format = format}, "../../", {fmt::format("{}.{}", name, format)}, output)
            .front());
  for (const fs::path& file : drawn) output.publish(file);
}

}  // namespace stickslip::report
