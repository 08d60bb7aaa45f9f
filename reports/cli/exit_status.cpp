// SPDX-License-Identifier: MIT
#include "exit_status.hpp"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <stdexcept>
#include <string>

#include "output_file.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/data/input_text.hpp"

namespace stickslip::cli {

namespace {

int told(const std::string& sentence, ExitStatus status) {
  constexpr std::size_t longest = 2000;
  fmt::print(stderr, "stickslip: {}\n", data::printable(sentence, longest));
  return status;
}

}  // namespace

int exit_status_of(const std::function<int()>& work) {
  try {
    return work();
  } catch (const data::InputError& error) {
    return told(error.what(), unusable);
  } catch (const OutputError& error) {
    return told(error.what(), unusable);
  } catch (const std::logic_error& error) {
    return told(fmt::format("this is a mistake in stickslip itself, not in the input: {}", error.what()),
                failed);
  } catch (const std::bad_alloc&) {
    return told("the memory does not suffice for this problem", failed);
  } catch (const std::exception& error) {
    return told(error.what(), failed);
  }
}

}  // namespace stickslip::cli
