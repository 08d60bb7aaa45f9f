// SPDX-License-Identifier: MIT
#include "stickslip/data/contact_event.hpp"

namespace stickslip::data {

std::string_view to_string(ContactState state) { return state == ContactState::stick ? "stick" : "slip"; }

std::string_view to_string(ContactChange change) {
  switch (change) {
    case ContactChange::onset:
      return "onset";
    case ContactChange::capture:
      return "capture";
    case ContactChange::reversal:
      return "reversal";
    case ContactChange::graze:
      return "graze";
  }
  return "";
}

}  // namespace stickslip::data
