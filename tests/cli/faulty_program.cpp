// SPDX-License-Identifier: MIT
// The program with a backend `glsl` that answers wrongly: SPHEREPAIR_FAULT names how (faulty_backend.h), from the step
// SPHEREPAIR_FAULT_FROM on.
#include <cstdlib>

#include "bench/cli/command_line.h"
#include "common/backend/cpu_team.h"
#include "tests/support/faulty_backend.h"

int main(int argc, char** argv) {
  using namespace spherepair;
  wait_passively(argv);
  const char *fault = std::getenv("SPHEREPAIR_FAULT"), *from = std::getenv("SPHEREPAIR_FAULT_FROM");
  return run_program(argc, argv, faulty_opener(fault_from_name(fault ? fault : "none"), from ? std::stoull(from) : 0));
}
