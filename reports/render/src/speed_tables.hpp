#pragma once

#include <string>

#include "stickslip/benchmarks/speed_record.hpp"

namespace stickslip::report {

/// Rows, one for each comparison: work, plain way, fast way, milliseconds of the fast way, ratio of the
/// times.
[[nodiscard]] std::string speed_rows(const benchmarks::SpeedRecord& record);

/// Rows, one for each fast way whose operations are counted: flops and bytes a step, shares of the machine's,
/// %.
[[nodiscard]] std::string load_rows(const benchmarks::SpeedRecord& record);

/// Rows, one for each mesh: elements, nanoseconds a step and element, that relative to the first mesh.
[[nodiscard]] std::string scale_rows(const benchmarks::SpeedRecord& record);

}  // namespace stickslip::report
