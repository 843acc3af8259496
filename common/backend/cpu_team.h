// SPDX-License-Identifier: MIT
// The threads that share the CPU's work: OpenMP's.
#pragma once

#include <cstdint>
#include <exception>
#include <mutex>

namespace spherepair {

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
