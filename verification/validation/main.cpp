// SPDX-License-Identifier: MIT
/// Makes the tables of data/measurements from the raw records:
///
///     stickslip_validation_tables figures FOLDER [calibration]    figures.csv, of all records or of those of calibration
///     stickslip_validation_tables predictions [ENTRY]             the rows of predictions.csv
///     stickslip_validation_tables comparison                      E and u_val of every prediction
///     stickslip_validation_tables rig                             what an experiment with the beam must measure
///     stickslip_validation_tables bias                            over all points of a quantity

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string>
#include <string_view>

#include "stickslip/data/case_file.hpp"
#include "validation/rig.hpp"
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

void print_predictions(const std::string& entry) {
  fmt::print("entry,record,quantity,form,value,u_input,u_num\n");
  for (const Prediction& one : predictions())
    if (entry.empty() || entry == std::to_string(one.entry))
      fmt::print("{},{},{},{},{:.6g},{:.2g},{:.2g}\n", one.entry, one.record, one.quantity, one.form,
                 one.value, one.input_uncertainty, one.numerical_uncertainty);
}

void print_comparison() {
  fmt::print("experiment,record,quantity,form,D,u_D,S,u_input,u_num,E,u_val,resolved\n");
  for (const Comparison& one : comparisons())
    fmt::print("{},{},{},{},{:.5g},{:.2g},{:.5g},{:.2g},{:.2g},{:.3g},{:.2g},{}\n", one.experiment,
               one.prediction.record, one.prediction.quantity, one.prediction.form, one.measured.value,
               one.measured.uncertainty, one.prediction.value, one.prediction.input_uncertainty,
               one.prediction.numerical_uncertainty, one.error(), one.uncertainty(),
               one.is_resolved() ? "yes" : "no");
}

void print_bias() {
  fmt::print("experiment,quantity,form,points,resolved,beyond,mean,spread\n");
  for (const Bias& one : biases(comparisons()))
    fmt::print("{},{},{},{},{},{},{:.3f},{:.3f}\n", one.experiment, one.quantity, one.form, one.points,
               one.resolved, one.beyond, one.mean, one.spread);
}

void print_rig() {
  const auto beam = stickslip::data::load_case("rig").beam;
  fmt::print("length,load,following,fixed,accuracy,load_accuracy\n");
  for (const FrequencyPair& pair : axial_direction_experiment(beam))
    fmt::print("{},{},{:.5g},{:.5g},{:.2g},{:.2g}\n", pair.length, pair.load, pair.following, pair.fixed,
               pair.accuracy, allowed_load_error(beam, pair));
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view what = argc > 1 ? argv[1] : "";
  try {
    if (what == "figures" && (argc == 3 || argc == 4)) {
      print_figures(argv[2], argc == 4);
    } else if (what == "predictions" && argc <= 3) {
      print_predictions(argc == 3 ? argv[2] : "");
    } else if (what == "comparison" && argc == 2) {
      print_comparison();
    } else if (what == "bias" && argc == 2) {
      print_bias();
    } else if (what == "rig" && argc == 2) {
      print_rig();
    } else {
      fmt::print(stderr,
                 "usage: stickslip_validation_tables figures FOLDER [calibration] | predictions [ENTRY] | "
                 "comparison | bias | rig\n");
      return 1;
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "stickslip_validation_tables: {}\n", error.what());
    return 1;
  }
  return 0;
}
