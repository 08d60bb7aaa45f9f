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

std::vector<fs::path> draw_in_scratch(const std::string& script, const std::string& format, const std::string& tables,
                                      const std::vector<std::string>& drawings, OutputFolder& output) {
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
  }
  return files;
}

void draw(const std::string& name, OutputFolder& output) {
  for (const std::string format : {"pdf", "png"})
    for (const fs::path& file :
         draw_in_scratch(name, format, "../../", {fmt::format("{}.{}", name, format)}, output))
      output.publish(file);
}

}  // namespace stickslip::report
