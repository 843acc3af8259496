// SPDX-License-Identifier: MIT
// The program with a backend `opengl` that answers wrongly: SPHEREPAIR_FAULT names how (faulty_backend.h), from the
// step SPHEREPAIR_FAULT_FROM on. SPHEREPAIR_OTHERS is the share of the cores that other programs seem to keep busy.
#include <cstdlib>

#include "bench/cli/command_line.h"
#include "bench/options/program_threads.h"
#include "tests/faults/faulty_backend.h"

int main(int argc, char** argv) {
  using namespace spherepair;
  wait_passively(argv);
  const char *fault = std::getenv("SPHEREPAIR_FAULT"), *from = std::getenv("SPHEREPAIR_FAULT_FROM");
  Clocks clocks = host_clocks();
  if (const char* others = std::getenv("SPHEREPAIR_OTHERS"))
    clocks.machine = [share = std::stod(others), clocks] {
      constexpr int cores = 4;
      return MachineUse{clocks.cores() + share * cores * clocks.wall(), cores};
    };
  return run_program(argc, argv, faulty_opener(fault_from_name(fault ? fault : "none"), from ? std::stoull(from) : 0),
                     run_directly, clocks);
}
