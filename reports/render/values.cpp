// SPDX-License-Identifier: MIT
#include "render/values.hpp"

#include <map>
#include <string>

#include "render/findings.hpp"
#include "render/json_text.hpp"
#include "render/text_file.hpp"
#include "stickslip/benchmarks/speed_record.hpp"
#include "studies/common/described_types.hpp"

namespace stickslip::benchmarks {
STICKSLIP_MEMBERS(SpeedComparison::Load, (flops_per_step, "1"), (bytes_per_step, "B"), (share_of_flops, "1"),
                  (share_of_bytes, "1"))
STICKSLIP_MEMBERS(SpeedComparison, (work, "-"), (plain, "-"), (fast, "-"), (fast_seconds, "s"), (load),
                  (ratio(), "1"))
}  // namespace stickslip::benchmarks

namespace stickslip::report {

namespace {

using nlohmann::json;

json speed(const benchmarks::SpeedRecord& record) {
  json scale = json::array();
  for (std::size_t i = 0; i < record.elements.size(); ++i)
    scale.push_back({{"elements", record.elements[i]},
                     {"seconds_per_element", record.seconds_per_element[i]},
                     {"relative", record.seconds_per_element[i] / record.seconds_per_element[0]}});
  return {{"processor", record.processor}, {"comparisons", record.comparisons}, {"scale", scale}};
}

}  // namespace

void write_values(StudyResults& results, const Environment& environment,
                  const std::filesystem::path& folder) {
  results.run_all();
  const std::map<std::string, json> values{{"environment", environment},
                                           {"paper", results.paper()},
                                           {"flat_section", results.flat_section()},
                                           {"stick_excitation", results.stick_excitation()},
                                           {"findings", findings(results)},
                                           {"speed", speed(benchmarks::read_speed_record())}};
  for (const auto& [name, value] : values) replace_text(folder / (name + ".json"), json_text(value));
}

}  // namespace stickslip::report
