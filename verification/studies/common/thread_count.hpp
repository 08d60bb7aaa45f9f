// SPDX-License-Identifier: MIT
#pragma once

namespace stickslip::studies {

/// The number of threads that a study uses: the number that the machine runs concurrently, unless
/// set_thread_count() has changed it. The results do not depend on it.
[[nodiscard]] unsigned thread_count() noexcept;

/// Sets the number of threads. Throws std::invalid_argument if `count` is 0.
void set_thread_count(unsigned count);

}  // namespace stickslip::studies
