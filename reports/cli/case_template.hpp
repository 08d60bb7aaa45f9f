// SPDX-License-Identifier: MIT
#pragma once

/// The text of a new case file.

#include <string>
#include <vector>

#include "stickslip/data/case_file.hpp"

namespace stickslip::cli {

/// A line of the new case. The value is as in the file, but without the quotes.
struct CaseLine {
  std::string table, key, value, comment;
  bool is_asked{true};  ///< and not set by --set

  [[nodiscard]] std::string path() const { return table + "." + key; }
};

/// The steel blade of the tutorial.
[[nodiscard]] std::vector<CaseLine> steel_blade();

/// A mass on a spring and a damper.
[[nodiscard]] std::vector<CaseLine> one_mass();

/// A structure in files that the user has.
[[nodiscard]] std::vector<CaseLine> matrices();

/// Without the sides that a section of this shape does not have, unless --set gives them: the reader refuses those.
[[nodiscard]] std::vector<CaseLine> for_shape(std::vector<CaseLine> lines);

/// Replaces the value of a line, or what the key may stand in place of.
void set(std::vector<CaseLine>& lines, const data::Override& override);

/// The file with its comments; `file` is its name.
[[nodiscard]] std::string template_text(const std::vector<CaseLine>& lines, const std::string& file);

}  // namespace stickslip::cli
