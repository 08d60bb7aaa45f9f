// SPDX-License-Identifier: MIT
#pragma once

/// What the report draws and quotes: each study, run on the paper's case with the settings chosen in studies.cpp, and each
/// figure. A study is run on first use, on whatever thread asks for it.

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "render/drawing.hpp"
#include "stickslip/data/case_file.hpp"
#include "validation/study.hpp"

namespace stickslip::report {

template <typename Result>
class Study;

class Results {
 public:
  /// `announce` is told what starts, before each study; `folder` receives each result as <name>.json.
  /// The overrides apply to each case. The text draws the rows of the claimed domain that are computed again.
  Results(std::function<void(const std::string&)> announce, std::filesystem::path folder,
          const std::vector<data::Override>& overrides = {}, std::string text = {});

  template <typename Result>
  const Result& operator()(const Study<Result>& study);

  /// Runs every study that has not run, thread_count() of them at a time, each on one thread. `progress` receives the
  /// fraction of studies that are done, 0 to 1.
  void run_all(const std::function<void(double)>& progress);

  const std::string drawn_by;
  const data::Case paper, damped, half_stiffness, flat_section;

 private:
  struct Kept {
    std::mutex guard;
    std::shared_ptr<const void> result;
  };
  std::function<void(const std::string&)> announce_;
  std::filesystem::path folder_;
  std::vector<Kept> results_;  // by the number of the study
};

/// The table of validation.gp.
[[nodiscard]] CsvTable comparison_table(const std::vector<validation::Comparison>& comparisons);

/// A figure: its name is that of figures/<name>.gp.
struct Figure {
  std::string name;
  FigureData (*data)(Results&);
};

[[nodiscard]] const std::vector<Figure>& all_figures();

}  // namespace stickslip::report
