#pragma once

namespace stickslip::studies {

/// How many threads a study works on: as many as the machine runs at once, until set_thread_count(). No
/// result depends on it.
[[nodiscard]] unsigned thread_count() noexcept;

/// Throws std::invalid_argument unless `count` is 1 or more.
void set_thread_count(unsigned count);

}  // namespace stickslip::studies
