// SPDX-License-Identifier: MIT
#include "render/json_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace stickslip::report {

namespace {

// JSON has no such numbers; the library would write null.
void spell_out_infinities(nlohmann::json& value) {
  if (value.is_structured())
    for (auto& part : value) spell_out_infinities(part);
  else if (value.is_number_float() && !std::isfinite(value.get<double>()))
    value = fmt::format("{}", value.get<double>());
}

}  // namespace

std::string json_text(nlohmann::json value) {
  spell_out_infinities(value);
  return value.dump() + "\n";
}

}  // namespace stickslip::report
