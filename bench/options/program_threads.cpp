// SPDX-License-Identifier: MIT
#include "bench/options/program_threads.h"

#include <fmt/format.h>
#include <omp.h>
#include <unistd.h>

#include <cstdlib>
#include <latch>
#include <string>
#include <thread>
#include <vector>

#include "common/backend/backend.h"
#include "common/scene/counted.h"

namespace spherepair {

void wait_passively(char** argv) {
  for (const char* name : {"OMP_WAIT_POLICY", "GOMP_SPINCOUNT", "KMP_BLOCKTIME"})
    if (std::getenv(name)) return;
  ::setenv("OMP_WAIT_POLICY", "passive", 1);
  ::execv("/proc/self/exe", argv);  // returns only on failure; threads then spin
}

// Starts as many threads of our own at once, to learn whether OpenMP's can start. OpenMP's threads then stay until the
// end.
void start_team(int threads) {
  const size_t wanted = size_t(threads > 0 ? threads : omp_get_num_procs()) - 1;  // besides this thread
  std::vector<std::thread> trial;
  std::latch all_tried(1);
  std::string trouble;
  try {
    trial.reserve(wanted);
    while (trial.size() < wanted) trial.emplace_back([&] { all_tried.wait(); });
    // As much memory as OpenMP allocates for its team besides the stacks: if its own allocation fails, it ends the
    // program.
    const std::vector<char> of_team((wanted + 64) * 1024);
  } catch (const std::exception& error) {
    trouble = error.what();
  }
  const size_t started = trial.size();
  all_tried.count_down();
  for (std::thread& thread : trial) thread.join();
  if (!trouble.empty())
    throw BackendError(
        fmt::format("{} of {} could be started before memory or threads ran out ({}): ask for fewer with "
                    "--threads, or raise the limits on processes and memory (ulimit -u, ulimit -v)",
                    started + 1, counted(wanted + 1, "thread"), trouble));
  omp_set_num_threads(int(wanted) + 1);
  int running = 0;
#pragma omp parallel reduction(+ : running)
  running += 1;
}

}  // namespace spherepair
