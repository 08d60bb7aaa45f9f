// SPDX-License-Identifier: MIT
#include <csignal>

#include "program.hpp"

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error like a full disk
  return stickslip::cli::run_program(argc, argv);
}
