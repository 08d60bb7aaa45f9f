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

std::string definitions(const FigureData& data, const std::string& format, const std::string& drawing) {
  std::string text = fmt::format("folder='../../'; format='{}'; output='{}'", format, drawing);
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

void draw(const std::string& name, const FigureData& data, OutputFolder& output) {
  const fs::path folder = output.scratch() / "figures";
  if (!fs::exists(folder)) fs::copy(templates_directory() / "figures", folder);
  for (const std::string format : {"pdf", "png"}) {
    const std::string drawing = fmt::format("{}.{}", name, format);
    const fs::path log = folder / (drawing + ".log");
    const int status =
        run_tool("gnuplot", {"-e", definitions(data, format, drawing), name + ".gp"}, folder, log);
    require_success(status, folder / drawing, log);
    output.publish(folder / drawing);
  }
}

}  // namespace stickslip::report
