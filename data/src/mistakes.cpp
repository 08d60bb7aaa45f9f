// SPDX-License-Identifier: MIT
#include "stickslip/data/mistakes.hpp"

namespace stickslip::data {

void Mistakes::collect(const std::function<void()>& work,
                       const std::function<std::string(const FieldError&)>& place) {
  try {
    work();
  } catch (const FieldError& error) {
    sentences_.push_back((place ? place(error) + ": " : "") + error.what());
  } catch (const InputError& error) {
    sentences_.emplace_back(error.what());
  }
}

void Mistakes::throw_if_any() const {
  if (sentences_.empty()) return;
  if (sentences_.size() == 1) throw InputError(sentences_.front());
  std::string lines;
  for (const std::string& sentence : sentences_) lines += (lines.empty() ? "" : "\n") + sentence;
  throw InputErrors(lines);
}

}  // namespace stickslip::data
