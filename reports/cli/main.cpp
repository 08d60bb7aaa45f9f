// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <malloc.h>
#include <unistd.h>

#include <csignal>

#include "program.hpp"

int main(int argc, char** argv) {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})  // else an output takes its number
    if (::fcntl(stream, F_GETFD) < 0) (void)::open("/dev/null", O_RDONLY);
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error like a full disk
#ifdef __GLIBC__
  ::mallopt(M_TRIM_THRESHOLD,
            1 << 28);  // memory that is asked for again and again is not given back to the system
  ::mallopt(M_MMAP_THRESHOLD, 1 << 28);
#endif
  return stickslip::cli::run_program(argc, argv);
}
