// SPDX-License-Identifier: MIT
#pragma once

/// GSL's status codes as exceptions.

#include <gsl/gsl_errno.h>

#include <mutex>
#include <stdexcept>
#include <string>

namespace stickslip::analytic {

/// Turns off GSL's aborting error handler while at least one instance lives, in whatever thread, and then
/// puts back the handler that was there before the first.
class StatusInsteadOfAbort {
 public:
  StatusInsteadOfAbort() {
    const std::lock_guard lock(mutex_);
    if (instances_++ == 0) previous_ = gsl_set_error_handler_off();
  }
  ~StatusInsteadOfAbort() {
    const std::lock_guard lock(mutex_);
    if (--instances_ == 0) gsl_set_error_handler(previous_);
  }
  StatusInsteadOfAbort(const StatusInsteadOfAbort&) = delete;
  StatusInsteadOfAbort& operator=(const StatusInsteadOfAbort&) = delete;

 private:
  static inline std::mutex mutex_;
  static inline int instances_ = 0;
  static inline gsl_error_handler_t* previous_ = nullptr;
};

/// Throws std::runtime_error, "<where>: <GSL's reason>.", unless status is success.
inline void require_success(int status, const std::string& where) {
  if (status != GSL_SUCCESS) throw std::runtime_error(where + ": " + gsl_strerror(status) + ".");
}

}  // namespace stickslip::analytic
