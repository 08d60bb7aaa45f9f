// SPDX-License-Identifier: MIT
#pragma once

// For the commands that do not use the frame yet.
#include "command.hpp"
