// SPDX-License-Identifier: MIT
// Keeps each thread of the CPU backend on a core of its own while a time is taken.
#pragma once

#include <sched.h>

#include "common/backend/backend.h"

namespace spherepair {

int threads_of(const BackendInfo& cpu);

// Pins OpenMP's threads, this one first, to the cores that the process may use; the destructor lets them go. Does
// nothing if there are fewer cores than threads, or if the environment places the threads (OMP_PROC_BIND, OMP_PLACES,
// GOMP_CPU_AFFINITY, KMP_AFFINITY).
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
