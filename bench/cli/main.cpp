// SPDX-License-Identifier: MIT
#include "bench/cli/command_line.h"
#include "bench/options/program_threads.h"

int main(int argc, char** argv) {
  spherepair::wait_passively(argv);
  return spherepair::run_program(argc, argv);
}
