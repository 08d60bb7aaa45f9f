// SPDX-License-Identifier: MIT
#pragma once

/// What most tests of numbers need: GoogleTest, the standard library, requirements, tolerances and names of parameters.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "support/parameter_name.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"
