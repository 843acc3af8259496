// SPDX-License-Identifier: MIT
// OpenMP threads that share the CPU's work.
#pragma once

#include <cstdint>
#include <exception>
#include <mutex>

namespace spherepair {

// Returns the number of threads for so many shares of work: one or all. Teams of changing size are slow: GCC's OpenMP
// runtime ends the threads that a smaller team leaves out, and starts new ones for the next larger team.
inline int team_of(uint64_t shares, int threads) { return shares < 2 ? 1 : threads; }

// Carries exceptions out of a parallel region, which none may leave. run() catches what its work throws; rethrow(),
// after the region, throws the error of the lowest share, so that it is the same for any number of threads.
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
