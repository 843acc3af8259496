// SPDX-License-Identifier: MIT
// Threads of the CPU backend, each on a core of its own while a time is taken.
#pragma once

#include <sched.h>

#include "common/backend/backend.h"

namespace spherepair {

int threads_of(const BackendInfo& cpu);

// Pins OpenMP's threads, this one first, to the cores that the process may use, and lets them go again. Not where there
// are fewer cores than threads, nor where the environment has places of its own for them (OMP_PROC_BIND, OMP_PLACES,
// GOMP_CPU_AFFINITY, KMP_AFFINITY): then those hold.
class PinnedTeam {
 public:
  explicit PinnedTeam(int threads);
  ~PinnedTeam();
  PinnedTeam(const PinnedTeam&) = delete;
  PinnedTeam& operator=(const PinnedTeam&) = delete;
  bool pinned() const { return pinned_; }

 private:
  int threads_;
  cpu_set_t before_{};
  bool pinned_ = false;
};

}  // namespace spherepair
