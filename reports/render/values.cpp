// SPDX-License-Identifier: MIT
#include "render/values.hpp"

#include <map>
#include <string>

#include "render/findings.hpp"
#include "render/study_json.hpp"
#include "stickslip/data/atomic_file.hpp"

namespace stickslip::report {

STICKSLIP_JSON(Environment, version, commit, date, compiler, eigen, gsl, rest)

void write_values(StudyResults& results, const Environment& environment,
                  const std::filesystem::path& folder) {
  results.run_all();
  const std::map<std::string, nlohmann::json> values{{"environment", environment},
                                                     {"paper", results.paper()},
                                                     {"flat_section", results.flat_section()},
                                                     {"stick_excitation", results.stick_excitation()},
                                                     {"findings", findings(results)}};
  for (const auto& [name, value] : values) data::write_text(folder / (name + ".json"), json_text(value));
}

}  // namespace stickslip::report
