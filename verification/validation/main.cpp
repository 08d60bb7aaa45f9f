// SPDX-License-Identifier: MIT
/// Makes the tables of data/measurements from the raw records:
///
///     stickslip_validation_tables figures FOLDER [calibration]    figures.csv, of all records or of those of calibration
///     stickslip_validation_tables predictions                     the rows of predictions.csv

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string>
#include <string_view>

#include "validation/study.hpp"

namespace {

using namespace stickslip::validation;

void print_figures(const std::string& folder, bool only_calibration) {
  fmt::print("record,quantity,value,uncertainty,count\n");
  for (const SetPoint& point : set_points())
    for (const auto& [quantity, figure] : read_raw(point, folder)) {
      // The amplitude of the damper is prescribed.
      if (only_calibration && point.role != "calibration" && quantity != "amplitude") continue;
      fmt::print("{},{},{:.6g},{:.2g},{}\n", point.record, quantity, figure.value, figure.uncertainty,
                 figure.count);
    }
}

void print_predictions() {
  fmt::print("entry,record,quantity,form,value,u_input,u_num\n");
  for (const Prediction& one : predictions())
    fmt::print("{},{},{},{},{:.6g},{:.2g},{:.2g}\n", one.entry, one.record, one.quantity, one.form, one.value,
               one.input_uncertainty, one.numerical_uncertainty);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view what = argc > 1 ? argv[1] : "";
  try {
    if (what == "figures" && (argc == 3 || argc == 4)) {
      print_figures(argv[2], argc == 4);
    } else if (what == "predictions" && argc == 2) {
      print_predictions();
    } else {
      fmt::print(stderr, "usage: stickslip_validation_tables figures FOLDER [calibration] | predictions\n");
      return 1;
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "stickslip_validation_tables: {}\n", error.what());
    return 1;
  }
  return 0;
}
