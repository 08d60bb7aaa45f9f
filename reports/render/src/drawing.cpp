#include "drawing.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "external_tool.hpp"
#include "stickslip/report/report.hpp"

namespace stickslip::report {

namespace fs = std::filesystem;

namespace {

std::string contents_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string definitions(const FigureData& data, const std::string& folder, const std::string& format,
                        const std::string& drawing) {
  std::string text = fmt::format("folder='{}'; format='{}'; output='{}'", folder, format, drawing);
  for (const auto& [name, value] : data.variables) text += fmt::format("; {}={}", name, value);
  return text;
}

// gnuplot may report an error and yet leave a drawing behind, or say nothing and leave none.
void require_success(int status, const fs::path& drawing, const fs::path& log) {
  std::error_code error;
  const bool drawn = fs::exists(drawing, error) && fs::file_size(drawing, error) > 0;
  const std::string words = contents_of(log);
  if (status == 0 && drawn && words.empty()) return;
  throw std::runtime_error(
      fmt::format("gnuplot could not draw {}: {}", drawing.filename().string(),
                  words.empty() ? fmt::format("it ended with status {} and said nothing", status) : words));
}

}  // namespace

void write_tables(const FigureData& data, OutputFolder& output) {
  for (const auto& [name, table] : data.tables) output.write(name + ".csv", table.text());
}

std::vector<fs::path> draw_in_scratch(const std::string& script, const FigureData& data,
                                      const std::string& format, const std::string& tables,
                                      const std::vector<std::string>& drawings, OutputFolder& output) {
  const fs::path folder = output.scratch() / "figures";
  if (!fs::exists(folder)) fs::copy(templates_directory() / "figures", folder);
  const fs::path log = folder / (drawings.front() + ".log");
  const int status = run_tool(
      "gnuplot", {"-e", definitions(data, tables, format, drawings.front()), script + ".gp"}, folder, log);
  std::vector<fs::path> files;
  for (const std::string& drawing : drawings) {
    files.push_back(folder / drawing);
    require_success(status, files.back(), log);
  }
  return files;
}

void draw(const std::string& name, const FigureData& data, OutputFolder& output) {
  for (const std::string format : {"pdf", "png"})
    for (const fs::path& file :
         draw_in_scratch(name, data, format, "../../", {fmt::format("{}.{}", name, format)}, output))
      output.publish(file);
}

}  // namespace stickslip::report
