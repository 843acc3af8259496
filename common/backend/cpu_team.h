// SPDX-License-Identifier: MIT
// The threads that share the CPU's work: OpenMP's.
#pragma once

#include <cstdint>
#include <exception>
#include <mutex>

namespace spherepair {

// Lets OpenMP's threads sleep while they wait for each other. By default they spin: where another program holds a core,
// each parallel region then waits for a thread that lost its core for as long as it spun before. The
// runtime reads the setting (OMP_WAIT_POLICY) as the program is loaded, so the program is started anew with it, once,
// unless its environment has it already. For the first line of main.
void wait_passively(char** argv);

// Starts the threads of all later parallel regions, as many as asked for or, for 0, one a core. Throws BackendError
// where the system lets fewer run. For the start of a program: where OpenMP's runtime (GCC's) cannot start a thread, it
// ends the process, with the exit code of a difference.
void start_team(int threads);

// Threads for work of so many shares: one or all. A team of some in between would be dear: OpenMP's runtime (GCC's)
// ends the threads that it leaves out, and starts them anew for the next larger team.
inline int team_of(uint64_t shares, int threads) { return shares < 2 ? 1 : threads; }

// No exception may leave a parallel region. What can throw there, be it for want of memory, runs through here; behind
// the region the error of the least share is thrown again, so that it is the same on any number of threads.
class TeamErrors {
 public:
  template <typename Work>
  void run(uint64_t share, Work work) {
    try {
      work();
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!error_ || share < share_) error_ = std::current_exception(), share_ = share;
    }
  }
  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr error_;
  uint64_t share_ = 0;
};

}  // namespace spherepair
