#include "figure_format.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "input_text.hpp"
#include "stickslip/data/case_file.hpp"

namespace stickslip::cli {

std::string figure_format(const std::string& figure) {
  const std::string extension = std::filesystem::path(figure).extension().string();
  if (extension == ".pdf" || extension == ".png" || extension == ".svg") return extension.substr(1);
  throw data::InputError(
      fmt::format("--figure is '{}', but must end in .pdf, .png or .svg", data::printable(figure)));
}

}  // namespace stickslip::cli
