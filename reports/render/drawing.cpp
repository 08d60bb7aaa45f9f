// SPDX-License-Identifier: MIT
#include "render/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string_view>
#include <system_error>

#include "render/external_tool.hpp"
#include "render/report.hpp"
#include "stickslip/data/atomic_file.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/data/input_text.hpp"

namespace stickslip::report {

namespace fs = std::filesystem;

namespace {

// Run after the script of a figure: its labels fit into their room, and the last panel has a size.
constexpr const char* refuse_misfit =
    "area(from, to, size) = (to - from) * GPVAL_TERM_SCALE / size; if (unfit || !exists('composed') && "
    "(area(GPVAL_TERM_XMIN, GPVAL_TERM_XMAX, GPVAL_TERM_XSIZE) < across(8) || "
    "area(GPVAL_TERM_YMIN, GPVAL_TERM_YMAX, GPVAL_TERM_YSIZE) < up(3.5))) { printerr 'too small' }";

// What does not fit into the size of the figure.
struct Misfit : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// gnuplot may report an error and yet leave a drawing behind, or say nothing and leave none.
void require_success(int status, const fs::path& drawing, const fs::path& log) {
  std::error_code error;
  const bool drawn = fs::exists(drawing, error) && fs::file_size(drawing, error) > 0;
  std::string words = data::read_text(log);
  // What it says of every film.
  if (words.ends_with(" frames in animation sequence\n") && std::ranges::count(words, '\n') == 1)
    words.clear();
  if (status == 0 && drawn && words.empty()) return;
  if (words.find("plot titles into key") != std::string::npos || words == "too small\n")
    throw Misfit(fmt::format("{} is too small for its labels", drawing.filename().string()));
  throw std::runtime_error(
      fmt::format("gnuplot could not draw {}: {}", drawing.filename().string(),
                  words.empty() ? fmt::format("it ended with status {} and said nothing", status) : words));
}

// A text of gnuplot as TeX: indices and exponents where it is `enhanced`, and the letters that TeX does not take as they are.
std::string tex_text(std::string_view text, bool enhanced) {
  static const std::vector<std::pair<std::string_view, std::string_view>> letters{
      {"%", "\\%"},       {"&", "\\&"},      {"#", "\\#"},       {"$", "\\$"},
      {"_", "\\_"},       {"{", "\\{"},      {"}", "\\}"},       {"\\", "\\textbackslash{}"},
      {"^", "\\^{}"},     {"~", "\\~{}"},    {"|", "$|$"},       {"<", "$<$"},
      {">", "$>$"},       {"−", "$-$"},      {"±", "$\\pm$"},    {"≤", "$\\leq$"},
      {"≥", "$\\geq$"},   {"·", "$\\cdot$"}, {"μ", "$\\mu$"},    {"ω", "$\\omega$"},
      {"Ω", "$\\Omega$"}, {"ζ", "$\\zeta$"}, {"α", "$\\alpha$"}, {"ρ", "$\\rho$"}};
  std::string tex;
  if (text.size() > 1 && text[0] == '-' && std::isdigit(static_cast<unsigned char>(text[1])) != 0) {
    tex = "$-$";
    text.remove_prefix(1);
  }
  while (!text.empty()) {
    if (enhanced && (text[0] == '_' || text[0] == '^') && text.size() > 1) {
      const bool group = text[1] == '{';
      const std::size_t end = group ? std::min(text.find('}'), text.size() - 1) : 1;
      tex += fmt::format("\\text{}script{{{}}}", text[0] == '_' ? "sub" : "super",
                         tex_text(group ? text.substr(2, end - 2) : text.substr(1, 1), true));
      text.remove_prefix(end + 1);
      continue;
    }
    const auto letter =
        std::ranges::find_if(letters, [&](const auto& of) { return text.starts_with(of.first); });
    tex += letter == letters.end() ? text.substr(0, 1) : letter->second;
    text.remove_prefix(letter == letters.end() ? 1 : letter->first.size());
  }
  return tex;
}

// gnuplot writes texts as they are, and when it wrote them.
void write_tex(const fs::path& drawing, const std::string& title) {
  std::istringstream lines(data::read_text(drawing));
  std::string text =
      "% A picture to be read by \\input. The preamble needs \\usepackage{gnuplot-lua-tikz}.\n";
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("%% ")) continue;
    const std::size_t begin = line.find(") {");
    if (line.starts_with("\\node[") && begin != std::string::npos && line.ends_with("};")) {
      const std::string words = line.substr(begin + 3, line.size() - begin - 5);
      line.replace(begin + 3, words.size(), tex_text(words, words != title));
    }
    text += line + "\n";
  }
  data::write_text(drawing, text);
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
  if (extension == ".pdf" || extension == ".png" || extension == ".svg" || extension == ".tex")
    return extension.substr(1);
  throw data::FieldError("--figure", fmt::format("'{}'", data::printable(figure)),
                         "a file whose name ends in .pdf, .png, .svg or .tex");
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

namespace {

std::vector<fs::path> try_to_draw(const std::string& script, const Look& look, const std::string& tables,
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
  if (!look.font.empty()) definitions += "; chosen_font=" + data::gnuplot_string(look.font);
  if (look.is_composed) definitions += "; composed=1";
  std::vector<std::string> arguments{"-d", "-e", definitions, script + ".gp"};
  if (look.size_cm || !look.font.empty()) arguments.insert(arguments.end(), {"-e", refuse_misfit});
  const int status = run_tool("gnuplot", arguments, folder, log);
  std::vector<fs::path> files;
  for (const std::string& drawing : drawings) {
    files.push_back(folder / drawing);
    require_success(status, files.back(), log);
    if (look.format == "tex") write_tex(files.back(), look.title);
    if (look.format == "pdf") remove_date(files.back());
  }
  return files;
}

}  // namespace

std::vector<fs::path> draw_in_scratch(const std::string& script, const Look& look, const std::string& tables,
                                      const std::vector<std::string>& drawings, OutputFolder& output) {
  try {
    return try_to_draw(script, look, tables, drawings, output);
  } catch (const Misfit&) {
    if (!look.size_cm && look.font.empty()) throw;
  }
  if (!look.size_cm)
    throw data::FieldError("--font", look.font,
                           "of smaller letters in this figure, unless --size makes it larger");
  const auto [width, height] = *look.size_cm;
  std::string allowed = "of another shape";
  Look larger = look;
  for (double wide = width + 0.5; wide <= 40.0; wide += 0.5) try {
      larger.size_cm = {wide, std::ceil(2.0 * height / width * wide) / 2.0};
      (void)try_to_draw(script, larger, tables, drawings, output);
      allowed = fmt::format("at least {}x{} for all labels of this figure", wide, larger.size_cm->second);
      break;
    } catch (const Misfit&) {
    }
  throw data::FieldError("--size", fmt::format("{}x{}", width, height), allowed);
}

std::string drawing_of(const std::string& script, const Look& look,
                       const std::map<std::string, std::string>& tables) {
  const data::TemporaryFolder folder;
  OutputFolder output(folder.path());
  for (const auto& [name, text] : tables) output.write(name, text);
  return data::read_text(
      draw_in_scratch(script, look, "../../", {script + "." + look.format}, output).front());
}

void draw(const std::string& name, Look look, OutputFolder& output) {
  std::vector<fs::path> drawn;
  look.is_composed = true;
  for (const std::string format : {"pdf", "png"}) {
    look.format = format;
    drawn.push_back(
        draw_in_scratch(name, look, "../../", {fmt::format("{}.{}", name, format)}, output).front());
  }
  for (const fs::path& file : drawn) output.publish(file);
}

}  // namespace stickslip::report
