// SPDX-License-Identifier: MIT
#include "bench/cli/command_line.h"
#include "common/backend/cpu_team.h"

int main(int argc, char** argv) {
  spherepair::wait_passively(argv);
  return spherepair::run_program(argc, argv);
}
