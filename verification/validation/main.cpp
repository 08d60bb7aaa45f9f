// SPDX-License-Identifier: MIT
/// Prints the tables of data/measurements, from the raw records in FOLDER or from these tables:
///
///     stickslip_validation_tables figures FOLDER | predictions | comparison | bias

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string_view>

#include "validation/study.hpp"

namespace {

using namespace stickslip::validation;

void print_figures(const char* folder) {
  fmt::print("record,quantity,value,uncertainty,count\n");
  for (const SetPoint& point : set_points())
    for (const auto& [quantity, figure] : read_raw(point, folder))
      fmt::print("{},{},{:.6g},{:.2g},{}\n", point.record, quantity, figure.value, figure.uncertainty,
                 figure.count);
}

void print_predictions() {
  fmt::print("entry,record,quantity,form,value,u_input,u_num\n");
  for (const Prediction& one : predictions())
    fmt::print("{},{},{},{},{:.6g},{:.2g},{:.2g}\n", one.entry, one.record, one.quantity, one.form, one.value,
               one.input_uncertainty, one.numerical_uncertainty);
}

void print_comparison() {
  fmt::print("experiment,record,quantity,form,D,u_D,S,u_input,u_num,E,u_val,resolved\n");
  for (const Comparison& one : comparisons()) {
    const auto& [record, quantity, form, value, u_input, u_num, entry] = one.prediction;
    fmt::print("{},{},{},{},{:.5g},{:.2g},{:.5g},{:.2g},{:.2g},{:.3g},{:.2g},{}\n", one.experiment, record,
               quantity, form, one.measured.value, one.measured.uncertainty, value, u_input, u_num,
               one.error(), one.uncertainty(), one.is_resolved() ? "yes" : "no");
  }
}

void print_bias() {
  fmt::print("experiment,quantity,form,points,resolved,beyond,mean,spread\n");
  for (const auto& [experiment, quantity, form, points, resolved, beyond, mean, spread] :
       biases(comparisons()))
    fmt::print("{},{},{},{},{},{},{:.3f},{:.3f}\n", experiment, quantity, form, points, resolved, beyond,
               mean, spread);
}

}  // namespace

int main(int argc, char** argv) try {
  const std::string_view what = argc > 1 ? argv[1] : "";
  if (what == "figures" && argc == 3) return print_figures(argv[2]), 0;
  if (what == "predictions") return print_predictions(), 0;
  if (what == "comparison") return print_comparison(), 0;
  if (what == "bias") return print_bias(), 0;
  fmt::print(stderr, "usage: stickslip_validation_tables figures FOLDER | predictions | comparison | bias\n");
  return 1;
} catch (const std::exception& error) {
  fmt::print(stderr, "stickslip_validation_tables: {}\n", error.what());
  return 1;
}
