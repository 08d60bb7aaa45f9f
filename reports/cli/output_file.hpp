// SPDX-License-Identifier: MIT
#pragma once

#include "stickslip/data/atomic_file.hpp"

namespace stickslip::cli {

using OutputFile = data::AtomicFile;
using data::OutputError;

}  // namespace stickslip::cli
