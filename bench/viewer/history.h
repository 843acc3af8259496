// SPDX-License-Identifier: MIT
// Goes back to earlier steps of a run. Keeps a state now and then, and makes the steps between again, to the same bits.
#pragma once

#include <map>

#include "bench/formats/start.h"
#include "common/backend/motion.h"

namespace spherepair {

class History {
 public:
  // most_bytes: host memory for states; with room for few of them, going back takes more steps.
  explicit History(const Start& start, uint64_t most_bytes = uint64_t(1) << 30);

  void record(Motion& motion, uint64_t step);  // `step` is the one that the backend has just reached
  void go_to(Motion& motion, uint64_t step);   // from the first step of the run to the last that was reached
  uint64_t first() const { return start_.step; }
  uint64_t last() const { return last_; }
  size_t states() const { return kept_.size(); }

 private:
  struct Kept {
    Motion::State state;
    MotionState motion;
    uint64_t bytes() const;
  };

  const Start& start_;
  uint64_t most_bytes_, last_;
  uint64_t every_;  // steps between two kept states
  std::map<uint64_t, Kept> kept_;
};

}  // namespace spherepair
