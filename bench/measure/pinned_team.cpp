// SPDX-License-Identifier: MIT
#include "bench/measure/pinned_team.h"

#include <omp.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "bench/io/numbers.h"

namespace spherepair {
namespace {

bool placed_by_environment() {
  constexpr const char* names[] = {"OMP_PROC_BIND", "OMP_PLACES", "GOMP_CPU_AFFINITY", "KMP_AFFINITY"};
  return std::ranges::any_of(names, [](const char* name) { return std::getenv(name) != nullptr; });
}

std::vector<int> cores_of(const cpu_set_t& set) {
  std::vector<int> cores;
  for (int core = 0; core < CPU_SETSIZE; ++core)
    if (CPU_ISSET(core, &set)) cores.push_back(core);
  return cores;
}

// Limits this thread to these cores (0 in sched_setaffinity means this thread).
bool allow(const cpu_set_t& cores) { return sched_setaffinity(0, sizeof(cores), &cores) == 0; }

}  // namespace

int threads_of(const BackendInfo& cpu) {
  const auto found = cpu.details.find("threads");
  const auto threads = found == cpu.details.end() ? std::nullopt : whole_number_of(found->second, 1, 1u << 20);
  return threads ? int(*threads) : omp_get_max_threads();
}

PinnedTeam::PinnedTeam(int threads) : threads_(threads) {
  if (placed_by_environment() || sched_getaffinity(0, sizeof(before_), &before_) != 0) return;
  const std::vector<int> cores = cores_of(before_);
  if (size_t(threads) > cores.size()) return;
  int pinned = 0;
#pragma omp parallel num_threads(threads_) reduction(+ : pinned)
  {
    cpu_set_t own;
    CPU_ZERO(&own);
    CPU_SET(cores[size_t(omp_get_thread_num())], &own);
    pinned += allow(own);
  }
  pinned_ = pinned == threads_;
}

PinnedTeam::~PinnedTeam() {
#pragma omp parallel num_threads(threads_)
  allow(before_);
}

}  // namespace spherepair
