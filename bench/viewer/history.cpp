// SPDX-License-Identifier: MIT
#include "bench/viewer/history.h"

#include <algorithm>

#include "bench/check/finite_state.h"

namespace spherepair {
namespace {

constexpr uint64_t most_states = 64;

template <typename T>
uint64_t bytes_of(const std::vector<T>& values) {
  return values.size() * sizeof(T);
}

}  // namespace

// Keeps states of many spheres less often, since reading a state back takes as long as many steps.
History::History(const Start& start, uint64_t most_bytes)
    : start_(start),
      most_bytes_(most_bytes),
      last_(start.step),
      every_(std::max<uint64_t>(32, start.scene.size() / 4096)) {}

uint64_t History::Kept::bytes() const {
  return bytes_of(state.positions) + bytes_of(state.velocities) + bytes_of(motion.wide) + bytes_of(motion.anchors) +
         bytes_of(motion.flights) + bytes_of(motion.since) + bytes_of(motion.next_event);
}

// Drops every other state when there are too many.
void History::record(Motion& motion, uint64_t step) {
  if (step <= last_) return;
  last_ = step;
  if ((step - first()) % every_ != 0) return;
  Kept now{current_state(motion), {}};
  require_finite(now.state, step);
  now.motion = motion.save();
  const uint64_t most = std::min(most_states, most_bytes_ / std::max<uint64_t>(now.bytes(), 1));
  kept_[step] = std::move(now);
  while (kept_.size() > most) {
    every_ *= 2;
    std::erase_if(kept_, [&](const auto& kept) { return (kept.first - first()) % every_ != 0; });
  }
}

void History::go_to(Motion& motion, uint64_t step) {
  auto found = kept_.upper_bound(step);
  uint64_t at = first();
  if (found == kept_.begin()) {
    upload_start(start_, motion);
  } else {
    const auto& [step_of, kept] = *std::prev(found);
    Scene scene = start_.scene;
    scene.positions = kept.state.positions;
    scene.velocities = kept.state.velocities;
    motion.resume(scene, kept.motion);
    at = step_of;
  }
  for (; at < step; ++at) motion.move();
}

}  // namespace spherepair
